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
#include "musclewarp/frame_solvers/reconstruction_loss.h"
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

// Halves the spacing until several samples lie across a thin muscle. The mean
// thickness is twice the volume over the area, as for a plate.
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

// Reconstructs a surface that crosses no bone, if possible, by enlarging the
// margin: bones may have details between the samples of the surface. The last
// margin tried is returned in *surface_options. A thin muscle that would lose
// too much volume keeps the smaller margin; the separation of the new surfaces
// then resolves such details.
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
    // The range must exceed the margin: meshes beyond it do not bound a cell.
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

// Returns the volume that even triangles with edges of this length (mm) cut
// from a smooth surface whose vertices they share: the mean distance between an
// equilateral triangle and the sphere around its corners is edge^2 / (8
// radius).
double VolumeCutOff(const TriangleSoup& surface, double edge) {
  return edge * edge / 8 *
         MeanCurvatureIntegral(surface.points, surface.triangles);
}

// Remeshes a body with even triangles and grows it, as far as there is room, to
// the volume `before`, and what the triangles cut off. If they cut off more
// than expected, a second pass makes up for it.
TriangleSoup EvenAndGrown(const CellSurfaceOptions& options,
                          const TriangleSoup& body,
                          double before,
                          double edge,
                          int number,
                          const Solids& solids) {
  constexpr double kAccuracy = 5e-3;  // of the volume
  double volume = before + std::max(0.0, VolumeCutOff(body, edge));
  SurfaceGrowth growth(options,
                       body,
                       solids.muscle(number),
                       solids.MusclesBut(number),
                       solids.bones(),
                       volume);
  TriangleSoup best;
  double best_error = kInfinity;
  for (int tries = 0; tries < 2; ++tries) {
    TriangleSoup even = WithEvenTriangles(growth.UpTo(volume), edge);
    const double now = SignedVolume(even.points, even.triangles);
    const double error = std::abs(now / before - 1);
    VLOG(1) << "even triangles leave " << now << " of " << volume << " mm3";
    if (error < best_error) {
      best = std::move(even);
      best_error = error;
    }
    if (error < kAccuracy) break;
    volume *= before / now;
  }
  return best;
}

// Returns the area of thin parts of a muscle that are farther from a new
// surface than separation explains, mm^2: a tendon that the samples of the
// surface do not resolve. `spacing`: theirs, mm.
double LostThinArea(const SolidDistance& muscle,
                    const TriangleSoup& surface,
                    double spacing) {
  if (surface.triangles.rows() == 0) return 0;
  const TriangleBvh tree(surface.points, surface.triangles);
  const SearchableMesh& mesh = muscle.mesh();
  double area = 0;
#pragma omp parallel for schedule(static) reduction(+ : area)
  for (Eigen::Index f = 0; f < mesh.triangles().rows(); ++f) {
    const Corners corners = CornersOf(mesh.points(), mesh.triangles().row(f));
    const Eigen::RowVector3d centre = corners.colwise().mean();
    if (tree.IsWithin(centre, kGoneBeyond)) continue;
    // A body that is thicker than two spacings is this deep there.
    const Eigen::RowVector3d normal = AreaVector(corners);
    const double twice_area = normal.norm();
    if (twice_area == 0) continue;
    const Eigen::RowVector3d inward = centre - spacing / twice_area * normal;
    if (muscle.At(inward, 0) > -0.9 * spacing) area += twice_area / 2;
  }
  return area;
}

// Returns the surface of a muscle beside bones. While it lacks thin parts,
// places where the mesh crosses itself are bridged, and the samples are twice
// as fine.
TriangleSoup SurfaceWithThinParts(const ReconstructionOptions& options,
                                  int attempt,
                                  int number,
                                  const Solids& solids,
                                  CellSurfaceOptions* surface_options) {
  const SolidDistance& muscle = solids.muscle(number);
  CellSurfaceOptions tried = *surface_options;
  for (;;) {
    *surface_options = tried;
    TriangleSoup body = SurfaceBesideBones(options,
                                           attempt,
                                           muscle,
                                           solids.MusclesBut(number),
                                           solids.bones(),
                                           surface_options);
    const double lost = LostThinArea(muscle, body, tried.spacing);
    VLOG(1) << "samples at " << tried.spacing << " mm lose " << lost / 100
            << " cm2 of thin parts";
    tried.spacing /= 2;
    tried.bridge = options.bridge;
    if (lost <= options.max_lost_thin_area ||
        tried.spacing < options.least_spacing ||
        !LatticeFits(muscle.mesh().bvh().box(), tried.spacing)) {
      return body;
    }
  }
}

// Reconstructs the surface of a muscle from its cell among the solids.
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
  const TriangleSoup body =
      SurfaceWithThinParts(options, attempt, number, solids, &surface_options);
  // The volume before the first reconstruction. Volume that a label lost before
  // it became a mesh is not restored: it lay elsewhere.
  const SurfaceReconstruction& reconstruction = muscle.mesh.reconstruction;
  const double before =
      reconstruction.is_done ? reconstruction.volume_before : model.rest_volume;
  const double left = SignedVolume(body.points, body.triangles);
  // Such a small remainder is not grown; the caller rejects it.
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
