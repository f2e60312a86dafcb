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

// What is wrong after a round, the worst first: triangles that cross, a plane
// that a vertex is beyond by more than the gap has to spare, and triangles that
// are folded.
using RoundFaults = std::tuple<size_t, bool, int>;

RoundFaults FaultsOf(const StepOptions& options,
                     const StepDefects& defects,
                     double violation) {
  // Two muscles share a gap.
  const double allowed = (options.AimedGap() - options.gap) / 2;
  return {defects.num_crossings() + defects.self_crossings.size(),
          violation > allowed,
          defects.num_folded()};
}

// What a round has come to.
struct Round {
  RoundFaults faults;
  std::vector<Points> points;
  int crossing_pairs = 0;
  double violation = 0;
  double volume_error = 0;

  bool IsFree() const { return std::get<0>(faults) == 0; }
};

StepResult ResultOf(const ContactStep& step,
                    const std::vector<Points>& targets,
                    int rounds,
                    Round best) {
  StepSummary summary;
  summary.is_intersection_free = best.IsFree();
  summary.rounds = rounds;
  summary.crossing_pairs = best.crossing_pairs;
  summary.violation = best.violation;
  summary.volume_error = best.volume_error;
  return {{std::move(best.points), targets, step.bones_from_rest}, summary};
}

}  // namespace

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
    const RoundFaults faults = FaultsOf(options, defects, violation);
    VLOG(2) << "round " << round << ": " << defects.num_crossings()
            << " crossings, " << defects.self_crossings.size()
            << " of muscles with themselves, " << defects.num_folded()
            << " folded, violation " << violation << " mm";
    if (!best || faults < best->faults) {
      best = {faults,
              relaxed.points,
              defects.num_crossings(),
              violation,
              restored.worst_error};
    }
    if (best->faults == RoundFaults() ||
        (best->IsFree() &&
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
