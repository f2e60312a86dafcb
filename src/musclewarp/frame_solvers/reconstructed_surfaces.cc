// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/frame_solvers/reconstructed_surfaces.h"

#include <glog/logging.h>

#include <algorithm>
#include <cmath>
#include <deque>
#include <utility>

#include "musclewarp/base/infinity.h"
#include "musclewarp/base/parallel_for.h"
#include "musclewarp/base/stage_times.h"
#include "musclewarp/initial_separation/cell_surface.h"
#include "musclewarp/initial_separation/grown_surface.h"
#include "musclewarp/mesh/measures.h"
#include "musclewarp/preparation/memory_limits.h"
#include "musclewarp/preparation/scene_meshes.h"

namespace musclewarp {
namespace {

CellSurfaceOptions SurfaceOptions(const ReconstructionOptions& options,
                                  const MedialCellOptions& cell,
                                  const PreparedScene& scene,
                                  const std::vector<int>& muscles) {
  CellSurfaceOptions surface;
  surface.cell = cell;
  surface.spacing = options.max_spacing;
  for (const int i : muscles) {
    surface.spacing = std::min(
        surface.spacing,
        std::max(options.min_spacing,
                 options.spacing_fraction *
                     TypicalEdge(scene.muscles[i].model.fine_rest,
                                 scene.muscles[i].model.fine_triangles)));
  }
  return surface;
}

// Halves the spacing of the samples until there are several across a thin
// muscle: twice its volume by its area is what a plate of its thickness has.
double SpacingWithin(const ReconstructionOptions& options,
                     const MuscleModel& muscle,
                     double spacing) {
  const double thickness = 2 * muscle.rest_volume /
                           SurfaceArea(muscle.fine_rest, muscle.fine_triangles);
  const double largest =
      std::max(options.min_spacing, thickness / options.samples_across);
  while (spacing > largest) spacing /= 2;
  return spacing;
}

// Makes a surface that crosses no bone, with as large a margin as that takes,
// which is left in *surface_options: a
// bone may have details between the samples of a surface. Where a thin muscle
// would lose too much by the margin, such details are left to the separation of
// the new surfaces.
TriangleSoup SurfaceBesideBones(const ReconstructionOptions& options,
                                int attempt,
                                const SolidDistance& muscle,
                                const std::vector<const SolidDistance*>& others,
                                const std::vector<const SolidDistance*>& bones,
                                CellSurfaceOptions* surface_options) {
  MedialCellOptions& cell = surface_options->cell;
  cell.margin *= std::pow(options.margin_growth, attempt);
  TriangleSoup before;
  double least_volume = 0;
  for (int growth = 0;; ++growth) {
    TriangleSoup surface = CellSurface(*surface_options, muscle, others, bones);
    const double volume = SignedVolume(surface.points, surface.triangles);
    VLOG(1) << "cell with a margin of " << cell.margin << " mm: " << volume
            << " mm3";
    if (growth > 0 && volume < least_volume) return before;
    if (surface.triangles.rows() == 0 || growth == options.max_growths) {
      return surface;
    }
    if (growth == 0) {
      least_volume = (1 - options.max_loss_by_margin) * volume;
    }
    const TriangleBvh tree(surface.points, surface.triangles);
    const bool crosses =
        std::any_of(bones.begin(), bones.end(), [&](const SolidDistance* bone) {
          return !IntersectingTriangles(tree, bone->mesh().bvh()).empty();
        });
    if (!crosses) return surface;
    before = std::move(surface);
    cell.margin *= options.margin_growth;
    // A cell is bounded by what is in range of its margin.
    cell.range = std::max(cell.range, 2 * cell.margin);
  }
}

// The signed distances to all meshes, in scene order.
class Solids {
 public:
  explicit Solids(const SceneMeshes& meshes) {
    for (const NamedMesh& muscle : meshes.muscles()) {
      muscles_.push_back(&all_.emplace_back(*muscle.mesh));
    }
    for (const NamedMesh& bone : meshes.bones()) {
      bones_.push_back(&all_.emplace_back(*bone.mesh));
    }
  }
  const SolidDistance& muscle(int i) const { return *muscles_[i]; }
  const std::vector<const SolidDistance*>& bones() const { return bones_; }
  std::vector<const SolidDistance*> MusclesBut(int i) const {
    std::vector<const SolidDistance*> others = muscles_;
    others.erase(others.begin() + i);
    return others;
  }

 private:
  std::deque<SolidDistance> all_;
  std::vector<const SolidDistance*> muscles_, bones_;
};

// Gives a body even triangles and, as far as there is room, the volume of the
// mesh before it was made anew. Even triangles cut corners: what they cost is
// asked for once more.
TriangleSoup EvenAndGrown(const CellSurfaceOptions& options,
                          const TriangleSoup& body,
                          double before,
                          double edge,
                          int number,
                          const Solids& solids) {
  constexpr double kAccuracy = 5e-3;  // of the volume
  TriangleSoup best;
  double best_error = kInfinity;
  double volume = before;
  for (int tries = 0; tries < 2; ++tries) {
    TriangleSoup even =
        WithEvenTriangles(GrownSurface(options,
                                       body,
                                       solids.muscle(number),
                                       solids.MusclesBut(number),
                                       solids.bones(),
                                       volume),
                          edge);
    const double now = SignedVolume(even.points, even.triangles);
    const double error = std::abs(now / before - 1);
    if (error < best_error) {
      best = std::move(even);
      best_error = error;
    }
    if (error < kAccuracy) break;
    volume *= before / now;
  }
  return best;
}

// Makes the surface of a muscle anew from its cell among the solids.
TriangleSoup SurfaceOf(const ReconstructionOptions& options,
                       CellSurfaceOptions surface_options,
                       int attempt,
                       const PreparedMuscle& muscle,
                       int number,
                       const Solids& solids) {
  const MuscleModel& model = muscle.model;
  surface_options.spacing =
      SpacingWithin(options, model, surface_options.spacing);
  const double edge =
      std::max(surface_options.spacing,
               TypicalEdge(model.fine_rest, model.fine_triangles));
  CheckLatticeFits(model.name,
                   solids.muscle(number).mesh().bvh().box(),
                   surface_options.spacing);
  TriangleSoup body = SurfaceBesideBones(options,
                                         attempt,
                                         solids.muscle(number),
                                         solids.MusclesBut(number),
                                         solids.bones(),
                                         &surface_options);
  // Of the mesh before it was made anew for the first time. What a label lost
  // before it became a mesh does not come back: it was elsewhere.
  const SurfaceReconstruction& reconstruction = muscle.mesh.reconstruction;
  const double before =
      reconstruction.is_done ? reconstruction.volume_before : model.rest_volume;
  const double left = SignedVolume(body.points, body.triangles);
  // Of next to nothing no muscle grows; the caller refuses it.
  if (left < options.least_volume_fraction * before) return body;
  return EvenAndGrown(surface_options, body, before, edge, number, solids);
}

}  // namespace

std::vector<TriangleSoup> ReconstructedSurfaces(
    const ReconstructionOptions& options,
    const MedialCellOptions& cell,
    const std::vector<int>& muscles,
    int attempt,
    const PreparedScene& scene) {
  const ScopedStage stage("reconstruction of meshes");
  const CellSurfaceOptions surface_options =
      SurfaceOptions(options, cell, scene, muscles);
  const SceneMeshes meshes(scene);
  const Solids solids(meshes);
  std::vector<TriangleSoup> surfaces(muscles.size());
  ParallelFor(muscles.size(), [&](size_t k) {
    const int i = muscles[k];
    surfaces[k] = SurfaceOf(
        options, surface_options, attempt, scene.muscles[i], i, solids);
  });
  return surfaces;
}

}  // namespace musclewarp
