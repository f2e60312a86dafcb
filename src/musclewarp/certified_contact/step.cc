// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/certified_contact/step.h"

#include <glog/logging.h>

#include <optional>
#include <string>
#include <tuple>
#include <utility>

#include "musclewarp/certified_contact/defects.h"
#include "musclewarp/certified_contact/sheet_planes.h"
#include "musclewarp/certified_contact/volume.h"

namespace musclewarp {
namespace {

StepFaults FaultsOf(const StepOptions& options,
                    const StepDefects& defects,
                    double violation) {
  StepFaults faults;
  faults.crossing_pairs = defects.num_crossings();
  faults.self_crossing_pairs = static_cast<int>(defects.self_crossings.size());
  // Two muscles share a gap.
  faults.is_gap_violated = violation > (options.AimedGap() - options.gap) / 2;
  faults.folded_triangles = defects.num_folded();
  return faults;
}

// What a round has come to.
struct Round {
  StepSummary summary;
  std::vector<Points> points;
};

StepResult ResultOf(const ContactStep& step,
                    const std::vector<Points>& targets,
                    int rounds,
                    Round best) {
  best.summary.rounds = rounds;
  return {{std::move(best.points), targets, step.bones_from_rest},
          best.summary};
}

}  // namespace

bool IsBetter(const StepFaults& a, const StepFaults& b) {
  const auto rank = [](const StepFaults& faults) {
    return std::make_tuple(faults.crossing_pairs + faults.self_crossing_pairs,
                           faults.is_gap_violated,
                           faults.folded_triangles);
  };
  return rank(a) < rank(b);
}

OpenStep BeginStep(const StepOptions& options,
                   const ContactStep& step,
                   const std::vector<Points>& targets,
                   int sweeps) {
  OpenStep open{PlaneSet(options, step), StartOf(step), CarriedTrees(step)};
  std::vector<SeparatingPlane> planes =
      FindSeparatingPlanes(options, step, &open.trees);
  for (int i = 0; i < step.num_muscles(); ++i) {
    const std::vector<SeparatingPlane> sheets =
        FindPlanesBetweenSheets(options, step, i);
    planes.insert(planes.end(), sheets.begin(), sheets.end());
  }
  open.planes.Add(planes);
  open.relaxed = Relax(options,
                       step,
                       targets,
                       UniformStiffness(step.scene),
                       sweeps,
                       &open.planes,
                       std::move(open.relaxed));
  return open;
}

StepResult FinishStep(const StepOptions& options,
                      const ContactStep& step,
                      const std::vector<Points>& targets,
                      int sweeps,
                      OpenStep open) {
  Stiffness stiffness = UniformStiffness(step.scene);
  RelaxedPoints relaxed = std::move(open.relaxed);
  std::optional<Round> best;
  int polishing_rounds = 0;
  for (int round = 1; round <= options.max_rounds; ++round) {
    relaxed = Relax(options,
                    step,
                    targets,
                    stiffness,
                    round == 1 ? sweeps : options.repair_sweeps,
                    &open.planes,
                    std::move(relaxed));
    RestoredVolumes restored =
        RestoreVolumes(options, step, relaxed, &open.planes);
    relaxed.points = std::move(restored.points);
    const StepDefects defects =
        FindDefects(options, step, targets, relaxed.points, &open.trees);
    const double violation = open.planes.WorstViolation(relaxed.points);
    const StepFaults faults = FaultsOf(options, defects, violation);
    VLOG(2) << "round " << round << ": " << faults.crossing_pairs
            << " crossings, " << faults.self_crossing_pairs
            << " of muscles with themselves, " << faults.folded_triangles
            << " folded, violation " << violation << " mm";
    if (!best || IsBetter(faults, best->summary.faults)) {
      best = {{faults, round, violation, restored.worst_error}, relaxed.points};
    }
    const StepFaults& left = best->summary.faults;
    if (left.IsEmpty() ||
        (!left.HasCrossings() &&
         polishing_rounds++ == options.max_polishing_rounds)) {
      return ResultOf(step, targets, round, std::move(*best));
    }
    open.planes.Add(PlanesAgainst(defects, options, step, targets));
    stiffness =
        Stiffened(defects, options.defects, step.scene, std::move(stiffness));
  }
  return ResultOf(step, targets, options.max_rounds, std::move(*best));
}

StepResult AdvanceWithoutIntersection(
    const StepOptions& options,
    const ContactScene& scene,
    const ContactState& before,
    const std::vector<Points>& targets,
    const std::vector<Eigen::Matrix4d>& bones_from_rest) {
  std::string error;
  CHECK(options.IsValid(&error)) << error;
  const ContactStep step =
      MakeContactStep(scene, before, targets, bones_from_rest);
  return FinishStep(options,
                    step,
                    targets,
                    options.sweeps,
                    BeginStep(options, step, targets, 0));
}

}  // namespace musclewarp
