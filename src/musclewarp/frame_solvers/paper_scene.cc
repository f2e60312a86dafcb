// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/frame_solvers/paper_scene.h"

#include <glog/logging.h>

#include <optional>
#include <string>
#include <utility>

#include "musclewarp/base/stopwatch.h"
#include "musclewarp/scene/line_targets.h"

namespace musclewarp {
namespace {

void AddShape(const std::string& name,
              TriangleSoup soup,
              unsigned seed,
              PaperScene::Shapes* shapes) {
  shapes->push_back(
      std::make_unique<const ContactShape>(name, std::move(soup), seed));
}

PaperContact ContactOf(const PreparedScene& scene,
                       const ScenePose& pose,
                       const PaperContactOptions& options,
                       const PaperScene::Shapes& muscle_shapes,
                       const PaperScene::Shapes& bone_shapes) {
  std::vector<ContactBody> muscles;
  for (const auto& shape : muscle_shapes) {
    muscles.push_back(ContactBody::Deformable(*shape, options.seed));
  }
  std::vector<ContactBody> bones;
  for (size_t i = 0; i < bone_shapes.size(); ++i) {
    bones.push_back(ContactBody::Obstacle(
        *bone_shapes[i], BodyTransform(pose, scene.bones[i].body)));
  }
  return PaperContact(options, std::move(muscles), std::move(bones));
}

bool LiesInside(const ContactShape& inner, const ContactShape& outer) {
  for (Eigen::Index v = 0; v < inner.rest.rows(); ++v) {
    if (!outer.rest_inside_test.Contains(inner.rest.row(v))) return false;
  }
  return inner.rest.rows() > 0;
}

void WarnOfPair(const ContactShape& a,
                const ContactShape& b,
                std::vector<std::string>* warnings) {
  if (a.rest.rows() == b.rest.rows() && a.rest == b.rest) {
    warnings->push_back(a.name + " and " + b.name +
                        " are the same mesh: nothing parts them");
  } else if (LiesInside(a, b)) {
    warnings->push_back(a.name + " lies inside " + b.name);
  } else if (LiesInside(b, a)) {
    warnings->push_back(b.name + " lies inside " + a.name);
  }
}

std::vector<std::string> ContactWarnings(const PaperScene& contact) {
  std::vector<std::string> warnings;
  for (size_t a = 0; a < contact.muscles.size(); ++a) {
    for (size_t b = a + 1; b < contact.muscles.size(); ++b) {
      WarnOfPair(*contact.muscles[a], *contact.muscles[b], &warnings);
    }
    for (const auto& bone : contact.bones) {
      WarnOfPair(*contact.muscles[a], *bone, &warnings);
    }
  }
  return warnings;
}

}  // namespace

bool PaperSceneOptions::IsValid(std::string* error) const {
  return group.IsValid(error) && bone_hull.IsValid(error);
}

PaperScene PreparePaperScene(const PreparedScene& scene,
                             const PaperSceneOptions& options) {
  const Stopwatch stopwatch;
  std::string error;
  CHECK(options.IsValid(&error)) << error;
  PaperScene contact;
  contact.options = options;
  const unsigned seed = options.group.paper.seed;
  const bool needs_hulls = options.group.level == ContactLevel::kCoarse;
  for (const PreparedMuscle& muscle : scene.muscles) {
    const MuscleModel& model = muscle.model;
    AddShape(model.name,
             {model.fine_rest, model.fine_triangles},
             seed,
             &contact.muscles);
    if (!needs_hulls) continue;
    AddShape(model.name,
             {model.coarse_rest, model.coarse_triangles},
             seed,
             &contact.muscle_hulls);
  }
  for (const PreparedBone& bone : scene.bones) {
    AddShape(bone.mesh.name, bone.rest, seed, &contact.bones);
    if (!needs_hulls) continue;
    AddShape(bone.mesh.name,
             OuterHull(bone.rest, options.bone_hull),
             seed,
             &contact.bone_hulls);
  }
  contact.warnings = ContactWarnings(contact);
  for (const std::string& warning : contact.warnings) LOG(WARNING) << warning;
  contact.wall_ms = stopwatch.Milliseconds();
  return contact;
}

GroupContact ContactInPose(const PreparedScene& scene,
                           const PaperScene& contact,
                           const ScenePose& pose) {
  const GroupContactOptions& options = contact.options.group;
  std::vector<const MuscleModel*> models;
  for (const PreparedMuscle& muscle : scene.muscles) {
    models.push_back(&muscle.model);
  }
  PaperContact fine =
      ContactOf(scene, pose, options.paper, contact.muscles, contact.bones);
  if (options.level == ContactLevel::kFine) {
    return GroupContact(
        options, std::move(models), std::move(fine), std::nullopt);
  }
  return GroupContact(
      options,
      std::move(models),
      ContactOf(
          scene, pose, options.paper, contact.muscle_hulls, contact.bone_hulls),
      std::move(fine));
}

}  // namespace musclewarp
