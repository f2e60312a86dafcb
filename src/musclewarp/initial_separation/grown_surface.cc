// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/initial_separation/grown_surface.h"

#include <glog/logging.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <mutex>
#include <string>
#include <unordered_map>

#include "musclewarp/base/infinity.h"
#include "musclewarp/initial_separation/growth_search.h"
#include "musclewarp/initial_separation/marching_tetrahedra.h"
#include "musclewarp/mesh/measures.h"

namespace musclewarp {
namespace {

using Eigen::RowVector3d;

// The decrease of the growth per distance from the cut.
constexpr double kDecline = 1.0 / 3;

// The largest growth, mm, and the largest ratio of growth to the mean thickness
// of the part that was cut off.
constexpr double kLongestReach = 30;
constexpr double kReachPerThickness = 6;

// Scales the function of a grown body so that its Lipschitz constant is at most
// 1, in spite of kDecline.
constexpr double kSlope = 1 / (1 + kDecline);

// How much deeper than it has to be the distance to the cell is measured, mm.
constexpr double kSlack = 0.2;

// The spacing, in multiples, with which the search for the growth begins.
constexpr double kCoarser = 2;

// Returns the triangles of a body that lie more than `depth` (mm) inside the
// muscle: its cuts.
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

// Returns true if the segment from `a` to `b` meets a triangle.
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

}  // namespace

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
      : body_(body),
        mesh_(body),
        distance_(mesh_),
        cut_(body.points, cut),
        cell_(CellWithin(options.cell, reach), muscle, others, bones),
        around_(bones),
        limit_(reach + 2 * kCoarser * options.spacing / kSlope),
        blocked_(options.spacing / 4) {
    around_.insert(around_.end(), others.begin(), others.end());
  }

  const TriangleSoup& body() const { return body_; }

  // Returns the largest part of the body after it has grown by `t`, mm.
  TriangleSoup GrownBy(double t, double spacing) const {
    Box3 box = mesh_.bvh().box();
    for (int k = 0; k < 3; ++k) {
      box.lower[k] -= t + spacing;
      box.upper[k] += t + spacing;
    }
    TriangleSoup grown = MarchingTetrahedra(
        [&](const RowVector3d& p) {
          // Values more than two samples from the boundary do not matter.
          return Region(p, t, /*border=*/2 * spacing);
        },
        box,
        spacing);
    if (grown.triangles.rows() > 0) KeepLargestBody(&grown);
    return grown;
  }

 private:
  // Extends the range of the cell, so that it includes all bones and muscles
  // that the growth can reach.
  static MedialCellOptions CellWithin(MedialCellOptions cell, double reach) {
    cell.range = std::max(cell.range, reach + 2 * cell.margin);
    return cell;
  }

  // The quantities that determine the growth at a position, mm. They are
  // measured as far as a growth needs them.
  struct Measures {
    double own = 0;             // the signed distance to the body
    double to_cut = kInfinity;  // the distance to the cuts, if it is below ...
    double cut_limit = 0;       // ... this limit
    double cell = 0;            // the signed distance to the cell, if above ...
    double cell_depth = -kInfinity;  // ... minus this depth, or that
    bool is_way_known = false;
    bool is_blocked = false;  // the way to the body
  };

  // Returns a function that is negative in the grown body. Within `border` of
  // the boundary it is nowhere below the signed distance to the cell, so that
  // bodies that grow next to each other do not cross.
  double Region(const RowVector3d& p, double t, double border) const {
    Shard& shard = ShardOf(p);
    Measures at = Known(p, &shard);
    // The body itself lies within its cell, and no growth reaches farther.
    if (at.own <= -border) return kSlope * at.own;
    if (kSlope * (at.own - t) >= border) return kSlope * (at.own - t);
    bool has_measured = MeasureCut(p, t / kDecline, &at);
    const double growth = std::max(0.0, t - kDecline * at.to_cut);
    const double grown = kSlope * (at.own - growth);
    double region = grown;
    if (grown < border && growth > 0) {
      has_measured |= MeasureCell(p, -grown, &at);
      region = std::max(grown, at.cell);
      if (region < 0 && at.own > 0) has_measured |= MeasureWay(p, &at);
    }
    if (has_measured) {
      const std::lock_guard<std::mutex> lock(shard.mutex);
      shard.measures[KeyOf(p)] = at;
    }
    return region < 0 && at.is_blocked ? blocked_ : region;
  }

  // Every growth that is tried evaluates the same positions.
  using Key = std::array<double, 3>;
  static Key KeyOf(const RowVector3d& p) { return {p[0], p[1], p[2]}; }
  struct HashOfKey {
    // Positions form a lattice, so that sums of coordinates would collide.
    size_t operator()(const Key& key) const {
      size_t hash = 0;
      for (const double x : key) {
        hash = (hash ^ std::hash<double>()(x)) * 0x9E3779B97F4A7C15U;
        hash ^= hash >> 32;
      }
      return hash;
    }
  };
  struct Shard {
    std::mutex mutex;
    std::unordered_map<Key, Measures, HashOfKey> measures;
  };
  Shard& ShardOf(const RowVector3d& p) const {
    return shards_[HashOfKey()(KeyOf(p)) % shards_.size()];
  }

  // Returns the known quantities at a position, at least its distance to the
  // body.
  Measures Known(const RowVector3d& p, Shard* shard) const {
    {
      const std::lock_guard<std::mutex> lock(shard->mutex);
      const auto known = shard->measures.find(KeyOf(p));
      if (known != shard->measures.end()) return known->second;
    }
    Measures at;
    at.own = distance_.At(p, limit_);
    const std::lock_guard<std::mutex> lock(shard->mutex);
    return shard->measures.emplace(KeyOf(p), at).first->second;
  }

  // Measure a position, if it has not been done. They return true if so.
  bool MeasureCut(const RowVector3d& p, double limit, Measures* at) const {
    if (at->cut_limit >= limit || at->to_cut < at->cut_limit) return false;
    at->cut_limit = limit;
    at->to_cut =
        cut_.num_triangles() == 0 ? 0 : cut_.ClosestPoint(p, limit).distance;
    return true;
  }
  bool MeasureCell(const RowVector3d& p, double depth, Measures* at) const {
    if (at->cell_depth >= depth) return false;
    // A little more, for the next growth that is tried.
    at->cell_depth = std::max(depth, 0.0) + kSlack;
    at->cell = cell_.DistanceDownTo(at->cell_depth, p);
    return true;
  }
  bool MeasureWay(const RowVector3d& p, Measures* at) const {
    if (at->is_way_known) return false;
    at->is_way_known = true;
    at->is_blocked = IsBlocked(p, at->own);
    return true;
  }

  // Returns true if a bone or another muscle lies between a position and the
  // body, `own` away: the body would grow through it or around it.
  bool IsBlocked(const RowVector3d& p, double own) const {
    // A margin above rounding.
    const RowVector3d on_body =
        mesh_.bvh().ClosestPoint(p, own * (1 + 1e-9) + 1e-9).point;
    return std::any_of(
        around_.begin(), around_.end(), [&](const SolidDistance* other) {
          return SegmentMeets(p, on_body, other->mesh().bvh());
        });
  }

  TriangleSoup body_;
  SearchableMesh mesh_;
  SolidDistance distance_;
  TriangleBvh cut_;
  MedialCell cell_;
  std::vector<const SolidDistance*> around_;  // bones and other muscles
  double limit_;                              // of distances to the body, mm
  double blocked_;

  // Several shards, so that threads do not wait for each other.
  mutable std::array<Shard, 64> shards_;
};

namespace {

// A growth and the resulting body.
struct Growth {
  GrowthGuess at;
  TriangleSoup body;
};

// Returns the growth with which a body has a volume (mm^3), or `reach` if that
// is not enough, beginning with `first` (SearchGrowth). `left` is the volume
// without growth.
Growth GrowthFor(const GrowingBody& body,
                 double left,
                 double volume,
                 double spacing,
                 double reach,
                 const GrowthGuess& first) {
  Growth growth;
  const auto volume_at = [&](double tried) {
    growth.body = body.GrownBy(tried, spacing);
    const double now = SignedVolume(growth.body.points, growth.body.triangles);
    VLOG(1) << "a body grown by " << tried << " mm has " << now << " of "
            << volume << " mm3";
    return now;
  };
  growth.at = SearchGrowth(volume_at, left, volume, reach, first);
  return growth;
}

}  // namespace

SurfaceGrowth::SurfaceGrowth(const CellSurfaceOptions& options,
                             const TriangleSoup& body,
                             const SolidDistance& muscle,
                             const std::vector<const SolidDistance*>& others,
                             const std::vector<const SolidDistance*>& bones,
                             double volume)
    : spacing_(options.spacing),
      left_(SignedVolume(body.points, body.triangles)) {
  std::string error;
  CHECK(options.IsValid(&error)) << error;
  CHECK_GT(body.triangles.rows(), 0);
  const Triangles cut = CutTriangles(body, muscle, options.spacing / 2);
  const double area =
      SurfaceArea(body.points, cut.rows() > 0 ? cut : body.triangles);
  reach_ = std::clamp(kReachPerThickness * (volume - left_) / area,
                      options.spacing,
                      kLongestReach);
  body_ = std::make_unique<GrowingBody>(
      options, body, muscle, others, bones, cut, reach_);
}

SurfaceGrowth::~SurfaceGrowth() = default;

TriangleSoup SurfaceGrowth::UpTo(double volume) {
  const TriangleSoup& body = body_->body();
  if (left_ >= volume) return body;
  if (last_.t == 0) {
    // Coarser samples cut corners: they only give the initial growth.
    const double coarse = kCoarser * spacing_;
    last_ = GrowthFor(*body_, left_, volume, coarse, reach_, {spacing_}).at;
  }
  Growth growth = GrowthFor(*body_, left_, volume, spacing_, reach_, last_);
  last_ = growth.at;
  const TriangleSoup& grown = growth.body;
  return SignedVolume(grown.points, grown.triangles) > left_ ? grown : body;
}

}  // namespace musclewarp
