// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/studies/convergence_run.h"

#include <glog/logging.h>

#include <algorithm>
#include <memory>
#include <numeric>
#include <optional>
#include <utility>

#include "musclewarp/base/input_error.h"
#include "musclewarp/base/stopwatch.h"
#include "musclewarp/studies/convergence_measures.h"
#include "musclewarp/studies/mesh_density.h"

namespace musclewarp {
namespace {

TriangleSoup RestMesh(const MuscleModel& model) {
  return {model.fine_rest, model.fine_triangles};
}

std::optional<RestResult> SeparatedRest(const DeformerOptions& options,
                                        const PrepareOptions& prepare,
                                        PreparedScene* scene) {
  if (options.frames.contact != ContactKind::kCertified) return std::nullopt;
  RestSeparationOptions separation = RestSeparationOptionsOf(options);
  separation.prepare = prepare;
  return SeparateRest(separation, SolversOf(options.solver).single, {}, scene);
}

// Returns the frames of the poses in `frames`.
std::vector<Frame> SolveFrames(const DeformerOptions& options,
                               const PreparedScene& scene,
                               std::optional<RestResult> rest,
                               const std::vector<int>& frames) {
  const MuscleSolvers solvers = SolversOf(options.solver);
  const auto frame_solver =
      MakeFrameSolver(scene,
                      options.frames,
                      std::make_shared<SceneMeshes>(scene),
                      std::move(rest));
  // Without contact the result does not depend on the way to the pose.
  const bool is_motion = options.frames.contact == ContactKind::kCertified &&
                         scene.scene.is_motion;
  SceneState state;
  if (is_motion) state = frame_solver->StartOfMotion(solvers);
  std::vector<Frame> solved_frames;
  for (int index = 0; index <= frames.back(); ++index) {
    const bool is_wanted =
        std::binary_search(frames.begin(), frames.end(), index);
    if (!is_wanted && !is_motion) continue;
    SolvedFrame solved = frame_solver->Solve(
        solvers, scene.scene.poses[index], is_motion ? &state : nullptr, {});
    state = std::move(solved.state);
    if (is_wanted) solved_frames.push_back(std::move(solved.frame));
  }
  return solved_frames;
}

DiscretisedMuscle Measured(const PreparedMuscle& prepared,
                           const MuscleFrame& frame,
                           const Points& base_rest,
                           const SurfacePlaces& places) {
  const MuscleModel& model = prepared.model;
  DiscretisedMuscle muscle;
  muscle.coarse_vertices = static_cast<int>(model.coarse_rest.rows());
  muscle.samples = static_cast<int>(model.samples.size());
  muscle.fine_vertices = static_cast<int>(model.fine_rest.rows());
  muscle.is_reconstructed = prepared.mesh.reconstruction.is_done;
  muscle.displacements =
      CarriedPoints(places, model.fine_triangles, frame.points) - base_rest;
  muscle.rest_distance = places.largest_distance;
  muscle.volume_ratio = 1 + frame.volume_error;
  muscle.stretch = frame.shape.triangles;
  muscle.moment_arms = frame.line_moment_arms;
  return muscle;
}

std::vector<DiscretisedFrame> MeasureFrames(const PreparedScene& base,
                                            const PreparedScene& scene,
                                            const std::vector<Frame>& frames) {
  std::vector<DiscretisedFrame> measured(frames.size());
  for (size_t i = 0; i < frames.size(); ++i) {
    measured[i].ms = frames[i].wall_ms;
    measured[i].is_usable = frames[i].IsUsable();
  }
  for (size_t m = 0; m < scene.muscles.size(); ++m) {
    const TriangleSoup base_mesh = RestMesh(base.muscles[m].model);
    const SurfacePlaces places =
        NearestPlaces(RestMesh(scene.muscles[m].model), base_mesh);
    for (size_t i = 0; i < frames.size(); ++i) {
      measured[i].muscles.push_back(Measured(
          scene.muscles[m], frames[i].muscles[m], base_mesh.points, places));
    }
  }
  return measured;
}

PrepareOptions OptionsWith(const Discretisation& discretisation,
                           PrepareOptions options) {
  options.muscle.hull.coarse_vertices = discretisation.coarse_vertices;
  options.muscle.sample_spacing = discretisation.sample_spacing;
  return options;
}

}  // namespace

Discretisation DiscretisationOf(const PrepareOptions& options) {
  return {options.muscle.hull.coarse_vertices,
          options.muscle.sample_spacing,
          /*density=*/1};
}

PreparedScene Rediscretised(const PreparedScene& base,
                            const PrepareOptions& options,
                            const Discretisation& discretisation) {
  const Discretisation before = DiscretisationOf(options);
  PreparedScene scene = base;
  if (discretisation == before) return scene;
  PrepareOptions changed = OptionsWith(discretisation, options);
  changed.remove_slivers = false;  // done in `base`
  std::vector<TriangleSoup> meshes;
  for (const PreparedMuscle& muscle : base.muscles) {
    meshes.push_back(RestMesh(muscle.model));
  }
  std::vector<int> all(meshes.size());
  std::iota(all.begin(), all.end(), 0);
  if (discretisation.coarse_vertices != before.coarse_vertices) {
    ReplaceMuscleMeshes(changed, all, meshes, &scene);
  }
  if (discretisation.sample_spacing != before.sample_spacing ||
      discretisation.density != before.density) {
    for (TriangleSoup& mesh : meshes) {
      mesh = WithDensity(mesh, discretisation.density);
    }
    RetriangulateMuscles(changed, all, meshes, &scene);
  }
  return scene;
}

DiscretisationResult SolveDiscretisation(const DeformerOptions& options,
                                         const PreparedScene& base,
                                         const Discretisation& discretisation,
                                         const std::vector<int>& frames) {
  CHECK(options.frames.contact != ContactKind::kPaper);
  DiscretisationResult result;
  result.discretisation = discretisation;
  if (frames.empty()) return result;
  try {
    const Stopwatch stopwatch;
    PreparedScene scene = Rediscretised(base, options.prepare, discretisation);
    std::optional<RestResult> rest = SeparatedRest(
        options, OptionsWith(discretisation, options.prepare), &scene);
    result.prepare_ms = stopwatch.Milliseconds();
    result.frames = MeasureFrames(
        base, scene, SolveFrames(options, scene, std::move(rest), frames));
  } catch (const InputError& error) {
    result.failure = error.what();
  }
  return result;
}

}  // namespace musclewarp
