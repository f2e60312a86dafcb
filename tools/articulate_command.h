// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <ostream>
#include <string>
#include <vector>

#include "musclewarp/settings/articulation_settings.h"
#include "musclewarp/settings/label_settings.h"
#include "musclewarp/settings/thread_settings.h"

namespace musclewarp {

// The settings that musclewarp-articulate has in addition to those of labels
// and joints.
struct SkeletonSettings {
  std::string out;
  std::string muscles;
  std::string motion;
  bool html = false;
};

constexpr const char* HeadingOf(Described<SkeletonSettings>) {
  return "Files of the skeleton";
}

constexpr auto FieldsOf(Described<SkeletonSettings>) {
  using S = SkeletonSettings;
  return std::make_tuple(
      Field(&S::out, "out")
          .Text("folder for the model, the scene and the report")
          .Path(),
      Field(&S::muscles, "muscles")
          .Text("meshes of muscles for the scene; commas"),
      Field(&S::motion, "motion")
          .Text("coordinates that move together, in degrees: "
                "hip_flexion_r:-10:60:15 goes from -10 to 60 in 15 frames; "
                "commas; without it a motion of each coordinate is written, "
                "and the scene moves the first one by 30 degrees"),
      Field(&S::html, "html")
          .Text("also write joints.html, the bones and joints as one page to "
                "look at"));
}

// The settings of musclewarp-articulate.
struct ArticulateOptions : ArticulationSettings,
                           LabelSettings,
                           SkeletonSettings,
                           ThreadSettings {};

// Finds the joints of a skeleton on the shapes of its bones, and writes the
// input of musclewarp-deform: out/model.osim with its meshes in out/Geometry,
// out/motions/<name>.mot, and out/scene.json, which moves the muscles by the
// first motion. Also writes the report out/joints.json (docs/joints.md) and, if
// `options.html` is set, the page out/joints.html (joints_page.h).
//
// `files` are meshes of bones, whose names tell what they are (bone_names.h),
// and at most one label image, which may also contain muscles (subject.h). The
// meshes of its labels are written to out/meshes.
//
// Returns 0 if all joints are good or weak, and 1 if one failed. Throws
// InputError, before anything is written, if a file cannot be read, two meshes
// have the same name, an option is not allowed or no joint has a coordinate of
// the motion, and as Articulate() does.
int ArticulateCommand(const std::vector<std::string>& files,
                      const ArticulateOptions& options,
                      std::ostream& screen);

}  // namespace musclewarp
