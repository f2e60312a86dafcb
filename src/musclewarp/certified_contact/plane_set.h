// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <vector>

#include "musclewarp/certified_contact/contact_step.h"
#include "musclewarp/certified_contact/plane_owner.h"
#include "musclewarp/certified_contact/separating_planes.h"
#include "musclewarp/certified_contact/step_options.h"
#include "musclewarp/proximity/half_space.h"

namespace musclewarp {

// The separating planes of one step, indexed by vertex: stores the half-spaces
// of each vertex, updates the levels of planes between muscles, and projects
// points into the half-spaces of a vertex.
//
//   PlaneSet planes(options, step);
//   planes.Add(FindPlanesBetweenMuscles(options, step, trees));
//   planes.UpdateLevels(unprojected, points, /*is_first=*/true);
//   planes.FindNear(muscle, v, p);
//   points[muscle].row(v) = planes.Projected(muscle, v, p);
//
// FindNear(), RefreshNear() and Projected() may be called concurrently for
// different vertices.
// The order of the muscles affects rounding only.
class PlaneSet {
 public:
  // Keeps references.
  PlaneSet(const StepOptions& options, const ContactStep& step);

  // Adds planes. A bone's plane gets no half-space for a vertex predicted more
  // than RelaxationOptions::max_push above it, as the vertex cannot reach the
  // plane.
  void Add(const std::vector<SeparatingPlane>& planes);

  // Sets the levels of planes between muscles, or sheets of one muscle, halfway
  // between the `unprojected` positions of both sides; the level follows an
  // attached side, and the other side yields. Unless `is_first` (in a run of
  // sweeps), a side whose `points` violate the plane, as other planes block it,
  // shifts the plane by the violation, so that the other side yields more. #V x
  // 3 each, mm.
  void UpdateLevels(const std::vector<Points>& unprojected,
                    const std::vector<Points>& points,
                    bool is_first);

  // Selects the half-spaces of a vertex that Projected() uses: those that
  // `point` violates or lies in by less than the reach. Of those that face
  // almost the same way only the one that leaves least room counts, of bones,
  // which do not yield, and of others apart.
  void FindNear(int muscle, int vertex, const Eigen::RowVector3d& point);

  // Has the near half-spaces of a vertex follow UpdateLevels().
  void RefreshNear(int muscle, int vertex);

  // Projects `point` into the near half-spaces of a vertex. If their
  // intersection is not within RelaxationOptions::max_push, returns a
  // compromise that favours bones: other muscles yield by UpdateLevels(), bones
  // do not. The result is within max_push of the predicted vertex.
  Eigen::RowVector3d Projected(int muscle,
                               int vertex,
                               const Eigen::RowVector3d& point) const;

  // Returns, for each of `vertices` near a plane at `points` (#V x 3, mm), the
  // half-space that its target (`targets`, #V x 3, mm) violates most or, if
  // none, that it is nearest to violating. These are the rows of the coarse
  // solve.
  OwnedHalfSpaces MostViolated(int muscle,
                               const std::vector<int>& vertices,
                               const Points& points,
                               const Points& targets) const;

  // Returns the worst violation of a plane by a vertex, mm, without planes
  // between sheets of one muscle.
  double WorstViolation(const std::vector<Points>& points) const;

 private:
  // The half gap of a bone's plane is zero, as its level includes the gap.
  struct Plane {
    Eigen::RowVector3d normal;
    double half_gap;  // mm
    double distance;  // of the two sides before the step, mm
    int moving;       // index in moving_; -1 - b for bone b
  };
  // The present levels of the half-spaces above and below a plane, mm.
  struct Levels {
    double above, below;
  };
  // A plane between muscles, whose level follows both sides, and its shift
  // towards the side that yields.
  struct MovingPlane {
    int plane;
    PlaneOwner owner;

    // As that of the owner, but for muscles that stand still: the level follows
    // these, and the other side yields.
    double share_above;
    std::vector<int> also_below;  // as in SeparatingPlane
    int shared_corner;            // as in SeparatingPlane
    double shift = 0;             // mm
  };
  // The half-space of a vertex above plane p is p, that of one below it is ~p.
  using Side = int;
  // A half-space of a vertex. Sweeps read these more often than anything else,
  // so that what they need of the plane is beside it.
  struct VertexSpace {
    Eigen::RowVector3d normal;
    double level;     // of the last FindNear() or RefreshNear(), mm
    double distance;  // of the plane
    Side side;
    bool is_of_bone;
  };
  struct VertexSide {
    int vertex;
    Side side;
  };

  void AddPlane(const SeparatingPlane& plane);

  // Returns the fraction of the corners of a triangle that are attached.
  double AttachedShare(int muscle, const Eigen::RowVector3i& corners) const;

  // Sorts the half-spaces of each vertex, including `added` (by muscle).
  void SortSpaces(const std::vector<std::vector<VertexSide>>& added);
  bool ComesBefore(const VertexSpace& a, const VertexSpace& b) const;
  VertexSpace SpaceOf(Side side) const;

  static int NumberOf(Side side) { return side < 0 ? ~side : side; }
  double LevelOf(Side side) const {
    return side < 0 ? levels_[~side].below : levels_[side].above;
  }
  void SetLevel(int plane, double level);
  bool IsWithinOneMuscle(Side side) const;
  PlaneOwner CarrierOf(Side side) const;
  void UpdateLevel(const std::vector<Points>& unprojected,
                   const std::vector<Points>& points,
                   bool is_first,
                   MovingPlane* moving);

  const StepOptions& options_;
  const ContactStep& step_;
  std::vector<Plane> planes_;
  std::vector<Levels> levels_;  // of planes_
  std::vector<MovingPlane> moving_;

  // By muscle, by vertex: the half-spaces of vertex v start at first_[v].
  std::vector<std::vector<VertexSpace>> spaces_;
  std::vector<std::vector<int>> first_;

  // By muscle: the near half-spaces of vertex v are those of spaces_ whose
  // places are the num_near_[v] entries from first_[v] on.
  std::vector<std::vector<int>> near_;
  std::vector<std::vector<int>> num_near_;
};

}  // namespace musclewarp
