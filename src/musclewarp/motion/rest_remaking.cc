// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/motion/rest_remaking.h"

#include <glog/logging.h>

#include <algorithm>
#include <cmath>
#include <deque>
#include <iomanip>
#include <map>
#include <set>
#include <sstream>
#include <utility>

#include "musclewarp/base/input_error.h"
#include "musclewarp/base/option_check.h"
#include "musclewarp/base/parallel_for.h"
#include "musclewarp/certified_contact/cell_surface.h"
#include "musclewarp/mesh/measures.h"

namespace musclewarp {
namespace {

// The muscles, by number, whose meshes have to be made anew. What crosses a
// bone holds up the muscles around it, and a muscle may cross itself as long as
// it crosses others: so these come only if there is nothing worse, or in the
// last attempt, which takes all.
std::vector<int> UncleanMuscles(const PreparedScene& scene,
                                const SceneIntersections& rest,
                                bool is_last_attempt) {
  std::map<std::string, int> numbers;
  std::set<int> beside_bones, beside_muscles, by_themselves;
  for (size_t i = 0; i < scene.muscles.size(); ++i) {
    const int number = static_cast<int>(i);
    numbers[scene.muscles[i].model.name] = number;
    if (rest.self_pairs_of_muscles[i] > 0) by_themselves.insert(number);
  }
  for (const PairIntersection& pair : rest.pairs) {
    if (pair.triangle_pairs + pair.vertices_inside == 0) continue;
    const auto a = numbers.find(pair.a), b = numbers.find(pair.b);
    const bool are_muscles = a != numbers.end() && b != numbers.end();
    for (const auto& muscle : {a, b}) {
      if (muscle == numbers.end()) continue;
      (are_muscles ? beside_muscles : beside_bones).insert(muscle->second);
    }
  }
  std::set<int> unclean;
  for (const std::set<int>& worst :
       {beside_bones, beside_muscles, by_themselves}) {
    if (unclean.empty() || is_last_attempt) {
      unclean.insert(worst.begin(), worst.end());
    }
  }
  return {unclean.begin(), unclean.end()};
}

// The places, a clause each.
std::string Describe(const PreparedScene& scene,
                     const SceneIntersections& rest) {
  std::ostringstream text;
  text << std::fixed << std::setprecision(1);
  const char* separator = "";
  for (const PairIntersection& pair : rest.pairs) {
    if (pair.triangle_pairs + pair.vertices_inside == 0) continue;
    text << separator << pair.a << " crosses " << pair.b << " around ("
         << pair.place.x() << ", " << pair.place.y() << ", " << pair.place.z()
         << "), " << pair.max_depth_mm << " mm deep";
    separator = "; ";
  }
  for (size_t i = 0; i < scene.muscles.size(); ++i) {
    if (rest.self_pairs_of_muscles[i] == 0) continue;
    text << separator << scene.muscles[i].model.name << " crosses itself in "
         << rest.self_pairs_of_muscles[i] << " pairs of triangles";
    separator = "; ";
  }
  return text.str();
}

CellSurfaceOptions SurfaceOptions(const RestRemakingOptions& options,
                                  const MedialCellOptions& cell,
                                  const PreparedScene& scene,
                                  const std::vector<int>& unclean) {
  CellSurfaceOptions surface;
  surface.cell = cell;
  surface.spacing = options.max_spacing;
  for (const int i : unclean) {
    surface.spacing = std::min(
        surface.spacing,
        std::max(options.min_spacing,
                 options.spacing_share *
                     TypicalEdge(scene.muscles[i].model.fine_rest,
                                 scene.muscles[i].model.fine_triangles)));
  }
  return surface;
}

// Makes a surface that crosses no bone, with as large a margin as that takes: a
// bone may have details between the samples of a surface.
TriangleSoup SurfaceBesideBones(
    const RestRemakingOptions& options,
    CellSurfaceOptions surface_options,
    int attempt,
    const SolidDistance& muscle,
    const std::vector<const SolidDistance*>& others,
    const std::vector<const SolidDistance*>& bones) {
  surface_options.cell.margin *= std::pow(options.margin_growth, attempt);
  for (int growth = 0;; ++growth) {
    TriangleSoup surface = CellSurface(surface_options, muscle, others, bones);
    if (surface.triangles.rows() == 0 || growth == options.max_growths) {
      return surface;
    }
    const TriangleBvh tree(surface.points, surface.triangles);
    const bool crosses =
        std::any_of(bones.begin(), bones.end(), [&](const SolidDistance* bone) {
          return !IntersectingTriangles(tree, bone->mesh().bvh()).empty();
        });
    if (!crosses) return surface;
    surface_options.cell.margin *= options.margin_growth;
    // A cell is bounded by what is in range of its margin.
    surface_options.cell.range =
        std::max(surface_options.cell.range, 2 * surface_options.cell.margin);
  }
}

// Compares the new surface of a muscle with the old one.
Remaking Compare(const SearchableMesh& before, const TriangleSoup& after) {
  Remaking remaking;
  remaking.is_done = true;
  remaking.volume_before = SignedVolume(before.points(), before.triangles());
  remaking.volume_after = SignedVolume(after.points, after.triangles);
  const TriangleBvh tree(after.points, after.triangles);
  for (Eigen::Index f = 0; f < before.triangles().rows(); ++f) {
    const Corners t = CornersOf(before.points(), before.triangles().row(f));
    const Eigen::RowVector3d middle = t.colwise().mean();
    const double edge = (t.row(1) - t.row(0)).norm();
    const double distance =
        tree.ClosestPoint(middle, std::numeric_limits<double>::infinity())
            .distance;
    remaking.farthest = std::max(remaking.farthest, distance);
    if (distance <= edge) continue;
    const double area = AreaVector(t).norm() / 2;
    remaking.lost_area += area;
    remaking.place += area * middle;
  }
  if (remaking.lost_area > 0) remaking.place /= remaking.lost_area;
  return remaking;
}

std::string Warning(const std::string& name, const Remaking& remaking) {
  std::ostringstream text;
  text
      << std::fixed << std::setprecision(1) << name
      << " could not be separated by moving its vertices, so its mesh was made "
         "anew: "
      << remaking.volume_before / 1000 << " cm3 before, "
      << remaking.volume_after / 1000 << " cm3 after; "
      << remaking.lost_area / 100 << " cm2 of the old surface were left";
  if (remaking.lost_area > 0) {
    text << ", around (" << remaking.place.x() << ", " << remaking.place.y()
         << ", " << remaking.place.z() << "), by " << remaking.farthest
         << " mm at most";
  }
  return text.str();
}

// Throws InputError if too little of a muscle is left.
void CheckEnoughIsLeft(const RestRemakingOptions& options,
                       const std::string& name,
                       const Remaking& remaking) {
  if (remaking.volume_after >=
      options.least_volume_share * remaking.volume_before) {
    return;
  }
  throw InputError(
      name,
      "only " +
          std::to_string(static_cast<int>(100 * remaking.volume_after /
                                          remaking.volume_before)) +
          " % of the muscle are outside bones and other muscles",
      "check that the meshes are in one frame, or correct them");
}

void Remake(const RestRemakingOptions& options,
            const PrepareOptions& prepare,
            const MedialCellOptions& cell,
            const std::vector<int>& unclean,
            int attempt,
            PreparedScene* scene) {
  const SceneMeshes meshes(*scene);
  const CellSurfaceOptions surface_options =
      SurfaceOptions(options, cell, *scene, unclean);
  std::deque<SolidDistance> solids;
  std::vector<const SolidDistance*> muscles, bones;
  for (const NamedMesh& muscle : meshes.muscles()) {
    muscles.push_back(&solids.emplace_back(*muscle.mesh));
  }
  for (const NamedMesh& bone : meshes.bones()) {
    bones.push_back(&solids.emplace_back(*bone.mesh));
  }
  std::vector<TriangleSoup> surfaces(unclean.size());
  std::vector<Remaking> remakings(unclean.size());
  ParallelFor(unclean.size(), [&](size_t k) {
    const int i = unclean[k];
    std::vector<const SolidDistance*> others = muscles;
    others.erase(others.begin() + i);
    TriangleSoup surface = SurfaceBesideBones(
        options, surface_options, attempt, *muscles[i], others, bones);
    const MuscleModel& model = scene->muscles[i].model;
    if (surface.triangles.rows() > 0) {
      surface = WithEvenTriangles(
          surface,
          std::max(surface_options.spacing,
                   TypicalEdge(model.fine_rest, model.fine_triangles)));
    }
    remakings[k] = Compare(*meshes.muscles()[i].mesh, surface);
    CheckEnoughIsLeft(options, model.name, remakings[k]);
    surfaces[k] = std::move(surface);
  });
  ReplaceMuscleMeshes(prepare, unclean, std::move(surfaces), scene);
  for (size_t k = 0; k < unclean.size(); ++k) {
    PreparedMuscle& muscle = scene->muscles[unclean[k]];
    // Without slivers, which take a little volume with them.
    remakings[k].volume_after = muscle.model.rest_volume;
    if (muscle.mesh.remaking.is_done) {
      remakings[k].volume_before = muscle.mesh.remaking.volume_before;
    }
    muscle.mesh.remaking = remakings[k];
  }
}

}  // namespace

bool RestRemakingOptions::IsValid(std::string* error) const {
  return OptionCheck("RestRemakingOptions", error)
      .IsAtLeast("margin_growth", margin_growth, 1)
      .IsAtLeast("max_growths", max_growths, 0)
      .IsAtLeast("max_attempts", max_attempts, 1)
      .IsAbove("spacing_share", spacing_share, 0)
      .IsAbove("min_spacing", min_spacing, 0)
      .IsAtLeast("max_spacing", max_spacing, min_spacing)
      .IsWithin("least_volume_share", least_volume_share, 0, 1)
      .is_valid();
}

std::unique_ptr<FrameSolver> MakeCleanFrameSolver(
    const RestRemakingOptions& remaking,
    const PrepareOptions& prepare,
    const FrameSolverOptions& options,
    const MuscleSolvers& solvers,
    const ProgressCallback& on_progress,
    PreparedScene* scene) {
  std::string error;
  CHECK(remaking.IsValid(&error)) << error;
  for (int attempt = 0;; ++attempt) {
    auto solver = MakeFrameSolver(*scene,
                                  options,
                                  solvers,
                                  std::make_shared<SceneMeshes>(*scene),
                                  on_progress);
    if (options.contact != ContactKind::kCertified) return solver;
    const SceneIntersections& rest = *solver->contact().rest;
    const std::vector<int> unclean =
        UncleanMuscles(*scene, rest, attempt + 1 == remaking.max_attempts);
    if (unclean.empty()) {
      for (const PreparedMuscle& muscle : scene->muscles) {
        if (!muscle.mesh.remaking.is_done) continue;
        scene->warnings.push_back(
            Warning(muscle.model.name, muscle.mesh.remaking));
        LOG(WARNING) << scene->warnings.back();
      }
      return solver;
    }
    if (remaking.kind == RemakeKind::kNever ||
        attempt == remaking.max_attempts) {
      throw InputError(
          scene->scene.name,
          "the meshes cannot be separated in the rest pose: " +
              Describe(*scene, rest),
          remaking.kind == RemakeKind::kNever
              ? "let their surfaces be made anew (--remake=auto), or correct "
                "the meshes there"
              : "correct the meshes there");
    }
    if (!scene->as_delivered) {
      scene->as_delivered = solver->RestFrame().intersections;
    }
    if (on_progress) on_progress({"remaking", attempt, 0});
    Remake(remaking,
           prepare,
           options.certified.separation.cell,
           unclean,
           attempt,
           scene);
  }
}

}  // namespace musclewarp
