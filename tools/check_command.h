// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <ostream>
#include <string>
#include <vector>

namespace musclewarp {

// What musclewarp-check is asked for beside the files; the fields are its
// flags.
struct CheckOptions {
  std::string json;            // file to write the figures to; empty: none
  bool require_clean = false;  // crossing meshes make the result not usable
  double gap = 0;  // mm; meshes nearer than that make it not usable either
  double mm_per_unit = 1;  // of the files

  // Which meshes are bones, and may cross each other: names of files among
  // those given, without their extension, or more files.
  std::vector<std::string> bones;
  int threads = 0;  // 0: as many as OpenMP chooses
};

// Reports on mesh files as they are, without repair: size, defects, volume and
// self-intersections of each, and for every two of them the triangle pairs that
// cross (by an exact test), the vertices of one inside the other, how deep they
// are, and the smallest distance of meshes that are apart. A folder in `files`
// stands for all its meshes; that of a frame has the bones of the frame even if
// the run writes them once. What bones do with each other is reported, too, but
// does not make the result not usable: they stay where they are delivered.
// Returns an exit code. Throws InputError, before anything is written, for
// files that cannot be read and options that are not allowed.
int CheckCommand(const std::vector<std::string>& files,
                 const CheckOptions& options,
                 std::ostream& screen);

}  // namespace musclewarp
