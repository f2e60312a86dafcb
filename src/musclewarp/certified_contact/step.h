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

// The numbers of defects at the end of a step, by which rounds are compared.
struct DefectCounts {
  int crossing_pairs = 0;       // of triangles of two meshes
  int self_crossing_pairs = 0;  // of triangles of one muscle

  // True if a vertex violates a plane by more than
  // StepOptions::AllowedViolation().
  bool is_gap_violated = false;

  // Of muscles with more than DefectOptions::max_folded_fraction of them.
  int folded_triangles = 0;

  bool HasCrossings() const { return crossing_pairs + self_crossing_pairs > 0; }
  bool IsEmpty() const {
    return !HasCrossings() && !is_gap_violated && folded_triangles == 0;
  }
};

// Returns true if `a` has fewer defects than `b`, in lexicographic order:
// crossings of two meshes, self-crossings, the gap, folded triangles.
bool IsBetter(const DefectCounts& a, const DefectCounts& b);

// The fractions of vertices, those pushed farthest, that measures of the push
// ignore: single vertices are pushed far where muscles are squeezed.
constexpr double kPushedFarthest = 1.0 / 100;  // for the length of steps
constexpr double kUnsettled = 1.0 / 500;       // for convergence

// The outcome of a step: its defects, and the push by which the caller adapts
// the length of steps.
struct StepSummary {
  DefectCounts defects;
  int rounds = 0;
  double violation = 0;     // the worst of a plane by a vertex, mm
  double volume_error = 0;  // relative, worst over the muscles

  // The largest distance of vertices from their prediction, mm, over the
  // muscles, without the fraction kPushedFarthest of the vertices of each, plus
  // `violation`.
  double push = 0;

  // True if contact pushes muscles by less than the reach (without the fraction
  // kUnsettled of vertices), so that a second step would not push them farther.
  bool is_short_of_reach = false;

  // True if the restoration of a volume ended at VolumeOptions::max_move.
  bool is_short_of_volume = false;

  // By muscle: whether contact pushes it by the reach.
  std::vector<char> is_pushed_far = {};

  // True if the step was given up because it pushes muscles too far. The state
  // is empty then.
  bool is_given_up = false;

  // True if it was given up because a muscle would pass through a bone; `push`
  // is then the depth, which is not proportional to the length of the step.
  bool passes_bone = false;
};

// The state after a step, and the summary of the step.
struct StepResult {
  ContactState state;  // of the best round, even if it has defects
  StepSummary summary;
};

// The target of a step, and the limit on its push.
struct StepGoal {
  // The predicted state: pose, bones, attached vertices, coarse meshes and the
  // targets interpolated from them. Its points and planes are not read.
  ContactState state;

  // A step that pushes muscles farther than this, mm, is given up. Unless
  // infinite, a step in which muscles tunnel through a bone by more than
  // RelaxationOptions::max_push is given up as well, as planes cannot hold them
  // (MaxTunnelling).
  double max_push = kInfinity;

  // By muscle: whether it stands still while others move out of its way; its
  // targets are those before. Empty: all muscles move.
  std::vector<char> is_still = {};

  // By muscle: its reach, mm. Empty: StepOptions::reach.
  std::vector<double> reaches = {};
};

// The result of the coarse solve with contact rows, by muscle; see
// ContactState.
struct CoarseSolution {
  std::vector<Points> coarse;
  std::vector<Points> targets;
  std::vector<OwnedHalfSpaces> planes;
};

// Solves the coarse meshes with the contact rows of PlaneSet::MostViolated.
// `points`: the relaxed vertices, #V x 3 each, mm.
using SolveCoarse = std::function<CoarseSolution(
    const PlaneSet& planes, const std::vector<Points>& points)>;

// Moves muscles and bones from the intersection-free state `before` to the goal
// so that no triangles cross there. Step() finds separating planes, relaxes the
// vertices between them with half of the sweeps, solves the coarse meshes with
// contact rows, and continues with the other half. Then it restores volumes,
// finds defects, and repeats rounds with planes against them until none are
// left, at most `max_rounds` times. It returns the best round. Triangles that
// cross at the end indicate a step that is too long, or a lack of room.
//
// Without `solve_coarse` the coarse meshes stay as in the goal. Precondition
// (CHECKed): the options are valid.
StepResult Step(const StepOptions& options,
                const ContactScene& scene,
                const ContactState& before,
                const StepGoal& goal,
                const SolveCoarse& solve_coarse = nullptr);

}  // namespace musclewarp
