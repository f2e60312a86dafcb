// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/mujoco/mjcf_slides.h"

#include <algorithm>
#include <string>
#include <utility>

#include "musclewarp/mesh/transformed.h"

namespace musclewarp {
namespace {

// The place of a body of the model in the tree; -1 for the ground.
int PlaceOf(const MjcfTree& tree, int body) {
  for (size_t i = 0; i < tree.bodies.size(); ++i) {
    if (tree.bodies[i].model_body == body) return static_cast<int>(i);
  }
  return -1;
}

// A name that no other body or joint has.
std::string NameOfSlide(const MjcfTree& tree) {
  const std::string prefix = "skin_slide_";
  const auto others = std::count_if(
      tree.bodies.begin(), tree.bodies.end(), [&](const MjcfBody& body) {
        return body.name.compare(0, prefix.size(), prefix) == 0;
      });
  return prefix + std::to_string(others + 1);
}

}  // namespace

void AddSlides(const SkinSlides& slides,
               const std::vector<Coordinate>& coordinates,
               int body,
               const Eigen::Matrix4d& body_from_rest,
               MjcfTree* tree,
               MjcfSkin* skin) {
  const int parent = PlaceOf(*tree, body);
  Eigen::MatrixXd& weights = skin->skin.weights;
  Eigen::Index column = weights.cols();
  weights.conservativeResize(
      Eigen::NoChange,
      column + static_cast<Eigen::Index>(slides.slides.size()));
  for (const SkinSlide& slide : slides.slides) {
    const Coordinate& of = coordinates[slide.coordinate];
    MjcfBody added;
    added.name = NameOfSlide(*tree);
    added.parent = parent;
    MjcfJoint joint;
    joint.name = added.name;
    joint.is_hinge = false;
    joint.axis = body_from_rest.topLeftCorner<3, 3>() * slide.direction;
    joint.anchor.setZero();
    MjcfCoupling coupling = {joint.name, of.name};
    double power = 1;
    for (size_t k = 0; k < slide.coefficients.size(); ++k) {
      coupling.coefficients[k] = kMetresPerMillimetre * slide.coefficients[k];
      joint.default_value += power * coupling.coefficients[k];
      power *= of.default_value;
    }
    added.joints.push_back(joint);
    tree->couplings.push_back(coupling);
    skin->bones.push_back({added.name, RigidInverse(body_from_rest)});
    tree->bodies.push_back(std::move(added));
    weights.col(slides.bone) -= slide.weights;
    weights.col(column++) = slide.weights;
  }
  skin->skin.mean_distance = slides.mean_distance;
  skin->skin.largest_distance = slides.largest_distance;
  skin->num_slides = static_cast<int>(slides.slides.size());
}

}  // namespace musclewarp
