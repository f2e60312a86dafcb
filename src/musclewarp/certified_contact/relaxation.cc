// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/certified_contact/relaxation.h"

#include <algorithm>

#include "musclewarp/base/stage_times.h"
#include "musclewarp/base/work_counts.h"

namespace musclewarp {
namespace {

using Eigen::RowVector3d;

// The constant data of the sweeps over one muscle.
struct MuscleSweep {
  const StepOptions& options;
  const MuscleSurface& surface;
  const Points& predicted;
  const Points& targets;
  const AttachedPoints& attached;
  int muscle;

  // The edge weights of MuscleSurface times the stiffness and, #V, their sum
  // plus the weight of the vertex itself.
  std::vector<double> weights;
  Eigen::VectorXd sums_of_weights;
};

MuscleSweep SweepOf(const StepOptions& options,
                    const ContactStep& step,
                    const Points& targets,
                    const Eigen::VectorXd& stiffness,
                    int muscle) {
  const MuscleSurface& surface = step.scene.muscles[muscle];
  MuscleSweep sweep = {options,
                       surface,
                       step.predicted[muscle],
                       targets,
                       step.attached[muscle],
                       muscle,
                       surface.weights,
                       Eigen::VectorXd(surface.num_vertices())};
  const double length = options.relaxation.smoothing_length;
  for (int v = 0; v < surface.num_vertices(); ++v) {
    double sum = 1 / (length * length) * surface.areas[v];
    for (int e = surface.first[v]; e < surface.first[v + 1]; ++e) {
      const int u = surface.neighbours[e];
      sweep.weights[e] *= std::max(stiffness[u], stiffness[v]);
      sum += sweep.weights[e];
    }
    sweep.sums_of_weights[v] = sum;
  }
  return sweep;
}

// Returns the place, or the nearest one within the reach of the predicted
// vertex.
RowVector3d WithinReach(const MuscleSweep& sweep,
                        int v,
                        const RowVector3d& place) {
  const RowVector3d beyond = place - sweep.predicted.row(v);
  const double far = beyond.norm();
  const double reach = sweep.options.reach;
  if (far <= reach) return place;
  return sweep.predicted.row(v) + reach / far * beyond;
}

// Returns the minimizer of the energy over the position of one vertex.
// `offsets`: those of all vertices, #V x 3, mm.
RowVector3d LowestPlace(const MuscleSweep& sweep,
                        int v,
                        const Points& offsets) {
  const MuscleSurface& surface = sweep.surface;
  RowVector3d sum = RowVector3d::Zero();
  for (int e = surface.first[v]; e < surface.first[v + 1]; ++e) {
    sum += sweep.weights[e] * offsets.row(surface.neighbours[e]);
  }
  return sweep.targets.row(v) + sum / sweep.sums_of_weights[v];
}

void SweepMuscle(const MuscleSweep& sweep,
                 bool looks_at_all_planes,
                 PlaneSet* planes,
                 Points* offsets,
                 Points* points,
                 Points* unprojected) {
  const std::vector<int>& attached = sweep.attached.vertices;
  size_t next = 0;  // index of the next attached vertex
  for (int v = 0; v < sweep.surface.num_vertices(); ++v) {
    const bool is_attached = next < attached.size() && attached[next] == v;
    const RowVector3d place = WithinReach(
        sweep,
        v,
        is_attached ? RowVector3d(sweep.attached.positions.row(next))
                    : LowestPlace(sweep, v, *offsets));
    next += is_attached;
    unprojected->row(v) = place;
    if (looks_at_all_planes) planes->FindNear(sweep.muscle, v, place);
    points->row(v) = planes->Projected(sweep.muscle, v, place);
    offsets->row(v) = points->row(v) - sweep.targets.row(v);
  }
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
  std::vector<MuscleSweep> muscles;
  std::vector<Points> offsets;
  for (int i = 0; i < step.num_muscles(); ++i) {
    muscles.push_back(SweepOf(options, step, targets[i], stiffness[i], i));
    offsets.push_back(relaxed.points[i] - targets[i]);
  }
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    planes->UpdateLevels(relaxed.unprojected, relaxed.points, sweep == 0);
    const bool looks_at_all_planes =
        sweep % options.relaxation.full_sweep_interval == 0 ||
        sweep + 1 == sweeps;
#pragma omp parallel for schedule(dynamic, 1)
    for (int i = 0; i < step.num_muscles(); ++i) {
      SweepMuscle(muscles[i],
                  looks_at_all_planes,
                  planes,
                  &offsets[i],
                  &relaxed.points[i],
                  &relaxed.unprojected[i]);
    }
  }
  for (const MuscleSurface& muscle : step.scene.muscles) {
    CountWork(WorkUnit::kVertexSweeps,
              static_cast<std::int64_t>(sweeps) * muscle.num_vertices());
  }
  return relaxed;
}

}  // namespace musclewarp
