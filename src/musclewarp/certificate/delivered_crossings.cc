// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/certificate/delivered_crossings.h"

#include <set>

#include "musclewarp/certificate/containment.h"
#include "musclewarp/mesh/connectivity.h"
#include "musclewarp/proximity/mesh_intersection.h"

namespace musclewarp {
namespace {

// Returns a point of each piece of a soup that has none of `crossing`, its
// triangles.
std::vector<Eigen::RowVector3d> PointsOfPieces(const TriangleSoup& soup,
                                               const std::set<int>& crossing) {
  const Components components = ConnectedComponents(
      soup.triangles, EdgeUses(soup.triangles), soup.triangles.rows());
  std::vector<bool> is_done(components.count, false);
  for (const int f : crossing) is_done[components.label[f]] = true;
  std::vector<Eigen::RowVector3d> points;
  for (Eigen::Index f = 0; f < soup.triangles.rows(); ++f) {
    const int label = components.label[f];
    if (is_done[label]) continue;
    is_done[label] = true;
    points.push_back(soup.points.row(soup.triangles(f, 0)));
  }
  return points;
}

// Collects the crossings of one muscle and one bone.
class PairCount {
 public:
  void Add(int f, const Corners& triangle, int g) {
    ++crossing_.triangle_pairs;
    of_bone_.insert(g);
    if (of_muscle_.insert(f).second) sum_ += triangle.colwise().mean();
  }

  void AddPiecesInside(const BoxedMesh& muscle, const TriangleSoup& bone) {
    for (const auto& point : PointsOfPieces(bone, of_bone_)) {
      if (!IsInsideClosed(point, muscle)) continue;
      if (++crossing_.pieces_inside == 1) crossing_.place = point;
    }
  }

  bool IsEmpty() const {
    return crossing_.triangle_pairs + crossing_.pieces_inside == 0;
  }

  DeliveredCrossing Result(const std::string& muscle,
                           const std::string& bone) const {
    DeliveredCrossing result = crossing_;
    result.muscle = muscle;
    result.bone = bone;
    if (!of_muscle_.empty()) {
      result.place = sum_ / static_cast<double>(of_muscle_.size());
    }
    return result;
  }

 private:
  DeliveredCrossing crossing_;
  std::set<int> of_muscle_, of_bone_;
  Eigen::RowVector3d sum_ = Eigen::RowVector3d::Zero();
};

}  // namespace

std::vector<DeliveredCrossing> CrossingsWithDelivered(
    const std::vector<NamedMesh>& muscles,
    const std::vector<DeliveredOnly>& delivered,
    const std::vector<ExemptArea>& exempt) {
  std::vector<DeliveredCrossing> crossings;
  for (size_t b = 0; b < delivered.size(); ++b) {
    const TriangleSoup& soup = delivered[b].soup;
    if (soup.triangles.rows() == 0) continue;
    const TriangleBvh bone(soup.points, soup.triangles);
    for (size_t a = 0; a < muscles.size(); ++a) {
      const NamedMesh& muscle = muscles[a];
      const TriangleBvh& tree = muscle.mesh->bvh();
      const ExemptArea* area =
          FindExempt(exempt, static_cast<int>(a), static_cast<int>(b));
      PairCount count;
      for (const auto& [f, g] : IntersectingTriangles(tree, bone)) {
        if (!area || !area->triangles[f]) count.Add(f, tree.corners(f), g);
      }
      if (!area && tree.box().Overlaps(bone.box())) {
        count.AddPiecesInside(BoxedMesh(muscle.view()), soup);
      }
      if (count.IsEmpty()) continue;
      crossings.push_back(count.Result(muscle.name, delivered[b].bone));
    }
  }
  return crossings;
}

}  // namespace musclewarp
