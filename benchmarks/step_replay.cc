// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "step_replay.h"

#include <omp.h>

#include <algorithm>
#include <numeric>
#include <utility>

#include "musclewarp/base/input_error.h"
#include "musclewarp/motion/pose_step.h"
#include "musclewarp/preparation/scene_meshes.h"

namespace musclewarp {
namespace {

bool AreOfOneMesh(const std::vector<Points>& a, const std::vector<Points>& b) {
  return std::equal(
      a.begin(),
      a.end(),
      b.begin(),
      b.end(),
      [](const Points& p, const Points& q) { return p.rows() == q.rows(); });
}

double LargestDistance(const std::vector<Points>& a,
                       const std::vector<Points>& b) {
  double largest = 0;
  for (size_t i = 0; i < a.size(); ++i) {
    if (a[i].rows() == 0) continue;
    largest = std::max(largest, (a[i] - b[i]).rowwise().norm().maxCoeff());
  }
  return largest;
}

CertifiedScene SceneAtRest(const Deformer& deformer,
                           const DeformerOptions& options) {
  return RestoreCertifiedScene(
      deformer.scene(), options.frames.certified, *deformer.state().contact);
}

}  // namespace

StepDifference Compare(const ContactState& recorded, const ContactState& now) {
  StepDifference difference;
  difference.is_other_outcome = !AreOfOneMesh(recorded.points, now.points);
  difference.is_same =
      !difference.is_other_outcome && recorded.points == now.points &&
      recorded.targets == now.targets && recorded.coarse == now.coarse &&
      recorded.free_coarse == now.free_coarse;
  if (difference.is_other_outcome) return difference;
  difference.points = LargestDistance(recorded.points, now.points);
  difference.targets = LargestDistance(recorded.targets, now.targets);
  return difference;
}

double StepTimes::Milliseconds() const {
  return std::accumulate(
      stages.begin(), stages.end(), 0.0, [](double sum, const auto& stage) {
        return sum + stage.ms;
      });
}

double StepTimes::ProcessorMilliseconds() const {
  return std::accumulate(
      stages.begin(), stages.end(), 0.0, [](double sum, const auto& stage) {
        return sum + stage.processor_ms;
      });
}

StepReplay::StepReplay(const Scene& scene, const DeformerOptions& options)
    : options_(options),
      solvers_(SolversOf(options.solver)),
      deformer_(scene, options) {
  deformer_.Reset();
  at_rest_ = moving_ = SceneAtRest(deformer_, options_);
  at_rest_.rest.held.clear();
}

StepTimes StepReplay::Take(const std::string& path,
                           const RecordedStep& recorded,
                           int threads,
                           int repeats,
                           StepDifference* difference) const {
  const CertifiedScene& certified =
      recorded.IsOfRestPose() ? at_rest_ : moving_;
  if (!AreOfOneMesh(recorded.before.points, certified.rest.points)) {
    throw InputError(path,
                     "is of other meshes than the scene has now",
                     "record it again with musclewarp-deform --record_steps");
  }
  const MotionContext context = {deformer_.scene(),
                                 certified,
                                 options_.frames.pre_rotation,
                                 solvers_.single};
  const PoseStep step = {recorded.OptionsIn(certified.options.step),
                         recorded.pose,
                         recorded.is_settling,
                         recorded.max_push,
                         recorded.is_still,
                         recorded.reaches};
  omp_set_num_threads(threads);
  std::vector<StepTimes> times;
  for (int i = 0; i < repeats; ++i) {
    const StageRecording recording;
    {
      const ScopedStage rest("everything else");
      const PoseStepResult result = TakeStep(
          context, step, recorded.before, StepSolves(certified.muscles.size()));
      *difference = Compare(recorded.after, result.state);
    }
    times.push_back({threads, recording.times()});
    std::rotate(times.back().stages.begin(),
                times.back().stages.begin() + 1,
                times.back().stages.end());
  }
  const auto median = times.begin() + repeats / 2;
  std::nth_element(
      times.begin(), median, times.end(), [](const auto& a, const auto& b) {
        return a.ProcessorMilliseconds() < b.ProcessorMilliseconds();
      });
  return std::move(*median);
}

}  // namespace musclewarp
