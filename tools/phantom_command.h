// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <iosfwd>
#include <string>

namespace musclewarp {

// What musclewarp-phantom is asked for; the fields are its flags.
struct PhantomRequest {
  std::string out;            // the folder to write to, made if needed
  std::string scene = "hip";  // one of PhantomSceneNames()
  uint32_t seed = 1;    // of defects and bumps, and of all in a random scene
  int num_muscles = 0;  // of a random scene; 0: drawn from the seed
};

// Writes the scene and says on `log` what its meshes are and which defects they
// have. Throws InputError that names the flag or the file.
void MakePhantom(const PhantomRequest& request, std::ostream& log);

}  // namespace musclewarp
