// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/frame_solvers/rest_separation.h"

#include <glog/logging.h>

#include <algorithm>
#include <iomanip>
#include <map>
#include <set>
#include <sstream>
#include <utility>

#include "musclewarp/base/input_error.h"
#include "musclewarp/base/option_check.h"
#include "musclewarp/base/parallel_for.h"
#include "musclewarp/frame_solvers/reconstructed_surfaces.h"
#include "musclewarp/mesh/measures.h"

namespace musclewarp {
namespace {

// The muscles, by number, whose meshes have to be made anew. What crosses a
// bone holds up the muscles around it, and a muscle may cross itself or be far
// from where it was as long as it crosses others: so these come only if there
// is nothing worse, or in the last attempt, which takes all.
std::vector<int> UncleanMuscles(const PreparedScene& scene,
                                const ContactReport& contact,
                                bool is_last_attempt) {
  const SceneIntersections& rest = *contact.rest;
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
  const std::set<int> displaced(contact.displaced_at_rest.begin(),
                                contact.displaced_at_rest.end());
  std::set<int> unclean;
  for (const std::set<int>& worst :
       {beside_bones, beside_muscles, by_themselves, displaced}) {
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

// Compares the new surface of a muscle with the old one.
SurfaceReconstruction Compare(const SearchableMesh& before,
                              const TriangleSoup& after) {
  SurfaceReconstruction reconstruction;
  reconstruction.is_done = true;
  reconstruction.volume_before =
      SignedVolume(before.points(), before.triangles());
  reconstruction.volume_after = SignedVolume(after.points, after.triangles);
  const TriangleBvh tree(after.points, after.triangles);
  for (Eigen::Index f = 0; f < before.triangles().rows(); ++f) {
    const Corners t = CornersOf(before.points(), before.triangles().row(f));
    const Eigen::RowVector3d middle = t.colwise().mean();
    const double edge = (t.row(1) - t.row(0)).norm();
    const double distance =
        tree.ClosestPoint(middle, std::numeric_limits<double>::infinity())
            .distance;
    reconstruction.farthest = std::max(reconstruction.farthest, distance);
    if (distance <= edge) continue;
    const double area = AreaVector(t).norm() / 2;
    reconstruction.lost_area += area;
    reconstruction.place += area * middle;
  }
  if (reconstruction.lost_area > 0)
    reconstruction.place /= reconstruction.lost_area;
  return reconstruction;
}

std::string Warning(const std::string& name,
                    const SurfaceReconstruction& reconstruction) {
  std::ostringstream text;
  text
      << std::fixed << std::setprecision(1) << name
      << " could not be separated by moving its vertices, so its mesh was made "
         "anew: "
      << reconstruction.volume_before / 1000 << " cm3 before, "
      << reconstruction.volume_after / 1000 << " cm3 after; "
      << reconstruction.lost_area / 100 << " cm2 of the old surface were left";
  if (reconstruction.lost_area > 0) {
    text << ", around (" << reconstruction.place.x() << ", "
         << reconstruction.place.y() << ", " << reconstruction.place.z()
         << "), by " << reconstruction.farthest << " mm at most";
  }
  return text.str();
}

// Throws InputError if too little of a muscle is left.
void CheckEnoughIsLeft(const ReconstructionOptions& options,
                       const std::string& name,
                       const SurfaceReconstruction& reconstruction) {
  if (reconstruction.volume_after >=
      options.least_volume_share * reconstruction.volume_before) {
    return;
  }
  throw InputError(
      name,
      "only " +
          std::to_string(static_cast<int>(100 * reconstruction.volume_after /
                                          reconstruction.volume_before)) +
          " % of the muscle are outside bones and other muscles",
      "check that the meshes are in one frame, or correct them");
}

void Remake(const ReconstructionOptions& options,
            const PrepareOptions& prepare,
            const std::vector<int>& unclean,
            std::vector<TriangleSoup> surfaces,
            PreparedScene* scene) {
  const SceneMeshes meshes(*scene);
  std::vector<SurfaceReconstruction> remakings(unclean.size());
  ParallelFor(unclean.size(), [&](size_t k) {
    const int i = unclean[k];
    remakings[k] = Compare(*meshes.muscles()[i].mesh, surfaces[k]);
    CheckEnoughIsLeft(options, scene->muscles[i].model.name, remakings[k]);
  });
  ReplaceMuscleMeshes(prepare, unclean, std::move(surfaces), scene);
  for (size_t k = 0; k < unclean.size(); ++k) {
    PreparedMuscle& muscle = scene->muscles[unclean[k]];
    // Without slivers, which take a little volume with them.
    remakings[k].volume_after = muscle.model.rest_volume;
    if (muscle.mesh.reconstruction.is_done) {
      remakings[k].volume_before = muscle.mesh.reconstruction.volume_before;
    }
    muscle.mesh.reconstruction = remakings[k];
  }
}

}  // namespace

bool ReconstructionOptions::IsValid(std::string* error) const {
  return OptionCheck("ReconstructionOptions", error)
      .IsAtLeast("margin_growth", margin_growth, 1)
      .IsAtLeast("max_growths", max_growths, 0)
      .IsAtLeast("max_attempts", max_attempts, 1)
      .IsWithin("max_loss_by_margin", max_loss_by_margin, 0, 1)
      .IsAbove("spacing_share", spacing_share, 0)
      .IsAbove("min_spacing", min_spacing, 0)
      .IsAtLeast("max_spacing", max_spacing, min_spacing)
      .IsAtLeast("samples_across", samples_across, 1)
      .IsWithin("least_volume_share", least_volume_share, 0, 1)
      .is_valid();
}

std::unique_ptr<FrameSolver> MakeCleanFrameSolver(
    const ReconstructionOptions& reconstruction,
    const PrepareOptions& prepare,
    const FrameSolverOptions& options,
    const MuscleSolvers& solvers,
    const ProgressCallback& on_progress,
    PreparedScene* scene) {
  std::string error;
  CHECK(reconstruction.IsValid(&error)) << error;
  for (int attempt = 0;; ++attempt) {
    auto solver = MakeFrameSolver(*scene,
                                  options,
                                  solvers,
                                  std::make_shared<SceneMeshes>(*scene),
                                  on_progress);
    if (options.contact != ContactKind::kCertified) return solver;
    const SceneIntersections& rest = *solver->contact().rest;
    const std::vector<int> unclean = UncleanMuscles(
        *scene, solver->contact(), attempt + 1 == reconstruction.max_attempts);
    const bool is_over = reconstruction.kind == ReconstructionKind::kNever ||
                         attempt == reconstruction.max_attempts;
    if (unclean.empty() ||
        (is_over && rest.IsClean() && rest.self_pairs == 0)) {
      for (const PreparedMuscle& muscle : scene->muscles) {
        if (!muscle.mesh.reconstruction.is_done) continue;
        scene->warnings.push_back(
            Warning(muscle.model.name, muscle.mesh.reconstruction));
        LOG(WARNING) << scene->warnings.back();
      }
      return solver;
    }
    if (is_over) {
      throw InputError(
          scene->scene.name,
          "the meshes cannot be separated in the rest pose: " +
              Describe(*scene, rest),
          reconstruction.kind == ReconstructionKind::kNever
              ? "let their surfaces be made anew (--remake=auto), or correct "
                "the meshes there"
              : "correct the meshes there");
    }
    if (!scene->as_delivered) {
      scene->as_delivered = solver->RestFrame().intersections;
    }
    if (on_progress) on_progress({"remaking", attempt, 0});
    Remake(reconstruction,
           prepare,
           unclean,
           ReconstructedSurfaces(reconstruction,
                                 options.certified.separation.cell,
                                 unclean,
                                 attempt,
                                 *scene),
           scene);
  }
}

}  // namespace musclewarp
