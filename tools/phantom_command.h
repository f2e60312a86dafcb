// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <iosfwd>
#include <string>

#include "musclewarp/base/described.h"
#include "musclewarp/phantom/variation.h"

namespace musclewarp {

constexpr auto FieldsOf(Described<Variation>) {
  using S = Variation;
  return std::make_tuple(
      Field(&S::num_muscles, "num_muscles")
          .Text("number of muscles of the scene random; 0: drawn from the "
                "seed, 2 to 20")
          .Within(2, 32)
          .Or(0),
      Field(&S::num_vertices, "num_vertices")
          .Text("number of vertices of each muscle of the scene random, about; "
                "0: as the seed has it, at most some 4000")
          .Within(20, 1e6)
          .Or(0),
      Field(&S::num_poses, "num_poses")
          .Text("number of poses of the scene random; 1 is the last of the "
                "motion alone; 0: drawn from the seed, 3 to 5")
          .Within(1, 1e6)
          .Or(0),
      Field(&S::size, "size")
          .Text("factor of all lengths of the scene")
          .Within(1e-6, 1e6),
      Field(&S::offset, "offset", "mm")
          .Text("by how much the scene is moved along each axis, after it has "
                "its size")
          .Within(-1e9, 1e9));
}

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
