// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <functional>
#include <vector>

#include "musclewarp/base/infinity.h"
#include "musclewarp/certified_contact/contact_step.h"
#include "musclewarp/certified_contact/plane_set.h"
#include "musclewarp/certified_contact/step_options.h"

namespace musclewarp {

// What is wrong at the end of a step.
struct DefectCounts {
  int crossing_pairs = 0;       // of triangles of two meshes
  int self_crossing_pairs = 0;  // of triangles of one muscle

  // A vertex is beyond a plane by more than the gap has to spare.
  bool is_gap_violated = false;

  // Of the muscles that have more of them than
  // DefectOptions::max_folded_fraction.
  int folded_triangles = 0;

  bool HasCrossings() const { return crossing_pairs + self_crossing_pairs > 0; }
  bool IsEmpty() const {
    return !HasCrossings() && !is_gap_violated && folded_triangles == 0;
  }
};

// Returns true if `a` is less bad than `b`: crossings are the worst, then the
// gap.
bool IsBetter(const DefectCounts& a, const DefectCounts& b);

// How far contact moves vertices beside the way that their muscle is carried is
// measured without the share of them that moves farthest: single vertices are
// pushed far where muscles are squeezed.
constexpr double kPushedFarthest = 1.0 / 100;  // for the length of steps
constexpr double kUnsettled = 1.0 / 500;       // for what has settled

struct StepSummary {
  DefectCounts defects;
  int rounds = 0;
  double violation = 0;     // of a plane by a vertex, at most, mm
  double volume_error = 0;  // relative, the worst of all muscles

  // How far contact has pushed the muscle that it pushed farthest, mm, but for
  // the share kPushedFarthest of its vertices.
  double push = 0;

  // True if muscles, but for the share kUnsettled of their vertices, are pushed
  // by less than the reach, so that no second step would push them farther.
  bool is_short_of_reach = false;

  // True if the step was given up because it pushes muscles too far. There is
  // no state then.
  bool is_given_up = false;
};

struct StepResult {
  ContactState state;  // of the best round, whatever the summary says
  StepSummary summary;
};

// Where a step goes.
struct StepGoal {
  // The state as it is predicted: its pose, its bones, what they hold, and the
  // coarse meshes, which carry the vertices to its targets. Its points and
  // planes are not read.
  ContactState state;

  // A step that pushes muscles farther is given up, mm; and so is one that
  // carries them so far through a bone that planes cannot hold them, unless
  // this is infinite.
  double max_push = kInfinity;
};

// What the coarse meshes become as they make way for planes, by muscle; see
// ContactState.
struct CoarseSolution {
  std::vector<Points> coarse;
  std::vector<Points> targets;
  std::vector<OwnedHalfSpaces> planes;
};

// Solves the coarse meshes so that they make way for the planes, as far as
// PlaneSet::MostViolated says. `points`: the vertices between the planes, #V x
// 3 each, mm.
using SolveCoarse = std::function<CoarseSolution(
    const PlaneSet& planes, const std::vector<Points>& points)>;

// Moves muscles and bones from `before`, in which no triangles cross, to the
// goal, so that none cross there. Separating planes are found, vertices are
// relaxed between them, by half of the sweeps, the coarse meshes are solved to
// make way for the planes, and the other half follows. Then volumes are
// restored and defects are found, and rounds go on with planes against these
// until there are none, at most so many rounds. The best round counts. If
// triangles cross at the end, the step was too long, or there is no room.
//
// Without `solve_coarse` the coarse meshes stay where the goal has them.
// Precondition (CHECKed): the options are valid.
StepResult Step(const StepOptions& options,
                const ContactScene& scene,
                const ContactState& before,
                const StepGoal& goal,
                const SolveCoarse& solve_coarse = nullptr);

}  // namespace musclewarp
