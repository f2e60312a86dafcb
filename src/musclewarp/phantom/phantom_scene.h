// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "musclewarp/mesh/triangle_soup.h"
#include "musclewarp/phantom/planted_defects.h"
#include "musclewarp/phantom/variation.h"
#include "musclewarp/scene/scene.h"

namespace musclewarp {

// Made-up scenes: musculoskeletal data that may be given to anybody, with known
// shapes and defects, for the demo and the tests. All of it is computed, and
// comes out with the same bytes on every machine.

// The mesh of a muscle or bone, before and after it was damaged.
struct PhantomMesh {
  std::string name;
  // The true surface: a closed 2-manifold, outward oriented.
  TriangleSoup surface;
  PlantedDefects defects;
  // The surface with the defects: what is written to the file.
  TriangleSoup delivered;
};

// A scene: what the scene file says, and the meshes it names. Paths in `scene`
// are relative to the folder that it will be written to.
struct PhantomScene {
  Scene scene;
  // The meshes of the muscles, then those of the bones, in the order of
  // `scene`.
  std::vector<PhantomMesh> meshes;
  // The same scene for OpenSim, a model (.osim) and a motion (.mot); "" if
  // there is none.
  std::string model_text;
  std::string motion_text;
};

// Returns the names of all scenes, "hip" first.
std::vector<std::string> PhantomSceneNames();

// Makes the scene of that name. The seed decides on bumps and places of
// defects, and on everything in the scene "random" (see MakeRandomScene).
//
// Throws InputError that lists the known names for any other, and InputError
// that names the flag for a value of `variation` that the scene cannot have.
// Precondition: its values are in the ranges of their fields.
PhantomScene MakePhantomScene(const std::string& name,
                              uint32_t seed,
                              const Variation& variation = {});

// Writes a scene to a folder, which is made if need be: scene.json, a .ply file
// for each mesh, and if the scene has a model, NAME.osim, NAME.mot and
// motion.json, a scene file that uses them. Throws InputError if the folder
// cannot be written.
void WritePhantomScene(const PhantomScene& scene, const std::string& dir);

}  // namespace musclewarp
