// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/motion/certified_stepper.h"

#include <glog/logging.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "musclewarp/base/infinity.h"
#include "musclewarp/base/stopwatch.h"
#include "musclewarp/certified_contact/moves.h"
#include "musclewarp/motion/pose_pushes.h"
#include "musclewarp/motion/pose_step.h"
#include "musclewarp/motion/settling_muscles.h"
#include "musclewarp/motion/step_remedies.h"
#include "musclewarp/scene/line_targets.h"

namespace musclewarp {
namespace {

// The number of states that the stepper may backtrack.
constexpr size_t kMaxWaypoints = 4;

// Muscles unfold as long as a step leaves less than this fraction of the
// self-crossings of the step before.
constexpr double kFewer = 0.9;

// A state of the motion without crossing triangles.
struct Waypoint {
  double at;
  ContactState state;
};

// Returns the length of steps after `returns` backtracks: the unchecked length
// times 1/4 for each, whatever the push.
StepLength ShorterSteps(StepLengthOptions options, int returns) {
  options.longest = options.unchecked * std::pow(0.25, returns);
  options.unchecked = options.longest;
  options.shortest = options.longest;
  return StepLength(options);
}

bool IsFinite(const ContactState& state) {
  for (const std::vector<Points>* points : {&state.coarse, &state.points}) {
    for (const Points& of_muscle : *points) {
      if (!of_muscle.allFinite()) return false;
    }
  }
  return true;
}

// The state of AdvanceToPose between two steps.
class PoseStepper {
 public:
  PoseStepper(const MotionContext& context,
              const AdvanceOptions& options,
              const ScenePose& goal,
              double at,
              ContactState* state)
      : context_(context),
        options_(options),
        from_(state->pose),
        goal_(goal),
        step_(options.step),
        length_(options.length),
        at_(at),
        settling_(state->points.size(),
                  options.settling_tolerance,
                  options.step.reach),
        state_(state),
        solves_(state->points.size()) {
    if (options.relaxes_rest) {
      SetReaches(MovesOfMost(state->points, state->targets, kUnsettled), 1);
    }
  }

  bool IsAtGoal() const { return at_ >= 1; }
  bool IsSettled() const { return is_settled_; }
  bool IsTimedOut() const {
    return options_.timeout_s > 0 &&
           watch_.Milliseconds() > 1000 * options_.timeout_s;
  }
  // Why no further step to the pose may start.
  GivenUp WhyGivenUp() const {
    const bool is_stuck = options_.max_stuck_steps > 0 &&
                          stuck_steps_ >= options_.max_stuck_steps;
    return is_broken_     ? GivenUp::kNotFinite
           : is_stuck     ? GivenUp::kStuck
           : IsTimedOut() ? GivenUp::kTimedOut
                          : GivenUp::kNot;
  }
  double at() const { return at_; }
  AdvanceSummary TakeSummary() {
    VLOG(1) << "at most " << most_stuck_steps_
            << " steps in a row with crossing triangles";
    summary_.solves = std::move(solves_.all);
    return std::move(summary_);
  }

  // Takes a step towards the pose and applies the remedies of its outcome.
  void Advance() {
    const double to = length_.NextFrom(at_);
    const ScenePose pose =
        to == 1 ? goal_
                : WithPushes(
                      context_.scene,
                      context_.pre_rotation,
                      WithTautLines(
                          context_.scene.scene,
                          PoseBetween(context_.scene.scene, from_, goal_, to)));
    PoseStepResult attempt =
        Try({step_, pose, /*is_settling=*/false, length_.max_push()});
    StepOutcome outcome = StepOutcome::kClean;
    if (!IsFinite(attempt.state)) {
      outcome = StepOutcome::kNotFinite;
    } else if (attempt.summary.passes_bone) {
      outcome = StepOutcome::kPassing;
    } else if (attempt.summary.push > length_.max_push()) {
      outcome = StepOutcome::kPushedFar;
    } else if (Crosses(attempt.summary)) {
      outcome = summary_.last_clean ? StepOutcome::kStillStuck
                                    : StepOutcome::kCrossing;
    }
    Respond(outcome, to, std::move(attempt));
  }

  // Takes a settling step at the pose.
  void Settle() {
    is_still_ = StillMuscles();
    PoseStepResult attempt = Try(
        {step_, goal_, /*is_settling=*/true, kInfinity, is_still_, reaches_});
    Respond(!IsFinite(attempt.state)   ? StepOutcome::kSettledNotFinite
            : Crosses(attempt.summary) ? StepOutcome::kSettledCrossing
                                       : StepOutcome::kSettledClean,
            1,
            std::move(attempt));
  }

  // Computes the remainder of the motion without contact.
  void GiveUp(GivenUp why) {
    summary_.given_up = why;
    summary_.reached = at_;
    if (!summary_.last_clean) summary_.last_clean = *state_;
    Accept(GoWithoutContact(context_, goal_, *state_));
  }

 private:
  void Respond(StepOutcome outcome, double to, PoseStepResult attempt) {
    for (const StepRemedy remedy : RemediesOf(outcome)) {
      if (Apply(remedy, to, &attempt)) return;
    }
  }

  // Returns false if the remedy is not available.
  bool Apply(StepRemedy remedy, double to, PoseStepResult* attempt) {
    switch (remedy) {
      case StepRemedy::kAccept:
        summary_.last_clean.reset();
        LeaveWaypoint();
        GoOn(to, attempt);
        stuck_steps_ = 0;
        return true;
      case StepRemedy::kAcceptStuck:
        if (!summary_.last_clean) summary_.last_clean = *state_;
        GoOn(to, attempt);
        most_stuck_steps_ = std::max(most_stuck_steps_, ++stuck_steps_);
        return true;
      case StepRemedy::kShorten:
        return length_.ShortenFor(attempt->summary.push);
      case StepRemedy::kHalve:
        return length_.Halve();
      case StepRemedy::kGoBack:
        return GoBack();
      case StepRemedy::kReachFarther:
        settling_.MoveAll();
        return ReachFarther();
      case StepRemedy::kSettle:
        SettleAt(attempt);
        return true;
      case StepRemedy::kEndSettling:
        is_settled_ = true;
        return true;
      case StepRemedy::kGiveUp:
        is_broken_ = true;
        return true;
    }
    return false;
  }

  void GoOn(double to, PoseStepResult* attempt) {
    length_.Grow(attempt->summary.push);
    // Muscles that are pushed by less than the reach need no settling, unless
    // too many triangles are folded: a step from here may unfold them.
    const bool is_folded = attempt->summary.defects.folded_triangles > 0;
    is_settled_ = attempt->summary.is_short_of_reach && !is_folded &&
                  !options_.always_settles;
    settling_.MoveOnly(attempt->summary.is_pushed_far);
    // Defects of a muscle that stands still are not looked for.
    if (is_folded || options_.always_settles) settling_.MoveAll();
    Accept(std::move(*attempt));
    at_ = to;
  }

  void SettleAt(PoseStepResult* attempt) {
    const DefectCounts defects = attempt->summary.defects;
    const bool is_short_of_volume = attempt->summary.is_short_of_volume;
    const std::vector<double> moves =
        MovesOfMost(state_->points, attempt->state.points, kUnsettled);
    const double move = *std::max_element(moves.begin(), moves.end());
    VLOG(1) << "most vertices have moved by less than " << move << " mm";
    summary_.last_clean.reset();
    const bool stops_short = defects.IsEmpty() && move > step_.reach;
    Accept(std::move(*attempt), stops_short);
    settling_.Add(moves, is_still_);
    const bool is_sound =
        !defects.HasCrossings() && !is_short_of_volume &&
        (options_.relaxes_rest || defects.folded_triangles == 0);
    is_settled_ = settling_.AreSettled() && is_sound;
    if (!is_sound) settling_.MoveAll();
    if (!options_.relaxes_rest) return;
    // Muscles that stood still may be out of balance.
    is_settled_ = is_settled_ && is_still_.empty();
    SetReaches(moves, options_.reach_growth);
    ContinueUnfolding(defects.self_crossing_pairs);
  }

  // Returns by muscle whether it stands still in the next settling step: all do
  // but those that are not settled and those in contact with them, which have
  // to yield. Empty: all muscles move.
  std::vector<char> StillMuscles() const {
    const std::vector<char> may_be = settling_.Still();
    std::vector<char> is_still = may_be;
    if (state_->planes.empty()) is_still.clear();
    for (size_t i = 0; i < is_still.size(); ++i) {
      if (may_be[i]) continue;
      for (const PlaneOwner& owner : state_->planes[i].owners) {
        if (owner.IsBone()) continue;
        is_still[owner.muscle_above] = is_still[owner.muscle_below] = false;
      }
    }
    return is_still;
  }

  // Ends the unfolding of muscles when it does not help any more.
  void ContinueUnfolding(int self_crossings) {
    step_.unfolds = step_.unfolds && self_crossings > 0 &&
                    self_crossings < kFewer * self_crossings_;
    self_crossings_ = self_crossings;
  }

  // Has each muscle reach as far as `growth` times its last move, mm.
  void SetReaches(const std::vector<double>& moves, double growth) {
    reaches_.clear();
    for (const double move : moves) reaches_.push_back(ReachFor(growth * move));
    step_.reach = *std::max_element(reaches_.begin(), reaches_.end());
  }

  // Returns a reach, mm, which still may grow once.
  double ReachFor(double move) const {
    return std::clamp(move,
                      options_.step.reach,
                      std::max(options_.step.reach,
                               options_.max_reach / options_.reach_growth));
  }

  // Keeps the state before a step as a waypoint, unless the last is close.
  void LeaveWaypoint() {
    const double spacing = options_.length.unchecked;
    if (!trail_.empty() && at_ - trail_.back().at < 0.99 * spacing) return;
    if (trail_.size() == kMaxWaypoints) trail_.erase(trail_.begin());
    trail_.push_back({at_, *state_});
  }

  // Backtracks to the first waypoint, if any, and continues with shorter
  // steps. Returns false after `max_returns` backtracks.
  bool GoBack() {
    if (returns_ == options_.max_returns) return false;
    ++returns_;
    if (!trail_.empty()) {
      at_ = trail_.front().at;
      *state_ = std::move(trail_.front().state);
      trail_.clear();
    }
    length_ = ShorterSteps(options_.length, returns_);
    VLOG(1) << "back to " << at_ << ", for steps of " << length_.length();
    return true;
  }

  PoseStepResult Try(const PoseStep& step) {
    ++summary_.steps;
    PoseStepResult attempt = TakeStep(context_, step, *state_, solves_);
    if (options_.on_step) {
      options_.on_step(summary_.steps,
                       {step.pose,
                        step.is_settling,
                        step.max_push,
                        step.options.reach,
                        step.options.sweeps,
                        step.options.unfolds,
                        step.is_still,
                        step.reaches,
                        *state_,
                        attempt.state});
    }
    VLOG(1) << "step from " << at_ << " of length " << length_.length()
            << ", reach " << step_.reach << " mm: push " << attempt.summary.push
            << " mm, " << attempt.summary.rounds << " rounds, "
            << attempt.summary.defects.crossing_pairs << " crossing pairs, "
            << attempt.summary.defects.self_crossing_pairs
            << " of muscles with themselves; "
            << std::count(step.is_still.begin(), step.is_still.end(), true)
            << " muscles stood still";
    return attempt;
  }

  bool Crosses(const StepSummary& step) const {
    return options_.relaxes_rest ? step.defects.crossing_pairs > 0
                                 : step.defects.HasCrossings();
  }

  // Enlarges the reach of the next step. Returns false at `max_reach`.
  bool ReachFarther() {
    if (step_.reach >= options_.max_reach) return false;
    const auto farther = [&](double reach) {
      return std::min(options_.reach_growth * reach, options_.max_reach);
    };
    step_.reach = farther(step_.reach);
    for (double& reach : reaches_) reach = farther(reach);
    return true;
  }

  // Replaces the state. The next step reaches farther if muscles stopped short.
  void Accept(PoseStepResult attempt, bool stops_short = false) {
    if (stops_short) {
      ReachFarther();
    } else {
      step_.reach = options_.step.reach;
    }
    *state_ = std::move(attempt.state);
    solves_ = std::move(attempt.solves);
  }

  const MotionContext& context_;
  const AdvanceOptions& options_;
  const ScenePose from_;
  const ScenePose& goal_;
  const Stopwatch watch_;
  StepOptions step_;
  StepLength length_;
  double at_;
  int stuck_steps_ = 0;  // the latest ones, accepted with crossing triangles
  int most_stuck_steps_ = 0;
  bool is_settled_ = false;
  bool is_broken_ = false;  // no step from here has finite coordinates
  SettlingMuscles settling_;
  std::vector<char> is_still_;         // in the last settling step, by muscle
  std::vector<double> reaches_;        // of a settling rest pose, by muscle, mm
  double self_crossings_ = kInfinity;  // after the last settling step
  int returns_ = 0;
  std::vector<Waypoint> trail_;  // the latest last
  ContactState* state_;
  StepSolves solves_;  // of the current state
  AdvanceSummary summary_;
};

}  // namespace

AdvanceSummary AdvanceToPose(const MotionContext& context,
                             const AdvanceOptions& options,
                             const ScenePose& goal,
                             double at,
                             const ProgressCallback& on_progress,
                             ContactState* state) {
  const auto say = [&](const std::string& stage, int done, int total) {
    if (on_progress) on_progress({stage, done, total, ""});
  };
  PoseStepper stepper(context, options, goal, at, state);
  while (!stepper.IsAtGoal()) {
    say("moving", static_cast<int>(100 * stepper.at()), 100);
    const GivenUp why = stepper.WhyGivenUp();
    if (why != GivenUp::kNot) {
      stepper.GiveUp(why);
      return stepper.TakeSummary();
    }
    stepper.Advance();
  }
  for (int step = 0; step < options.max_settling_steps; ++step) {
    if (stepper.IsSettled() || stepper.IsTimedOut()) break;
    say("relaxing", step, options.max_settling_steps);
    stepper.Settle();
  }
  return stepper.TakeSummary();
}

}  // namespace musclewarp
