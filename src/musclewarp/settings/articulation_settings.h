// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "musclewarp/base/described.h"
#include "musclewarp/joints/articulation.h"

namespace musclewarp {

// The settings of the search for the joints of a skeleton (Articulate).
struct ArticulationSettings {
  std::string side = "both";
  std::string joints;
  std::string zero = "anatomy";
  std::string axes = ArticulationOptions().axes;
  std::string given;
};

constexpr auto FieldsOf(Described<ArticulationSettings>) {
  using S = ArticulationSettings;
  return std::make_tuple(
      Field(&S::side, "side")
          .Text("where joints are found: right, left or both; one of them is "
                "also the side of bones of which nothing else tells it")
          .OneOf("right, left, both"),
      Field(&S::joints, "joints")
          .Text("hip, knee, patella, ankle, subtalar, shoulder, elbow, "
                "forearm; commas; without it all for which there are bones"),
      Field(&S::zero, "zero")
          .Text("pose in which coordinates are 0: anatomy (the frames of both "
                "bones are parallel) or scan (the pose of the scan)")
          .OneOf("anatomy, scan"),
      Field(&S::axes, "axes")
          .Text("where +x, +y and +z of the files point, such as LPS or ASR; "
                "none: not known"),
      Field(&S::given, "given")
          .Text("file of joints to take as they are, in the form of "
                "joints.json")
          .Path());
}

// Returns the options that the settings mean, with the joints of the file
// `given`. Throws InputError, naming the setting, for a value that is not
// allowed, and for a file that cannot be read.
ArticulationOptions OptionsOf(const ArticulationSettings& settings);

}  // namespace musclewarp
