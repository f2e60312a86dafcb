// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/certified_contact/muscle_sweep.h"

#include <algorithm>
#include <cmath>

#include "musclewarp/mesh/measures.h"

namespace musclewarp {

using Eigen::RowVector3d;

MuscleSweep::MuscleSweep(const StepOptions& options,
                         const ContactStep& step,
                         int muscle,
                         const Points& targets,
                         const Eigen::VectorXd& stiffness,
                         const Points& points)
    : options_(options),
      surface_(step.scene.muscles[muscle]),
      attached_(step.attached[muscle].positions),
      muscle_(muscle),
      reach_(ReachOf(options, step, muscle)) {
  const double length = options.relaxation.smoothing_length;
  const int count = surface_.num_vertices();
  std::vector<int> attached(count, -1);
  const std::vector<int>& numbers = step.attached[muscle].vertices;
  for (size_t k = 0; k < numbers.size(); ++k) {
    attached[numbers[k]] = static_cast<int>(k);
  }
  for (const int v : surface_.blocks.vertices) {
    const double curvature = surface_.areas[v] / (length * length);
    vertices_.push_back({targets.row(v),
                         step.predicted[muscle].row(v),
                         curvature,
                         curvature,
                         v,
                         attached[v],
                         0});
    places_.push_back({points.row(v) - targets.row(v), points.row(v)});
  }
  if (!step.before.withheld.empty()) {
    withheld_ = step.before.withheld[muscle];
  }
  AddEdges(targets, stiffness);
  gradient_ = Points::Zero(count, 3);
}

void MuscleSweep::AddEdges(const Points& targets,
                           const Eigen::VectorXd& stiffness) {
  const RelaxationOptions& options = options_.relaxation;
  std::vector<int> order(vertices_.size());  // of a vertex among the blocks
  for (size_t i = 0; i < vertices_.size(); ++i) {
    order[vertices_[i].number] = static_cast<int>(i);
  }
  edges_.reserve(surface_.neighbours.size());
  for (Vertex& vertex : vertices_) {
    const int v = vertex.number;
    vertex.first_edge = static_cast<int>(edges_.size());
    for (int e = surface_.first[v]; e < surface_.first[v + 1]; ++e) {
      const int u = surface_.neighbours[e];
      const double length = surface_.lengths[e];
      const double of_target = (targets.row(u) - targets.row(v)).norm();
      const double rope = std::max(options.stretch_limit * length, of_target);
      edges_.push_back(
          {order[u],
           surface_.weights[e] * std::max(stiffness[u], stiffness[v]),
           length > 0 ? options.strain_hardening / (length * length) : 0,
           rope,
           (rope - of_target) * (rope - of_target)});
      vertex.full_curvature += edges_.back().weight;
    }
  }
}

void MuscleSweep::UpdateGradient(const Points& points) {
  const Points by_vertex = VolumeGradient(points, surface_.triangles);
  double linear = 0;
  yield_ = 0;
  for (size_t i = 0; i < vertices_.size(); ++i) {
    gradient_.row(i) = by_vertex.row(vertices_[i].number);
    linear += gradient_.row(i).dot(places_[i].point);
    if (vertices_[i].attached >= 0) continue;
    yield_ += gradient_.row(i).squaredNorm() / vertices_[i].full_curvature;
  }
  // The volume is a cubic form in the vertices.
  lacking_ = surface_.volume - linear / 3 + linear + withheld_;
}

void MuscleSweep::SetPressure(double gain) {
  pressure_ = 0;
  if (gain == 0 || !(yield_ > 0)) return;
  double linear = 0;
  for (size_t i = 0; i < places_.size(); ++i) {
    linear += gradient_.row(i).dot(places_[i].point);
  }
  pressure_ = gain * (lacking_ - linear) / yield_;
}

// Returns the place, or the nearest one within the reach of the predicted
// vertex.
RowVector3d MuscleSweep::WithinReach(const Vertex& vertex,
                                     const RowVector3d& place) const {
  const RowVector3d beyond = place - vertex.predicted;
  const double squared = beyond.squaredNorm();
  if (squared <= reach_ * reach_) return place;
  return vertex.predicted + reach_ / std::sqrt(squared) * beyond;
}

// Returns the minimizer over the position of one vertex of a quadratic function
// that has the slope of the energy and the pressure where the vertex is, and at
// least two thirds of its curvature: along a strain that hardens, a step is up
// to 1.5 times too long, below the 2 at which sweeps would not converge.
RowVector3d MuscleSweep::LowestPlace(int i) const {
  const Vertex& vertex = vertices_[i];
  const Place& place = places_[i];
  double curvature = vertex.curvature;
  RowVector3d descent = pressure_ * gradient_.row(i) - curvature * place.offset;
  const int end = i + 1 < static_cast<int>(vertices_.size())
                      ? vertices_[i + 1].first_edge
                      : static_cast<int>(edges_.size());
  for (int e = vertex.first_edge; e < end; ++e) {
    const Edge& edge = edges_[e];
    const Place& other = places_[edge.neighbour];
    const RowVector3d strain = other.offset - place.offset;
    const double strain_squared = strain.squaredNorm();
    const double hardening = edge.hardening * strain_squared;
    descent += edge.weight * (1 + hardening) * strain;
    curvature += edge.weight * (1 + 2 * hardening);
    if (strain_squared <= edge.loose) continue;
    const RowVector3d along = other.point - place.point;
    const double square = along.squaredNorm();
    if (square <= edge.rope * edge.rope) continue;
    const double pull = options_.relaxation.rope_factor * edge.weight;
    descent += pull * (1 - edge.rope / std::sqrt(square)) * along;
    curvature += pull;
  }
  return vertex.target + place.offset + descent / curvature;
}

void MuscleSweep::SweepBlock(int block,
                             const PlaneChanges& changes,
                             PlaneSet* planes,
                             Points* points,
                             Points* unprojected) {
  const std::vector<int>& first = surface_.blocks.first;
  for (int i = first[block]; i < first[block + 1]; ++i) {
    const Vertex& vertex = vertices_[i];
    const int v = vertex.number;
    const RowVector3d lowest = WithinReach(
        vertex,
        vertex.attached < 0 ? LowestPlace(i)
                            : RowVector3d(attached_.row(vertex.attached)));
    unprojected->row(v) = lowest;
    if (changes.looks_at_all) {
      planes->FindNear(muscle_, v, lowest);
    } else if (changes.levels_moved) {
      planes->RefreshNear(muscle_, v);
    }
    Place& place = places_[i];
    place.point = planes->Projected(muscle_, v, lowest);
    place.offset = place.point - vertex.target;
    points->row(v) = place.point;
  }
}

}  // namespace musclewarp
