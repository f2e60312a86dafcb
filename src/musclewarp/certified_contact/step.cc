// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/certified_contact/step.h"

#include <glog/logging.h>

#include <string>
#include <utility>

#include "musclewarp/certified_contact/defects.h"
#include "musclewarp/certified_contact/sheet_planes.h"
#include "musclewarp/certified_contact/volume.h"

namespace musclewarp {

OpenStep BeginStep(const StepOptions& options,
                   const ContactStep& step,
                   const std::vector<Points>& targets,
                   int sweeps) {
  OpenStep open{PlaneSet(options, step), StartOf(step), CarriedTrees(step)};
  std::vector<SeparatingPlane> planes =
      FindSeparatingPlanes(options, step, &open.trees);
  const size_t between = planes.size();
  for (int i = 0; i < step.num_muscles(); ++i) {
    const std::vector<SeparatingPlane> within =
        FindPlanesBetweenSheets(options, step, i);
    planes.insert(planes.end(), within.begin(), within.end());
  }
  VLOG(2) << between << " planes between surfaces, " << planes.size() - between
          << " between sheets of one muscle";
  open.planes.Add(planes);
  open.relaxed = Relax(options,
                       step,
                       targets,
                       UniformStiffness(step.scene),
                       sweeps,
                       &open.planes,
                       std::move(open.relaxed));
  return open;
}

StepResult FinishStep(const StepOptions& options,
                      const ContactStep& step,
                      const std::vector<Points>& targets,
                      int sweeps,
                      OpenStep open) {
  StepSummary summary;
  Stiffness stiffness = UniformStiffness(step.scene);
  RelaxedPoints relaxed = std::move(open.relaxed);
  // Two muscles share a gap.
  const double allowed = (options.AimedGap() - options.gap) / 2;
  while (summary.rounds < options.max_rounds) {
    ++summary.rounds;
    relaxed = Relax(options,
                    step,
                    targets,
                    stiffness,
                    summary.rounds == 1 ? sweeps : options.repair_sweeps,
                    &open.planes,
                    std::move(relaxed));
    RestoredVolumes restored =
        RestoreVolumes(options, step, relaxed, &open.planes);
    relaxed.points = std::move(restored.points);
    summary.volume_error = restored.worst_error;
    summary.violation = open.planes.WorstViolation(relaxed.points);
    const StepDefects defects =
        FindDefects(options, step, targets, relaxed.points, &open.trees);
    summary.crossing_pairs = defects.num_crossings();
    // Vertices on the wrong side of a plane and folded triangles are worth
    // another round, but no reason to give up a step.
    const bool is_better_possible =
        summary.violation > allowed || defects.num_folded() > 0;
    summary.is_intersection_free =
        !defects.HasCrossings() &&
        (!is_better_possible || summary.rounds == options.max_rounds);
    VLOG(2) << "round " << summary.rounds << ": " << defects.num_crossings()
            << " crossings, " << defects.self_crossings.size()
            << " of muscles with themselves, " << defects.num_folded()
            << " folded, violation " << summary.violation << " mm";
    if (summary.is_intersection_free) break;
    open.planes.Add(PlanesAgainst(defects, options, step, targets));
    stiffness =
        Stiffened(defects, options.defects, step.scene, std::move(stiffness));
  }
  return {{std::move(relaxed.points), targets, step.bones_from_rest}, summary};
}

StepResult AdvanceWithoutIntersection(
    const StepOptions& options,
    const ContactScene& scene,
    const ContactState& before,
    const std::vector<Points>& targets,
    const std::vector<Eigen::Matrix4d>& bones_from_rest) {
  std::string error;
  CHECK(options.IsValid(&error)) << error;
  const ContactStep step =
      MakeContactStep(scene, before, targets, bones_from_rest);
  return FinishStep(options,
                    step,
                    targets,
                    options.sweeps,
                    BeginStep(options, step, targets, 0));
}

}  // namespace musclewarp
