// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "musclewarp/base/stopwatch.h"
#include "musclewarp/paper_contact/group_contact.h"
#include "musclewarp/solver/muscle_model.h"
#include "musclewarp/solver/muscle_state.h"
#include "musclewarp/solver/muscle_target.h"
#include "musclewarp/solver/solver_summary.h"
#include "musclewarp/solver/step_length.h"

namespace musclewarp {

// How a group of muscles in contact approaches rest, and when it is at rest.
struct GroupIterationOptions {
  // Starts where the paper's schedule ends and continues slowly below it. A
  // vertex in contact is pulled in and put back in every iteration, by a
  // smaller amount the shorter the steps are.
  StepLengthSchedule step_length = {0.125, 0.01, 0.97};

  // Each iteration corrects the share alpha of the volume error, but at least
  // this share. The paper corrects all of it however short the step is; where
  // contact undoes a part of the correction, that asks for more and more of the
  // other vertices. The share alpha alone would leave an error at which the
  // correction and what contact undoes are in balance.
  double min_volume_fraction = 0.2;

  // The group is at rest when, for every muscle, the mean shape of the last
  // `window` iterations differs by less than drift_threshold, mm (root mean
  // square over the vertices in contact), from that of the `window` iterations
  // before. Single moves would not tell, because vertices in contact never hold
  // still.
  int window = 10;
  double drift_threshold = 0.25;

  // The solver has converged when the group is at rest and the fine volumes are
  // within this relative tolerance; they are made exact at the end. Until the
  // group is at rest for the first time the volumes are those of the coarse
  // meshes, unless contact moves fine vertices.
  double volume_tolerance = 0.02;

  // The solver gives up after this many iterations.
  int max_iterations = 500;

  // Returns false and names the field, its value and the rule if a field, one
  // of step_length included, is out of range.
  bool IsValid(std::string* error) const;
};

// Decides on step length, volume mesh and convergence for a solver that
// iterates on all muscles of a group at once, and writes their summaries. It is
// shared by the reference solver and the Ceres solver:
//
//   GroupProgress progress(...);
//   while (!progress.IsOver()) {  // an iteration
//     ... step by progress.alpha() ...
//     progress.Record(contact, volume_errors);
//   }
//   progress.Finish(states);
class GroupProgress {
 public:
  // Keeps references to all arguments but `start` and `contact`. `start` are
  // the states before the first step.
  // Preconditions (CHECKed): the options are valid; there are as many models,
  // targets and states, and at least one.
  GroupProgress(const std::vector<const MuscleModel*>& models,
                const std::vector<MuscleTarget>& targets,
                const std::vector<MuscleState>& start,
                const GroupIterationOptions& options,
                const GroupContact& contact,
                std::vector<SolverSummary>* summaries);

  // The step length of the next iteration.
  double alpha() const { return alpha_; }

  // The divisor of the volume error for the next iteration: the full step is to
  // correct the error over this, so that the shortened step corrects
  // max(alpha, min_volume_fraction) of it.
  double volume_alpha() const;

  // Whether the next iteration is to use the volume of the fine meshes.
  bool is_fine_volume() const { return is_fine_volume_; }

  // Adds an iteration to the histories and decides whether it was the last.
  // `volume_errors` are relative, one per muscle, of the states from which the
  // steps started.
  void Record(const GroupContact& contact,
              const std::vector<double>& volume_errors);

  // Ends the solve of all muscles as failed, because of one of them.
  void Fail(int muscle, const std::string& message);

  // Whether the solve has converged, failed or reached the iteration limit.
  bool IsOver() const { return is_over_; }

  // Fills in final energies, volume ratios and times, at the end.
  void Finish(const std::vector<MuscleState>& states);

 private:
  int iterations() const { return (*summaries_)[0].iterations; }
  // Returns the largest difference between the mean shapes of the last two
  // windows, mm; infinity unless a window, other than the first, has just
  // ended.
  double Drift(const GroupContact& contact);
  void End(StopReason reason, const std::string& message);

  const Stopwatch stopwatch_;
  const std::vector<const MuscleModel*>& models_;
  const std::vector<MuscleTarget>& targets_;
  const GroupIterationOptions& options_;
  std::vector<SolverSummary>* summaries_;
  double alpha_;
  bool is_fine_volume_;
  std::vector<Points> window_sums_;    // of the points in this window
  std::vector<Points> previous_sums_;  // of the one before; empty in the first
  bool is_over_ = false;
};

}  // namespace musclewarp
