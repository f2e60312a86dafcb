// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/frame_solvers/reconstruction_loss.h"

#include <Eigen/Dense>
#include <algorithm>
#include <iterator>
#include <vector>

#include "musclewarp/base/infinity.h"
#include "musclewarp/mesh/measures.h"
#include "musclewarp/mesh/triangle.h"
#include "musclewarp/proximity/mesh_intersection.h"
#include "musclewarp/proximity/triangle_bvh.h"

namespace musclewarp {
namespace {

using Eigen::RowVector3d;

// Returns the carriers to which vertices of a muscle are attached.
std::set<std::string> CarriersOf(const PreparedMuscle& muscle) {
  std::set<std::string> carriers;
  for (const int a : muscle.attached.attachment) {
    carriers.insert(NameOfCarrier(muscle.model.attachments[a]));
  }
  return carriers;
}

RowVector3d CentreOf(const TriangleSoup& soup, Eigen::Index f) {
  return CornersOf(soup.points, soup.triangles.row(f)).colwise().mean();
}

// Returns how deep a point is in a closed mesh, mm; 0 outside.
double DepthIn(const SearchableMesh& mesh, const RowVector3d& p) {
  if (!mesh.bvh().box().Contains(p) || !mesh.winding().IsInside(p)) return 0;
  return mesh.bvh().ClosestPoint(p, kInfinity).distance;
}

// Returns the longest action line, or none.
Points LongestLine(const MuscleModel& model) {
  Points longest;
  double most = 0;
  for (const ActionLine& line : model.lines) {
    double length = 0;
    for (Eigen::Index i = 1; i < line.rest.rows(); ++i) {
      length += (line.rest.row(i) - line.rest.row(i - 1)).norm();
    }
    if (length <= most) continue;
    most = length;
    longest = line.rest;
  }
  return longest;
}

// Returns a segment along the axis on which points spread most.
Points LongestAxis(const Points& points) {
  const RowVector3d mean = points.colwise().mean();
  const Points centred = points.rowwise() - mean;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(
      Eigen::Matrix3d(centred.transpose() * centred));
  const RowVector3d axis = solver.eigenvectors().col(2).transpose();
  const Eigen::VectorXd along = centred * axis.transpose();
  Points segment(2, 3);
  segment << mean + along.minCoeff() * axis, mean + along.maxCoeff() * axis;
  return segment;
}

// The first and last place of points along a line, mm.
struct Range {
  double first = kInfinity, last = -kInfinity;
};

Range RangeAlong(const Points& line, const Points& points) {
  Range range;
  const Eigen::Index last = line.rows() - 2;
  for (const auto& p : points.rowwise()) {
    double nearest = kInfinity, place = 0, passed = 0;
    for (Eigen::Index i = 0; i <= last; ++i) {
      const RowVector3d way = line.row(i + 1) - line.row(i);
      const double length = way.norm();
      if (length == 0) continue;
      double at = (p - line.row(i)).dot(way) / length;
      if (i > 0) at = std::max(at, 0.0);
      if (i < last) at = std::min(at, length);
      const double distance =
          (p - line.row(i) - at / length * way).squaredNorm();
      if (distance < nearest) {
        nearest = distance;
        place = passed + at;
      }
      passed += length;
    }
    range.first = std::min(range.first, place);
    range.last = std::max(range.last, place);
  }
  return range;
}

}  // namespace

DeliveredMuscle DeliveredMuscleOf(const PreparedScene& scene,
                                  const SceneMeshes& meshes,
                                  size_t muscle) {
  const PreparedMuscle& prepared = scene.muscles[muscle];
  DeliveredMuscle delivered = {
      {prepared.model.fine_rest, prepared.model.fine_triangles},
      CarriersOf(prepared)};
  std::vector<const SearchableMesh*> others;
  for (size_t i = 0; i < meshes.muscles().size(); ++i) {
    if (i != muscle) others.push_back(meshes.muscles()[i].mesh);
  }
  for (const NamedMesh& bone : meshes.bones()) others.push_back(bone.mesh);
  double depth = 0;
#pragma omp parallel for schedule(dynamic, 64) reduction(max : depth)
  for (Eigen::Index f = 0; f < delivered.mesh.triangles.rows(); ++f) {
    const RowVector3d centre = CentreOf(delivered.mesh, f);
    for (const SearchableMesh* other : others) {
      depth = std::max(depth, DepthIn(*other, centre));
    }
  }
  delivered.depth = depth;
  return delivered;
}

double LostExtent(const Points& before, const Points& after, Points line) {
  if (line.rows() < 2) line = LongestAxis(before);
  const Range was = RangeAlong(line, before), is = RangeAlong(line, after);
  return std::max({0.0, is.first - was.first, was.last - is.last});
}

SurfaceReconstruction LossOf(const DeliveredMuscle& delivered,
                             const PreparedMuscle& reconstructed) {
  const TriangleSoup& before = delivered.mesh;
  const MuscleModel& model = reconstructed.model;
  SurfaceReconstruction loss;
  loss.is_done = true;
  loss.volume_before = SignedVolume(before.points, before.triangles);
  loss.volume_after = model.rest_volume;
  const TriangleBvh tree(model.fine_rest, model.fine_triangles);
  for (Eigen::Index f = 0; f < before.triangles.rows(); ++f) {
    const Corners t = CornersOf(before.points, before.triangles.row(f));
    const RowVector3d middle = CentreOf(before, f);
    const double edge = (t.row(1) - t.row(0)).norm();
    const double area = AreaVector(t).norm() / 2;
    const double distance = tree.ClosestPoint(middle, kInfinity).distance;
    loss.farthest = std::max(loss.farthest, distance);
    if (distance > kGoneBeyond + 2 * delivered.depth) loss.gone_area += area;
    if (distance <= edge) continue;
    loss.lost_area += area;
    loss.place += area * middle;
  }
  if (loss.lost_area > 0) loss.place /= loss.lost_area;
  loss.lost_extent =
      std::max(0.0,
               LostExtent(before.points, model.fine_rest, LongestLine(model)) -
                   2 * delivered.depth);
  const std::set<std::string> carriers = CarriersOf(reconstructed);
  std::set_difference(delivered.carriers.begin(),
                      delivered.carriers.end(),
                      carriers.begin(),
                      carriers.end(),
                      std::back_inserter(loss.lost_attachments));
  return loss;
}

}  // namespace musclewarp
