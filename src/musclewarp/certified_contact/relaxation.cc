// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/certified_contact/relaxation.h"

#include <algorithm>
#include <cmath>

#include "musclewarp/base/stage_times.h"
#include "musclewarp/base/work_counts.h"
#include "musclewarp/mesh/measures.h"

namespace musclewarp {
namespace {

using Eigen::RowVector3d;

// An edge of the energy, seen from one of its ends.
struct SweepEdge {
  int neighbour;
  double weight;     // w
  double hardening;  // h / e^2, mm^-2
  double rope;       // s, mm
};

// The constant data of the sweeps over one muscle.
struct MuscleSweep {
  const StepOptions& options;
  const MuscleSurface& surface;
  const Points& predicted;
  const Points& targets;
  const AttachedPoints& attached;
  int muscle;
  std::vector<SweepEdge> edges;  // as MuscleSurface::neighbours
  Eigen::VectorXd curvatures;    // of the energy without strain, #V
  Points pushes;                 // by the pressure, #V x 3, mm
};

// Sets the pressure that restores a fraction `gain` of the volume that is
// missing at `points`, #V x 3, mm, if nothing is in the way.
void SetPressure(double gain, const Points& points, MuscleSweep* sweep) {
  const MuscleSurface& surface = sweep->surface;
  Points& pushes = sweep->pushes;
  pushes = VolumeGradient(points, surface.triangles);
  // The volume is a cubic form in the vertices.
  const double volume = pushes.cwiseProduct(points).sum() / 3;
  for (const int v : sweep->attached.vertices) pushes.row(v).setZero();
  // The volume that a unit of pressure restores in a sweep.
  const double yield =
      pushes.rowwise().squaredNorm().cwiseQuotient(sweep->curvatures).sum();
  pushes *= yield > 0 ? gain * (surface.volume - volume) / yield : 0;
}

MuscleSweep SweepOf(const StepOptions& options,
                    const ContactStep& step,
                    const Points& targets,
                    const Eigen::VectorXd& stiffness,
                    int muscle) {
  const MuscleSurface& surface = step.scene.muscles[muscle];
  const RelaxationOptions& relaxation = options.relaxation;
  MuscleSweep sweep = {options,
                       surface,
                       step.predicted[muscle],
                       targets,
                       step.attached[muscle],
                       muscle,
                       {},
                       surface.areas / (relaxation.smoothing_length *
                                        relaxation.smoothing_length),
                       Points::Zero(surface.num_vertices(), 3)};
  sweep.edges.reserve(surface.neighbours.size());
  for (int v = 0; v < surface.num_vertices(); ++v) {
    for (int e = surface.first[v]; e < surface.first[v + 1]; ++e) {
      const int u = surface.neighbours[e];
      const double length = surface.lengths[e];
      const double of_target = (targets.row(u) - targets.row(v)).norm();
      sweep.edges.push_back(
          {u,
           surface.weights[e] * std::max(stiffness[u], stiffness[v]),
           length > 0 ? relaxation.strain_hardening / (length * length) : 0,
           std::max(relaxation.stretch_limit * length, of_target)});
      sweep.curvatures[v] += sweep.edges.back().weight;
    }
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

// Returns the minimizer over the position of one vertex of a quadratic function
// that has the slope of the energy and the pressure where the vertex is, and at
// least two thirds of its curvature: along a strain that hardens, a step is up
// to 1.5 times too long, below the 2 at which sweeps would not converge.
// `offsets` and `points`: those of all vertices, #V x 3, mm.
RowVector3d LowestPlace(const MuscleSweep& sweep,
                        int v,
                        const Points& offsets,
                        const Points& points) {
  const MuscleSurface& surface = sweep.surface;
  const RelaxationOptions& options = sweep.options.relaxation;
  const RowVector3d offset = offsets.row(v), point = points.row(v);
  double curvature =
      surface.areas[v] / (options.smoothing_length * options.smoothing_length);
  RowVector3d descent = sweep.pushes.row(v) - curvature * offset;
  for (int e = surface.first[v]; e < surface.first[v + 1]; ++e) {
    const SweepEdge& edge = sweep.edges[e];
    const RowVector3d strain = offsets.row(edge.neighbour) - offset;
    const double hardening = edge.hardening * strain.squaredNorm();
    descent += edge.weight * (1 + hardening) * strain;
    curvature += edge.weight * (1 + 2 * hardening);
    const RowVector3d along = points.row(edge.neighbour) - point;
    const double square = along.squaredNorm();
    if (square <= edge.rope * edge.rope) continue;
    const double pull = options.rope_factor * edge.weight;
    descent += pull * (1 - edge.rope / std::sqrt(square)) * along;
    curvature += pull;
  }
  return sweep.targets.row(v) + offset + descent / curvature;
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
                    : LowestPlace(sweep, v, *offsets, *points));
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
    // The last sweep settles in the planes.
    const double pressure_gain =
        sweep + 1 == sweeps ? 0 : options.relaxation.pressure_gain;
#pragma omp parallel for schedule(dynamic, 1)
    for (int i = 0; i < step.num_muscles(); ++i) {
      if (pressure_gain > 0) {
        SetPressure(pressure_gain, relaxed.points[i], &muscles[i]);
      } else {
        muscles[i].pushes.setZero();
      }
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
