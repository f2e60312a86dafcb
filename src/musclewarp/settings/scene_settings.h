// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "musclewarp/base/described.h"
#include "musclewarp/scene/model_sources.h"

namespace musclewarp {

// The settings of a scene that is read from a file: the poses to compute, and
// replacements for what the file says.
struct SceneSettings {
  std::string scene;
  std::string data_root;
  std::string frames = "all";
  std::string motion;
  std::string motion_in_degrees;
  std::string geometry;
};

constexpr auto FieldsOf(Described<SceneSettings>) {
  using S = SceneSettings;
  // The paths have no effect on results: the record of a run has a hash of the
  // contents of the files.
  return std::make_tuple(
      Field(&S::scene, "scene")
          .Text("scene file (JSON)")
          .Path()
          .Changes(Effect::kNothing),
      Field(&S::data_root, "data_root")
          .Text("folder that the paths in the scene are relative to; without "
                "it the folder of the scene file")
          .Path()
          .Changes(Effect::kNothing),
      Field(&S::frames, "frames")
          .Text(
              "poses to compute: all, last, N, FIRST:LAST, FIRST:LAST:STEP "
              "(LAST included) or PART/PARTS (3/8: the third of eight parts); "
              "FIRST and LAST may be times: 0.1s:0.35s")
          .Changes(Effect::kFiles),
      Field(&S::motion, "motion")
          .Text("OpenSim motion (.mot, .sto) in place of the one the scene "
                "names")
          .Path()
          .Changes(Effect::kNothing),
      Field(&S::motion_in_degrees, "motion_in_degrees")
          .Text("whether angles of the motion are in degrees, for files whose "
                "header does not say so: yes or no"),
      Field(&S::geometry, "geometry")
          .Text("folders with meshes of the model, with commas, beside its own "
                "and the folder Geometry there")
          .Path()
          .Changes(Effect::kNothing));
}

// Returns what the settings say of the model of a scene. Throws InputError,
// naming the setting, for a value that is not allowed and for a folder of
// `geometry` that does not exist.
ModelSources OptionsOf(const SceneSettings& settings);

}  // namespace musclewarp
