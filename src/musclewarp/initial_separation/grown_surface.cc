// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/initial_separation/grown_surface.h"

#include <glog/logging.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <mutex>
#include <string>

#include "musclewarp/base/infinity.h"
#include "musclewarp/initial_separation/marching_tetrahedra.h"
#include "musclewarp/mesh/measures.h"

namespace musclewarp {
namespace {

using Eigen::RowVector3d;

// How much less a body grows by the distance to where it was cut.
constexpr double kDecline = 1.0 / 3;

// A body grows by no more than this, mm, and by no more than so many times the
// thickness of what was cut off, on the mean.
constexpr double kLongestReach = 30;
constexpr double kReachPerThickness = 6;

// With the decline above, keeps the function of a grown body from changing by
// more than the way between two places.
constexpr double kSlope = 1 / (1 + kDecline);

// The growth is looked for with samples at this many spacings, and the volume
// found to this share of it, in at most so many steps.
constexpr double kCoarser = 2;
constexpr double kAccuracy = 2e-3;
constexpr int kMostSteps = 14;

// Returns the triangles of a body that lie deeper in the muscle than `depth`,
// mm: where it was cut.
Triangles CutTriangles(const TriangleSoup& body,
                       const SolidDistance& muscle,
                       double depth) {
  std::vector<int> cut;
  for (int f = 0; f < body.triangles.rows(); ++f) {
    const RowVector3d middle =
        CornersOf(body.points, body.triangles.row(f)).colwise().mean();
    if (muscle.At(middle, 0) < -depth) cut.push_back(f);
  }
  return body.triangles(cut, Eigen::all);
}

// Returns true if the straight way from `a` to `b` meets a triangle.
bool SegmentMeets(const RowVector3d& a,
                  const RowVector3d& b,
                  const TriangleBvh& tree) {
  Box3 box;
  for (int k = 0; k < 3; ++k) {
    box.lower[k] = std::min(a[k], b[k]);
    box.upper[k] = std::max(a[k], b[k]);
  }
  const RowVector3d way = b - a;
  bool meets = false;
  tree.Traverse(
      [&](const Box3& other) { return !meets && box.Overlaps(other); },
      [&](int f) {
        const Corners& t = tree.corners(f);
        const RowVector3d u = t.row(1) - t.row(0), v = t.row(2) - t.row(0);
        const RowVector3d normal = u.cross(v), from = a - t.row(0);
        const double along = -way.dot(normal);
        if (along == 0) return;
        const double part = from.dot(normal) / along;
        const RowVector3d aside = from.cross(way) / along;
        const double x = v.dot(aside), y = -u.dot(aside);
        meets |= part >= 0 && part <= 1 && x >= 0 && y >= 0 && x + y <= 1;
      });
  return meets;
}

// A body that grows in its medial cell.
class GrowingBody {
 public:
  GrowingBody(const CellSurfaceOptions& options,
              const TriangleSoup& body,
              const SolidDistance& muscle,
              const std::vector<const SolidDistance*>& others,
              const std::vector<const SolidDistance*>& bones,
              const Triangles& cut,
              double reach)
      : mesh_(body),
        distance_(mesh_),
        cut_(body.points, cut),
        cell_(CellWithin(options.cell, reach), muscle, others, bones),
        around_(bones),
        reach_(reach),
        border_(2 * kCoarser * options.spacing),
        limit_(reach + border_ / kSlope),
        blocked_(options.spacing / 4) {
    around_.insert(around_.end(), others.begin(), others.end());
  }

  // Returns the body after it has grown by `t`, mm, as its largest part.
  TriangleSoup GrownBy(double t, double spacing) const {
    // One box for every growth, so that the same places are sampled.
    Box3 box = mesh_.bvh().box();
    for (int k = 0; k < 3; ++k) {
      box.lower[k] -= reach_ + spacing;
      box.upper[k] += reach_ + spacing;
    }
    TriangleSoup grown = MarchingTetrahedra(
        [&](const RowVector3d& p) { return Region(p, t); }, box, spacing);
    if (grown.triangles.rows() > 0) KeepLargestBody(&grown);
    return grown;
  }

 private:
  // A cell that knows of all that can be reached.
  static MedialCellOptions CellWithin(MedialCellOptions cell, double reach) {
    cell.range = std::max(cell.range, reach + 2 * cell.margin);
    return cell;
  }

  // What the growth at a place depends on.
  struct Measures {
    double own = 0;     // the signed distance to the body, at most `limit_`
    double to_cut = 0;  // the distance to where it was cut
    double cell = 0;    // the signed distance to the cell
    bool is_blocked = false;
  };

  // Negative in the grown body. Near its border it is nowhere below the signed
  // distance to the cell, so that bodies which grow beside each other do not
  // cross.
  double Region(const RowVector3d& p, double t) const {
    const Measures& at = MeasuresAt(p);
    const double growth = std::max(0.0, t - kDecline * at.to_cut);
    const double grown = kSlope * (at.own - growth);
    // The body itself lies in its cell.
    if (grown >= border_ || at.own <= -border_) return grown;
    const double region = std::max(grown, at.cell);
    return region < 0 && at.is_blocked ? blocked_ : region;
  }

  // The same places are asked for again with every growth that is tried.
  const Measures& MeasuresAt(const RowVector3d& p) const {
    const std::array<double, 3> key = {p[0], p[1], p[2]};
    Shard& shard = shards_[std::hash<double>()(p[0] + 3 * p[1] + 7 * p[2]) %
                           shards_.size()];
    {
      const std::lock_guard<std::mutex> lock(shard.mutex);
      const auto known = shard.measures.find(key);
      if (known != shard.measures.end()) return known->second;
    }
    const Measures measures = Measure(p);
    const std::lock_guard<std::mutex> lock(shard.mutex);
    return shard.measures.emplace(key, measures).first->second;
  }

  Measures Measure(const RowVector3d& p) const {
    Measures at;
    at.own = distance_.At(p, limit_);
    at.to_cut = kInfinity;
    if (at.own <= -border_ || at.own >= limit_) return at;
    if (cut_.num_triangles() == 0) {
      at.to_cut = 0;
    } else {
      const auto cut = cut_.ClosestPoint(p, reach_ / kDecline);
      if (cut.triangle >= 0) at.to_cut = cut.distance;
    }
    at.cell = cell_.SignedDistance(p);
    at.is_blocked = at.cell < 0 && at.own > 0 && IsBlocked(p);
    return at;
  }

  // True if a bone or another muscle lies between a place and the body: there
  // the body would grow through it, or round it.
  bool IsBlocked(const RowVector3d& p) const {
    const RowVector3d on_body = mesh_.bvh().ClosestPoint(p, kInfinity).point;
    return std::any_of(
        around_.begin(), around_.end(), [&](const SolidDistance* other) {
          return SegmentMeets(p, on_body, other->mesh().bvh());
        });
  }

  SearchableMesh mesh_;
  SolidDistance distance_;
  TriangleBvh cut_;
  MedialCell cell_;
  std::vector<const SolidDistance*> around_;  // bones and other muscles
  double reach_;                              // the largest growth, mm
  double border_;  // farther from the border nothing depends on the values, mm
  double limit_;   // of distances to the body, mm
  double blocked_;

  // Ordered by coordinates; several, so that threads do not wait for each
  // other.
  struct Shard {
    std::mutex mutex;
    std::map<std::array<double, 3>, Measures> measures;
  };
  mutable std::array<Shard, 64> shards_;
};

// A growth, mm, and the body after it.
struct Growth {
  double t = 0;
  TriangleSoup body;
};

// Returns the growth that gives a body a volume, or the reach if that is too
// little: by false position between a growth that is too small and one that is
// too large, beginning with `t`. `left` is the volume without growth.
Growth GrowthFor(const GrowingBody& body,
                 double left,
                 double volume,
                 double spacing,
                 double reach,
                 double t) {
  double low = 0, high = reach;
  double low_volume = left, high_volume = kInfinity;
  Growth growth;
  for (int step = 0; step < kMostSteps; ++step) {
    growth = {t, body.GrownBy(t, spacing)};
    const double now = SignedVolume(growth.body.points, growth.body.triangles);
    VLOG(1) << "a body grown by " << t << " mm has " << now << " of " << volume
            << " mm3";
    if (std::abs(now - volume) < kAccuracy * volume) break;
    if (now < volume) {
      if (t == reach) break;
      low = t;
      low_volume = now;
    } else {
      high = t;
      high_volume = now;
    }
    if (high_volume == kInfinity) {
      t = std::min(1.5 * t, reach);
      continue;
    }
    const double part = (volume - low_volume) / (high_volume - low_volume);
    t = low + std::clamp(part, 0.1, 0.9) * (high - low);
  }
  return growth;
}

}  // namespace

TriangleSoup GrownSurface(const CellSurfaceOptions& options,
                          const TriangleSoup& body,
                          const SolidDistance& muscle,
                          const std::vector<const SolidDistance*>& others,
                          const std::vector<const SolidDistance*>& bones,
                          double volume) {
  std::string error;
  CHECK(options.IsValid(&error)) << error;
  CHECK_GT(body.triangles.rows(), 0);
  const double left = SignedVolume(body.points, body.triangles);
  const Triangles cut = CutTriangles(body, muscle, options.spacing / 2);
  if (left >= volume) return body;
  const double area =
      SurfaceArea(body.points, cut.rows() > 0 ? cut : body.triangles);
  const double reach = std::clamp(kReachPerThickness * (volume - left) / area,
                                  options.spacing,
                                  kLongestReach);
  const GrowingBody growing(options, body, muscle, others, bones, cut, reach);
  // Coarser samples cut corners: they tell where to begin.
  const double coarse = kCoarser * options.spacing;
  const double begin =
      GrowthFor(growing, left, volume, coarse, reach, options.spacing).t;
  TriangleSoup grown =
      GrowthFor(growing, left, volume, options.spacing, reach, begin).body;
  return SignedVolume(grown.points, grown.triangles) > left ? grown : body;
}

}  // namespace musclewarp
