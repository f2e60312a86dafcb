// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/frame_solvers/rest_separation.h"

#include <glog/logging.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <sstream>
#include <utility>
#include <vector>

#include "musclewarp/base/input_error.h"
#include "musclewarp/base/option_check.h"
#include "musclewarp/base/parallel_for.h"
#include "musclewarp/base/stopwatch.h"
#include "musclewarp/base/text.h"
#include "musclewarp/frame_solvers/certified_frame.h"
#include "musclewarp/frame_solvers/reconstructed_surfaces.h"
#include "musclewarp/frame_solvers/reconstruction_loss.h"
#include "musclewarp/frame_solvers/rest_retriangulation.h"
#include "musclewarp/frames/frame_measures.h"
#include "musclewarp/mesh/measures.h"

namespace musclewarp {
namespace {

using Reasons = std::map<int, ReconstructionReason>;  // by muscle

// Returns the muscles that need reconstruction, each with its worst reason.
Reasons UncleanMuscles(const ReconstructionOptions& options,
                       const RestResult& rest) {
  Reasons reasons;
  for (const PairFigures& pair : rest.intersections.pairs) {
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
  if (!options.reconstructs_displaced) return reasons;
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
  const double body_size = scene.scene.body_size;
  std::ostringstream text;
  const char* separator = "";
  for (const PairFigures& pair : rest.pairs) {
    if (!pair.Counts()) continue;
    text << separator << pair.a << " crosses " << pair.b << " around "
         << PlaceText(pair.place, body_size) << ", "
         << LengthText(pair.max_depth_mm, body_size) << " deep";
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
                    const SurfaceReconstruction& reconstruction,
                    double body_size) {
  const double cm3 = std::pow(body_size, 3) / 1000;
  const double cm2 = std::pow(body_size, 2) / 100;
  std::ostringstream text;
  text << name << " could not be separated by moving its vertices ("
       << Text(reconstruction.reason) << "), so its mesh was made anew: "
       << MeasureText(reconstruction.volume_before * cm3) << " cm3 before, "
       << MeasureText(reconstruction.volume_after * cm3) << " cm3 after; "
       << MeasureText(reconstruction.lost_area * cm2)
       << " cm2 of the old surface are not part of the new one";
  if (reconstruction.lost_area > 0) {
    text << ", around " << PlaceText(reconstruction.place, body_size) << ", "
         << LengthText(reconstruction.farthest, body_size) << " away at most";
  }
  return text.str();
}

// Throws InputError if too little of a muscle is left.
void CheckEnoughIsLeft(const ReconstructionOptions& options,
                       const MuscleModel& before,
                       const TriangleSoup& after) {
  const double share =
      SignedVolume(after.points, after.triangles) / before.rest_volume;
  if (share >= options.least_volume_fraction) return;
  throw InputError(before.name,
                   "only " + std::to_string(static_cast<int>(100 * share)) +
                       " % of the muscle lies outside bones and other muscles",
                   "check that the meshes are in one frame, or correct them");
}

// Returns the names of muscles to be reconstructed.
std::string NamesOf(const Reasons& reasons, const PreparedScene& scene) {
  std::string names;
  for (const auto& [muscle, reason] : reasons) {
    if (!names.empty()) names += ", ";
    names += scene.muscles[muscle].model.name;
  }
  return names;
}

// What muscles were before their first reconstruction, by muscle.
using DeliveredMuscles = std::map<int, DeliveredMuscle>;

// Reconstructs the meshes of muscles. Repeated reconstructions keep the reason
// of the first one.
void Reconstruct(const RestSeparationOptions& options,
                 const Reasons& reasons,
                 int attempt,
                 DeliveredMuscles* delivered,
                 PreparedScene* scene) {
  std::vector<int> muscles;
  const SceneMeshes meshes(*scene);
  for (const auto& [muscle, reason] : reasons) {
    muscles.push_back(muscle);
    if (delivered->count(muscle) > 0) continue;
    delivered->emplace(muscle, DeliveredMuscleOf(*scene, meshes, muscle));
  }
  std::vector<TriangleSoup> surfaces =
      ReconstructedSurfaces(options.reconstruction,
                            options.contact.SeparationByGap().cell,
                            muscles,
                            attempt,
                            *scene);
  for (size_t k = 0; k < muscles.size(); ++k) {
    CheckEnoughIsLeft(
        options.reconstruction, scene->muscles[muscles[k]].model, surfaces[k]);
  }
  ReplaceMuscleMeshes(options.prepare, muscles, std::move(surfaces), scene);
  ParallelFor(muscles.size(), [&](size_t k) {
    PreparedMuscle& muscle = scene->muscles[muscles[k]];
    SurfaceReconstruction& known = muscle.mesh.reconstruction;
    const ReconstructionReason reason =
        known.is_done ? known.reason : reasons.at(muscles[k]);
    known = LossOf(delivered->at(muscles[k]), muscle);
    known.reason = reason;
  });
}

// Separates the meshes without reconstruction. `cells`: of earlier attempts.
RestResult SeparateOnce(const RestSeparationOptions& options,
                        const MuscleSolver& solver,
                        const ProgressCallback& on_progress,
                        const PreparedScene& scene,
                        KnownCells* cells) {
  SceneMeshes meshes(scene);
  CertifiedScene certified = PrepareCertifiedScene(scene,
                                                   meshes,
                                                   options.contact,
                                                   options.pre_rotation,
                                                   solver,
                                                   on_progress,
                                                   cells);
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
    scene->warnings.push_back(Warning(
        muscle.model.name, muscle.mesh.reconstruction, scene->scene.body_size));
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
      .IsAtLeast("max_lost_thin_area", max_lost_thin_area, 0)
      .IsAbove("least_spacing", least_spacing, 0)
      .IsAtLeast("bridge", bridge, 0)
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
  DeliveredMuscles delivered;
  KnownCells cells;
  for (int attempt = 0;; ++attempt) {
    RestResult result =
        SeparateOnce(options, solver, on_progress, *scene, &cells);
    Reasons reasons = UncleanMuscles(options.reconstruction, result);
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
          is_never ? "let their surfaces be made anew ({remake}=auto), or "
                     "correct the meshes there"
                   : "correct the meshes there");
    }
    if (!scene->as_delivered) {
      SceneMeshes meshes(*scene);
      scene->as_delivered = IntersectAsPrepared(*scene, &meshes);
    }
    // The last attempt reconstructs all of them.
    if (attempt + 1 < max_attempts) KeepWorst(&reasons);
    if (on_progress) {
      on_progress({"remaking", attempt, 0, NamesOf(reasons, *scene)});
    }
    Reconstruct(options, reasons, attempt, &delivered, scene);
  }
}

}  // namespace musclewarp
