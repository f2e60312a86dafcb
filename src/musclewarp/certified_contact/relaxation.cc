// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/certified_contact/relaxation.h"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <utility>

#include "musclewarp/base/stage_times.h"
#include "musclewarp/base/work_counts.h"
#include "musclewarp/certified_contact/muscle_sweep.h"

namespace musclewarp {
namespace {

// A block of a muscle.
struct MuscleBlock {
  int muscle, block;
};

// Returns the blocks of all muscles that move by colour.
std::vector<std::vector<MuscleBlock>> BlocksByColour(const ContactStep& step) {
  std::vector<std::vector<MuscleBlock>> colours;
  for (int i = 0; i < step.num_muscles(); ++i) {
    if (step.is_still[i]) continue;
    const VertexBlocks& blocks = step.scene.muscles[i].blocks;
    colours.resize(std::max(colours.size(), blocks.colours.size()));
    for (size_t c = 0; c < blocks.colours.size(); ++c) {
      for (const int b : blocks.colours[c]) colours[c].push_back({i, b});
    }
  }
  return colours;
}

}  // namespace

RelaxedPoints StartOf(const ContactStep& step) {
  return {step.predicted, step.predicted};
}

Stiffness UniformStiffness(const ContactScene& scene) {
  Stiffness stiffness;
  for (const MuscleSurface& muscle : scene.muscles) {
    stiffness.push_back(Eigen::VectorXd::Ones(muscle.num_vertices()));
  }
  return stiffness;
}

RelaxedPoints Relax(const StepOptions& options,
                    const ContactStep& step,
                    const std::vector<Points>& targets,
                    const Stiffness& stiffness,
                    int sweeps,
                    PlaneSet* planes,
                    RelaxedPoints start) {
  const ScopedStage stage("relaxation");
  RelaxedPoints relaxed = std::move(start);
  const std::vector<std::vector<MuscleBlock>> colours = BlocksByColour(step);
  std::vector<std::optional<MuscleSweep>> muscles(step.num_muscles());
#pragma omp parallel for schedule(dynamic, 1)
  for (int i = 0; i < step.num_muscles(); ++i) {
    if (step.is_still[i]) continue;
    muscles[i].emplace(
        options, step, i, targets[i], stiffness[i], relaxed.points[i]);
  }
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    MuscleSweep::PlaneChanges changes;
    changes.looks_at_all =
        sweep % options.relaxation.full_sweep_interval == 0 ||
        sweep + 1 == sweeps;
    changes.levels_moved = sweep % options.relaxation.level_interval == 0;
    if (changes.levels_moved) {
      planes->UpdateLevels(relaxed.unprojected, relaxed.points, sweep == 0);
    }
    // The last sweep settles in the planes.
    const double pressure_gain =
        sweep + 1 == sweeps ? 0 : options.relaxation.pressure_gain;
#pragma omp parallel for schedule(dynamic, 1)
    for (int i = 0; i < step.num_muscles(); ++i) {
      if (step.is_still[i]) continue;
      if (changes.looks_at_all && pressure_gain > 0) {
        muscles[i]->UpdateGradient(relaxed.points[i]);
      }
      muscles[i]->SetPressure(pressure_gain);
    }
    for (const std::vector<MuscleBlock>& blocks : colours) {
#pragma omp parallel for schedule(dynamic, 1)
      for (size_t k = 0; k < blocks.size(); ++k) {
        const auto [i, block] = blocks[k];
        muscles[i]->SweepBlock(block,
                               changes,
                               planes,
                               &relaxed.points[i],
                               &relaxed.unprojected[i]);
      }
    }
  }
  for (int i = 0; i < step.num_muscles(); ++i) {
    if (step.is_still[i]) continue;
    CountWork(WorkUnit::kVertexSweeps,
              static_cast<std::int64_t>(sweeps) *
                  step.scene.muscles[i].num_vertices());
  }
  return relaxed;
}

}  // namespace musclewarp
