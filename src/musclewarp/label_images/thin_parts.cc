// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/label_images/thin_parts.h"

#include <algorithm>
#include <array>

namespace musclewarp {
namespace {

// Parts of the region that extend farther than this from the voxels inside the
// surface, in steps through faces of voxels, are cut off.
constexpr int kRimVoxels = 2;

// Paths through faces among the voxels of a region. A region has a margin of
// outside voxels on all sides, so that steps stay within the box.
class Ways {
 public:
  explicit Ways(const LabelRegion& region)
      : strides_{
            1, region.size[0], std::int64_t{region.size[0]} * region.size[1]} {}

  // Calls visit(voxel) for the neighbours of a voxel.
  template <typename Visit>
  void ForEachBeside(std::int64_t voxel, const Visit& visit) const {
    for (const std::int64_t stride : strides_) {
      visit(voxel - stride);
      visit(voxel + stride);
    }
  }

  // Returns the voxels connected to `seed` among those for which take(voxel) is
  // true. take() must return false for a voxel after it has returned true.
  template <typename Take>
  std::vector<std::int64_t> PartWith(std::int64_t seed,
                                     const Take& take) const {
    std::vector<std::int64_t> part = {seed};
    for (size_t next = 0; next < part.size(); ++next) {
      ForEachBeside(part[next], [&](std::int64_t beside) {
        if (take(beside)) part.push_back(beside);
      });
    }
    return part;
  }

 private:
  std::array<std::int64_t, 3> strides_;
};

// Returns the largest part of the region inside the surface.
std::vector<std::int64_t> LargestPartInside(const LabelRegion& region,
                                            const Ways& ways,
                                            const float* smoothed,
                                            double level) {
  std::vector<bool> is_open(region.is_inside.size());
  for (size_t at = 0; at < is_open.size(); ++at) {
    is_open[at] = region.is_inside[at] && smoothed[at] > level;
  }
  const auto take = [&](std::int64_t at) {
    const bool takes = is_open[at];
    is_open[at] = false;
    return takes;
  };
  std::vector<std::int64_t> largest;
  for (size_t at = 0; at < is_open.size(); ++at) {
    if (!take(at)) continue;
    std::vector<std::int64_t> part = ways.PartWith(at, take);
    if (part.size() > largest.size()) largest = std::move(part);
  }
  return largest;
}

}  // namespace

std::vector<std::int64_t> VoxelsCutOff(const LabelRegion& region,
                                       const float* smoothed,
                                       double level) {
  const Ways ways(region);
  const std::vector<std::int64_t> main =
      LargestPartInside(region, ways, smoothed, level);
  if (main.empty()) return {};
  // The steps from the main part to every voxel of the region.
  constexpr int kUnreached = -1;
  std::vector<int> steps(region.is_inside.size(), kUnreached);
  for (const std::int64_t at : main) steps[at] = 0;
  std::vector<std::int64_t> front = main;
  for (size_t next = 0; next < front.size(); ++next) {
    const int step = steps[front[next]] + 1;
    ways.ForEachBeside(front[next], [&](std::int64_t beside) {
      if (!region.is_inside[beside] || steps[beside] != kUnreached) return;
      steps[beside] = step;
      front.push_back(beside);
    });
  }
  std::vector<std::int64_t> cut_off;
  const auto take = [&](std::int64_t at) {
    const bool takes = steps[at] > 0;
    if (takes) steps[at] = kUnreached;
    return takes;
  };
  // Starting at the farthest voxel, take each connected part outside the main
  // part.
  for (auto at = front.rbegin(); at != front.rend(); ++at) {
    if (steps[*at] <= kRimVoxels) continue;
    steps[*at] = kUnreached;
    const std::vector<std::int64_t> part = ways.PartWith(*at, take);
    cut_off.insert(cut_off.end(), part.begin(), part.end());
  }
  std::sort(cut_off.begin(), cut_off.end());
  return cut_off;
}

}  // namespace musclewarp
