// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <set>
#include <string>

#include "musclewarp/mesh/triangle_soup.h"
#include "musclewarp/preparation/prepared_scene.h"
#include "musclewarp/preparation/scene_meshes.h"

namespace musclewarp {

// What a muscle was before its mesh was reconstructed for the first time.
struct DeliveredMuscle {
  TriangleSoup mesh;               // after repair
  std::set<std::string> carriers;  // to which vertices of it were attached

  // How deep the centre of a triangle of it is in a bone or another muscle at
  // most, mm.
  double depth = 0;
};

// Returns a muscle of the scene, by its index, before it is reconstructed.
// `meshes`: those of the scene, in the rest pose.
DeliveredMuscle DeliveredMuscleOf(const PreparedScene& scene,
                                  const SceneMeshes& meshes,
                                  size_t muscle);

// Surfaces that are separated move by less than twice the depth of the muscle
// in other meshes, as what lies beyond a bone has to come back: neither is
// counted as lost. A triangle is gone if its centre is farther from the
// reconstructed surface than this and that, mm.
constexpr double kGoneBeyond = 3;

// Compares the reconstructed mesh of a muscle with the delivered one: all
// fields of SurfaceReconstruction but `reason`. A volume that has grown back
// hides a part that is gone, which its surface, extent and attachments tell.
SurfaceReconstruction LossOf(const DeliveredMuscle& delivered,
                             const PreparedMuscle& reconstructed);

// Returns by how much the points of one mesh reach farther along a line than
// those of another, at the end where it is more, mm: places beyond the ends of
// the line count along its first and last segment. `line`: #P x 3, two points
// at least; without any the axis along which `before` is longest.
double LostExtent(const Points& before, const Points& after, Points line);

}  // namespace musclewarp
