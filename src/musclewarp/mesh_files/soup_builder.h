// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "musclewarp/mesh/triangle_soup.h"

namespace musclewarp {

// The largest mesh that is read. What segmentation gives is far below; a file
// of more is damaged, or packed by someone who means harm.
struct MeshLimits {
  std::int64_t vertices = 5000000;
  std::int64_t faces = 10000000;
};

// Collects the points and faces that a reader finds in a mesh file, checks
// them, and makes triangles of them, so that all formats have the same checks
// and messages. Checked are: points are finite, a face has at least three
// corners, its corners exist, there is at least one face, and no more vertices
// and faces than are allowed. Each failure is an InputError that names the
// vertex or face, counted as the file counts, and its line if the file has
// lines.
//
//   SoupBuilder builder(path);
//   builder.AddPoint({0, 0, 1.5}, cursor.line());
//   ...
//   builder.AddPolygon({0, 1, 2, 3}, cursor.line());
//   return builder.Build();
class SoupBuilder {
 public:
  // `path` is the file, for messages. `first_index` is the number that the
  // format gives to the first vertex and the first face.
  explicit SoupBuilder(std::string path,
                       int first_index = 0,
                       const MeshLimits& limits = {});

  // Adds a point, mm. `line` is the line of the file, 0 for binary files.
  void AddPoint(const Eigen::Vector3d& point, std::size_t line = 0);

  // Adds a face with three corners or more, counted from 0 whatever
  // `first_index` is. Corners may name points that are added later.
  void AddPolygon(const std::vector<std::int64_t>& corners,
                  std::size_t line = 0);

  // Adds a triangle strip: every corner from the third on makes a triangle with
  // the two corners before it, and every second triangle is turned round so
  // that all face the same way. Triangles with a repeated corner are left out:
  // writers use them to steer a strip.
  void AddStrip(const std::vector<std::int64_t>& corners, std::size_t line = 0);

  std::int64_t num_points() const { return points_.size() / 3; }
  std::int64_t num_faces() const { return faces_.size(); }

  // Returns the points in the order they were added, and the triangles of the
  // faces in that order. A polygon becomes a fan around the first of its
  // corners from which all triangles face the same way, so that a concave
  // polygon does not fold over; around its first corner if there is none.
  // `face_of_triangle`, unless null, is set to the face of each triangle,
  // counted from 0.
  TriangleSoup Build(std::vector<int>* face_of_triangle = nullptr) const;

 private:
  struct Face {
    std::size_t end;  // in corners_, behind the last corner
    std::size_t line;
    bool is_strip;
  };

  void AddFace(const std::vector<std::int64_t>& corners,
               std::size_t line,
               bool is_strip);
  [[noreturn]] void ThrowTooLarge(std::int64_t most, const char* what) const;
  std::string Where(const char* element,
                    std::int64_t index,
                    std::size_t line) const;
  void CheckCorners() const;

  std::string path_;
  int first_index_;
  MeshLimits limits_;
  std::vector<double> points_;
  std::vector<std::int64_t> corners_;
  std::vector<Face> faces_;
};

}  // namespace musclewarp
