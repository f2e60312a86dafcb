// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/initial_separation/initial_separation.h"

#include <glog/logging.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <deque>
#include <map>
#include <utility>

#include "musclewarp/base/option_check.h"
#include "musclewarp/base/stage_times.h"

namespace musclewarp {
namespace {

using Eigen::RowVector3d;

RowVector3d UnitNormal(const Corners& t) {
  const RowVector3d n = AreaVector(t);
  const double norm = n.norm();
  return norm > 0 ? RowVector3d(n / norm) : RowVector3d::Zero();
}

// The directions in which the vertices of a muscle are pushed.
struct Pushes {
  Points sum;
  Eigen::VectorXd count;

  explicit Pushes(Eigen::Index vertices)
      : sum(Points::Zero(vertices, 3)),
        count(Eigen::VectorXd::Zero(vertices)) {}
};

// A triangle of a muscle that crosses another triangle.
struct Crossing {
  size_t muscle;
  int triangle;
  Corners other;
  bool is_counted;  // true once for each pair of triangles
};

// The state of the muscles during their separation.
class Separator {
 public:
  Separator(const std::vector<const SearchableMesh*>& muscles,
            const std::vector<const SearchableMesh*>& bones,
            const std::vector<ExemptArea>& exempt,
            const InitialSeparationOptions& options)
      : muscles_(muscles), bones_(bones), exempt_(exempt), options_(options) {
    for (const SearchableMesh* muscle : muscles) {
      muscle_distances_.emplace_back(*muscle);
    }
    for (const SearchableMesh* bone : bones) {
      bone_distances_.emplace_back(*bone);
    }
  }

  // Moves the vertices of the muscles into their medial cells. `known`: of an
  // earlier separation, or null.
  void EnterCells(KnownCells* known) {
    // Cells end within their range of a muscle; the rest is for paths that
    // leave it.
    const double reach = 3 * options_.cell.range;
    std::vector<char> is_known(muscles_.size(), false);
    if (known) is_known = AreStillKnown(*known, muscles_, bones_, reach);
    std::vector<const SolidDistance*> bones;
    for (const SolidDistance& bone : bone_distances_) bones.push_back(&bone);
    cells_.reserve(muscles_.size());
    std::vector<const MedialCell*> cells;  // that are not known
    std::vector<const Points*> rest;
    for (size_t i = 0; i < muscles_.size(); ++i) {
      std::vector<const SolidDistance*> others;
      for (size_t j = 0; j < muscles_.size(); ++j) {
        if (j != i) others.push_back(&muscle_distances_[j]);
      }
      cells_.emplace_back(
          options_.cell, muscle_distances_[i], std::move(others), bones);
      if (is_known[i]) continue;
      cells.push_back(&cells_.back());
      rest.push_back(&muscles_[i]->points());
    }
    std::vector<Points> projected = MedialCell::Project(cells, rest);
    auto next = projected.begin();
    for (size_t i = 0; i < muscles_.size(); ++i) {
      points_.push_back(is_known[i] ? known->projected[i] : std::move(*next++));
    }
    if (known) Remember(muscles_, bones_, points_, known);
    for (const ExemptArea& area : exempt_) {
      for (Eigen::Index v = 0; v < points_[area.muscle].rows(); ++v) {
        if (!area.vertices[v]) continue;
        points_[area.muscle].row(v) = muscles_[area.muscle]->points().row(v);
      }
    }
    for (size_t i = 0; i < muscles_.size(); ++i) {
      trees_.emplace_back(points_[i], muscles_[i]->triangles());
    }
    has_moved_.assign(muscles_.size(), true);
  }

  // Finds the triangles of muscles that cross others. Pairs of meshes that have
  // not moved since the last search are not tested again.
  std::vector<Crossing> FindCrossings() {
    const size_t num_muscles = muscles_.size();
    for (size_t i = 0; i < num_muscles; ++i) {
      for (size_t j = i + 1; j < num_muscles; ++j) {
        if (!has_moved_[i] && !has_moved_[j]) continue;
        found_[{i, j}].crossings = CrossingsOfMuscles(i, j);
      }
      for (size_t b = 0; b < bones_.size(); ++b) {
        if (!has_moved_[i]) continue;
        found_[{i, num_muscles + b}].crossings = CrossingsOfBone(i, b);
      }
    }
    has_moved_.assign(num_muscles, false);
    std::vector<Crossing> crossings;
    for (auto& [pair, found] : found_) {
      const int count = static_cast<int>(found.crossings.size());
      std::vector<int>& fewest = found.fewest;
      fewest.push_back(fewest.empty() ? count : std::min(fewest.back(), count));
      crossings.insert(
          crossings.end(), found.crossings.begin(), found.crossings.end());
    }
    return crossings;
  }

  // Returns true if every pair of meshes that cross is idle (idle_rounds).
  bool IsIdle() const {
    return std::all_of(found_.begin(), found_.end(), [&](const auto& item) {
      const PairOfMeshes& pair = item.second;
      return pair.crossings.empty() || IsPairIdle(pair.fewest);
    });
  }

  // Returns the directions in which the vertices of crossing triangles are
  // pushed.
  std::vector<Pushes> PushesFor(const std::vector<Crossing>& crossings) const {
    std::vector<Pushes> pushes;
    for (const Points& points : points_) pushes.emplace_back(points.rows());
    const std::vector<Points> inward = WaysInward(crossings);
    for (const Crossing& crossing : crossings) {
      Push(crossing, inward[crossing.muscle], &pushes[crossing.muscle]);
    }
    return pushes;
  }

  // Moves pushed vertices by a step, and nearby vertices along with them.
  void Apply(const Pushes& pushes, size_t muscle) {
    Points& points = points_[muscle];
    std::vector<int> pushed;
    for (Eigen::Index v = 0; v < points.rows(); ++v) {
      if (pushes.count[v] > 0) pushed.push_back(static_cast<int>(v));
    }
    if (pushed.empty()) return;
    has_moved_[muscle] = true;
    const double radius = options_.carry_radius;
    Points moves = Points::Zero(points.rows(), 3);
#pragma omp parallel for schedule(dynamic, 256)
    for (Eigen::Index v = 0; v < points.rows(); ++v) {
      RowVector3d sum = RowVector3d::Zero();
      double weights = 0, most = 0;
      for (const int u : pushed) {
        const double d = (points.row(u) - points.row(v)).norm();
        if (d >= radius) continue;
        const double w = (1 - d / radius) * (1 - d / radius);
        sum += w * pushes.sum.row(u) / pushes.count[u];
        weights += w;
        most = std::max(most, 1 - d / radius);
      }
      if (weights > 0) moves.row(v) = options_.step * most / weights * sum;
    }
    points += moves;
    trees_[muscle].Refit(points);
  }

  std::vector<Points> TakePoints() { return std::move(points_); }

 private:
  struct PairOfMeshes {
    std::vector<Crossing> crossings;
    std::vector<int> fewest;  // the fewest crossings so far, by round
  };

  // A pair that crosses again after it was separated is idle too: other meshes
  // push it back and forth.
  bool IsPairIdle(const std::vector<int>& fewest) const {
    const size_t window = options_.idle_rounds;
    return fewest.size() > window &&
           fewest.back() >=
               options_.idle_fraction * fewest[fewest.size() - 1 - window];
  }

  std::vector<Crossing> CrossingsOfMuscles(size_t i, size_t j) const {
    std::vector<Crossing> crossings;
    for (const auto& [f, g] : IntersectingTriangles(trees_[i], trees_[j])) {
      crossings.push_back({i, f, trees_[j].corners(g), true});
      crossings.push_back({j, g, trees_[i].corners(f), false});
    }
    return crossings;
  }

  std::vector<Crossing> CrossingsOfBone(size_t i, size_t b) const {
    const ExemptArea* area =
        FindExempt(exempt_, static_cast<int>(i), static_cast<int>(b));
    std::vector<Crossing> crossings;
    for (const auto& [f, g] :
         IntersectingTriangles(trees_[i], bones_[b]->bvh())) {
      if (area && area->triangles[f]) continue;
      crossings.push_back({i, f, bones_[b]->bvh().corners(g), true});
    }
    return crossings;
  }

  // Returns, by muscle, the unit directions into the medial cell at the
  // vertices of crossing triangles, #V x 3; zero at other vertices.
  std::vector<Points> WaysInward(const std::vector<Crossing>& crossings) const {
    std::vector<Points> inward;
    std::vector<std::vector<char>> is_needed;
    for (const Points& points : points_) {
      inward.push_back(Points::Zero(points.rows(), 3));
      is_needed.emplace_back(points.rows(), false);
    }
    for (const Crossing& crossing : crossings) {
      const size_t i = crossing.muscle;
      for (const int v : muscles_[i]->triangles().row(crossing.triangle)) {
        is_needed[i][v] = true;
      }
    }
    for (size_t i = 0; i < points_.size(); ++i) {
#pragma omp parallel for schedule(dynamic, 16)
      for (Eigen::Index v = 0; v < points_[i].rows(); ++v) {
        if (is_needed[i][v]) {
          inward[i].row(v) = cells_[i].Inward(points_[i].row(v));
        }
      }
    }
    return inward;
  }

  // Pushes the corners of a crossing triangle.
  void Push(const Crossing& crossing,
            const Points& ways_inward,
            Pushes* pushes) const {
    const auto t =
        muscles_[crossing.muscle]->triangles().row(crossing.triangle);
    RowVector3d inward = RowVector3d::Zero();
    for (int k = 0; k < 3; ++k) inward += ways_inward.row(t[k]);
    const RowVector3d normal = UnitNormal(crossing.other);
    RowVector3d direction =
        normal.dot(inward) > options_.min_agreement ? normal : inward;
    if (direction.norm() == 0) direction = normal;
    direction.normalize();
    for (int k = 0; k < 3; ++k) {
      pushes->sum.row(t[k]) += direction;
      pushes->count[t[k]] += 1;
    }
  }

  const std::vector<const SearchableMesh*>& muscles_;
  const std::vector<const SearchableMesh*>& bones_;
  const std::vector<ExemptArea>& exempt_;
  const InitialSeparationOptions& options_;
  std::deque<SolidDistance> muscle_distances_, bone_distances_;
  std::vector<MedialCell> cells_;
  std::vector<Points> points_;
  std::vector<TriangleBvh> trees_;

  // By muscle: whether it has moved since the last search for crossings.
  std::vector<char> has_moved_;

  // By the indices of the two meshes, with bones after muscles.
  std::map<std::pair<size_t, size_t>, PairOfMeshes> found_;
};

}  // namespace

bool InitialSeparationOptions::IsValid(std::string* error) const {
  return OptionCheck("InitialSeparationOptions", error)
             .IsAbove("step", step, 0)
             .IsAbove("carry_radius", carry_radius, 0)
             .IsWithin("min_agreement", min_agreement, -1, 1)
             .IsAtLeast("max_rounds", max_rounds, 0)
             .IsAtLeast("idle_rounds", idle_rounds, 1)
             .IsWithin("idle_fraction", idle_fraction, 0, 1)
             .is_valid() &&
         cell.IsValid(error);
}

InitialSeparation SeparateInitially(
    const std::vector<const SearchableMesh*>& muscles,
    const std::vector<const SearchableMesh*>& bones,
    const std::vector<ExemptArea>& exempt,
    const InitialSeparationOptions& options,
    const std::function<void(int round, int crossing_pairs)>& on_round,
    KnownCells* cells) {
  std::string error;
  CHECK(options.IsValid(&error)) << error;
  const ScopedStage stage("cells of the rest pose");
  Separator separator(muscles, bones, exempt, options);
  if (on_round) on_round(0, 0);
  separator.EnterCells(cells);
  const ScopedStage rounds("separation");
  InitialSeparation result;
  for (;; ++result.rounds) {
    const std::vector<Crossing> crossings = separator.FindCrossings();
    result.crossing_pairs = static_cast<int>(std::count_if(
        crossings.begin(), crossings.end(), [](const Crossing& crossing) {
          return crossing.is_counted;
        }));
    VLOG(2) << "separation, round " << result.rounds << ": "
            << result.crossing_pairs << " crossing pairs";
    if (result.crossing_pairs == 0 || result.rounds == options.max_rounds ||
        separator.IsIdle()) {
      break;
    }
    if (on_round) on_round(result.rounds, result.crossing_pairs);
    const std::vector<Pushes> pushes = separator.PushesFor(crossings);
    for (size_t i = 0; i < muscles.size(); ++i) separator.Apply(pushes[i], i);
  }
  result.points = separator.TakePoints();
  return result;
}

}  // namespace musclewarp
