// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/phantom/variation.h"

#include <glog/logging.h>

#include <Eigen/Core>
#include <cmath>

#include "musclewarp/cgal/even_remeshing.h"
#include "musclewarp/geometry/decimation.h"
#include "musclewarp/mesh/measures.h"
#include "musclewarp/phantom/phantom_scene.h"
#include "musclewarp/phantom/scene_parts.h"

namespace musclewarp {
namespace {

// Returns the surface with about as many vertices: not moved where there are to
// be fewer, which keeps a thin muscle from becoming thinner.
TriangleSoup WithVertices(const TriangleSoup& surface, int num_vertices) {
  if (num_vertices <= surface.points.rows()) {
    DecimationOptions options;
    options.max_triangles = 2 * num_vertices - 4;  // of a sphere
    return Decimated(surface, options).soup;
  }
  // 2 N equilateral triangles.
  const double area = SurfaceArea(surface.points, surface.triangles);
  return Remeshed(surface, std::sqrt(2 * area / (std::sqrt(3) * num_vertices)));
}

// x -> size * x + offset
Points Placed(const Points& points, double size, double offset) {
  return (size * points.array() + offset).matrix();
}

}  // namespace

void GiveVertices(int num_vertices, PhantomScene* scene) {
  for (size_t i = 0; i < scene->scene.muscles.size(); ++i) {
    PhantomMesh& mesh = scene->meshes[i];
    TriangleSoup other = WithVertices(mesh.surface, num_vertices);
    // A thin muscle needs more, or its sides cross.
    for (int more = 2 * num_vertices;
         more < mesh.surface.points.rows() && !phantom::IsSoundSurface(other);
         more *= 2) {
      other = WithVertices(mesh.surface, more);
    }
    if (!phantom::IsSoundSurface(other)) continue;
    mesh.surface = other;
    mesh.delivered = other;
    SceneMuscle& muscle = scene->scene.muscles[i];
    muscle.attachments = phantom::AttachmentsAtEnds(mesh, muscle.lines);
  }
}

void Place(double size, double offset, PhantomScene* scene) {
  if (size == 1 && offset == 0) return;
  CHECK(scene->model_text.empty());
  for (PhantomMesh& mesh : scene->meshes) {
    mesh.surface.points = Placed(mesh.surface.points, size, offset);
    mesh.delivered.points = Placed(mesh.delivered.points, size, offset);
  }
  for (SceneMuscle& muscle : scene->scene.muscles) {
    for (ActionLine& line : muscle.lines) {
      line.rest = Placed(line.rest, size, offset);
    }
    for (Attachment& attachment : muscle.attachments) {
      attachment.points = Placed(attachment.points, size, offset);
      attachment.radius *= size;
    }
  }
  const Eigen::Vector3d moved = Eigen::Vector3d::Constant(offset);
  for (ScenePose& pose : scene->scene.poses) {
    for (auto& [body, matrix] : pose.bodies) {
      matrix.topRightCorner<3, 1>() = size * matrix.topRightCorner<3, 1>() +
                                      moved -
                                      matrix.topLeftCorner<3, 3>() * moved;
    }
    for (auto& [line, points] : pose.lines) {
      points = Placed(points, size, offset);
    }
  }
}

}  // namespace musclewarp
