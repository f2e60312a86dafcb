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

// Solves the muscles that move with contact rows for the planes that their
// samples violate most; the others keep what they have. `goal`: the predicted
// state; `free`: the solution without contact. `summaries` receives those of
// both solves, merged.
CoarseSolution SolveWithContactRows(const MotionContext& context,
                                    const PlaneSet& planes,
                                    const std::vector<Points>& points,
                                    const std::vector<char>& is_still,
                                    const ContactState& goal,
                                    const SolvedPose& free,
                                    std::vector<SolverSummary>* summaries) {
  const ScopedStage stage("solve with contact");
  const CertifiedScene& certified = context.certified;
  CoarseSolution solution{goal.coarse, goal.targets, goal.planes};
  solution.planes.resize(certified.muscles.size());
  const auto moves = [&](size_t i) { return is_still.empty() || !is_still[i]; };
  std::vector<OneSidedRows> rows(certified.muscles.size());
  for (size_t i = 0; i < certified.muscles.size(); ++i) {
    if (!moves(i)) continue;
    solution.planes[i] = planes.MostViolated(
        static_cast<int>(i), certified.samples[i], points[i], goal.targets[i]);
    rows[i] =
        OneSidedRowsOf(solution.planes[i].spaces, certified.row_weights[i]);
    CountWork(WorkUnit::kRows, rows[i].size());
  }
  SolvedPose solved = SolveWithRows(ModelsOf(certified.muscles),
                                    free,
                                    goal.pose,
                                    context.pre_rotation,
                                    context.solver,
                                    rows,
                                    StatesOf(goal.coarse));
#pragma omp parallel for schedule(dynamic, 1)
  for (size_t i = 0; i < certified.muscles.size(); ++i) {
    if (!moves(i)) continue;
    solution.coarse[i] = std::move(solved.states[i].coarse);
    solution.targets[i] =
        FinePoints(certified.muscles[i]->model, {solution.coarse[i], {}});
    (*summaries)[i] = std::move(solved.summaries[i]);
  }
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

// Returns the state of the coarse meshes in a pose, without its points and
// planes.
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
  PoseStepResult result;
  SolvedPose free;
  StepGoal goal;
  if (step.is_settling) {
    free = {StatesOf(before.free_coarse), solves.free, 0};
    result.solves.all = solves.all;
    goal.state = before;
    goal.state.points.clear();
  } else {
    free = SolveFree(context, before, step.pose);
    result.solves.all = free.summaries;
    std::vector<Points> free_coarse = CoarseOf(free.states);
    std::vector<Points> coarse = MovedAlong(before, free_coarse);
    goal.state =
        GoalOf(context, step.pose, std::move(free_coarse), std::move(coarse));
  }
  result.solves.free = free.summaries;
  goal.max_push = step.max_push;
  goal.is_still = step.is_still;
  goal.reaches = step.reaches;
  SolveCoarse solve_coarse;
  if (context.certified.options.coarse_weight > 0) {
    solve_coarse = [&](const PlaneSet& planes,
                       const std::vector<Points>& points) {
      return SolveWithContactRows(context,
                                  planes,
                                  points,
                                  step.is_still,
                                  goal.state,
                                  free,
                                  &result.solves.all);
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
