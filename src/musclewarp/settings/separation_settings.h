// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "musclewarp/deformer/mesh_separation.h"
#include "musclewarp/settings/rest_settings.h"

namespace musclewarp {

// The settings of a separation of meshes without a motion (SeparateMeshes).
struct SeparationSettings : RestSettings {
  double max_move = MeshSeparationOptions().requirements.displacement_allowance;
};

constexpr auto FieldsOf(Described<SeparationSettings>) {
  using S = SeparationSettings;
  return std::make_tuple(
      Inherited<RestSettings>(),
      Field(&S::max_move, "max_move", "mm")
          .Text("how far a vertex may move beyond twice the depth of its mesh "
                "in others and what the meshes that push it add; with more the "
                "result is not usable")
          .AtLeast(0));
}

// Returns the options that the settings mean. Throws InputError, naming the
// setting, for a value that is not allowed.
RestSeparationOptions OptionsOf(const SeparationSettings& settings);

}  // namespace musclewarp
