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
#include "musclewarp/base/stage_times.h"
#include "musclewarp/base/stopwatch.h"
#include "musclewarp/certified_contact/moves.h"
#include "musclewarp/motion/step_remedies.h"

namespace musclewarp {
namespace {

SolvedPose SolveFree(const Mover& mover,
                     const Place& from,
                     const ScenePose& pose) {
  const ScopedStage stage("solve without contact");
  const SceneState before = {from.pose, from.free.states, {}};
  return SolvePose(mover.scene,
                   pose,
                   mover.pre_rotation,
                   mover.solver,
                   Predict(mover.scene, before, pose, mover.pre_rotation));
}

// Solves the muscles with rows for the planes that their samples violate most.
SolvedPose SolveWithContactRows(const Mover& mover,
                                const PlaneSet& contact_planes,
                                const std::vector<Points>& points,
                                const std::vector<Points>& targets,
                                const ScenePose& pose,
                                const SolvedPose& free,
                                const SolvedPose& start) {
  const ScopedStage stage("solve with contact");
  const CertifiedScene& certified = mover.certified;
  std::vector<ContactRows> contact(mover.scene.muscles.size());
  for (size_t k = 0; k < certified.order.size(); ++k) {
    CarriedHalfSpaces planes = contact_planes.MostViolated(
        static_cast<int>(k), certified.samples[k], points[k], targets[k]);
    for (PlaneCarrier& carrier : planes.carriers) {
      if (carrier.IsBone()) continue;
      carrier.muscle_above = certified.order[carrier.muscle_above];
      carrier.muscle_below = certified.order[carrier.muscle_below];
    }
    contact[certified.order[k]] = {
        OneSidedRowsOf(planes.spaces, certified.options.coarse_weight),
        std::move(planes.carriers)};
  }
  return SolveWithRows(mover.scene,
                       free,
                       pose,
                       mover.pre_rotation,
                       mover.solver,
                       std::move(contact),
                       start.states);
}

// A step that was tried: where it ended, and what came of it.
struct Attempt {
  Place place;
  StepSummary summary;
};

// Tries a step from a place to a pose. `start` is where the coarse meshes are
// predicted. The step is given up if it pushes muscles by more than `max_push`,
// mm.
Attempt TryStep(const Mover& mover,
                const StepOptions& options,
                const Place& from,
                const ScenePose& pose,
                const SolvedPose& free,
                const SolvedPose& start,
                double max_push) {
  Attempt attempt;
  attempt.place.pose = pose;
  attempt.place.free = free;
  attempt.place.solved = start;
  const StepGoal goal = {FineMeshes(mover, start.states),
                         BonesFromRest(mover.scene, pose),
                         AttachedIn(mover, pose),
                         max_push};
  SolveCoarse solve_coarse;
  if (mover.certified.options.coarse_weight > 0) {
    solve_coarse = [&](const PlaneSet& planes,
                       const std::vector<Points>& points) {
      attempt.place.solved = SolveWithContactRows(
          mover, planes, points, goal.targets, pose, free, start);
      return FineMeshes(mover, attempt.place.solved.states);
    };
  }
  StepResult result =
      Step(options, mover.certified.contact, from.surfaces, goal, solve_coarse);
  attempt.place.surfaces = std::move(result.state);
  attempt.summary = result.summary;
  return attempt;
}

// Predicts the coarse meshes of the next step: they keep the displacement by
// contact that they have.
SolvedPose MovedAlong(const Place& from, const SolvedPose& free) {
  SolvedPose start = free;
  for (size_t i = 0; i < start.states.size(); ++i) {
    start.states[i].coarse +=
        from.solved.states[i].coarse - from.free.states[i].coarse;
  }
  return start;
}

// Goes to a pose without contact: muscles keep the offsets that they have.
void GoWithoutContact(const Mover& mover, const ScenePose& goal, Place* place) {
  const SolvedPose free = SolveFree(mover, *place, goal);
  SolvedPose solved = MovedAlong(*place, free);
  const std::vector<Points> targets = FineMeshes(mover, solved.states);
  for (size_t k = 0; k < targets.size(); ++k) {
    place->surfaces.points[k] += targets[k] - place->surfaces.targets[k];
  }
  place->surfaces.targets = targets;
  place->surfaces.bones_from_rest = BonesFromRest(mover.scene, goal);
  place->pose = goal;
  place->free = free;
  place->solved = std::move(solved);
}

// How many places a walk may go back.
constexpr size_t kMaxWaypoints = 4;

// A place on the way, in which nothing crosses.
struct Waypoint {
  double at;
  Place place;
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
         Place* place)
      : mover_(mover),
        options_(options),
        from_(place->pose),
        goal_(goal),
        step_(options.step),
        length_(options.length),
        at_(at),
        place_(place) {}

  bool IsAtGoal() const { return at_ >= 1; }
  bool IsSettled() const { return is_settled_; }
  bool IsTimedOut() const {
    return options_.timeout_s > 0 &&
           watch_.Milliseconds() > 1000 * options_.timeout_s;
  }
  double at() const { return at_; }
  WalkSummary TakeSummary() { return std::move(summary_); }

  // Tries a step on the way, and does what follows.
  void Advance() {
    const double to = length_.NextFrom(at_);
    const ScenePose pose =
        to == 1 ? goal_ : PoseBetween(mover_.scene.scene, from_, goal_, to);
    const SolvedPose free = SolveFree(mover_, *place_, pose);
    Attempt attempt =
        Try(pose, free, MovedAlong(*place_, free), length_.max_push());
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
    Attempt attempt = Try(goal_, place_->free, place_->solved, kInfinity);
    Respond(Crosses(attempt.summary) ? StepOutcome::kSettledCrossing
                                     : StepOutcome::kSettledClean,
            1,
            std::move(attempt));
  }

  // Goes the rest of the way without contact.
  void GiveUp() {
    summary_.is_timed_out = true;
    summary_.reached = at_;
    if (!summary_.last_clean) summary_.last_clean = *place_;
    GoWithoutContact(mover_, goal_, place_);
  }

 private:
  void Respond(StepOutcome outcome, double to, Attempt attempt) {
    for (const StepRemedy remedy : RemediesOf(outcome)) {
      if (Apply(remedy, to, &attempt)) return;
    }
  }

  // Returns false if a remedy is not possible.
  bool Apply(StepRemedy remedy, double to, Attempt* attempt) {
    switch (remedy) {
      case StepRemedy::kAccept:
        summary_.last_clean.reset();
        LeaveWaypoint();
        GoOn(to, attempt);
        return true;
      case StepRemedy::kAcceptStuck:
        if (!summary_.last_clean) summary_.last_clean = *place_;
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

  void GoOn(double to, Attempt* attempt) {
    length_.Grow(attempt->summary.push);
    // Muscles that are pushed by less than the reach get there in one step.
    is_settled_ = attempt->summary.is_short_of_reach;
    Accept(std::move(*attempt));
    at_ = to;
  }

  void SettleAt(Attempt* attempt) {
    const double move = MoveOfMost(
        place_->surfaces.points, attempt->place.surfaces.points, kUnsettled);
    VLOG(1) << "most vertices have moved by less than " << move << " mm";
    summary_.last_clean.reset();
    const bool stops_short =
        attempt->summary.faults.IsEmpty() && move > step_.reach;
    Accept(std::move(*attempt), stops_short);
    is_settled_ = move < options_.settling_tolerance;
  }

  // Remembers the place before a step, unless it is close to the last one.
  void LeaveWaypoint() {
    const double spacing = options_.length.unchecked;
    if (!trail_.empty() && at_ - trail_.back().at < 0.99 * spacing) return;
    if (trail_.size() == kMaxWaypoints) trail_.erase(trail_.begin());
    trail_.push_back({at_, *place_});
  }

  // Goes back to the first waypoint, if there is one, for shorter steps from
  // there on. Returns false if that was done often enough.
  bool GoBack() {
    if (returns_ == options_.max_returns) return false;
    ++returns_;
    if (!trail_.empty()) {
      at_ = trail_.front().at;
      *place_ = std::move(trail_.front().place);
      trail_.clear();
    }
    length_ = ShorterSteps(options_.length, returns_);
    VLOG(1) << "back to " << at_ << ", for steps of " << length_.length();
    return true;
  }

  Attempt Try(const ScenePose& pose,
              const SolvedPose& free,
              const SolvedPose& start,
              double max_push) {
    ++summary_.steps;
    Attempt attempt =
        TryStep(mover_, step_, *place_, pose, free, start, max_push);
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
  void Accept(Attempt attempt, bool stops_short = false) {
    if (stops_short) {
      ReachFarther();
    } else {
      step_.reach = options_.step.reach;
    }
    *place_ = std::move(attempt.place);
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
  Place* place_;
  WalkSummary summary_;
};

}  // namespace

WalkSummary Walk(const Mover& mover,
                 const WalkOptions& options,
                 const ScenePose& goal,
                 double at,
                 const ProgressCallback& on_progress,
                 Place* place) {
  const auto say = [&](const std::string& stage, int done, int total) {
    if (on_progress) on_progress({stage, done, total});
  };
  Walker walker(mover, options, goal, at, place);
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
