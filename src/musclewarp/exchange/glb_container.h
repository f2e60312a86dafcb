// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "musclewarp/mesh/triangle_soup.h"

namespace musclewarp {

// The arrays of a binary glTF 2.0 file (.glb) while they are collected. They go
// to a file at once, so that memory does not grow with their number. Each Add
// returns the number of the accessor of an array.
class GlbArrays {
 public:
  // `path` is that of the file in which arrays wait until WriteGlb; it is
  // removed by the destructor.
  explicit GlbArrays(const std::string& path);
  ~GlbArrays();
  GlbArrays(const GlbArrays&) = delete;
  GlbArrays& operator=(const GlbArrays&) = delete;

  // Vectors of 1, 3 or 4 float numbers, a row each. `is_vertex_data` is true of
  // what the vertices of a mesh have; `has_bounds` says whether the least and
  // the largest numbers are recorded, which positions and times need.
  int AddFloats(const Eigen::MatrixXf& values,
                bool is_vertex_data,
                bool has_bounds);

  int AddTriangles(const Triangles& triangles);

  // Writes the file: the rest of its JSON, to which buffers, views and
  // accessors are added here, and the arrays. Throws InputError if the arrays
  // have more than 4 GB, which is the limit of the format, or the disk is full;
  // the messages name `path_for_messages`.
  void WriteGlb(const std::string& path,
                const std::string& path_for_messages,
                nlohmann::ordered_json json);

 private:
  int AddAccessor(const void* data,
                  std::size_t bytes,
                  int target,
                  nlohmann::ordered_json accessor);

  std::string path_;
  std::ofstream file_;
  std::uint64_t size_ = 0;
  nlohmann::ordered_json views_ = nlohmann::ordered_json::array();
  nlohmann::ordered_json accessors_ = nlohmann::ordered_json::array();
};

}  // namespace musclewarp
