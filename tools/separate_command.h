// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <ostream>
#include <string>
#include <vector>

#include "musclewarp/motion/rest_remaking.h"

namespace musclewarp {

// What musclewarp-separate is asked for beside the files that may move; the
// fields are its flags.
struct SeparateOptions {
  std::string out;                 // folder for the results
  std::vector<std::string> bones;  // files of meshes that must not move
  double gap = 0.1;                // mm, that meshes keep at least

  // What happens to meshes that cannot be separated by moving their vertices.
  RemakeKind remake = RemakeKind::kAuto;
  std::vector<std::string> formats = {"ply"};  // of the meshes written
  bool json = false;         // if true, separation.json is written, too
  int threads = 0;           // 0: as many as OpenMP chooses
  bool is_terminal = false;  // true if the screen is a terminal
};

// Moves the vertices of meshes as little as it takes for no two of them to
// cross and for each to keep its volume. There are neither lines of action nor
// poses: the meshes are the muscles of a scene in its rest pose, which
// certified contact separates. Bones stay where they are. They are tested
// neither against each other nor with themselves.
//
// Meshes are named by the stems of their files, and are repaired first. All of
// them, bones too, are written to out/<name>.<format>, and tables of what
// crossed and what moved to `screen`. With `json`, out/separation.json has the
// same figures under the keys of report.json (docs/report.md).
//
// Returns 0 if the certificate of the result has no shortcomings
// (certificate/shortcomings.h; how far meshes move does not count), and 1 if it
// has, or if the program was interrupted (SIGINT, SIGTERM). Throws InputError,
// before anything is written, for files that cannot be read or repaired, two
// files of one name, options that are not allowed, results that would replace a
// file that was read, and meshes that cannot be separated.
int SeparateCommand(const std::vector<std::string>& files,
                    const SeparateOptions& options,
                    std::ostream& screen);

}  // namespace musclewarp
