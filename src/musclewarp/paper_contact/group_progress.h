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

// How a group of muscles in contact approaches rest, and when it is there.
struct GroupIterationOptions {
  // As in the paper down to 0.125, then on, slowly: a vertex in contact is
  // pulled in and put back in every iteration, by less the shorter the steps.
  StepLengthSchedule step_length = {0.125, 0.01, 0.97};

  // Of the volume error an iteration corrects alpha, but at least this share.
  // The paper corrects all of it at once, however short the step; where contact
  // takes a part of the correction back, that asks for ever more of the other
  // vertices. With alpha alone an error stays that balances what is taken back.
  double min_volume_share = 0.2;

  // At rest when no muscle's mean shape over so many iterations differs by
  // more, mm (root mean square over the vertices in contact), from that over as
  // many before, and the volumes are kept. Until the first time that this is
  // so, the volume is that of the coarse meshes (unless contact moves fine
  // vertices). Single moves do not tell, as vertices in contact never hold
  // still. The volume is made exact at the end.
  int window = 10;
  double drift_threshold = 0.25;
  double volume_tolerance = 0.02;  // relative

  int max_iterations = 500;

  bool IsValid(std::string* error) const;
};

// Keeps the summaries of the muscles of a group while a solver iterates on all
// of them at once.
class GroupProgress {
 public:
  // Keeps references to all but the states, which are the start.
  GroupProgress(const std::vector<const MuscleModel*>& models,
                const std::vector<MuscleTarget>& targets,
                const std::vector<MuscleState>& start,
                const GroupIterationOptions& options,
                const GroupContact& contact,
                std::vector<SolverSummary>* summaries);

  // For the next iteration.
  double alpha() const { return alpha_; }
  // For the correction of the volume, see min_volume_share: the full step is to
  // correct the volume error over this.
  double volume_alpha() const;
  bool is_fine_volume() const { return is_fine_volume_; }

  // After an iteration: adds it to the histories. `volume_errors`: relative, of
  // the states the steps were for.
  void Record(const GroupContact& contact,
              const std::vector<double>& volume_errors);

  void Fail(int muscle, const std::string& message);

  // Converged, failed or at the limit of iterations.
  bool IsOver() const { return is_over_; }

  // Energies, volume ratios and times, at the end.
  void Finish(const std::vector<MuscleState>& states);

 private:
  int iterations() const { return (*summaries_)[0].iterations; }
  // The difference of the mean shapes of two windows, mm; infinite but at the
  // end of a window.
  double Drift(const GroupContact& contact);
  void End(StopReason reason, const std::string& message);

  const Stopwatch stopwatch_;
  const std::vector<const MuscleModel*>& models_;
  const std::vector<MuscleTarget>& targets_;
  const GroupIterationOptions& options_;
  std::vector<SolverSummary>* summaries_;
  double alpha_;
  bool is_fine_volume_;
  std::vector<Points> window_sums_;
  std::vector<Points> previous_sums_;  // none before the second window
  bool is_over_ = false;
};

}  // namespace musclewarp
