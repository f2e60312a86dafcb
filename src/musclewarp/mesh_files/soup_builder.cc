// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/mesh_files/soup_builder.h"

#include <Eigen/Geometry>

#include "musclewarp/base/input_error.h"
#include "musclewarp/mesh_files/export_advice.h"
#include "musclewarp/mesh_files/text_cursor.h"

namespace musclewarp {
namespace {

using PolygonCorners = Eigen::Map<const Eigen::Matrix<std::int64_t, 1, -1>>;

// Twice the area vector of the triangle.
Eigen::Vector3d Normal(const Points& points,
                       std::int64_t a,
                       std::int64_t b,
                       std::int64_t c) {
  const Eigen::Vector3d pa = points.row(a);
  const Eigen::Vector3d pb = points.row(b);
  const Eigen::Vector3d pc = points.row(c);
  return (pb - pa).cross(pc - pa);
}

// The first corner from which every triangle of the fan faces as the polygon
// as a whole does, so that no triangle of a concave polygon folds over; 0 if
// there is none. Corners beyond the first few are not tried: a fan of a polygon
// that large is a guess in any case, and the search is quadratic.
std::size_t FanCorner(const Points& points, const PolygonCorners& corners) {
  constexpr std::size_t kTried = 64;
  const std::size_t size = corners.size();
  Eigen::Vector3d whole = Eigen::Vector3d::Zero();
  for (std::size_t i = 1; i + 1 < size; ++i) {
    whole += Normal(points, corners[0], corners[i], corners[i + 1]);
  }
  for (std::size_t first = 0; first < std::min(size, kTried); ++first) {
    bool sees_all = true;
    for (std::size_t i = 1; sees_all && i + 1 < size; ++i) {
      sees_all = Normal(points,
                        corners[first],
                        corners[(first + i) % size],
                        corners[(first + i + 1) % size])
                     .dot(whole) > 0;
    }
    if (sees_all) return first;
  }
  return 0;
}

void AppendFan(const Points& points,
               const PolygonCorners& corners,
               std::vector<int>* triangles) {
  const std::size_t size = corners.size();
  const std::size_t first = size == 3 ? 0 : FanCorner(points, corners);
  for (std::size_t i = 1; i + 1 < size; ++i) {
    for (const std::size_t k : {first, first + i, first + i + 1}) {
      triangles->push_back(static_cast<int>(corners[k % size]));
    }
  }
}

void AppendStrip(const PolygonCorners& corners, std::vector<int>* triangles) {
  for (Eigen::Index i = 0; i + 2 < corners.size(); ++i) {
    const auto a = static_cast<int>(corners[i + i % 2]);
    const auto b = static_cast<int>(corners[i + 1 - i % 2]);
    const auto c = static_cast<int>(corners[i + 2]);
    // Repeated corners only steer the strip; they are no faces.
    if (a == b || b == c || c == a) continue;
    triangles->insert(triangles->end(), {a, b, c});
  }
}

}  // namespace

SoupBuilder::SoupBuilder(std::string path,
                         int first_index,
                         const MeshLimits& limits)
    : path_(std::move(path)), first_index_(first_index), limits_(limits) {}

void SoupBuilder::AddPoint(const Eigen::Vector3d& point, std::size_t line) {
  if (!point.allFinite()) {
    std::string text;
    for (const double x : {point.x(), point.y(), point.z()}) {
      text += text.empty() ? "(" : ", ";
      AppendReal(x, &text);
    }
    throw InputError(Where("vertex", num_points(), line),
                     "is at " + text + "), coordinates must be finite",
                     "repair the mesh where it was made and export it again");
  }
  if (num_points() == limits_.vertices) {
    ThrowTooLarge(limits_.vertices, "vertices");
  }
  points_.insert(points_.end(), point.data(), point.data() + 3);
}

void SoupBuilder::AddPolygon(const std::vector<std::int64_t>& corners,
                             std::size_t line) {
  AddFace(corners, line, false);
}

void SoupBuilder::AddStrip(const std::vector<std::int64_t>& corners,
                           std::size_t line) {
  AddFace(corners, line, true);
}

void SoupBuilder::AddFace(const std::vector<std::int64_t>& corners,
                          std::size_t line,
                          bool is_strip) {
  if (corners.size() < 3) {
    throw InputError(
        Where("face", num_faces(), line),
        "has " + std::to_string(corners.size()) + " corners, at least 3 needed",
        "remove edges and points from the mesh and export it again");
  }
  if (num_faces() == limits_.faces) ThrowTooLarge(limits_.faces, "faces");
  corners_.insert(corners_.end(), corners.begin(), corners.end());
  faces_.push_back({corners_.size(), line, is_strip});
}

void SoupBuilder::ThrowTooLarge(std::int64_t most, const char* what) const {
  throw InputError(path_,
                   "has more than " + std::to_string(most) + " " + what,
                   "simplify the mesh");
}

std::string SoupBuilder::Where(const char* element,
                               std::int64_t index,
                               std::size_t line) const {
  std::string where = path_ + ": ";
  if (line > 0) where += "line " + std::to_string(line) + ", ";
  return where + element + " " + std::to_string(index + first_index_);
}

void SoupBuilder::CheckCorners() const {
  std::size_t corner = 0;
  for (std::size_t f = 0; f < faces_.size(); ++f) {
    for (; corner < faces_[f].end; ++corner) {
      const std::int64_t vertex = corners_[corner];
      if (vertex >= 0 && vertex < num_points()) continue;
      throw InputError(Where("face", f, faces_[f].line),
                       "names vertex " + std::to_string(vertex + first_index_) +
                           ", the file has " + std::to_string(num_points()) +
                           " vertices, numbered from " +
                           std::to_string(first_index_),
                       kExportAgain);
    }
  }
}

TriangleSoup SoupBuilder::Build(std::vector<int>* face_of_triangle) const {
  CheckCorners();
  TriangleSoup soup;
  soup.points = Eigen::Map<const Points>(points_.data(), points_.size() / 3, 3);
  std::vector<int> triangles;
  triangles.reserve(3 * faces_.size());
  if (face_of_triangle) face_of_triangle->clear();
  std::size_t begin = 0;
  for (std::size_t f = 0; f < faces_.size(); ++f) {
    const Face& face = faces_[f];
    const PolygonCorners corners(corners_.data() + begin, face.end - begin);
    if (face.is_strip) {
      AppendStrip(corners, &triangles);
    } else {
      AppendFan(soup.points, corners, &triangles);
    }
    begin = face.end;
    if (face_of_triangle) {
      face_of_triangle->resize(triangles.size() / 3, static_cast<int>(f));
    }
  }
  if (triangles.empty()) {
    throw InputError(
        path_,
        "has no faces (" + std::to_string(num_points()) + " vertices)",
        "export the surface as a triangle mesh");
  }
  soup.triangles =
      Eigen::Map<const Triangles>(triangles.data(), triangles.size() / 3, 3);
  return soup;
}

}  // namespace musclewarp
