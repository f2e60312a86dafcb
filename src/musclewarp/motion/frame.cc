// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/motion/frame.h"

#include <memory>
#include <optional>
#include <utility>

#include "musclewarp/base/stopwatch.h"
#include "musclewarp/geometry/folded_triangles.h"
#include "musclewarp/mesh/measures.h"
#include "musclewarp/scene/line_targets.h"

namespace musclewarp {
namespace {

double PolylineLength(const Points& points) {
  const Eigen::Index segments = points.rows() - 1;
  return (points.bottomRows(segments) - points.topRows(segments))
      .rowwise()
      .norm()
      .sum();
}

MuscleFrame FrameOf(const MuscleModel& model,
                    const ScenePose& pose,
                    const MuscleState& state,
                    SolverSummary summary) {
  MuscleFrame frame;
  frame.solver = std::move(summary);
  frame.fine = FinePoints(model, state);
  frame.volume_ratio =
      SignedVolume(frame.fine, model.fine_triangles) / model.rest_volume;
  frame.max_displacement =
      (frame.fine - model.fine_rest).rowwise().norm().maxCoeff();
  frame.folded_triangles = static_cast<int>(
      FoldedTriangles(model.fine_rest, frame.fine, model.fine_triangles)
          .size());
  const std::vector<LineTarget> targets = LineTargets(model.lines, pose);
  for (size_t i = 0; i < targets.size(); ++i) {
    frame.line_lengths[model.lines[i].name] = PolylineLength(targets[i].points);
  }
  return frame;
}

SceneIntersections Intersect(const PreparedScene& scene,
                             const std::vector<const Points*>& muscles,
                             const std::vector<const Points*>& bones) {
  std::vector<std::unique_ptr<SearchableMesh>> meshes;
  const auto add = [&](const std::string& name,
                       const Points& points,
                       const Triangles& triangles) {
    meshes.push_back(
        std::make_unique<SearchableMesh>(TriangleSoup{points, triangles}));
    return NamedMesh{name, meshes.back().get()};
  };
  std::vector<NamedMesh> named_muscles;
  for (size_t i = 0; i < muscles.size(); ++i) {
    const MuscleModel& model = scene.muscles[i].model;
    named_muscles.push_back(add(model.name, *muscles[i], model.fine_triangles));
  }
  std::vector<NamedMesh> named_bones;
  for (size_t i = 0; i < bones.size(); ++i) {
    named_bones.push_back(add(
        scene.bones[i].mesh.name, *bones[i], scene.bones[i].rest.triangles));
  }
  return IntersectScene(named_muscles, named_bones);
}

}  // namespace

int Frame::iterations() const {
  int sum = 0;
  for (const MuscleFrame& muscle : muscles) sum += muscle.solver.iterations;
  return sum;
}

std::string Frame::stop_reason(const PreparedScene& scene) const {
  for (size_t i = 0; i < muscles.size(); ++i) {
    if (muscles[i].solver.stop_reason == StopReason::kConverged) continue;
    return ToString(muscles[i].solver.stop_reason) + " (" +
           scene.muscles[i].model.name + ")";
  }
  return ToString(StopReason::kConverged);
}

bool Frame::IsUsable() const {
  for (const MuscleFrame& muscle : muscles) {
    if (!muscle.solver.IsSolutionUsable()) return false;
  }
  return true;
}

Frame SolveFrame(const PreparedScene& scene,
                 const SceneContact* contact,
                 int index,
                 const PreRotationOptions& pre_rotation,
                 const GroupSolver& solver) {
  const Stopwatch moving;
  Frame frame;
  frame.index = index;
  frame.pose = &scene.scene.poses[index];
  const ScenePose& pose = *frame.pose;
  std::vector<const MuscleModel*> models;
  std::vector<MuscleTarget> targets;
  std::vector<MuscleState> states;
  for (const PreparedMuscle& muscle : scene.muscles) {
    models.push_back(&muscle.model);
    targets.push_back(TargetOf(muscle.model, pose, pre_rotation));
    MuscleState start;
    start.coarse = contact
                       ? UnconstrainedMinimizer(muscle.model, targets.back())
                       : muscle.model.coarse_rest;
    states.push_back(std::move(start));
  }
  std::optional<GroupContact> group_contact;
  if (contact) group_contact = ContactInPose(scene, *contact, pose);
  std::vector<SolverSummary> summaries;
  const Stopwatch solving;
  solver(models,
         targets,
         group_contact ? &*group_contact : nullptr,
         &states,
         &summaries);
  frame.solve_ms = solving.Milliseconds();
  for (const PreparedBone& bone : scene.bones) {
    frame.bones.push_back(
        Transformed(bone.rest.points, BodyTransform(pose, bone.body)));
  }
  frame.wall_ms = moving.Milliseconds();

  const Stopwatch certifying;
  std::vector<const Points*> muscles;
  std::vector<const Points*> bones;
  for (size_t i = 0; i < models.size(); ++i) {
    frame.muscles.push_back(
        FrameOf(*models[i], pose, states[i], std::move(summaries[i])));
  }
  for (const MuscleFrame& muscle : frame.muscles) {
    muscles.push_back(&muscle.fine);
  }
  for (const Points& bone : frame.bones) bones.push_back(&bone);
  frame.intersections = Intersect(scene, muscles, bones);
  frame.certify_ms = certifying.Milliseconds();
  return frame;
}

SceneIntersections RestIntersections(const PreparedScene& scene) {
  std::vector<const Points*> muscles;
  std::vector<const Points*> bones;
  for (const auto& muscle : scene.muscles) {
    muscles.push_back(&muscle.model.fine_rest);
  }
  for (const auto& bone : scene.bones) bones.push_back(&bone.rest.points);
  return Intersect(scene, muscles, bones);
}

SceneIntersections RestIntersectionsAfterFix(const PreparedScene& scene,
                                             const SceneContact& contact) {
  GroupContact group_contact = ContactInPose(scene, contact, ScenePose());
  std::vector<MuscleState> states;
  for (const auto& muscle : scene.muscles) {
    states.push_back({muscle.model.coarse_rest, {}});
  }
  group_contact.Start(&states);
  std::vector<Points> fine;
  for (size_t i = 0; i < states.size(); ++i) {
    fine.push_back(FinePoints(scene.muscles[i].model, states[i]));
  }
  std::vector<const Points*> muscles;
  std::vector<const Points*> bones;
  for (const Points& points : fine) muscles.push_back(&points);
  for (const auto& bone : scene.bones) bones.push_back(&bone.rest.points);
  return Intersect(scene, muscles, bones);
}

}  // namespace musclewarp
