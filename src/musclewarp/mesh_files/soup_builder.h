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

// Collects what a reader finds in a mesh file and checks it: finite points, at
// least three corners a face, at least one face, corners that are there.
// Each failure is an InputError that names the vertex or face, counted as the
// file counts, and its line where the file has lines.
class SoupBuilder {
 public:
  // first_index: the number the format gives the first vertex.
  explicit SoupBuilder(std::string path, int first_index = 0);

  // line: 0 for binary files.
  void AddPoint(const Eigen::Vector3d& point, std::size_t line = 0);

  // Corners counted from 0; they may name points that are added later.
  void AddPolygon(const std::vector<std::int64_t>& corners,
                  std::size_t line = 0);

  // A triangle strip: every corner from the third on makes a triangle with the
  // two before it, every other one turned round.
  void AddStrip(const std::vector<std::int64_t>& corners, std::size_t line = 0);

  std::int64_t num_points() const { return points_.size() / 3; }
  std::int64_t num_faces() const { return faces_.size(); }

  // Points in the order added. A polygon becomes the fan of its first corner
  // that sees all the others (its first corner, if there is none).
  TriangleSoup Build() const;

 private:
  struct Face {
    std::size_t end;  // In corners_, behind the last corner.
    std::size_t line;
    bool is_strip;
  };

  void AddFace(const std::vector<std::int64_t>& corners,
               std::size_t line,
               bool is_strip);
  std::string Where(const char* element,
                    std::int64_t index,
                    std::size_t line) const;
  void CheckCorners() const;

  std::string path_;
  int first_index_;
  std::vector<double> points_;
  std::vector<std::int64_t> corners_;
  std::vector<Face> faces_;
};

}  // namespace musclewarp
