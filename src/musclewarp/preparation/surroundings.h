// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "musclewarp/anatomy/measured_bone.h"
#include "musclewarp/fibres/muscle_ends.h"
#include "musclewarp/mesh/triangle_soup.h"
#include "musclewarp/preparation/bone_trees.h"
#include "musclewarp/proximity/triangle_bvh.h"
#include "musclewarp/scene/scene.h"

namespace musclewarp {

// The meshes to which the muscles of a scene may be attached in the rest pose:
// the bones, by body, and the other muscles. Meshes are copied; units are mm.
class Surroundings {
 public:
  void AddBone(const std::string& name,
               const std::string& body,
               std::shared_ptr<const BoneTrees> bone);
  void AddBone(const std::string& name,
               const std::string& body,
               const TriangleSoup& bone) {
    AddBone(name, body, std::make_shared<BoneTrees>(bone));
  }

  // Muscles are numbered in the order in which they are added.
  void AddMuscle(const TriangleSoup& muscle);

  // The bodies, ordered by their first bones.
  const std::vector<BodySurface>& bodies() const { return bodies_; }

  // The bodies on whose bones a muscle may end: those that it names, in their
  // order, or all. Precondition: the muscle passes CheckScene.
  std::vector<BodySurface> BodiesOf(const SceneMuscle& muscle) const;

  // The bones, in the order in which they were added.
  const std::vector<MeasuredBone>& bones() const { return bones_; }
  const TriangleBvh& surface_of_bone(size_t bone) const {
    return bone_trees_[bone]->mesh.bvh();
  }
  std::vector<const TriangleBvh*> SurfacesOfBones() const;

  const TriangleSoup& muscle(size_t muscle) const { return meshes_[muscle]; }
  const TriangleBvh& surface_of(size_t muscle) const {
    return *muscles_[muscle];
  }

  // Returns all muscles except the one with the index `muscle`.
  std::vector<const TriangleBvh*> MusclesBeside(int muscle) const;

 private:
  std::vector<MeasuredBone> bones_;
  std::vector<std::shared_ptr<const BoneTrees>> bone_trees_;
  std::vector<std::unique_ptr<TriangleBvh>> muscles_;
  std::vector<TriangleSoup> meshes_;  // of the muscles
  std::vector<BodySurface> bodies_;
};

}  // namespace musclewarp
