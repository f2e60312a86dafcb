// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "musclewarp/exchange/tetrahedral_mesh.h"

namespace musclewarp {

// The corners of a tetrahedron, in the order of Tetrahedra, and of a face.
using ElementCorners = std::array<int, 4>;
using FaceCorners = std::array<int, 3>;

// A face of the border of some elements, outward, and the element inside.
struct BorderFace {
  FaceCorners face;
  int element = -1;
};

// Tetrahedra that are replaced by others while their mesh is improved. Each has
// a quality: minus the cosine of its smallest dihedral angle, which grows with
// the angle, or kInverted.
class ChangingElements {
 public:
  // Below all qualities of tetrahedra that are not inverted.
  static constexpr double kInverted = -2;

  // The first `surface_points` points stay, and so do the faces of the border.
  ChangingElements(Eigen::Index surface_points, const TetrahedralMesh& mesh);

  // Returns the mesh, without points inside that no element has any more.
  TetrahedralMesh Result() const;

  // One more than the largest number that an element had so far.
  int num_elements() const { return static_cast<int>(elements_.size()); }
  bool IsThere(int t) const { return elements_[t][0] >= 0; }
  bool IsInside(int v) const { return v >= surface_points_; }
  const ElementCorners& corners(int t) const { return elements_[t]; }
  const Eigen::RowVector3d& point(int v) const { return points_[v]; }
  const std::vector<int>& elements_of(int v) const { return elements_of_[v]; }
  double quality(int t) const { return quality_[t]; }

  // The quality that an element would have; of the second one with an outward
  // face of others, from which it goes inward to `place`.
  double QualityOf(const ElementCorners& corners) const;
  double QualityOf(const FaceCorners& face,
                   const Eigen::RowVector3d& place) const;

  // Returns the smallest quality of elements.
  double Worst(const std::vector<int>& elements) const;

  std::vector<int> ElementsAround(int a, int b) const;

  // Returns the element on the other side of a face, or -1 at the border.
  int Neighbour(int t, const FaceCorners& face) const;

  // Return face f of an element, and the one without corner v, outward; and
  // the corner that a face lacks.
  FaceCorners FaceOf(int t, int f) const;
  FaceCorners FaceOpposite(int t, int v) const;
  int CornerBeside(int t, const FaceCorners& face) const;

  Eigen::RowVector3d MiddleOf(int t) const;

  // Returns the points around an edge inside, counterclockwise seen from b;
  // none for an edge of the border. `around`: ElementsAround(a, b).
  std::vector<int> RingOf(int a, int b, const std::vector<int>& around) const;

  // Returns the faces that only one of the elements has.
  std::vector<BorderFace> BorderOf(const std::vector<int>& elements) const;

  void Replace(const std::vector<int>& old,
               const std::vector<ElementCorners>& fresh);

  // Replaces elements by those that join the outward faces of their border to
  // a new point.
  void JoinTo(const Eigen::RowVector3d& place,
              const std::vector<FaceCorners>& border,
              const std::vector<int>& elements);

  void MovePoint(int v, const Eigen::RowVector3d& place);

 private:
  void Add(const ElementCorners& corners);
  void Remove(int t);

  int surface_points_;
  std::vector<Eigen::RowVector3d> points_;
  std::vector<ElementCorners> elements_;  // those that are gone begin with -1
  std::vector<double> quality_;
  std::vector<std::vector<int>> elements_of_;  // of each point
};

}  // namespace musclewarp
