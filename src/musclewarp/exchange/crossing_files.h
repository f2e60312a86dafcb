// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "musclewarp/exchange/crossing_places.h"

namespace musclewarp {

// Writes what crosses in the frames of a run, or in a set of meshes, to a
// folder: triangles and curves to be loaded beside the meshes, whose
// coordinates they have, and a table of the places.
class CrossingFiles {
 public:
  // `format` is the extension of the files of triangles and curves: "ply",
  // "obj" or "vtp".
  CrossingFiles(const std::string& dir, const std::string& format);

  // Writes <label>_triangles.<format> and <label>_curves.<format>, and adds a
  // line to the table for each place. Without places only the table knows of
  // the frame. Meshes are numbered as in FindCrossingPlaces. Throws InputError
  // if the folder cannot be written.
  void Add(const std::string& label,
           const std::vector<NamedMesh>& meshes,
           const std::vector<CrossingPlace>& places);

  // Writes crossings.csv with the columns frame (its label), a, b, x_mm, y_mm,
  // z_mm, depth_mm, vertices_inside, triangles_of_a, triangles_of_b, curve_mm.
  void WriteTable() const;

 private:
  std::string dir_;
  std::string format_;
  std::string table_;
};

}  // namespace musclewarp
