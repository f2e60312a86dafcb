// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <iosfwd>
#include <string>

#include "musclewarp/base/described.h"
#include "musclewarp/phantom/variation.h"

namespace musclewarp {

// The settings of musclewarp-phantom.
struct PhantomRequest : Variation {
  std::string out;
  std::string scene = "hip";  // one of PhantomSceneNames()
  uint32_t seed = 1;
};

constexpr auto FieldsOf(Described<PhantomRequest>) {
  using S = PhantomRequest;
  return std::make_tuple(
      Field(&S::out, "out").Text("folder to write to; made if need be").Path(),
      Field(&S::scene, "scene")
          .Text("which scene: hip, or one that is hard on contact: "
                "stress_attachment, stress_edge, stress_plate, "
                "stress_resolution, stress_sheet, stress_sweep, or random, an "
                "anatomy that is drawn from the seed"),
      Field(&S::seed, "seed")
          .Text("places of the planted defects and bumps of the surfaces; in "
                "the scene random everything"),
      Inherited<Variation>());
}

// Writes the scene, and lists its meshes and their defects on `log`. Throws
// InputError, which names the flag or the file.
void MakePhantom(const PhantomRequest& request, std::ostream& log);

}  // namespace musclewarp
