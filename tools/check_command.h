// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <ostream>
#include <string>
#include <vector>

#include "musclewarp/settings/label_settings.h"
#include "musclewarp/settings/thread_settings.h"

namespace musclewarp {

// The settings of musclewarp-check.
struct CheckOptions : UnitSettings, ThreadSettings {
  std::string json;
  bool require_clean = false;
  double gap = 0;
  std::string bone;
};

constexpr auto FieldsOf(Described<CheckOptions>) {
  using S = CheckOptions;
  return std::make_tuple(
      Field(&S::json, "json").Text("file to write all figures to").Path(),
      Field(&S::require_clean, "require_clean")
          .Text("exit with 1 if any two meshes cross or contain each other"),
      Field(&S::gap, "gap", "mm")
          .Text("exit with 1 if any two meshes are nearer to each other")
          .AtLeast(0),
      Field(&S::bone, "bone")
          .Text("which meshes are bones, commas: names of the files given, "
                "without extension, or more files; that two bones cross, or "
                "are near each other, does not change the exit code"),
      Inherited<UnitSettings>(),
      Inherited<ThreadSettings>());
}

// Reports on mesh files without repairing them: size, defects, volume and
// self-intersections of each, and for every two of them the triangle pairs that
// cross (by an exact test), the vertices of one inside the other and their
// depth, or the smallest distance of meshes that are apart. A folder in `files`
// stands for all its meshes; the folder of a frame also has the bones of the
// frame if the run wrote them only once. Crossings of two bones are reported,
// but do not make the result unusable, as bones do not move. Returns an exit
// code. Throws InputError, before anything is written, for files that cannot be
// read and options that are not allowed.
int CheckCommand(const std::vector<std::string>& files,
                 const CheckOptions& options,
                 std::ostream& screen);

}  // namespace musclewarp
