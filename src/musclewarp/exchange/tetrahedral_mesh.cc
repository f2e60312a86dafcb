// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/exchange/tetrahedral_mesh.h"

#include <glog/logging.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

#include "musclewarp/base/angles.h"

namespace musclewarp {
namespace {

using Eigen::RowVector3d;
using TetrahedronCorners = Eigen::Matrix<double, 4, 3, Eigen::RowMajor>;

TetrahedronCorners CornersOfElement(const TetrahedralMesh& mesh,
                                    Eigen::Index t) {
  TetrahedronCorners corners;
  for (int k = 0; k < 4; ++k) {
    corners.row(k) = mesh.points.row(mesh.tetrahedra(t, k));
  }
  return corners;
}

// Positive if the first three corners run counterclockwise seen from the
// fourth.
double SignedVolumeOf(const TetrahedronCorners& c) {
  const RowVector3d a = c.row(1) - c.row(0);
  const RowVector3d b = c.row(2) - c.row(0);
  return a.cross(b).dot(c.row(3) - c.row(0)) / 6;
}

// Adds the dihedral angles and the aspect of an element. Returns its smallest
// angle, degrees.
double Measure(const TetrahedronCorners& c, ElementQuality* quality) {
  std::array<RowVector3d, 4> normals;  // twice the area long
  double area = 0;
  for (int f = 0; f < 4; ++f) {
    const int* const k = kFaceCorners[f];
    const RowVector3d u = c.row(k[1]) - c.row(k[0]);
    const RowVector3d v = c.row(k[2]) - c.row(k[0]);
    normals[f] = u.cross(v);
    area += normals[f].norm() / 2;
  }
  double longest = 0, smallest = 180;
  for (int i = 0; i < 4; ++i) {
    for (int k = i + 1; k < 4; ++k) {
      longest = std::max(longest, (c.row(i) - c.row(k)).norm());
      const double size = normals[i].norm() * normals[k].norm();
      const double cosine = size > 0 ? -normals[i].dot(normals[k]) / size : 1;
      const double angle = DegreesOf(std::acos(std::clamp(cosine, -1.0, 1.0)));
      smallest = std::min(smallest, angle);
      quality->largest_dihedral_deg =
          std::max(quality->largest_dihedral_deg, angle);
    }
  }
  const double radius = 3 * std::abs(SignedVolumeOf(c)) / area;
  const double regular = std::sqrt(24.0);  // longest edge over radius
  const double aspect = radius > 0 ? longest / radius / regular
                                   : std::numeric_limits<double>::infinity();
  quality->largest_aspect = std::max(quality->largest_aspect, aspect);
  quality->smallest_dihedral_deg =
      std::min(quality->smallest_dihedral_deg, smallest);
  return smallest;
}

// A triangle by its corners in rising order.
using SortedFace = std::array<int, 3>;

SortedFace Sorted(int a, int b, int c) {
  SortedFace face = {a, b, c};
  std::sort(face.begin(), face.end());
  return face;
}

struct FaceOfElement {
  SortedFace corners;
  ElementFace face;

  bool operator<(const FaceOfElement& other) const {
    return corners < other.corners;
  }
};

// Returns the faces that only one tetrahedron has, in order.
std::vector<FaceOfElement> SingleFaces(const Tetrahedra& tetrahedra) {
  std::vector<FaceOfElement> faces;
  faces.reserve(4 * tetrahedra.rows());
  for (Eigen::Index t = 0; t < tetrahedra.rows(); ++t) {
    for (int f = 0; f < 4; ++f) {
      const int* const k = kFaceCorners[f];
      faces.push_back(
          {Sorted(
               tetrahedra(t, k[0]), tetrahedra(t, k[1]), tetrahedra(t, k[2])),
           {static_cast<int>(t), f}});
    }
  }
  std::sort(faces.begin(), faces.end());
  std::vector<FaceOfElement> single;
  for (size_t i = 0; i < faces.size();) {
    size_t end = i + 1;
    while (end < faces.size() && faces[end].corners == faces[i].corners) ++end;
    if (end == i + 1) single.push_back(faces[i]);
    i = end;
  }
  return single;
}

}  // namespace

Eigen::VectorXd Volumes(const TetrahedralMesh& mesh) {
  Eigen::VectorXd volumes(mesh.tetrahedra.rows());
  for (Eigen::Index t = 0; t < volumes.size(); ++t) {
    volumes[t] = SignedVolumeOf(CornersOfElement(mesh, t));
  }
  return volumes;
}

ElementQuality QualityOf(const TetrahedralMesh& mesh,
                         const std::vector<bool>& is_sharp) {
  const auto is_at_sharp = [&](int v) {
    return v < static_cast<int>(is_sharp.size()) && is_sharp[v];
  };
  CHECK_GT(mesh.tetrahedra.rows(), 0);
  ElementQuality quality;
  quality.smallest_dihedral_deg = 180;
  for (Eigen::Index t = 0; t < mesh.tetrahedra.rows(); ++t) {
    const TetrahedronCorners corners = CornersOfElement(mesh, t);
    if (Measure(corners, &quality) < kSmallDihedralDeg) {
      const auto vertices = mesh.tetrahedra.row(t);
      ++quality.small_angles;
      quality.small_angles_at_sharp +=
          std::any_of(vertices.begin(), vertices.end(), is_at_sharp);
    }
    const double volume = SignedVolumeOf(corners);
    quality.inverted += !(volume > 0);
    quality.volume += volume;
  }
  return quality;
}

std::vector<ElementFace> BorderFaces(const Tetrahedra& tetrahedra,
                                     const Triangles& surface) {
  const std::vector<FaceOfElement> single = SingleFaces(tetrahedra);
  if (single.size() != static_cast<size_t>(surface.rows())) return {};
  std::vector<ElementFace> faces;
  for (Eigen::Index f = 0; f < surface.rows(); ++f) {
    const FaceOfElement wanted = {
        Sorted(surface(f, 0), surface(f, 1), surface(f, 2)), {}};
    const auto found = std::lower_bound(single.begin(), single.end(), wanted);
    if (found == single.end() || found->corners != wanted.corners) return {};
    faces.push_back(found->face);
  }
  return faces;
}

}  // namespace musclewarp
