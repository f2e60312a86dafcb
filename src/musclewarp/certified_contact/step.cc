// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/certified_contact/step.h"

#include <glog/logging.h>

#include <algorithm>
#include <optional>
#include <string>
#include <tuple>
#include <utility>

#include "musclewarp/certified_contact/bone_planes.h"
#include "musclewarp/certified_contact/defects.h"
#include "musclewarp/certified_contact/moves.h"
#include "musclewarp/certified_contact/relaxation.h"
#include "musclewarp/certified_contact/sheet_planes.h"
#include "musclewarp/certified_contact/tunnelling.h"
#include "musclewarp/certified_contact/volume.h"

namespace musclewarp {
namespace {

DefectCounts CountsOf(const StepOptions& options,
                      const Defects& defects,
                      double violation) {
  DefectCounts counts;
  counts.crossing_pairs = defects.num_crossings();
  counts.self_crossing_pairs = static_cast<int>(defects.self_crossings.size());
  counts.is_gap_violated = violation > options.AllowedViolation();
  counts.folded_triangles = defects.num_folded();
  return counts;
}

// Returns true if a step may end with these defects.
bool IsDone(const StepOptions& options,
            const DefectCounts& left,
            int polishing_rounds) {
  if (options.unfolds) return left.crossing_pairs == 0;
  return left.IsEmpty() || (!left.HasCrossings() &&
                            polishing_rounds >= options.max_polishing_rounds);
}

// The result of a round.
struct Round {
  StepSummary summary;
  std::vector<Points> points;
};

// The intermediate state of a step: its planes and the current vertices.
struct OpenStep {
  PlaneSet planes;
  RelaxedPoints relaxed;
  std::vector<TriangleBvh> trees;  // refitted for each search
  KeptBonePlanes kept;             // for the next step
};

StepResult ResultOf(const StepOptions& options,
                    const ContactStep& step,
                    ContactState state,
                    int rounds,
                    Round best) {
  StepSummary& summary = best.summary;
  summary.rounds = rounds;
  summary.push = MoveOfMostMoved(best.points, step.predicted, kPushedFarthest) +
                 summary.violation;
  summary.is_short_of_reach = summary.push < options.reach;
  const std::vector<double> pushes =
      MovesOfMost(best.points, step.predicted, kUnsettled);
  for (int i = 0; i < step.num_muscles(); ++i) {
    const bool is_far = pushes[i] >= 0.99 * ReachOf(options, step, i);
    summary.is_pushed_far.push_back(is_far);
    if (is_far) summary.is_short_of_reach = false;
  }
  state.points = std::move(best.points);
  return {std::move(state), summary};
}

StepResult GivenUp(double push, bool passes_bone) {
  StepResult result;
  result.summary.push = push;
  result.summary.is_given_up = true;
  result.summary.passes_bone = passes_bone;
  return result;
}

// Returns the volumes that are withheld after a step. Once a volume could not
// be restored, all that is missing adds to it, and what is too much is taken
// off.
std::vector<double> Withheld(const std::vector<double>& before,
                             const RestoredVolumes& restored) {
  std::vector<double> withheld = before;
  withheld.resize(restored.missing.size(), 0);
  bool is_any = false;
  for (size_t i = 0; i < withheld.size(); ++i) {
    if (!restored.is_limited[i] && withheld[i] == 0) continue;
    withheld[i] = std::max(0.0, withheld[i] + restored.missing[i]);
    is_any |= withheld[i] > 0;
  }
  if (!is_any) withheld.clear();
  return withheld;
}

// Finds the separating planes and relaxes the vertices between them.
OpenStep BeginStep(const StepOptions& options,
                   const ContactStep& step,
                   const std::vector<Points>& targets,
                   int sweeps) {
  OpenStep open{
      PlaneSet(options, step), StartOf(step), PredictedTrees(step), {}};
  std::vector<SeparatingPlane> planes =
      FindPlanesBetweenMuscles(options, step, open.trees);
  const auto add = [&](const std::vector<SeparatingPlane>& more) {
    planes.insert(planes.end(), more.begin(), more.end());
  };
  add(FindPlanesOfBones(options, step, &open.kept));
  for (int i = 0; i < step.num_muscles() && !options.unfolds; ++i) {
    if (!step.is_still[i]) add(FindPlanesBetweenSheets(options, step, i));
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

// Relaxes, restores volumes and finds defects until none are left. `state`: the
// result without its points.
StepResult FinishStep(const StepOptions& options,
                      const ContactStep& step,
                      ContactState state,
                      int sweeps,
                      OpenStep open) {
  const std::vector<Points>& targets = state.targets;
  Stiffness stiffness = UniformStiffness(step.scene);
  // Repairs settle in the planes, against which pressure would push.
  StepOptions repair = options;
  repair.relaxation.pressure_gain = 0;
  RelaxedPoints relaxed = std::move(open.relaxed);
  std::optional<Round> best;
  int polishing_rounds = 0;
  for (int round = 1; round <= options.max_rounds; ++round) {
    relaxed = Relax(round == 1 ? options : repair,
                    step,
                    targets,
                    stiffness,
                    round == 1 ? sweeps : options.repair_sweeps,
                    &open.planes,
                    std::move(relaxed));
    RestoredVolumes restored =
        RestoreVolumes(options, step, relaxed, &open.planes);
    relaxed.points = std::move(restored.points);
    if (round == 1) state.withheld = Withheld(step.before.withheld, restored);
    const bool is_limited = std::any_of(restored.is_limited.begin(),
                                        restored.is_limited.end(),
                                        [](char limited) { return limited; });
    Defects defects =
        FindDefects(options, step, targets, relaxed.points, &open.trees);
    const double violation = open.planes.WorstViolation(relaxed.points);
    const DefectCounts counts = CountsOf(options, defects, violation);
    VLOG(2) << "round " << round << ": " << counts.crossing_pairs
            << " crossings, " << counts.self_crossing_pairs
            << " of muscles with themselves, " << counts.folded_triangles
            << " folded, violation " << violation << " mm";
    if (!best || IsBetter(counts, best->summary.defects)) {
      best = {{counts, round, violation, restored.worst_error}, relaxed.points};
      best->summary.is_short_of_volume = is_limited;
    }
    const DefectCounts& left = best->summary.defects;
    if (IsDone(options, left, polishing_rounds)) {
      return ResultOf(options, step, std::move(state), round, std::move(*best));
    }
    if (!left.HasCrossings()) ++polishing_rounds;
    if (options.unfolds) defects.self_crossings.clear();
    open.planes.Add(PlanesAgainst(defects, options, step, targets));
    stiffness =
        Stiffened(defects, options.defects, step.scene, std::move(stiffness));
  }
  return ResultOf(
      options, step, std::move(state), options.max_rounds, std::move(*best));
}

}  // namespace

bool IsBetter(const DefectCounts& a, const DefectCounts& b) {
  const auto rank = [](const DefectCounts& counts) {
    return std::make_tuple(counts.crossing_pairs,
                           counts.self_crossing_pairs,
                           counts.is_gap_violated,
                           counts.folded_triangles);
  };
  return rank(a) < rank(b);
}

StepResult Step(const StepOptions& options,
                const ContactScene& scene,
                const ContactState& before,
                const StepGoal& goal,
                const SolveCoarse& solve_coarse) {
  std::string error;
  CHECK(options.IsValid(&error)) << error;
  ContactState state = goal.state;
  ContactStep step = MakeContactStep(scene,
                                     before,
                                     state.targets,
                                     state.bones_from_rest,
                                     state.held,
                                     goal.is_still);
  step.reaches = goal.reaches;
  if (goal.max_push < kInfinity) {
    const double passage = MaxTunnelling(step);
    if (passage > options.relaxation.max_push) {
      return GivenUp(passage, /*passes_bone=*/true);
    }
  }
  const int sweeps_before = solve_coarse ? options.sweeps / 2 : 0;
  OpenStep open = BeginStep(options, step, state.targets, sweeps_before);
  // The remaining sweeps hardly change the push.
  const double push =
      MoveOfMostMoved(open.relaxed.points, step.predicted, kPushedFarthest);
  if (push > goal.max_push) return GivenUp(push, /*passes_bone=*/false);
  state.planes.clear();
  state.bone_planes =
      std::make_shared<const KeptBonePlanes>(std::move(open.kept));
  if (solve_coarse) {
    CoarseSolution solution = solve_coarse(open.planes, open.relaxed.points);
    state.coarse = std::move(solution.coarse);
    state.targets = std::move(solution.targets);
    state.planes = std::move(solution.planes);
  }
  return FinishStep(options,
                    step,
                    std::move(state),
                    options.sweeps - sweeps_before,
                    std::move(open));
}

}  // namespace musclewarp
