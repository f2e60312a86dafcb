// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/settings/articulation_settings.h"

#include "musclewarp/anatomy/bone_names.h"
#include "musclewarp/base/near_name.h"
#include "musclewarp/base/short_list.h"
#include "musclewarp/base/text.h"
#include "musclewarp/geometry/view.h"
#include "musclewarp/joints/joint_table.h"
#include "musclewarp/joints/joints_file.h"
#include "musclewarp/scene/scene_names.h"
#include "musclewarp/settings/checked_settings.h"

namespace musclewarp {
namespace {

JointKind JointNamed(const std::string& name) {
  std::vector<std::string> known;
  for (const JointKind kind : AllJointKinds()) {
    if (ToString(kind) == name) return kind;
    known.push_back(ToString(kind));
  }
  throw InputError(
      "{joints}",
      "has " + QuotedName(name) + ", which is no joint",
      DidYouMean(name, known) + "allowed: " + ShortList(known, known.size()));
}

}  // namespace

ArticulationOptions OptionsOf(const ArticulationSettings& settings) {
  CheckSettings(settings);
  ArticulationOptions options;
  for (const std::string& joint : Split(settings.joints, ',')) {
    options.joints.push_back(JointNamed(joint));
  }
  if (settings.side != "both") options.side = ParseSide(settings.side);
  if (settings.zero == "scan") options.zero = ZeroPose::kScan;
  options.axes = settings.axes == "none" ? "" : settings.axes;
  if (!options.axes.empty() && !AreBodyAxes(options.axes)) {
    throw InputError("{axes}=" + options.axes,
                     "does not say where +x, +y and +z point",
                     "allowed: one letter each out of L or R, A or P, S or I, "
                     "such as LPS, or none");
  }
  if (!options.axes.empty() && !AreRightHanded(options.axes)) {
    throw InputError(
        "{axes}=" + options.axes,
        "is a left-handed frame, which shows bodies as in a mirror "
        "and turns joints the other way",
        "mirror the meshes, and give a right-handed frame such as "
        "LPS");
  }
  if (!settings.given.empty()) options.given = ReadJoints(settings.given);
  return options;
}

}  // namespace musclewarp
