// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/certified_contact/defects.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <optional>
#include <utility>

#include "musclewarp/base/stage_times.h"
#include "musclewarp/certified_contact/bone_planes.h"
#include "musclewarp/certified_contact/sheet_planes.h"
#include "musclewarp/mesh/transformed.h"
#include "musclewarp/proximity/mesh_intersection.h"

namespace musclewarp {
namespace {

using Eigen::RowVector3d;
using Eigen::RowVector3i;

// Returns the folded triangles, or none if their number is admissible.
std::vector<FoldedTriangle> TooManyFolded(const DefectOptions& options,
                                          const MuscleSurface& muscle,
                                          const Points& points) {
  std::vector<FoldedTriangle> folded =
      FoldedTriangles(muscle.rest, points, muscle.triangles);
  const auto count = static_cast<double>(muscle.triangles.rows());
  if (static_cast<double>(folded.size()) <=
      options.max_folded_fraction * count) {
    folded.clear();
  }
  return folded;
}

// Returns the plane that keeps the corner opposite to the longest edge of a
// triangle above that edge. The height over the longest edge is the smallest,
// so triangles fold there.
std::optional<SeparatingPlane> PlaneAgainstFold(const DefectOptions& options,
                                                const ContactScene& scene,
                                                int muscle,
                                                const FoldedTriangle& folded) {
  const MuscleSurface& surface = scene.muscles[muscle];
  const RowVector3i corners = surface.triangles.row(folded.triangle);
  const Corners unfolded =
      CornersOf(surface.rest, corners) * folded.rotation.transpose();
  int top = 0;
  double longest = 0;
  for (int k = 0; k < 3; ++k) {
    const double length =
        (unfolded.row((k + 1) % 3) - unfolded.row((k + 2) % 3)).norm();
    if (length > longest) {
      longest = length;
      top = k;
    }
  }
  const RowVector3d area = AreaVector(unfolded);
  const int u = (top + 1) % 3, v = (top + 2) % 3;
  const RowVector3d inward =
      area.cross(RowVector3d(unfolded.row(v) - unfolded.row(u)));
  if (!(inward.norm() > 0)) return std::nullopt;
  const double height = area.norm() / longest;
  SeparatingPlane plane;
  plane.muscle_above = plane.muscle_below = muscle;
  plane.above = RowVector3i::Constant(corners[top]);
  plane.below = RowVector3i(corners[u], corners[v], corners[v]);
  plane.normal = inward.normalized();
  plane.half_gap = options.unfolded_height * height / 2;
  plane.distance = height;
  return plane;
}

std::optional<SeparatingPlane> PlaneAgainstBone(const StepOptions& options,
                                                const ContactStep& step,
                                                const CrossingTriangle& pair) {
  const Corners at_rest =
      Transformed(CornersOf(step.before.points[pair.a],
                            step.scene.muscles[pair.a].triangles.row(pair.f)),
                  RigidInverse(step.before.bones_from_rest[pair.b]));
  const Corners& obstacle = step.scene.bones[pair.b]->corners(pair.g);
  const auto separation = SeparateTriangles(at_rest, obstacle);
  if (!separation) return std::nullopt;
  const double level = (obstacle * separation->normal.transpose()).maxCoeff();
  return PlaneOfBone(step,
                     pair.a,
                     pair.f,
                     pair.b,
                     {separation->normal, level + options.AimedGap()});
}

void AddSelfCrossings(const StepOptions& options,
                      const ContactStep& step,
                      const Points& targets,
                      const Points& points,
                      int muscle,
                      Defects* defects) {
  const MuscleSurface& surface = step.scene.muscles[muscle];
  for (const auto& [f, g] : surface.self_crossings->Find(points)) {
    if (PlaneBetweenSheets(options, step, targets, muscle, f, g)) {
      defects->self_crossings.push_back({muscle, f, muscle, g});
    }
  }
}

// Refits the trees to the muscles in the frame of a body.
void FitTo(const std::vector<Points>& points,
           const Eigen::Matrix4d& from_body,
           std::vector<TriangleBvh>* trees) {
#pragma omp parallel for schedule(dynamic, 1)
  for (size_t i = 0; i < points.size(); ++i) {
    (*trees)[i].Refit(Transformed(points[i], from_body));
  }
}

void AddBoneCrossings(const ContactStep& step,
                      const std::vector<Points>& points,
                      std::vector<TriangleBvh>* trees,
                      Defects* defects) {
  for (int bone = 0; bone < step.num_bones(); ++bone) {
    const Eigen::Matrix4d& place = step.bones_from_rest[bone];
    // Bones of one body are usually consecutive.
    if (bone == 0 || place != step.bones_from_rest[bone - 1]) {
      FitTo(points, RigidInverse(place), trees);
    }
    for (int i = 0; i < step.num_muscles(); ++i) {
      if (step.is_still[i]) continue;
      for (const auto& [f, g] :
           IntersectingTriangles((*trees)[i], *step.scene.bones[bone])) {
        if (step.scene.muscles[i].IsExempt(bone, f)) continue;
        defects->bone_crossings.push_back({i, f, bone, g});
      }
    }
  }
}

void Stiffen(const DefectOptions& options,
             const Triangles& triangles,
             const std::vector<int>& stiffer_triangles,
             Eigen::VectorXd* stiffness) {
  std::vector<bool> is_stiffer(stiffness->size(), false);
  for (const int f : stiffer_triangles) {
    for (const int v : triangles.row(f)) is_stiffer[v] = true;
  }
  for (Eigen::Index v = 0; v < stiffness->size(); ++v) {
    if (!is_stiffer[v]) continue;
    (*stiffness)[v] =
        std::min(options.stiffening * (*stiffness)[v], options.max_stiffness);
  }
}

}  // namespace

int Defects::num_crossings() const {
  return static_cast<int>(muscle_crossings.size() + bone_crossings.size());
}

int Defects::num_folded() const {
  size_t count = 0;
  for (const auto& of_muscle : folded) count += of_muscle.size();
  return static_cast<int>(count);
}

Defects FindDefects(const StepOptions& options,
                    const ContactStep& step,
                    const std::vector<Points>& targets,
                    const std::vector<Points>& points,
                    std::vector<TriangleBvh>* trees) {
  const ScopedStage stage("defects");
  Defects defects;
  defects.folded.resize(step.num_muscles());
#pragma omp parallel for schedule(dynamic, 1) if (step.num_muscles() > 1)
  for (int i = 0; i < step.num_muscles(); ++i) {
    (*trees)[i].Refit(points[i]);
    if (step.is_still[i]) continue;
    defects.folded[i] =
        TooManyFolded(options.defects, step.scene.muscles[i], points[i]);
  }
  for (int a = 0; a < step.num_muscles(); ++a) {
    if (!step.is_still[a]) {
      AddSelfCrossings(options, step, targets[a], points[a], a, &defects);
    }
    for (int b = a + 1; b < step.num_muscles(); ++b) {
      if (step.is_still[a] && step.is_still[b]) continue;
      for (const auto& [f, g] :
           IntersectingTriangles((*trees)[a], (*trees)[b])) {
        defects.muscle_crossings.push_back({a, f, b, g});
      }
    }
  }
  AddBoneCrossings(step, points, trees, &defects);
  return defects;
}

std::vector<SeparatingPlane> PlanesAgainst(const Defects& defects,
                                           const StepOptions& options,
                                           const ContactStep& step,
                                           const std::vector<Points>& targets) {
  std::vector<SeparatingPlane> planes;
  const auto add = [&](const std::optional<SeparatingPlane>& plane) {
    if (plane) planes.push_back(*plane);
  };
  for (int i = 0; i < static_cast<int>(defects.folded.size()); ++i) {
    for (const FoldedTriangle& folded : defects.folded[i]) {
      add(PlaneAgainstFold(options.defects, step.scene, i, folded));
    }
  }
  for (const CrossingTriangle& pair : defects.self_crossings) {
    add(PlaneBetweenSheets(
        options, step, targets[pair.a], pair.a, pair.f, pair.g));
  }
  for (const CrossingTriangle& pair : defects.muscle_crossings) {
    const auto separation =
        SeparateTriangles(step.trees_before[pair.a].corners(pair.f),
                          step.trees_before[pair.b].corners(pair.g));
    if (!separation) continue;
    planes.push_back(PlaneBetween(step,
                                  pair.a,
                                  pair.f,
                                  pair.b,
                                  pair.g,
                                  *separation,
                                  options.AimedGap() / 2));
  }
  for (const CrossingTriangle& pair : defects.bone_crossings) {
    add(PlaneAgainstBone(options, step, pair));
  }
  return planes;
}

Stiffness Stiffened(const Defects& defects,
                    const DefectOptions& options,
                    const ContactScene& scene,
                    Stiffness stiffness) {
  for (size_t i = 0; i < scene.muscles.size(); ++i) {
    std::vector<int> folded, crossing;
    for (const FoldedTriangle& triangle : defects.folded[i]) {
      folded.push_back(triangle.triangle);
    }
    for (const CrossingTriangle& pair : defects.self_crossings) {
      if (pair.a != static_cast<int>(i)) continue;
      crossing.push_back(pair.f);
      crossing.push_back(pair.g);
    }
    const Triangles& triangles = scene.muscles[i].triangles;
    Stiffen(options, triangles, folded, &stiffness[i]);
    Stiffen(options, triangles, crossing, &stiffness[i]);
  }
  return stiffness;
}

}  // namespace musclewarp
