// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "certified_contact/contact_group.h"

#include <memory>
#include <utility>

#include "musclewarp/certified_contact/bone_planes.h"
#include "musclewarp/mesh/measures.h"
#include "musclewarp/mesh/transformed.h"
#include "musclewarp/proximity/mesh_intersection.h"

namespace musclewarp {

ContactGroup::ContactGroup(std::vector<TriangleSoup> muscles,
                           std::vector<TriangleSoup> bones)
    : soups(std::move(muscles)), bone_soups(std::move(bones)) {
  for (const TriangleSoup& soup : soups) {
    scene.muscles.push_back(
        MakeMuscleSurface(soup.points,
                          soup.triangles,
                          SignedVolume(soup.points, soup.triangles)));
    state.points.push_back(soup.points);
  }
  state.targets = state.points;
  for (const TriangleSoup& soup : bone_soups) {
    scene.bones.push_back(
        std::make_shared<TriangleBvh>(soup.points, soup.triangles));
    state.bones_from_rest.push_back(Eigen::Matrix4d::Identity());
  }
}

StepSummary ContactGroup::StepTo(const ContactState& next,
                                 const StepOptions& options) {
  StepResult result = Step(options, scene, state, {next});
  if (!result.summary.defects.HasCrossings()) state = std::move(result.state);
  return result.summary;
}

int ContactGroup::CrossingPairs() const {
  size_t count = 0;
  for (size_t i = 0; i < soups.size(); ++i) {
    const TriangleBvh mine(state.points[i], soups[i].triangles);
    for (size_t j = i + 1; j < soups.size(); ++j) {
      count += IntersectingTriangles(
                   mine, TriangleBvh(state.points[j], soups[j].triangles))
                   .size();
    }
    for (size_t b = 0; b < bone_soups.size(); ++b) {
      const Points moved =
          Transformed(bone_soups[b].points, state.bones_from_rest[b]);
      count += IntersectingTriangles(
                   mine, TriangleBvh(moved, bone_soups[b].triangles))
                   .size();
    }
  }
  return static_cast<int>(count);
}

double ContactGroup::VolumeError(size_t muscle) const {
  return SignedVolume(state.points[muscle], soups[muscle].triangles) /
             scene.muscles[muscle].volume -
         1;
}

std::vector<SeparatingPlane> AllPlanes(const StepOptions& options,
                                       const ContactStep& step) {
  const std::vector<TriangleBvh> trees = PredictedTrees(step);
  KeptBonePlanes kept;
  std::vector<SeparatingPlane> planes =
      FindPlanesBetweenMuscles(options, step, trees);
  const std::vector<SeparatingPlane> of_bones =
      FindPlanesOfBones(options, step, &kept);
  planes.insert(planes.end(), of_bones.begin(), of_bones.end());
  return planes;
}

ContactGroup SpheresOverABone() {
  return ContactGroup(
      {SphereAt({0, 0, 10.5}, 10, 3), SphereAt({20.5, 0, 10.5}, 10, 3)},
      {MovedBy(Box(60, 40, 5), {10, 0, -2.5})});
}

}  // namespace musclewarp
