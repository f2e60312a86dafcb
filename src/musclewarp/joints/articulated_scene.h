// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "musclewarp/joints/articulation.h"
#include "musclewarp/opensim/storage_table.h"

namespace musclewarp {

// The motion of a coordinate from one value to another, degrees.
struct CoordinateSweep {
  std::string coordinate;
  double from = 0, to = 0;
};

// Coordinates that move together, in a number of equally spaced frames.
struct JointMotion {
  std::string name;
  int frames = 15;
  std::vector<CoordinateSweep> sweeps;
};

// The most frames that a motion may have.
constexpr int kMostMotionFrames = 100000;

// Returns the names of the coordinates of all joints that were found, without
// those that follow others.
std::vector<std::string> CoordinateNames(const Articulation& articulation);

// Throws InputError, whose place is `where`, if a coordinate of a motion is not
// one of those.
void CheckCoordinates(const JointMotion& motion,
                      const Articulation& articulation,
                      const std::string& where);

// Returns a motion for each of these coordinates, through its usual range and
// named after it.
std::vector<JointMotion> MotionsOfRanges(const Articulation& articulation);

// Returns a motion for a first look: the first coordinate of the first joint
// that was found, from the pose of the scan on by 30 degrees. It has no sweeps
// if no joint was found.
JointMotion FirstMotion(const Articulation& articulation);

// Returns a motion as a table over time, from 0 to 1 s, in degrees.
StorageTable MotionTable(const JointMotion& motion);

// Returns the bodies of the origin and the insertion of a muscle, which are
// named by themselves or by bones that belong to them; none if both names are
// empty. Throws InputError, which begins with the name of the muscle, for one
// end only, or a body or bone that the articulation does not have.
std::vector<std::string> EndBodiesOf(const Articulation& articulation,
                                     const std::string& muscle,
                                     const std::string& origin,
                                     const std::string& insertion);

// A mesh file of a scene.
struct SceneMeshFile {
  std::string name;
  std::string file;  // relative to the scene file

  // Of a muscle: the bodies of its origin and its insertion, or bones that
  // belong to them; empty: those that are nearest to its mesh.
  std::string origin = {}, insertion = {};

  // Of a muscle: its volume before its mesh was made, mm^3; 0: that of the
  // mesh.
  double delivered_volume = 0;
};

// The parts of a scene beside the bones of its articulation.
struct ArticulatedSceneParts {
  std::string name;
  std::string units = "mm";  // of the mesh files
  std::string axes = "LPS";
  std::string model = "model.osim";  // relative to the scene file
  std::vector<SceneMeshFile> bones, muscles;
};

// Returns a scene file (docs/scene.md) in which `motion` moves the bones of an
// articulation. Muscles have no lines: the programs make them from the meshes.
// The rest pose is that of the scan, the defaults of the model. Throws
// InputError for a muscle that names one end only, or a body or bone that the
// articulation does not have. Precondition (CHECKed): every bone is in
// `parts.bones`, by name.
nlohmann::ordered_json ArticulatedSceneJson(const Articulation& articulation,
                                            const ArticulatedSceneParts& parts,
                                            const JointMotion& motion);

}  // namespace musclewarp
