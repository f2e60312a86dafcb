// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/certified_contact/contact_relaxation.h"

#include <glog/logging.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <tuple>

#include "musclewarp/geometry/half_space_projection.h"
#include "musclewarp/mesh/measures.h"
#include "musclewarp/mesh/transformed.h"

namespace musclewarp {
namespace {

using Eigen::RowVector3d;
using Eigen::RowVector3i;

// Every so many sweeps, and in the last one, a vertex looks at all its planes;
// in the others at those that were nearer than the reach the last time.
constexpr int kFullSweepEvery = 6;

// Planes are looked for as far away as this part of what two surfaces may go
// towards each other. They rarely do, and are found later where they do.
constexpr double kLookedAt = 0.7;

// A plane is near to a vertex that is nearer than this, mm.
constexpr double kNear = 0.5;

// A push goes no farther than this, mm.
constexpr double kFarthestPush = 5;

// Of the room that a muscle was given by another one that it does not need any
// more, what is left after a sweep.
constexpr double kBiasDecay = 0.97;

// The turn of a triangle from `a` to `b`, as a matrix for row vectors.
Eigen::Matrix3d TurnOf(const Corners& a, const Corners& b) {
  const auto frame = [](const Corners& t) {
    Eigen::Matrix3d axes;
    const RowVector3d e = (t.row(1) - t.row(0)).normalized();
    const RowVector3d n =
        e.cross(RowVector3d(t.row(2) - t.row(0))).normalized();
    axes << e, n, e.cross(n);
    return axes;
  };
  return frame(a).transpose() * frame(b);
}

// The second numbers of pairs by their first.
struct Grouped {
  std::vector<int> starts, items;

  const int* begin(Eigen::Index first) const {
    return items.data() + starts[first];
  }
  int count(Eigen::Index first) const {
    return starts[first + 1] - starts[first];
  }
};

Grouped ByFirst(const std::vector<std::pair<int, int>>& pairs,
                Eigen::Index count) {
  Grouped grouped;
  grouped.starts.assign(count + 1, 0);
  for (const auto& pair : pairs) ++grouped.starts[pair.first + 1];
  for (Eigen::Index i = 0; i < count; ++i) {
    grouped.starts[i + 1] += grouped.starts[i];
  }
  std::vector<int> next = grouped.starts;
  grouped.items.resize(pairs.size());
  for (const auto& [first, second] : pairs) {
    grouped.items[next[first]++] = second;
  }
  return grouped;
}

}  // namespace

bool ContactRelaxationOptions::IsValid(std::string* error) const {
  if (gap > 0 && smoothing_length > 0 && reach > gap && sweeps > 0 &&
      repair_sweeps > 0 && volume_tolerance > 0) {
    return true;
  }
  *error =
      "ContactRelaxationOptions: allowed are gap, smoothing_length, sweeps, "
      "repair_sweeps and volume_tolerance above 0 and reach above gap";
  return false;
}

ContactRelaxation::ContactRelaxation(
    const ContactRelaxationOptions& options,
    const std::vector<ContactMesh>& muscles,
    const std::vector<const TriangleBvh*>& rest_bones,
    const ContactState& clean,
    const ContactState& next)
    : options_(options),
      muscles_(muscles),
      rest_bones_(rest_bones),
      bones_before_(clean.bones_from_rest),
      bones_(next.bones_from_rest),
      clean_(clean.points),
      targets_(next.targets),
      sides_(muscles.size()),
      first_sides_(muscles.size()),
      near_sides_(muscles.size()),
      num_near_sides_(muscles.size()) {
  std::string error;
  CHECK(options.IsValid(&error)) << error;
  CHECK_EQ(bones_.size(), bones_before_.size());
  carried_.resize(muscles.size());
  turns_.resize(muscles.size());
  clean_trees_.resize(muscles.size());
  trees_.resize(muscles.size());
#pragma omp parallel for schedule(dynamic, 1)
  for (int i = 0; i < num_muscles(); ++i) {
    carried_[i] = clean_[i] + next.targets[i] - clean.targets[i];
    clean_trees_[i] = std::make_unique<TriangleBvh>(*muscles_[i].tree);
    clean_trees_[i]->Refit(clean_[i]);
    trees_[i] = std::make_unique<TriangleBvh>(*muscles_[i].tree);
    trees_[i]->Refit(carried_[i]);
    turns_[i].resize(muscles[i].triangles.rows());
    for (Eigen::Index f = 0; f < muscles[i].triangles.rows(); ++f) {
      turns_[i][f] = TurnOf(clean_trees_[i]->corners(static_cast<int>(f)),
                            trees_[i]->corners(static_cast<int>(f)));
    }
  }
  for (const ContactMesh& mesh : muscles_) {
    stiffness_.push_back(Eigen::VectorXd::Ones(mesh.num_vertices()));
  }
  points_ = carried_;
  wishes_ = carried_;
  for (int a = 0; a < num_muscles(); ++a) {
    for (int b = a + 1; b < num_muscles(); ++b) FindMusclePlanes(a, b);
  }
  for (size_t bone = 0; bone < bones_.size(); ++bone) {
    FindBonePlanes(static_cast<int>(bone));
  }
  SortSides();
}

void ContactRelaxation::AddBonePlane(int muscle,
                                     int triangle,
                                     int bone,
                                     const HalfSpace& space) {
  // From the rest pose of the bone to its new place.
  HalfSpace moved;
  moved.normal = space.normal * bones_[bone].topLeftCorner<3, 3>().transpose();
  moved.level =
      space.level + moved.normal.dot(bones_[bone].topRightCorner<3, 1>());
  for (int k = 0; k < 3; ++k) {
    const int v = muscles_[muscle].triangles(triangle, k);
    if (moved.normal.dot(carried_[muscle].row(v)) - moved.level <=
        kFarthestPush) {
      sides_[muscle].push_back({v, -1, 1, moved});
    }
  }
}

void ContactRelaxation::FindBonePlanes(int bone) {
  const Eigen::Matrix4d rest_from_before = RigidInverse(bones_before_[bone]);
  const Eigen::Matrix4d now_from_before = bones_[bone] * rest_from_before;
  for (int i = 0; i < num_muscles(); ++i) {
    // Where it was and where it is carried to, as the bone sees it.
    const Points at_rest = Transformed(clean_[i], rest_from_before);
    const Points carried = Transformed(carried_[i], RigidInverse(bones_[bone]));
    const Eigen::VectorXd moves =
        (Transformed(clean_[i], now_from_before) - carried_[i])
            .rowwise()
            .norm();
    const Triangles& triangles = muscles_[i].triangles;
    // What a triangle may meet between.
    const double margin = options_.gap + kLookedAt * options_.reach;
    std::vector<Box3> passed(triangles.rows());
#pragma omp parallel for schedule(static)
    for (Eigen::Index f = 0; f < triangles.rows(); ++f) {
      passed[f] = BoxOf(BoxOf(CornersOf(at_rest, triangles.row(f)), margin),
                        BoxOf(CornersOf(carried, triangles.row(f)), margin));
    }
    trees_[i]->RefitBoxes(passed);
    const Grouped met = ByFirst(
        trees_[i]->CollectOverlaps(
            *rest_bones_[bone],
            [&](int f, int /*g*/) { return !muscles_[i].IsExempt(bone, f); }),
        triangles.rows());
    std::vector<std::vector<HalfSpace>> found(triangles.rows());
#pragma omp parallel for schedule(dynamic, 64)
    for (Eigen::Index f = 0; f < triangles.rows(); ++f) {
      if (met.count(f) == 0) continue;
      const double move = std::max({moves[triangles(f, 0)],
                                    moves[triangles(f, 1)],
                                    moves[triangles(f, 2)]});
      const double radius = margin + std::min(1.5 * move, 2 * kFarthestPush);
      PartFromObstacles(CornersOf(at_rest, triangles.row(f)),
                        *rest_bones_[bone],
                        met.begin(f),
                        met.count(f),
                        radius,
                        options_.gap,
                        &found[f]);
    }
    for (Eigen::Index f = 0; f < triangles.rows(); ++f) {
      for (const HalfSpace& space : found[f]) {
        AddBonePlane(i, static_cast<int>(f), bone, space);
      }
    }
  }
}

RowVector3d ContactRelaxation::Turned(
    int a, int f, int b, int g, const RowVector3d& before) const {
  const RowVector3d turned = before * (turns_[a][f] + turns_[b][g]);
  // Triangles without area have no turn.
  return turned.norm() > 0.5 ? turned.normalized() : before;
}

ContactRelaxation::Plane ContactRelaxation::PlaneOf(
    int a, int b, const PartedPair& pair) const {
  Plane plane;
  plane.muscle_a = a;
  plane.muscle_b = b;
  plane.a = muscles_[a].triangles.row(pair.a);
  plane.b = muscles_[b].triangles.row(pair.b);
  plane.normal = Turned(a, pair.a, b, pair.b, pair.normal);
  plane.half_gap = options_.gap / 2;
  plane.distance = pair.distance;
  return plane;
}

void ContactRelaxation::AddPlane(const Plane& plane) {
  const int index = static_cast<int>(planes_.size());
  planes_.push_back(plane);
  for (int k = 0; k < 3; ++k) {
    sides_[plane.muscle_a].push_back(
        {plane.a[k], index, 1, {plane.normal, 0}, plane.distance});
    sides_[plane.muscle_b].push_back(
        {plane.b[k], index, -1, {-plane.normal, 0}, plane.distance});
  }
}

void ContactRelaxation::FindMusclePlanes(int a, int b) {
  const std::vector<PartedPair> pairs =
      PartedPairs(*clean_trees_[a],
                  *clean_trees_[b],
                  *trees_[a],
                  *trees_[b],
                  options_.gap + kLookedAt * 2 * options_.reach);
  std::vector<Plane> planes(pairs.size());
#pragma omp parallel for schedule(static)
  for (size_t i = 0; i < pairs.size(); ++i) {
    planes[i] = PlaneOf(a, b, pairs[i]);
  }
  for (const Plane& plane : planes) AddPlane(plane);
}

void ContactRelaxation::SortSides() {
#pragma omp parallel for schedule(dynamic, 1)
  for (int i = 0; i < num_muscles(); ++i) {
    std::vector<int>& first = first_sides_[i];
    first.assign(muscles_[i].num_vertices() + 1, 0);
    for (const Side& side : sides_[i]) ++first[side.vertex + 1];
    for (size_t v = 1; v < first.size(); ++v) first[v] += first[v - 1];
    std::vector<Side> sorted(sides_[i].size());
    std::vector<int> next = first;
    for (const Side& side : sides_[i]) sorted[next[side.vertex]++] = side;
    // In an order that is not that of the muscles.
    const auto comes_first = [](const Side& a, const Side& b) {
      const auto key = [](const Side& side) {
        const Eigen::RowVector3d& n = side.space.normal;
        return std::make_tuple(
            side.distance, side.space.level, n[0], n[1], n[2]);
      };
      return key(a) < key(b);
    };
    for (size_t v = 1; v < first.size(); ++v) {
      std::stable_sort(sorted.begin() + first[v - 1],
                       sorted.begin() + first[v],
                       comes_first);
    }
    near_sides_[i].resize(sorted.size());
    num_near_sides_[i].assign(muscles_[i].num_vertices(), 0);
    sides_[i] = std::move(sorted);
  }
}

double ContactRelaxation::Level(const Side& side) const {
  if (side.plane < 0) return side.space.level;
  const Plane& plane = planes_[side.plane];
  return side.sign * plane.level + plane.half_gap;
}

void ContactRelaxation::FindNearSides(int muscle,
                                      int vertex,
                                      const RowVector3d& point) {
  const int begin = first_sides_[muscle][vertex];
  int* near = near_sides_[muscle].data() + begin;
  int count = 0;
  for (int i = begin; i < first_sides_[muscle][vertex + 1]; ++i) {
    const Side& side = sides_[muscle][i];
    if (side.space.normal.dot(point) < Level(side) + options_.reach) {
      near[count++] = i;
    }
  }
  num_near_sides_[muscle][vertex] = count;
}

RowVector3d ContactRelaxation::Projected(int muscle,
                                         int vertex,
                                         const RowVector3d& point) const {
  constexpr int kMost = 512;
  const int* near = near_sides_[muscle].data() + first_sides_[muscle][vertex];
  const int count = std::min(kMost, num_near_sides_[muscle][vertex]);
  std::array<HalfSpace, kMost> spaces;
  bool is_inside = true;
  for (int i = 0; i < count; ++i) {
    const Side& side = sides_[muscle][near[i]];
    spaces[i] = {side.space.normal, Level(side)};
    is_inside &= spaces[i].normal.dot(point) >= spaces[i].level;
  }
  if (is_inside) return point;
  RowVector3d nearest = point;
  if (ProjectIntoHalfSpaces(spaces.data(), count, options_.reach, &nearest)) {
    return nearest;
  }
  // A place between; another muscle has to give way, by SetLevels, but a bone
  // does not.
  ApproachHalfSpaces(spaces.data(), count, 10, &nearest);
  int bones = 0;
  for (int i = 0; i < count; ++i) {
    if (sides_[muscle][near[i]].plane < 0) spaces[bones++] = spaces[i];
  }
  ApproachHalfSpaces(spaces.data(), bones, 20, &nearest);
  const RowVector3d push = nearest - carried_[muscle].row(vertex);
  if (push.norm() <= kFarthestPush) return nearest;
  return carried_[muscle].row(vertex) + kFarthestPush / push.norm() * push;
}

void ContactRelaxation::SetLevels(bool is_first) {
#pragma omp parallel for schedule(static)
  for (size_t i = 0; i < planes_.size(); ++i) {
    Plane& plane = planes_[i];
    // The lowest corner of a and the highest of b.
    const auto lowest = [&](const std::vector<Points>& points) {
      double least = std::numeric_limits<double>::infinity();
      for (int k = 0; k < 3; ++k) {
        least = std::min(
            least, plane.normal.dot(points[plane.muscle_a].row(plane.a[k])));
      }
      return least;
    };
    const auto highest = [&](const std::vector<Points>& points) {
      double most = -std::numeric_limits<double>::infinity();
      for (int k = 0; k < 3; ++k) {
        most = std::max(
            most, plane.normal.dot(points[plane.muscle_b].row(plane.b[k])));
      }
      return most;
    };
    if (plane.corner >= 0) {
      plane.level = plane.normal.dot(points_[plane.muscle_a].row(plane.corner));
      continue;
    }
    if (!is_first) {
      // Who could not come to the side that is his is held by something else:
      // the other one has to go farther.
      const double down =
          std::max(0.0, plane.level + plane.half_gap - lowest(points_));
      const double up =
          std::max(0.0, highest(points_) - plane.level + plane.half_gap);
      if (down + up < 1e-3) plane.bias *= kBiasDecay;
      plane.bias += up - down;
    }
    plane.level = (lowest(wishes_) + highest(wishes_)) / 2 + plane.bias;
  }
}

void ContactRelaxation::SweepMuscle(int muscle, bool is_full) {
  const ContactMesh& mesh = muscles_[muscle];
  const Points& target = targets_[muscle];
  const Points& carried = carried_[muscle];
  const Eigen::VectorXd& stiffness = stiffness_[muscle];
  Points& points = points_[muscle];
  const double decay =
      1 / (options_.smoothing_length * options_.smoothing_length);
  for (int v = 0; v < mesh.num_vertices(); ++v) {
    RowVector3d sum = RowVector3d::Zero();
    double weights = decay * mesh.areas[v];
    for (int e = mesh.first[v]; e < mesh.first[v + 1]; ++e) {
      const int u = mesh.neighbours[e];
      const double weight =
          std::max(stiffness[u], stiffness[v]) * mesh.weights[e];
      sum += weight * (points.row(u) - target.row(u));
      weights += weight;
    }
    RowVector3d wish = target.row(v) + sum / weights;
    const RowVector3d beyond = wish - carried.row(v);
    const double far = beyond.norm();
    if (far > options_.reach) {
      wish = carried.row(v) + options_.reach / far * beyond;
    }
    wishes_[muscle].row(v) = wish;
    if (is_full) FindNearSides(muscle, v, wish);
    points.row(v) = Projected(muscle, v, wish);
  }
}

void ContactRelaxation::Sweep(int sweeps) {
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    SetLevels(sweep == 0);
    const bool is_full = sweep % kFullSweepEvery == 0 || sweep + 1 == sweeps;
#pragma omp parallel for schedule(dynamic, 1)
    for (int i = 0; i < num_muscles(); ++i) SweepMuscle(i, is_full);
  }
}

double ContactRelaxation::RestoreVolume(int muscle) {
  constexpr int kSteps = 40;
  constexpr int kSmoothing = 3;
  const ContactMesh& mesh = muscles_[muscle];
  Points& points = points_[muscle];
  const int count = mesh.num_vertices();
  // How far a vertex takes part: not where a plane holds it, and little beside.
  Eigen::VectorXd share(count);
  for (int v = 0; v < count; ++v) {
    share[v] = points.row(v) == wishes_[muscle].row(v);
  }
  for (int pass = 0; pass < kSmoothing; ++pass) {
    Eigen::VectorXd smooth = share;
    for (int v = 0; v < count; ++v) {
      if (share[v] == 0) continue;
      double sum = 0, weights = 0;
      for (int e = mesh.first[v]; e < mesh.first[v + 1]; ++e) {
        sum += mesh.weights[e] * share[mesh.neighbours[e]];
        weights += mesh.weights[e];
      }
      if (weights > 0) smooth[v] = (share[v] + sum / weights) / 2;
    }
    share = smooth;
  }
  double error = 0;
  for (int step = 0;; ++step) {
    error = SignedVolume(points, mesh.triangles) - mesh.volume;
    if (step == kSteps ||
        std::abs(error) <= options_.volume_tolerance * mesh.volume) {
      break;
    }
    Points normals = Points::Zero(count, 3);
    for (Eigen::Index f = 0; f < mesh.triangles.rows(); ++f) {
      const Corners t = CornersOf(points, mesh.triangles.row(f));
      const RowVector3d sixth = AreaVector(t) / 6;
      for (int k = 0; k < 3; ++k) normals.row(mesh.triangles(f, k)) += sixth;
    }
    const Eigen::VectorXd lengths = normals.rowwise().norm();
    const double slope = share.dot(lengths);
    if (!(slope > 0)) break;
    const double move =
        std::clamp(-error / slope, -options_.reach, options_.reach);
    for (int v = 0; v < count; ++v) {
      if (share[v] == 0 || lengths[v] == 0) continue;
      const RowVector3d moved =
          points.row(v) + share[v] * move / lengths[v] * normals.row(v);
      FindNearSides(muscle, v, moved);
      points.row(v) = Projected(muscle, v, moved);
    }
  }
  return std::abs(error) / mesh.volume;
}

double ContactRelaxation::RestoreVolumes() {
  double worst = 0;
#pragma omp parallel for schedule(dynamic, 1) reduction(max : worst)
  for (int i = 0; i < num_muscles(); ++i) {
    worst = std::max(worst, RestoreVolume(i));
  }
  return worst;
}

std::vector<VertexHalfSpace> ContactRelaxation::TightestPlanes(
    int muscle, const std::vector<int>& vertices) const {
  std::vector<VertexHalfSpace> planes;
  for (const int v : vertices) {
    double depth = -std::numeric_limits<double>::infinity();
    VertexHalfSpace tightest;
    for (int i = first_sides_[muscle][v]; i < first_sides_[muscle][v + 1];
         ++i) {
      const Side& side = sides_[muscle][i];
      const RowVector3d& normal = side.space.normal;
      const double level = Level(side);
      if (normal.dot(points_[muscle].row(v)) > level + kNear) continue;
      const double depth_here = level - normal.dot(targets_[muscle].row(v));
      if (depth_here <= depth) continue;
      depth = depth_here;
      tightest = {v, {normal, level}};
    }
    if (std::isfinite(depth)) planes.push_back(tightest);
  }
  return planes;
}

double ContactRelaxation::WorstViolation() const {
  double worst = 0;
  for (int i = 0; i < num_muscles(); ++i) {
    for (const Side& side : sides_[i]) {
      if (side.plane >= 0 && planes_[side.plane].IsWithinOne()) continue;
      worst = std::max(
          worst,
          Level(side) - side.space.normal.dot(points_[i].row(side.vertex)));
    }
  }
  return worst;
}

}  // namespace musclewarp
