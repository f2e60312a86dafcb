// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/certified_contact/volume.h"

#include <algorithm>
#include <cmath>

#include "musclewarp/base/stage_times.h"
#include "musclewarp/mesh/measures.h"

namespace musclewarp {
namespace {

using Eigen::RowVector3d;

// Returns the weight of each vertex in the restoration, #V: one for free
// vertices, zero for those held by a plane or a bone, smoothed in between.
Eigen::VectorXd SharesOf(const MuscleSurface& surface,
                         const AttachedPoints& attached,
                         const Points& points,
                         const Points& unprojected,
                         int smoothing_passes) {
  const int count = surface.num_vertices();
  Eigen::VectorXd shares(count);
  for (int v = 0; v < count; ++v) {
    shares[v] = points.row(v) == unprojected.row(v);
  }
  for (const int v : attached.vertices) shares[v] = 0;
  for (int pass = 0; pass < smoothing_passes; ++pass) {
    Eigen::VectorXd smooth = shares;
    for (int v = 0; v < count; ++v) {
      if (shares[v] == 0) continue;
      double sum = 0, weights = 0;
      for (int e = surface.first[v]; e < surface.first[v + 1]; ++e) {
        sum += surface.weights[e] * shares[surface.neighbours[e]];
        weights += surface.weights[e];
      }
      if (weights > 0) smooth[v] = (shares[v] + sum / weights) / 2;
    }
    shares = smooth;
  }
  return shares;
}

// The outcome for one muscle.
struct Restoration {
  double error = 0;    // that remains, relative
  double missing = 0;  // before, mm^3
  bool is_limited = false;
};

Restoration RestoreVolume(const StepOptions& options,
                          const MuscleSurface& surface,
                          const AttachedPoints& attached,
                          int muscle,
                          double reach,
                          const Points& unprojected,
                          PlaneSet* planes,
                          Points* points) {
  const VolumeOptions& limits = options.volume;
  const Eigen::VectorXd shares = SharesOf(
      surface, attached, *points, unprojected, limits.smoothing_passes);
  Restoration restoration;
  double error = 0, room = limits.max_move, since_found = 0;
  for (int step = 0;; ++step) {
    error = SignedVolume(*points, surface.triangles) - surface.volume;
    if (step == 0) restoration.missing = -error;
    restoration.is_limited = room <= 0;
    if (step == limits.max_steps || restoration.is_limited ||
        std::abs(error) <= limits.tolerance * surface.volume) {
      break;
    }
    const Points normals = VolumeGradient(*points, surface.triangles);
    const Eigen::VectorXd lengths = normals.rowwise().norm();
    const double slope = shares.dot(lengths);
    if (!(slope > 0)) break;
    const double farthest = std::min(reach, room);
    const double move = std::clamp(-error / slope, -farthest, farthest);
    room -= std::abs(move);
    // Half-spaces within the reach of a vertex are near: they serve until it
    // has gone half of that way.
    since_found += std::abs(move);
    const bool finds_near = step == 0 || since_found > reach / 2;
    if (finds_near) since_found = 0;
    for (int v = 0; v < surface.num_vertices(); ++v) {
      if (shares[v] == 0 || lengths[v] == 0) continue;
      const RowVector3d moved =
          points->row(v) + shares[v] * move / lengths[v] * normals.row(v);
      if (finds_near) planes->FindNear(muscle, v, moved);
      points->row(v) = planes->Projected(muscle, v, moved);
    }
  }
  restoration.error = std::abs(error) / surface.volume;
  return restoration;
}

}  // namespace

RestoredVolumes RestoreVolumes(const StepOptions& options,
                               const ContactStep& step,
                               const RelaxedPoints& relaxed,
                               PlaneSet* planes) {
  const ScopedStage stage("volume");
  RestoredVolumes restored;
  restored.points = relaxed.points;
  restored.missing.resize(step.num_muscles());
  restored.is_limited.resize(step.num_muscles());
  double worst = 0;
#pragma omp parallel for schedule(dynamic, 1) reduction(max : worst)
  for (int i = 0; i < step.num_muscles(); ++i) {
    if (step.is_still[i]) continue;
    const Restoration restoration = RestoreVolume(options,
                                                  step.scene.muscles[i],
                                                  step.attached[i],
                                                  i,
                                                  ReachOf(options, step, i),
                                                  relaxed.unprojected[i],
                                                  planes,
                                                  &restored.points[i]);
    restored.missing[i] = restoration.missing;
    restored.is_limited[i] = restoration.is_limited;
    worst = std::max(worst, restoration.error);
  }
  restored.worst_error = worst;
  return restored;
}

}  // namespace musclewarp
