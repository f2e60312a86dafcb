// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/motion/pose_step.h"

#include <utility>

#include "musclewarp/base/stage_times.h"
#include "musclewarp/base/work_counts.h"
#include "musclewarp/motion/solved_pose.h"

namespace musclewarp {
namespace {

SolvedPose SolveFree(const MotionContext& context,
                     const ContactState& from,
                     const ScenePose& pose) {
  const ScopedStage stage("solve without contact");
  const MuscleModels models = ModelsOf(context.certified.muscles);
  return SolvePose(models,
                   pose,
                   context.pre_rotation,
                   context.solver,
                   Predict(models,
                           StatesOf(from.free_coarse),
                           from.pose,
                           pose,
                           context.pre_rotation));
}

// Solves the muscles with contact rows for the planes that their samples
// violate most. `goal`: the predicted state; `free`: the solution without
// contact. `summaries` receives those of both solves, merged.
CoarseSolution SolveWithContactRows(const MotionContext& context,
                                    const PlaneSet& planes,
                                    const std::vector<Points>& points,
                                    const ContactState& goal,
                                    const SolvedPose& free,
                                    std::vector<SolverSummary>* summaries) {
  const ScopedStage stage("solve with contact");
  const CertifiedScene& certified = context.certified;
  CoarseSolution solution;
  std::vector<OneSidedRows> rows;
  for (size_t i = 0; i < certified.muscles.size(); ++i) {
    solution.planes.push_back(planes.MostViolated(
        static_cast<int>(i), certified.samples[i], points[i], goal.targets[i]));
    rows.push_back(OneSidedRowsOf(solution.planes.back().spaces,
                                  certified.row_weights[i]));
    CountWork(WorkUnit::kRows, rows.back().size());
  }
  SolvedPose solved = SolveWithRows(ModelsOf(certified.muscles),
                                    free,
                                    goal.pose,
                                    context.pre_rotation,
                                    context.solver,
                                    rows,
                                    StatesOf(goal.coarse));
  solution.coarse = CoarseOf(solved.states);
  solution.targets = FineMeshes(certified, solution.coarse);
  *summaries = std::move(solved.summaries);
  return solution;
}

// Predicts the coarse meshes of the next step: those without contact plus the
// current displacement by contact.
std::vector<Points> MovedAlong(const ContactState& from,
                               const std::vector<Points>& free_coarse) {
  std::vector<Points> coarse = free_coarse;
  for (size_t i = 0; i < coarse.size(); ++i) {
    coarse[i] += from.coarse[i] - from.free_coarse[i];
  }
  return coarse;
}

// Returns the state of the coarse meshes in a pose, without its points.
ContactState GoalOf(const MotionContext& context,
                    const ScenePose& pose,
                    std::vector<Points> free_coarse,
                    std::vector<Points> coarse) {
  ContactState state;
  state.pose = pose;
  state.bones_from_rest = BonesFromRest(context.scene, pose);
  state.free_coarse = std::move(free_coarse);
  state.coarse = std::move(coarse);
  state.targets = FineMeshes(context.certified, state.coarse);
  state.held = AttachedIn(context.certified, pose);
  return state;
}

}  // namespace

PoseStepResult TakeStep(const MotionContext& context,
                        const PoseStep& step,
                        const ContactState& before,
                        const StepSolves& solves) {
  const SolvedPose free =
      step.is_settling
          ? SolvedPose{StatesOf(before.free_coarse), solves.free, 0}
          : SolveFree(context, before, step.pose);
  PoseStepResult result;
  result.solves.free = free.summaries;
  result.solves.all = step.is_settling ? solves.all : free.summaries;
  std::vector<Points> free_coarse = CoarseOf(free.states);
  std::vector<Points> coarse =
      step.is_settling ? before.coarse : MovedAlong(before, free_coarse);
  const StepGoal goal = {
      GoalOf(context, step.pose, std::move(free_coarse), std::move(coarse)),
      step.max_push};
  SolveCoarse solve_coarse;
  if (context.certified.options.coarse_weight > 0) {
    solve_coarse = [&](const PlaneSet& planes,
                       const std::vector<Points>& points) {
      return SolveWithContactRows(
          context, planes, points, goal.state, free, &result.solves.all);
    };
  }
  StepResult taken =
      Step(step.options, context.certified.contact, before, goal, solve_coarse);
  result.state = std::move(taken.state);
  result.summary = taken.summary;
  return result;
}

PoseStepResult GoWithoutContact(const MotionContext& context,
                                const ScenePose& pose,
                                const ContactState& before) {
  SolvedPose free = SolveFree(context, before, pose);
  PoseStepResult result;
  std::vector<Points> free_coarse = CoarseOf(free.states);
  std::vector<Points> coarse = MovedAlong(before, free_coarse);
  result.state =
      GoalOf(context, pose, std::move(free_coarse), std::move(coarse));
  result.state.points = before.points;
  for (size_t i = 0; i < before.points.size(); ++i) {
    result.state.points[i] += result.state.targets[i] - before.targets[i];
  }
  result.solves.free = free.summaries;
  result.solves.all = std::move(free.summaries);
  return result;
}

}  // namespace musclewarp
