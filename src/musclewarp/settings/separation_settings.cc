// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/settings/separation_settings.h"

#include "musclewarp/settings/checked_settings.h"

namespace musclewarp {

RestSeparationOptions OptionsOf(const SeparationSettings& settings) {
  CheckSettings(settings);
  RestSeparationOptions options = MeshSeparationOptions();
  SetOptions(settings,
             &options.prepare,
             &options.contact,
             &options.requirements,
             &options.reconstruction);
  options.requirements.displacement_allowance = settings.max_move;
  return options;
}

}  // namespace musclewarp
