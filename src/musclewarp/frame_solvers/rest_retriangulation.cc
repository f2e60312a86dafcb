// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/frame_solvers/rest_retriangulation.h"

#include <optional>
#include <utility>
#include <vector>

#include "musclewarp/base/parallel_for.h"
#include "musclewarp/frame_solvers/certified_frame.h"
#include "musclewarp/frames/frame_measures.h"
#include "musclewarp/frames/muscle_shapes.h"
#include "musclewarp/preparation/exempt_areas.h"

namespace musclewarp {
namespace {

bool IsFreeOfCrossings(const SceneIntersections& intersections) {
  return intersections.IsClean() && intersections.self_pairs == 0;
}

// By muscle, for each vertex (#V): whether its edges must not be collapsed.
using LockedVertices = std::vector<std::vector<bool>>;

LockedVertices NoneLocked(const PreparedScene& scene) {
  LockedVertices locked;
  for (const PreparedMuscle& muscle : scene.muscles) {
    locked.emplace_back(muscle.model.fine_rest.rows(), false);
  }
  return locked;
}

// The muscles of a scene without their drawn-out triangles.
struct Retriangulation {
  std::vector<TriangleSoup> meshes;    // in the rest pose as prepared
  MuscleShapes shapes;                 // in the separated rest pose
  std::vector<std::vector<int>> kept;  // the vertices that stay
  std::vector<int> changed;            // the muscles that lost triangles
};

Retriangulation Retriangulated(const DrawnOutOptions& options,
                               const PreparedScene& scene,
                               const RestResult& rest,
                               const LockedVertices& locked) {
  Retriangulation result;
  const size_t num_muscles = scene.muscles.size();
  result.shapes = ShapesOf(scene, rest.state);
  result.meshes.resize(num_muscles);
  result.kept.resize(num_muscles);
  ParallelFor(num_muscles, [&](size_t m) {
    const MuscleModel& model = scene.muscles[m].model;
    Points& moved = result.shapes.fine[m];
    result.meshes[m] = {model.fine_rest, model.fine_triangles};
    result.kept[m] =
        RemoveDrawnOutTriangles(options, moved, locked[m], &result.meshes[m]);
    moved = Points(moved(result.kept[m], Eigen::all));
  });
  for (size_t m = 0; m < num_muscles; ++m) {
    if (result.kept[m].size() < locked[m].size()) {
      result.changed.push_back(static_cast<int>(m));
    }
  }
  return result;
}

// Returns what crosses in the separated rest pose with new triangles. `scene`:
// a copy of the scene, which gets them.
SceneIntersections CrossingsOf(const Retriangulation& retriangulation,
                               PreparedScene* scene) {
  for (const int m : retriangulation.changed) {
    MuscleModel& model = scene->muscles[m].model;
    model.fine_rest = retriangulation.meshes[m].points;
    model.fine_triangles = retriangulation.meshes[m].triangles;
  }
  scene->exempt = ExemptAreas(*scene);
  SceneMeshes meshes(*scene);
  return IntersectAtRest(*scene, retriangulation.shapes.fine, &meshes);
}

// Locks the corners of the triangles that cross.
void LockCrossing(const Retriangulation& retriangulation,
                  const SceneIntersections& crossings,
                  LockedVertices* locked) {
  const auto lock = [&](int m, int triangle) {
    for (const int v : retriangulation.meshes[m].triangles.row(triangle)) {
      (*locked)[m][retriangulation.kept[m][v]] = true;
    }
  };
  for (const PairFigures& pair : crossings.pairs) {
    for (const int f : pair.triangles_of_a) {
      if (pair.muscle_a >= 0) lock(pair.muscle_a, f);
    }
    for (const int f : pair.triangles_of_b) {
      if (pair.muscle_b >= 0) lock(pair.muscle_b, f);
    }
  }
  for (const int m : retriangulation.changed) {
    if (crossings.self_pairs_of_muscles[m] == 0) continue;
    for (const auto& [f, g] :
         SelfIntersections(TriangleSoup{retriangulation.shapes.fine[m],
                                        retriangulation.meshes[m].triangles})) {
      lock(m, f);
      lock(m, g);
    }
  }
}

// Returns new triangles with which nothing crosses, or nothing if there are
// none.
std::optional<Retriangulation> CleanRetriangulation(
    const DrawnOutOptions& options,
    const PreparedScene& scene,
    const RestResult& rest) {
  constexpr int kMaxAttempts = 5;
  LockedVertices locked = NoneLocked(scene);
  for (int attempt = 0; attempt < kMaxAttempts; ++attempt) {
    Retriangulation result = Retriangulated(options, scene, rest, locked);
    if (result.changed.empty()) break;
    PreparedScene copy = scene;
    const SceneIntersections crossings = CrossingsOf(result, &copy);
    if (IsFreeOfCrossings(crossings)) return result;
    LockCrossing(result, crossings, &locked);
  }
  return {};
}

// Returns the scene with new triangles.
PreparedScene WithTriangles(const PrepareOptions& options,
                            const Retriangulation& retriangulation,
                            const PreparedScene& scene) {
  PreparedScene result = scene;
  std::vector<TriangleSoup> meshes;
  for (const int m : retriangulation.changed) {
    meshes.push_back(retriangulation.meshes[m]);
  }
  RetriangulateMuscles(options, retriangulation.changed, meshes, &result);
  for (const int m : retriangulation.changed) {
    result.muscles[m].mesh.drawn_out_triangles +=
        static_cast<int>(scene.muscles[m].model.fine_triangles.rows() -
                         retriangulation.meshes[m].triangles.rows());
  }
  return result;
}

// Removes triangles once. Returns false, and changes nothing, if there are none
// to remove or the rest pose without them would be worse.
bool RetriangulateOnce(const RestSeparationOptions& options,
                       const MuscleSolver& solver,
                       const ProgressCallback& on_progress,
                       PreparedScene* scene,
                       RestResult* rest) {
  const std::optional<Retriangulation> retriangulation =
      CleanRetriangulation(options.drawn_out, *scene, *rest);
  if (!retriangulation) return false;
  PreparedScene changed =
      WithTriangles(options.prepare, *retriangulation, *scene);
  CertifiedContactOptions contact = options.contact;
  contact.max_rest_steps = options.relaxing_steps;
  SceneMeshes meshes(changed);
  CertifiedScene certified = RelaxCertifiedScene(changed,
                                                 contact,
                                                 options.pre_rotation,
                                                 solver,
                                                 retriangulation->shapes,
                                                 on_progress);
  RestResult relaxed = RestResultOf(
      changed, std::move(certified), options.requirements, &meshes);
  if (!IsFreeOfCrossings(relaxed.intersections) ||
      relaxed.displaced.size() > rest->displaced.size()) {
    return false;
  }
  *scene = std::move(changed);
  *rest = std::move(relaxed);
  return true;
}

}  // namespace

void RetriangulateDrawnOut(const RestSeparationOptions& options,
                           const MuscleSolver& solver,
                           const ProgressCallback& on_progress,
                           PreparedScene* scene,
                           RestResult* rest) {
  for (int i = 0; i < options.max_retriangulations; ++i) {
    if (!RetriangulateOnce(options, solver, on_progress, scene, rest)) return;
  }
}

}  // namespace musclewarp
