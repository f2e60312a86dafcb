// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/label_images/label_regions.h"

#include <cstdlib>

namespace musclewarp {
namespace {

// What is known of a voxel.
enum Mark : char { kBackground, kOfLabel, kOfPiece, kKept, kOutside };

// Voxels in a box, and what is known of them.
struct Marks {
  explicit Marks(const Eigen::Array3i& box_size)
      : size(box_size),
        marks(box_size.cast<std::int64_t>().prod(), kBackground) {}

  std::int64_t At(int i, int j, int k) const {
    return (std::int64_t{k} * size[1] + j) * size[0] + i;
  }

  Eigen::Array3i size;
  std::vector<char> marks;
};

// Gives the voxels that have the mark `from` and hang together with `seed` the
// mark `to`, through corners or only through sides. Returns their number.
std::int64_t Flood(
    std::int64_t seed, char from, char to, bool through_corners, Marks* marks) {
  const Eigen::Array3i& size = marks->size;
  std::vector<std::int64_t> front = {seed};
  marks->marks[seed] = to;
  std::int64_t count = 0;
  const auto visit = [&](int i, int j, int k) {
    if (i < 0 || j < 0 || k < 0 || i >= size[0] || j >= size[1] ||
        k >= size[2]) {
      return;
    }
    const std::int64_t at = marks->At(i, j, k);
    if (marks->marks[at] != from) return;
    marks->marks[at] = to;
    front.push_back(at);
  };
  while (!front.empty()) {
    const std::int64_t at = front.back();
    front.pop_back();
    ++count;
    const int i = static_cast<int>(at % size[0]);
    const int j = static_cast<int>(at / size[0] % size[1]);
    const int k = static_cast<int>(at / size[0] / size[1]);
    for (int step = 0; step < 27; ++step) {
      const int x = step % 3 - 1, y = step / 3 % 3 - 1, z = step / 9 - 1;
      if (through_corners || std::abs(x) + std::abs(y) + std::abs(z) == 1) {
        visit(i + x, j + y, k + z);
      }
    }
  }
  return count;
}

// Marks the largest piece as kept and all other voxels as background.
void KeepLargestPiece(Marks* marks, LabelRegion* region) {
  std::int64_t largest = -1;
  int pieces = 0;
  std::int64_t all = 0;
  const std::int64_t count = static_cast<std::int64_t>(marks->marks.size());
  for (std::int64_t at = 0; at < count; ++at) {
    if (marks->marks[at] != kOfLabel) continue;
    const std::int64_t voxels = Flood(at, kOfLabel, kOfPiece, true, marks);
    ++pieces;
    all += voxels;
    if (voxels <= region->voxels) continue;
    region->voxels = voxels;
    largest = at;
  }
  Flood(largest, kOfPiece, kKept, true, marks);
  for (char& mark : marks->marks) {
    if (mark == kOfPiece) mark = kBackground;
  }
  region->other_pieces = pieces - 1;
  region->other_voxels = all - region->voxels;
}

}  // namespace

std::map<int, LabelBox> BoxesOfLabels(const LabelImage& image) {
  std::map<int, LabelBox> boxes;
  const Eigen::Array3i& size = image.grid.size;
  std::int64_t at = 0;
  // Labels come in rows, so that the last box is most often the next one.
  int last_label = 0;
  LabelBox* last = nullptr;
  for (int k = 0; k < size[2]; ++k) {
    for (int j = 0; j < size[1]; ++j) {
      for (int i = 0; i < size[0]; ++i, ++at) {
        const int label = image.labels[at];
        if (label == 0) continue;
        const Eigen::Array3i place(i, j, k);
        if (label != last_label) {
          last = &boxes[label];
          last_label = label;
        }
        if (last->voxels == 0) last->lowest = last->highest = place;
        last->lowest = last->lowest.min(place);
        last->highest = last->highest.max(place);
        ++last->voxels;
      }
    }
  }
  return boxes;
}

LabelRegion RegionOfLabel(const LabelImage& image,
                          int label,
                          const LabelBox& box) {
  LabelRegion region;
  region.first = box.lowest - kRegionMargin;
  region.size = box.highest - box.lowest + 1 + 2 * kRegionMargin;
  Marks marks(region.size);
  const Eigen::Array3i& size = image.grid.size;
  for (int k = box.lowest[2]; k <= box.highest[2]; ++k) {
    for (int j = box.lowest[1]; j <= box.highest[1]; ++j) {
      for (int i = box.lowest[0]; i <= box.highest[0]; ++i) {
        if (image.labels[(std::int64_t{k} * size[1] + j) * size[0] + i] ==
            label) {
          marks.marks[marks.At(
              i - region.first[0], j - region.first[1], k - region.first[2])] =
              kOfLabel;
        }
      }
    }
  }
  KeepLargestPiece(&marks, &region);
  Flood(0, kBackground, kOutside, false, &marks);
  region.is_inside.resize(marks.marks.size());
  for (std::size_t at = 0; at < marks.marks.size(); ++at) {
    if (marks.marks[at] == kBackground) ++region.cavity_voxels;
    region.is_inside[at] = marks.marks[at] != kOutside;
  }
  region.voxels += region.cavity_voxels;
  return region;
}

}  // namespace musclewarp
