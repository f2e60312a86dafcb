// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/certified_contact/separating_planes.h"

#include <algorithm>
#include <utility>

#include "musclewarp/geometry/triangle_distance.h"
#include "musclewarp/mesh/transformed.h"

namespace musclewarp {
namespace {

using Eigen::RowVector3d;

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

void Append(const std::vector<std::vector<SeparatingPlane>>& parts,
            std::vector<SeparatingPlane>* planes) {
  for (const auto& part : parts) {
    planes->insert(planes->end(), part.begin(), part.end());
  }
}

// The triangles of `other` whose boxes are near a triangle before the step or
// where it is carried.
std::vector<int> NearTriangles(const Corners& before,
                               const TriangleBvh& other_before,
                               const Corners& carried,
                               const TriangleBvh& other_carried,
                               double square) {
  std::vector<int> near;
  const auto collect = [&](const Corners& mine, const TriangleBvh& theirs) {
    const Box3 box = BoxOf(mine);
    theirs.Traverse(
        [&](const Box3& node) { return node.SquaredDistance(box) <= square; },
        [&](int g) {
          if (BoxOf(theirs.corners(g)).SquaredDistance(box) <= square) {
            near.push_back(g);
          }
        });
  };
  collect(before, other_before);
  collect(carried, other_carried);
  std::sort(near.begin(), near.end());
  near.erase(std::unique(near.begin(), near.end()), near.end());
  return near;
}

void AddPlanesBetweenMuscles(const StepOptions& options,
                             const ContactStep& step,
                             const std::vector<TriangleBvh>& carried,
                             int a,
                             int b,
                             std::vector<SeparatingPlane>* planes) {
  // Either muscle may move by the reach.
  const double radius =
      options.AimedGap() + options.planes.search_share * 2 * options.reach;
  const double square = radius * radius;
  const TriangleBvh& tree_a = step.trees_before[a];
  const TriangleBvh& tree_b = step.trees_before[b];
  std::vector<std::vector<SeparatingPlane>> found(tree_a.num_triangles());
#pragma omp parallel for schedule(dynamic, 64)
  for (int f = 0; f < tree_a.num_triangles(); ++f) {
    for (const int g : NearTriangles(tree_a.corners(f),
                                     tree_b,
                                     carried[a].corners(f),
                                     carried[b],
                                     square)) {
      const auto separation =
          SeparateTriangles(tree_a.corners(f), tree_b.corners(g));
      if (!separation) continue;
      if (separation->distance > radius &&
          ClosestPointsOfTriangles(carried[a].corners(f), carried[b].corners(g))
                  .squared_distance > square) {
        continue;
      }
      found[f].push_back(
          PlaneBetween(step, a, f, b, g, *separation, options.AimedGap() / 2));
    }
  }
  Append(found, planes);
}

// The farthest that a vertex of each triangle moves in a step as the bone sees
// it, and the box around everything that the triangle may meet on its way.
struct PathsPastBone {
  Points at_rest;         // the vertices before, in the rest pose of the bone
  Eigen::VectorXd moves;  // of the vertices, mm
  std::vector<Box3> boxes;
};

PathsPastBone PathsOf(const ContactStep& step,
                      int muscle,
                      int bone,
                      double margin) {
  const Eigen::Matrix4d rest_from_before =
      RigidInverse(step.before.bones_from_rest[bone]);
  const Eigen::Matrix4d now_from_before =
      step.bones_from_rest[bone] * rest_from_before;
  const Points& before = step.before.points[muscle];
  const Triangles& triangles = step.scene.muscles[muscle].triangles;
  PathsPastBone paths;
  paths.at_rest = Transformed(before, rest_from_before);
  paths.moves = (Transformed(before, now_from_before) - step.carried[muscle])
                    .rowwise()
                    .norm();
  const Points carried = Transformed(step.carried[muscle],
                                     RigidInverse(step.bones_from_rest[bone]));
  paths.boxes.resize(triangles.rows());
#pragma omp parallel for schedule(static)
  for (Eigen::Index f = 0; f < triangles.rows(); ++f) {
    paths.boxes[f] =
        BoxOf(BoxOf(CornersOf(paths.at_rest, triangles.row(f)), margin),
              BoxOf(CornersOf(carried, triangles.row(f)), margin));
  }
  return paths;
}

void AddPlanesOfBone(const StepOptions& options,
                     const ContactStep& step,
                     int muscle,
                     int bone,
                     TriangleBvh* tree,
                     std::vector<SeparatingPlane>* planes) {
  const double margin =
      options.AimedGap() + options.planes.search_share * options.reach;
  const PathsPastBone paths = PathsOf(step, muscle, bone, margin);
  const MuscleSurface& surface = step.scene.muscles[muscle];
  const Triangles& triangles = surface.triangles;
  const TriangleBvh& obstacles = *step.scene.bones[bone];
  tree->RefitBoxes(paths.boxes);
  const Grouped met =
      ByFirst(tree->CollectOverlaps(
                  obstacles,
                  [&](int f, int /*g*/) { return !surface.IsExempt(bone, f); }),
              triangles.rows());
  std::vector<std::vector<SeparatingPlane>> found(triangles.rows());
#pragma omp parallel for schedule(dynamic, 64)
  for (Eigen::Index f = 0; f < triangles.rows(); ++f) {
    if (met.count(f) == 0) continue;
    const double move = std::max({paths.moves[triangles(f, 0)],
                                  paths.moves[triangles(f, 1)],
                                  paths.moves[triangles(f, 2)]});
    ObstacleOptions nearby;
    nearby.radius =
        margin + std::min(1.5 * move, 2 * options.relaxation.max_push);
    nearby.gap = options.AimedGap();
    nearby.overlooked_share = options.planes.overlooked_share;
    nearby.max_planes = options.planes.max_planes_per_triangle;
    for (const HalfSpace& space :
         SeparateFromObstacles(CornersOf(paths.at_rest, triangles.row(f)),
                               obstacles,
                               met.begin(f),
                               met.count(f),
                               nearby)) {
      found[f].push_back(
          PlaneOfBone(step, muscle, static_cast<int>(f), bone, space));
    }
  }
  Append(found, planes);
}

}  // namespace

SeparatingPlane PlaneBetween(const ContactStep& step,
                             int a,
                             int f,
                             int b,
                             int g,
                             const TriangleSeparation& before,
                             double half_gap) {
  SeparatingPlane plane;
  plane.muscle_above = a;
  plane.muscle_below = b;
  plane.above = step.scene.muscles[a].triangles.row(f);
  plane.below = step.scene.muscles[b].triangles.row(g);
  const RowVector3d turned =
      before.normal * (step.rotations[a][f] + step.rotations[b][g]);
  // Triangles without area have no rotation.
  plane.normal = turned.norm() > 0.5 ? turned.normalized() : before.normal;
  plane.half_gap = half_gap;
  plane.distance = before.distance;
  return plane;
}

SeparatingPlane PlaneOfBone(const ContactStep& step,
                            int muscle,
                            int f,
                            int bone,
                            const HalfSpace& at_rest) {
  const Eigen::Matrix4d& place = step.bones_from_rest[bone];
  SeparatingPlane plane;
  plane.muscle_above = muscle;
  plane.above = step.scene.muscles[muscle].triangles.row(f);
  plane.normal = at_rest.normal * place.topLeftCorner<3, 3>().transpose();
  plane.level = at_rest.level + plane.normal.dot(place.topRightCorner<3, 1>());
  return plane;
}

std::vector<SeparatingPlane> FindSeparatingPlanes(
    const StepOptions& options,
    const ContactStep& step,
    std::vector<TriangleBvh>* carried) {
  std::vector<SeparatingPlane> planes;
  for (int a = 0; a < step.num_muscles(); ++a) {
    for (int b = a + 1; b < step.num_muscles(); ++b) {
      AddPlanesBetweenMuscles(options, step, *carried, a, b, &planes);
    }
  }
  for (int bone = 0; bone < step.num_bones(); ++bone) {
    for (int i = 0; i < step.num_muscles(); ++i) {
      AddPlanesOfBone(options, step, i, bone, &(*carried)[i], &planes);
    }
  }
  return planes;
}

}  // namespace musclewarp
