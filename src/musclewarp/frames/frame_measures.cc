// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/frames/frame_measures.h"

#include <array>
#include <utility>

#include "musclewarp/base/stage_times.h"
#include "musclewarp/certificate/delivered_crossings.h"
#include "musclewarp/frames/bare_tendon_lines.h"
#include "musclewarp/frames/fibre_measures.h"
#include "musclewarp/frames/shape_measures.h"
#include "musclewarp/geometry/fine_map.h"
#include "musclewarp/geometry/folded_triangles.h"
#include "musclewarp/mesh/measures.h"
#include "musclewarp/mesh/transformed.h"
#include "musclewarp/scene/line_targets.h"
#include "musclewarp/scene/path_moment_arms.h"
#include "musclewarp/skeleton/polyline.h"

namespace musclewarp {
namespace {

// The lines and fibres that a muscle carries, and their lengths.
void AddLines(const PreparedMuscle& muscle,
              const Points& coarse,
              MuscleFrame* frame) {
  const MuscleModel& model = muscle.model;
  frame->lines = LinesAt(muscle.lines, coarse);
  for (size_t i = 0; i < model.lines.size(); ++i) {
    frame->line_lengths[model.lines[i].name] = PolylineLength(frame->lines[i]);
  }
  frame->fibres = LinesAt(muscle.fibres, coarse);
  if (frame->fibres.empty()) return;
  for (const Points& fibre : frame->fibres) {
    frame->fibre_lengths.push_back(PolylineLength(fibre));
  }
  const std::array<double, 5> fifths =
      StretchByFifths(LinesAt(muscle.fibres, model.coarse_rest), frame->fibres);
  frame->fibre_stretch_by_fifths.assign(fifths.begin(), fifths.end());
}

MuscleFrame FrameOf(const PreparedMuscle& muscle,
                    const SurfaceAtRest& rest,
                    const ScenePose& pose,
                    const Points& coarse,
                    const Points& fine,
                    const Points* before,
                    SolverSummary summary) {
  const MuscleModel& model = muscle.model;
  MuscleFrame frame;
  frame.name = model.name;
  frame.solver = std::move(summary);
  frame.points = fine;
  const double volume = SignedVolume(frame.points, model.fine_triangles);
  frame.volume_ratio = volume / muscle.mesh.delivered_volume;
  frame.volume = frame.volume_ratio * muscle.mesh.delivered_volume;
  frame.volume_error = volume / model.rest_volume - 1;
  frame.max_displacement =
      (frame.points - model.fine_rest).rowwise().norm().maxCoeff();
  frame.folded_triangles = static_cast<int>(
      FoldedTriangles(model.fine_rest, frame.points, model.fine_triangles)
          .size());
  frame.shape = MeasureShape(rest, frame.points, before ? *before : Points());
  frame.attachments = DriftOf(
      model.attachments,
      muscle.attached,
      AttachedPositions(model,
                        muscle.attached,
                        model.fine_rest(muscle.attached.vertices, Eigen::all),
                        pose),
      frame.points);
  AddLines(muscle, coarse, &frame);
  frame.bare_tendons = BareTendonLines(model.lines, &pose);
  const auto push = pose.pushes.find(model.name);
  if (push != pose.pushes.end()) {
    frame.max_bone_push = Product(model.fine_from_coarse, push->second)
                              .rowwise()
                              .norm()
                              .maxCoeff();
  }
  const std::vector<double> lengths = PathLengthsIn(pose, model.lines);
  for (size_t k = 0; k < lengths.size(); ++k) {
    frame.path_lengths[model.lines[k].name] = lengths[k];
  }
  return frame;
}

void AddBones(const PreparedScene& scene, const ScenePose& pose, Frame* frame) {
  for (const PreparedBone& bone : scene.bones) {
    const Eigen::Matrix4d from_rest = BodyTransform(pose, bone.body);
    frame->bones.push_back(Transformed(bone.rest.points, from_rest));
    frame->bones_from_rest.push_back(from_rest);
  }
}

// Returns what only the delivered bones have, in the pose of a frame.
std::vector<DeliveredOnly> DeliveredOnlyIn(const PreparedScene& scene,
                                           const Frame& frame) {
  std::vector<DeliveredOnly> delivered;
  for (size_t i = 0; i < scene.bones.size(); ++i) {
    const TriangleSoup& rest = scene.bones[i].delivered_only;
    delivered.push_back(
        {scene.bones[i].mesh.name,
         {Transformed(rest.points, frame.bones_from_rest[i]), rest.triangles}});
  }
  return delivered;
}

// Counts intersections and measures gaps.
void AddIntersections(const PreparedScene& scene,
                      const MeasureOptions& options,
                      SceneMeshes* meshes,
                      Frame* frame) {
  std::vector<Points> muscles;
  for (const MuscleFrame& muscle : frame->muscles) {
    muscles.push_back(muscle.points);
  }
  meshes->MoveTo(muscles, frame->bones);
  const ScopedStage stage("certificate");
  frame->intersections =
      IntersectScene(meshes->muscles(), meshes->bones(), scene.exempt);
  frame->delivered_crossings = CrossingsWithDelivered(
      meshes->muscles(), DeliveredOnlyIn(scene, *frame), scene.exempt);
  const ScopedStage gaps_stage("gaps of vertices");
  for (size_t i = 0; i < frame->muscles.size(); ++i) {
    MuscleFrame& muscle = frame->muscles[i];
    const std::vector<int>& inside = frame->intersections.inside_of_muscles[i];
    muscle.self_pairs = frame->intersections.self_pairs_of_muscles[i];
    if (options.vertex_gaps) {
      muscle.gaps =
          VertexGaps(i, meshes->muscles(), meshes->bones(), inside, kGapLimit);
      muscle.min_gap = muscle.gaps.minCoeff();
    } else {
      muscle.min_gap = SmallestVertexGap(
          i, meshes->muscles(), meshes->bones(), inside, kGapLimit);
    }
  }
}

}  // namespace

Frame MeasureFrame(const PreparedScene& scene,
                   const ScenePose& pose,
                   const MuscleShapes& shapes,
                   const std::vector<Points>& before,
                   std::vector<SolverSummary> summaries,
                   SceneMeshes* meshes,
                   const MeasureOptions& options) {
  const ScopedStage stage("measures of shapes");
  Frame frame;
  frame.name = pose.name;
  frame.time = pose.time;
  frame.coordinates = pose.coordinates;
  frame.muscles.resize(scene.muscles.size());
#pragma omp parallel for schedule(dynamic, 1)
  for (size_t i = 0; i < scene.muscles.size(); ++i) {
    frame.muscles[i] = FrameOf(scene.muscles[i],
                               meshes->rest_of_muscle(i),
                               pose,
                               shapes.coarse[i],
                               shapes.fine[i],
                               before.empty() ? nullptr : &before[i],
                               std::move(summaries[i]));
  }
  AddBones(scene, pose, &frame);
  AddIntersections(scene, options, meshes, &frame);
  return frame;
}

JudgedMuscle JudgedMuscleOf(const PreparedMuscle& muscle,
                            const MuscleFigures& figures) {
  return {figures,
          muscle.mesh.delivered_volume,
          static_cast<int>(muscle.model.fine_triangles.rows()),
          muscle.mesh.reconstruction,
          muscle.missed_bones};
}

Frame RestFrame(const PreparedScene& scene,
                SceneMeshes* meshes,
                const MeasureOptions& options) {
  Frame frame;
  for (const PreparedMuscle& muscle : scene.muscles) {
    MuscleFrame at_rest;
    at_rest.name = muscle.model.name;
    at_rest.points = muscle.model.fine_rest;
    at_rest.volume_ratio =
        muscle.model.rest_volume / muscle.mesh.delivered_volume;
    at_rest.volume = at_rest.volume_ratio * muscle.mesh.delivered_volume;
    AddLines(muscle, muscle.model.coarse_rest, &at_rest);
    at_rest.bare_tendons = BareTendonLines(muscle.model.lines, nullptr);
    frame.muscles.push_back(std::move(at_rest));
  }
  for (const PreparedBone& bone : scene.bones) {
    frame.bones.push_back(bone.rest.points);
    frame.bones_from_rest.push_back(Eigen::Matrix4d::Identity());
  }
  AddIntersections(scene, options, meshes, &frame);
  return frame;
}

SceneIntersections IntersectAsPrepared(const PreparedScene& scene,
                                       SceneMeshes* meshes) {
  std::vector<Points> muscles;
  for (const PreparedMuscle& muscle : scene.muscles) {
    muscles.push_back(muscle.model.fine_rest);
  }
  return IntersectAtRest(scene, muscles, meshes);
}

SceneIntersections IntersectAtRest(const PreparedScene& scene,
                                   const std::vector<Points>& muscles,
                                   SceneMeshes* meshes) {
  std::vector<Points> bones;
  for (const PreparedBone& bone : scene.bones) {
    bones.push_back(bone.rest.points);
  }
  meshes->MoveTo(muscles, bones);
  return IntersectScene(meshes->muscles(), meshes->bones(), scene.exempt);
}

}  // namespace musclewarp
