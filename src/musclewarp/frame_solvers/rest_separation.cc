// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/frame_solvers/rest_separation.h"

#include <glog/logging.h>

#include <algorithm>
#include <iomanip>
#include <iterator>
#include <map>
#include <sstream>
#include <utility>
#include <vector>

#include "musclewarp/base/input_error.h"
#include "musclewarp/base/option_check.h"
#include "musclewarp/base/parallel_for.h"
#include "musclewarp/base/stopwatch.h"
#include "musclewarp/frame_solvers/certified_frame.h"
#include "musclewarp/frame_solvers/reconstructed_surfaces.h"
#include "musclewarp/frame_solvers/rest_retriangulation.h"
#include "musclewarp/frames/frame_measures.h"
#include "musclewarp/mesh/measures.h"

namespace musclewarp {
namespace {

using Reasons = std::map<int, ReconstructionReason>;  // by muscle

// Returns the muscles that need reconstruction, each with its worst reason.
Reasons UncleanMuscles(const RestResult& rest) {
  Reasons reasons;
  for (const PairIntersection& pair : rest.intersections.pairs) {
    if (!pair.Counts()) continue;
    for (const int muscle : {pair.muscle_a, pair.muscle_b}) {
      if (muscle < 0) continue;
      const ReconstructionReason reason =
          pair.muscle_b < 0 ? ReconstructionReason::kCrossesBone
                            : ReconstructionReason::kCrossesMuscle;
      const auto known = reasons.emplace(muscle, reason).first;
      known->second = std::min(known->second, reason);
    }
  }
  const std::vector<int>& self_pairs = rest.intersections.self_pairs_of_muscles;
  for (size_t i = 0; i < self_pairs.size(); ++i) {
    if (self_pairs[i] == 0) continue;
    reasons.emplace(static_cast<int>(i), ReconstructionReason::kCrossesItself);
  }
  for (const int muscle : rest.displaced) {
    reasons.emplace(muscle, ReconstructionReason::kDisplaced);
  }
  return reasons;
}

// Keeps only the muscles with the worst reason, as its repair may remove the
// others: a muscle that crosses a bone blocks those around it, and a muscle
// that crosses others may cross itself or be displaced as a consequence.
void KeepWorst(Reasons* reasons) {
  const auto is_better = [](const auto& a, const auto& b) {
    return a.second < b.second;
  };
  const auto worst =
      std::min_element(reasons->begin(), reasons->end(), is_better);
  if (worst == reasons->end()) return;
  const ReconstructionReason reason = worst->second;
  for (auto muscle = reasons->begin(); muscle != reasons->end();) {
    muscle =
        muscle->second == reason ? std::next(muscle) : reasons->erase(muscle);
  }
}

// Returns the places of all crossings, one clause each.
std::string Describe(const PreparedScene& scene,
                     const SceneIntersections& rest) {
  std::ostringstream text;
  text << std::fixed << std::setprecision(1);
  const char* separator = "";
  for (const PairIntersection& pair : rest.pairs) {
    if (!pair.Counts()) continue;
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

// Returns the reason for which moving the vertices of a muscle was not enough.
std::string Text(ReconstructionReason reason) {
  switch (reason) {
    case ReconstructionReason::kCrossesBone:
      return "it still crossed a bone";
    case ReconstructionReason::kCrossesMuscle:
      return "it still crossed a muscle";
    case ReconstructionReason::kCrossesItself:
      return "it crossed itself";
    case ReconstructionReason::kDisplaced:
      return "parts of it moved too far";
  }
  LOG(FATAL) << "no such reason";
}

std::string Warning(const std::string& name,
                    const SurfaceReconstruction& reconstruction) {
  std::ostringstream text;
  text << std::fixed << std::setprecision(1) << name
       << " could not be separated by moving its vertices ("
       << Text(reconstruction.reason) << "), so its mesh was made anew: "
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
      options.least_volume_fraction * reconstruction.volume_before) {
    return;
  }
  throw InputError(
      name,
      "only " +
          std::to_string(static_cast<int>(100 * reconstruction.volume_after /
                                          reconstruction.volume_before)) +
          " % of the muscle lies outside bones and other muscles",
      "check that the meshes are in one frame, or correct them");
}

// Reconstructs the meshes of muscles. Repeated reconstructions keep the volume
// before and the reason of the first one.
void Reconstruct(const RestSeparationOptions& options,
                 const Reasons& reasons,
                 int attempt,
                 PreparedScene* scene) {
  std::vector<int> muscles;
  for (const auto& [muscle, reason] : reasons) muscles.push_back(muscle);
  std::vector<TriangleSoup> surfaces =
      ReconstructedSurfaces(options.reconstruction,
                            options.contact.separation.cell,
                            muscles,
                            attempt,
                            *scene);
  const SceneMeshes meshes(*scene);
  std::vector<SurfaceReconstruction> reconstructions(muscles.size());
  ParallelFor(muscles.size(), [&](size_t k) {
    const int i = muscles[k];
    reconstructions[k] = Compare(*meshes.muscles()[i].mesh, surfaces[k]);
    CheckEnoughIsLeft(options.reconstruction,
                      scene->muscles[i].model.name,
                      reconstructions[k]);
  });
  ReplaceMuscleMeshes(options.prepare, muscles, std::move(surfaces), scene);
  for (size_t k = 0; k < muscles.size(); ++k) {
    PreparedMuscle& muscle = scene->muscles[muscles[k]];
    SurfaceReconstruction& known = muscle.mesh.reconstruction;
    // The removal of slivers has changed the volume slightly.
    reconstructions[k].volume_after = muscle.model.rest_volume;
    reconstructions[k].reason = reasons.at(muscles[k]);
    if (known.is_done) {
      reconstructions[k].volume_before = known.volume_before;
      reconstructions[k].reason = known.reason;
    }
    known = reconstructions[k];
  }
}

// Separates the meshes without reconstruction.
RestResult SeparateOnce(const RestSeparationOptions& options,
                        const MuscleSolver& solver,
                        const ProgressCallback& on_progress,
                        const PreparedScene& scene) {
  SceneMeshes meshes(scene);
  CertifiedScene certified = PrepareCertifiedScene(scene,
                                                   meshes,
                                                   options.contact,
                                                   options.pre_rotation,
                                                   solver,
                                                   on_progress);
  return RestResultOf(
      scene, std::move(certified), options.requirements, &meshes);
}

// Returns the reconstructed muscles, and adds a warning for each.
std::vector<int> ReportReconstructions(PreparedScene* scene) {
  std::vector<int> reconstructed;
  for (size_t i = 0; i < scene->muscles.size(); ++i) {
    const PreparedMuscle& muscle = scene->muscles[i];
    if (!muscle.mesh.reconstruction.is_done) continue;
    reconstructed.push_back(static_cast<int>(i));
    scene->warnings.push_back(
        Warning(muscle.model.name, muscle.mesh.reconstruction));
    LOG(WARNING) << scene->warnings.back();
  }
  return reconstructed;
}

}  // namespace

bool ReconstructionOptions::IsValid(std::string* error) const {
  return OptionCheck("ReconstructionOptions", error)
      .IsAtLeast("margin_growth", margin_growth, 1)
      .IsAtLeast("max_growths", max_growths, 0)
      .IsAtLeast("max_attempts", max_attempts, 1)
      .IsWithin("max_loss_by_margin", max_loss_by_margin, 0, 1)
      .IsAbove("spacing_fraction", spacing_fraction, 0)
      .IsAbove("min_spacing", min_spacing, 0)
      .IsAtLeast("max_spacing", max_spacing, min_spacing)
      .IsAtLeast("samples_across", samples_across, 1)
      .IsWithin("least_volume_fraction", least_volume_fraction, 0, 1)
      .is_valid();
}

bool RestSeparationOptions::IsValid(std::string* error) const {
  return OptionCheck("RestSeparationOptions", error)
             .IsAtLeast("max_retriangulations", max_retriangulations, 0)
             .IsAtLeast("relaxing_steps", relaxing_steps, 0)
             .is_valid() &&
         contact.IsValid(error) && requirements.IsValid(error) &&
         prepare.IsValid(error) && reconstruction.IsValid(error) &&
         drawn_out.IsValid(error);
}

RestResult SeparateRest(const RestSeparationOptions& options,
                        const MuscleSolver& solver,
                        const ProgressCallback& on_progress,
                        PreparedScene* scene) {
  const Stopwatch separating;
  std::string error;
  CHECK(options.IsValid(&error)) << error;
  const bool is_never =
      options.reconstruction.kind == ReconstructionKind::kNever;
  const int max_attempts = options.reconstruction.max_attempts;
  for (int attempt = 0;; ++attempt) {
    RestResult result = SeparateOnce(options, solver, on_progress, *scene);
    Reasons reasons = UncleanMuscles(result);
    const bool is_over = is_never || attempt == max_attempts;
    const bool is_clean =
        result.intersections.IsClean() && result.intersections.self_pairs == 0;
    if (reasons.empty() || (is_over && is_clean)) {
      RetriangulateDrawnOut(options, solver, on_progress, scene, &result);
      result.reconstructed = ReportReconstructions(scene);
      result.wall_ms = separating.Milliseconds();
      return result;
    }
    if (is_over) {
      throw InputError(
          scene->scene.name,
          "the meshes cannot be separated in the rest pose: " +
              Describe(*scene, result.intersections),
          is_never ? "let their surfaces be made anew (--remake=auto), or "
                     "correct the meshes there"
                   : "correct the meshes there");
    }
    if (!scene->as_delivered) {
      SceneMeshes meshes(*scene);
      scene->as_delivered = IntersectAsPrepared(*scene, &meshes);
    }
    if (on_progress) on_progress({"remaking", attempt, 0});
    // The last attempt reconstructs all of them.
    if (attempt + 1 < max_attempts) KeepWorst(&reasons);
    Reconstruct(options, reasons, attempt, scene);
  }
}

}  // namespace musclewarp
