// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "musclewarp/mesh/triangle_soup.h"
#include "musclewarp/phantom/planted_defects.h"
#include "musclewarp/scene/scene.h"

namespace musclewarp {

// The mesh of a muscle or bone.
struct PhantomMesh {
  std::string name;
  TriangleSoup surface;  // closed 2-manifold, outward oriented
  PlantedDefects defects;
  TriangleSoup delivered;  // the surface with the defects: what is written
};

// A made-up scene: what a scene file says, and the meshes it names. Paths in
// `scene` are relative to the folder it will be written to.
struct PhantomScene {
  Scene scene;
  std::vector<PhantomMesh> meshes;  // muscles, then bones, in their order
  // The same scene for OpenSim; "" if there is none.
  std::string model_text;   // .osim
  std::string motion_text;  // .mot
};

// Names that MakePhantomScene knows.
std::vector<std::string> PhantomSceneNames();

// The scene of that name; everything else depends on the seed only. Throws
// InputError for a name it does not know.
PhantomScene MakePhantomScene(const std::string& name, uint32_t seed);

// Writes DIR/scene.json and one .ply file a mesh, and for OpenSim NAME.osim,
// NAME.mot and motion.json, a scene by these; makes the folder if need be.
// Throws InputError if it cannot be written.
void WritePhantomScene(const PhantomScene& scene, const std::string& dir);

}  // namespace musclewarp
