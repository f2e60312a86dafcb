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
#include "musclewarp/motion/pose_step.h"
#include "musclewarp/motion/step_remedies.h"

namespace musclewarp {
namespace {

// How many states a walk may go back.
constexpr size_t kMaxWaypoints = 4;

// A state on the way, in which nothing crosses.
struct Waypoint {
  double at;
  ContactState state;
};

// The length of steps after a walk has gone back so many times: a quarter of
// the unchecked length each time, whatever the push.
StepLength ShorterSteps(StepLengthOptions options, int returns) {
  options.longest = options.unchecked * std::pow(0.25, returns);
  options.unchecked = options.longest;
  options.shortest = options.longest;
  return StepLength(options);
}

// A walk that is under way.
class Walker {
 public:
  Walker(const Mover& mover,
         const WalkOptions& options,
         const ScenePose& goal,
         double at,
         ContactState* state)
      : mover_(mover),
        options_(options),
        from_(state->pose),
        goal_(goal),
        step_(options.step),
        length_(options.length),
        at_(at),
        state_(state),
        solves_(state->points.size()) {}

  bool IsAtGoal() const { return at_ >= 1; }
  bool IsSettled() const { return is_settled_; }
  bool IsTimedOut() const {
    return options_.timeout_s > 0 &&
           watch_.Milliseconds() > 1000 * options_.timeout_s;
  }
  double at() const { return at_; }
  WalkSummary TakeSummary() {
    summary_.solves = std::move(solves_.all);
    return std::move(summary_);
  }

  // Tries a step on the way, and does what follows.
  void Advance() {
    const double to = length_.NextFrom(at_);
    const ScenePose pose =
        to == 1 ? goal_ : PoseBetween(mover_.scene.scene, from_, goal_, to);
    PoseStepResult attempt =
        Try({step_, pose, /*is_settling=*/false, length_.max_push()});
    StepOutcome outcome = StepOutcome::kClean;
    if (attempt.summary.push > length_.max_push()) {
      outcome = StepOutcome::kPushedFar;
    } else if (Crosses(attempt.summary)) {
      outcome = summary_.last_clean ? StepOutcome::kStillStuck
                                    : StepOutcome::kCrossing;
    }
    Respond(outcome, to, std::move(attempt));
  }

  // The same at the pose.
  void Settle() {
    PoseStepResult attempt =
        Try({step_, goal_, /*is_settling=*/true, kInfinity});
    Respond(Crosses(attempt.summary) ? StepOutcome::kSettledCrossing
                                     : StepOutcome::kSettledClean,
            1,
            std::move(attempt));
  }

  // Goes the rest of the way without contact.
  void GiveUp() {
    summary_.is_timed_out = true;
    summary_.reached = at_;
    if (!summary_.last_clean) summary_.last_clean = *state_;
    Accept(GoWithoutContact(mover_, goal_, *state_));
  }

 private:
  void Respond(StepOutcome outcome, double to, PoseStepResult attempt) {
    for (const StepRemedy remedy : RemediesOf(outcome)) {
      if (Apply(remedy, to, &attempt)) return;
    }
  }

  // Returns false if a remedy is not possible.
  bool Apply(StepRemedy remedy, double to, PoseStepResult* attempt) {
    switch (remedy) {
      case StepRemedy::kAccept:
        summary_.last_clean.reset();
        LeaveWaypoint();
        GoOn(to, attempt);
        return true;
      case StepRemedy::kAcceptStuck:
        if (!summary_.last_clean) summary_.last_clean = *state_;
        GoOn(to, attempt);
        return true;
      case StepRemedy::kShorten:
        return length_.ShortenFor(attempt->summary.push);
      case StepRemedy::kHalve:
        return length_.Halve();
      case StepRemedy::kGoBack:
        return GoBack();
      case StepRemedy::kReachFarther:
        return ReachFarther();
      case StepRemedy::kSettle:
        SettleAt(attempt);
        return true;
      case StepRemedy::kEndSettling:
        is_settled_ = true;
        return true;
    }
    return false;
  }

  void GoOn(double to, PoseStepResult* attempt) {
    length_.Grow(attempt->summary.push);
    // Muscles that are pushed by less than the reach get there in one step.
    is_settled_ = attempt->summary.is_short_of_reach;
    Accept(std::move(*attempt));
    at_ = to;
  }

  void SettleAt(PoseStepResult* attempt) {
    const double move =
        MoveOfMost(state_->points, attempt->state.points, kUnsettled);
    VLOG(1) << "most vertices have moved by less than " << move << " mm";
    summary_.last_clean.reset();
    const bool stops_short =
        attempt->summary.faults.IsEmpty() && move > step_.reach;
    Accept(std::move(*attempt), stops_short);
    is_settled_ = move < options_.settling_tolerance;
  }

  // Remembers the state before a step, unless it is close to the last one.
  void LeaveWaypoint() {
    const double spacing = options_.length.unchecked;
    if (!trail_.empty() && at_ - trail_.back().at < 0.99 * spacing) return;
    if (trail_.size() == kMaxWaypoints) trail_.erase(trail_.begin());
    trail_.push_back({at_, *state_});
  }

  // Goes back to the first waypoint, if there is one, for shorter steps from
  // there on. Returns false if that was done often enough.
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
    PoseStepResult attempt = TakeStep(mover_, step, *state_, solves_);
    if (options_.on_step) {
      options_.on_step(summary_.steps,
                       {step.pose,
                        step.is_settling,
                        step.max_push,
                        step.options.reach,
                        step.options.sweeps,
                        *state_,
                        attempt.state});
    }
    VLOG(1) << "step from " << at_ << " of length " << length_.length()
            << ", reach " << step_.reach << " mm: push " << attempt.summary.push
            << " mm, " << attempt.summary.rounds << " rounds, "
            << attempt.summary.faults.crossing_pairs << " crossing pairs, "
            << attempt.summary.faults.self_crossing_pairs
            << " of muscles with themselves";
    return attempt;
  }

  bool Crosses(const StepSummary& step) const {
    return options_.accepts_self_crossings ? step.faults.crossing_pairs > 0
                                           : step.faults.HasCrossings();
  }

  // Lets the next step reach farther. Returns false if it may not.
  bool ReachFarther() {
    if (step_.reach >= options_.max_reach) return false;
    step_.reach =
        std::min(options_.reach_growth * step_.reach, options_.max_reach);
    return true;
  }

  // If muscles have farther to go, the next step reaches farther.
  void Accept(PoseStepResult attempt, bool stops_short = false) {
    if (stops_short) {
      ReachFarther();
    } else {
      step_.reach = options_.step.reach;
    }
    *state_ = std::move(attempt.state);
    solves_ = std::move(attempt.solves);
  }

  const Mover& mover_;
  const WalkOptions& options_;
  const ScenePose from_;
  const ScenePose& goal_;
  const Stopwatch watch_;
  StepOptions step_;
  StepLength length_;
  double at_;
  bool is_settled_ = false;
  int returns_ = 0;
  std::vector<Waypoint> trail_;  // the latest last
  ContactState* state_;
  StepSolves solves_;  // that the state comes from
  WalkSummary summary_;
};

}  // namespace

WalkSummary Walk(const Mover& mover,
                 const WalkOptions& options,
                 const ScenePose& goal,
                 double at,
                 const ProgressCallback& on_progress,
                 ContactState* state) {
  const auto say = [&](const std::string& stage, int done, int total) {
    if (on_progress) on_progress({stage, done, total});
  };
  Walker walker(mover, options, goal, at, state);
  while (!walker.IsAtGoal()) {
    say("moving", static_cast<int>(100 * walker.at()), 100);
    if (walker.IsTimedOut()) {
      walker.GiveUp();
      return walker.TakeSummary();
    }
    walker.Advance();
  }
  for (int step = 0; step < options.max_settling_steps; ++step) {
    if (walker.IsSettled() || walker.IsTimedOut()) break;
    say("relaxing", step, options.max_settling_steps);
    walker.Settle();
  }
  return walker.TakeSummary();
}

}  // namespace musclewarp
