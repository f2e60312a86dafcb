// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/preparation/surroundings.h"

#include <algorithm>
#include <utility>

#include "musclewarp/anatomy/bone_names.h"

namespace musclewarp {

void Surroundings::AddBone(const std::string& name,
                           const std::string& body,
                           std::shared_ptr<const BoneTrees> bone) {
  bones_.push_back(Measured(BoneOfName(name, bone->mesh.soup())));
  bones_.back().bone.body = body;
  bone_trees_.push_back(std::move(bone));
  auto surface = std::find_if(
      bodies_.begin(), bodies_.end(), [&](const BodySurface& other) {
        return other.body == body;
      });
  if (surface == bodies_.end()) {
    bodies_.push_back({body, {}});
    surface = bodies_.end() - 1;
  }
  surface->bones.push_back(&bone_trees_.back()->mesh.bvh());
}

std::vector<const TriangleBvh*> Surroundings::SurfacesOfBones() const {
  std::vector<const TriangleBvh*> surfaces;
  for (const auto& trees : bone_trees_) surfaces.push_back(&trees->mesh.bvh());
  return surfaces;
}

void Surroundings::AddMuscle(const TriangleSoup& muscle) {
  meshes_.push_back(muscle);
  muscles_.push_back(
      std::make_unique<TriangleBvh>(muscle.points, muscle.triangles));
}

std::vector<const TriangleBvh*> Surroundings::MusclesBeside(int muscle) const {
  std::vector<const TriangleBvh*> others;
  for (size_t m = 0; m < muscles_.size(); ++m) {
    if (static_cast<int>(m) != muscle) others.push_back(muscles_[m].get());
  }
  return others;
}

std::vector<BodySurface> Surroundings::BodiesOf(
    const SceneMuscle& muscle) const {
  if (muscle.end_bodies.empty()) return bodies_;
  std::vector<BodySurface> ends;
  for (const std::string& name : muscle.end_bodies) {
    for (const BodySurface& body : bodies_) {
      if (body.body == name) ends.push_back(body);
    }
  }
  return ends;
}

}  // namespace musclewarp
