// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/phantom/scene_parts.h"

#include <glog/logging.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <vector>

#include "musclewarp/base/angles.h"
#include "musclewarp/geometry/spread_points.h"
#include "musclewarp/mesh/defects.h"
#include "musclewarp/phantom/polygonize.h"
#include "musclewarp/proximity/mesh_intersection.h"

namespace musclewarp::phantom {

PhantomMesh MeshOf(const Solid& solid, uint32_t seed) {
  constexpr double kRoughnessLength = 14;  // mm
  PolygonizeOptions options;
  options.cell = solid.cell;
  PhantomMesh mesh;
  mesh.name = solid.name;
  mesh.surface = PolygonizeField(
      Rough(solid.field, solid.roughness, kRoughnessLength, seed),
      solid.box,
      options);
  mesh.defects = solid.defects;
  mesh.delivered = PlantDefects(mesh.surface, mesh.defects, seed);
  return mesh;
}

SceneMuscle MuscleOf(const PhantomMesh& mesh, std::vector<ActionLine> lines) {
  SceneMuscle muscle;
  muscle.name = mesh.name;
  muscle.mesh_path = mesh.name + ".ply";
  muscle.lines = std::move(lines);
  return muscle;
}

Attachment AttachmentTo(
    const std::string& body,
    const PhantomMesh& mesh,
    const std::function<bool(const Eigen::Vector3d&)>& is_in,
    int count) {
  Attachment attachment;
  attachment.body = body;
  std::vector<int> accepted;
  for (Eigen::Index i = 0; i < mesh.surface.points.rows(); ++i) {
    if (is_in(mesh.surface.points.row(i).transpose())) {
      accepted.push_back(static_cast<int>(i));
    }
  }
  const Points points = mesh.surface.points(accepted, Eigen::all);
  const std::vector<int> spread = SpreadPoints(points, count);
  CHECK_EQ(static_cast<int>(spread.size()), count);
  attachment.points = points(spread, Eigen::all);
  attachment.radius = 8;
  return attachment;
}

std::vector<Attachment> AttachmentsAtEnds(
    const PhantomMesh& mesh, const std::vector<ActionLine>& lines) {
  constexpr double kAttached = 12;  // mm around an end
  constexpr int kPoints = 5;
  std::vector<Attachment> attachments;
  for (const ActionLine& line : lines) {
    for (const Eigen::Index end : {Eigen::Index{0}, line.rest.rows() - 1}) {
      const Eigen::Vector3d centre = line.rest.row(end).transpose();
      std::vector<double> distances;
      for (Eigen::Index i = 0; i < mesh.surface.points.rows(); ++i) {
        distances.push_back(
            (mesh.surface.points.row(i).transpose() - centre).norm());
      }
      std::nth_element(
          distances.begin(), distances.begin() + kPoints, distances.end());
      const double radius = std::max(kAttached, distances[kPoints]);
      const auto is_near = [&](const Eigen::Vector3d& p) {
        return (p - centre).norm() < radius;
      };
      attachments.push_back(
          AttachmentTo(line.bodies[end], mesh, is_near, kPoints));
    }
  }
  return attachments;
}

bool IsSoundSurface(const TriangleSoup& mesh) {
  // Euler's formula for a sphere of triangles, V - E + F = 2, where E = 3/2 F.
  return CountDefects(mesh).IsClean() &&
         2 * mesh.points.rows() - mesh.triangles.rows() == 4 &&
         SelfIntersections(mesh).empty();
}

double MiddleAlongX(const Field& field, double y, double z) {
  constexpr double kReach = 200;  // mm
  constexpr double kStep = 0.5;   // mm
  double best_length = 0;
  double best_middle = 0;
  double length = 0;
  for (double x = -kReach; x <= kReach; x += kStep) {
    length = field({x, y, z}) < 0 ? length + kStep : 0;
    if (length > best_length) {
      best_length = length;
      best_middle = x - length / 2 + kStep / 2;
    }
  }
  CHECK_GT(best_length, 0) << "nothing at y = " << y << ", z = " << z;
  return best_middle;
}

Eigen::Matrix4d RotationAbout(const Eigen::Vector3d& centre,
                              const Eigen::Vector3d& axis,
                              double degrees) {
  Eigen::Affine3d turn = Eigen::Affine3d::Identity();
  turn.translate(centre);
  turn.rotate(Eigen::AngleAxisd(RadiansOf(degrees), axis));
  turn.translate(-centre);
  // Twelve decimals: sines differ in the last bits from library to library.
  // Adding zero makes -0 a plain 0.
  return (turn.matrix().array() * 1e12).round() / 1e12 + 0.0;
}

Points MovedLine(const ActionLine& line,
                 const std::map<std::string, Eigen::Matrix4d>& bodies) {
  CHECK_EQ(static_cast<Eigen::Index>(line.bodies.size()), line.rest.rows());
  Points moved = line.rest;
  for (Eigen::Index i = 0; i < moved.rows(); ++i) {
    const auto body = bodies.find(line.bodies[i]);
    if (body == bodies.end()) continue;
    const Eigen::Vector3d p = moved.row(i).transpose();
    moved.row(i) =
        RoundedPoint((body->second * p.homogeneous()).head<3>()).transpose();
  }
  return moved;
}

}  // namespace musclewarp::phantom
