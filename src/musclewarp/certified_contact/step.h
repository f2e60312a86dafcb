// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <vector>

#include "musclewarp/certified_contact/contact_step.h"
#include "musclewarp/certified_contact/plane_set.h"
#include "musclewarp/certified_contact/relaxation.h"
#include "musclewarp/certified_contact/step_options.h"

namespace musclewarp {

// What is wrong at the end of a step.
struct StepFaults {
  int crossing_pairs = 0;       // of triangles of two meshes
  int self_crossing_pairs = 0;  // of triangles of one muscle

  // A vertex is beyond a plane by more than the gap has to spare.
  bool is_gap_violated = false;

  // Of the muscles that have more of them than DefectOptions::max_folded_share.
  int folded_triangles = 0;

  bool HasCrossings() const { return crossing_pairs + self_crossing_pairs > 0; }
  bool IsEmpty() const {
    return !HasCrossings() && !is_gap_violated && folded_triangles == 0;
  }
};

// Returns true if `a` is less bad than `b`: crossings are the worst, then the
// gap.
bool IsBetter(const StepFaults& a, const StepFaults& b);

struct StepSummary {
  StepFaults faults;
  int rounds = 0;
  double violation = 0;     // of a plane by a vertex, at most, mm
  double volume_error = 0;  // relative, the worst of all muscles
};

struct StepResult {
  ContactState state;  // of the best round, whatever the summary says
  StepSummary summary;
};

// A step that is under way: its planes, and how far the vertices have come.
struct OpenStep {
  PlaneSet planes;
  RelaxedPoints relaxed;
  std::vector<TriangleBvh> trees;  // fitted to whatever is searched
};

// Finds the separating planes of a step and relaxes the vertices between them
// by `sweeps` sweeps. From there on the planes tell what the coarse meshes
// should make way for (PlaneSet::MostViolated). Keeps references to the options
// and the step.
OpenStep BeginStep(const StepOptions& options,
                   const ContactStep& step,
                   const std::vector<Points>& targets,
                   int sweeps);

// Ends a step: relaxes by `sweeps` sweeps, restores volumes, finds defects, and
// goes on with planes against these until there are none, at most so many
// rounds. The best round counts. `targets`: where the coarse meshes have the
// vertices now, #V x 3 each, mm. If triangles cross at the end, the step was
// too long or there is no room.
StepResult FinishStep(const StepOptions& options,
                      const ContactStep& step,
                      const std::vector<Points>& targets,
                      int sweeps,
                      OpenStep open);

// Moves muscles and bones from `before`, in which no triangles cross, to where
// the coarse meshes have the vertices at `targets` (#V x 3 each, mm) and the
// bones are at `bones_from_rest`, so that none cross there: both parts of a
// step, without a coarse solve between. Precondition (CHECKed): the options are
// valid.
StepResult AdvanceWithoutIntersection(
    const StepOptions& options,
    const ContactScene& scene,
    const ContactState& before,
    const std::vector<Points>& targets,
    const std::vector<Eigen::Matrix4d>& bones_from_rest);

}  // namespace musclewarp
