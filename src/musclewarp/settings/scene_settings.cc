// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/settings/scene_settings.h"

#include <filesystem>

#include "musclewarp/base/input_error.h"
#include "musclewarp/base/text.h"

namespace musclewarp {

ModelSources OptionsOf(const SceneSettings& settings) {
  ModelSources sources;
  sources.motion = settings.motion;
  sources.geometry = Split(settings.geometry, ',');
  for (const std::string& folder : sources.geometry) {
    if (std::filesystem::is_directory(folder)) continue;
    throw InputError("{geometry}=" + settings.geometry,
                     "\"" + folder + "\" is not a folder",
                     "give folders that exist, with commas between them");
  }
  const std::string& in_degrees = settings.motion_in_degrees;
  if (in_degrees == "yes" || in_degrees == "true") {
    sources.motion_in_degrees = true;
  } else if (in_degrees == "no" || in_degrees == "false") {
    sources.motion_in_degrees = false;
  } else if (!in_degrees.empty()) {
    throw InputError("{motion_in_degrees}=" + in_degrees,
                     "is no answer",
                     "allowed: yes, no");
  }
  return sources;
}

}  // namespace musclewarp
