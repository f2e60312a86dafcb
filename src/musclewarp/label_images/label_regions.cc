// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/label_images/label_regions.h"

#include <algorithm>
#include <utility>

namespace musclewarp {
namespace {

// The state of a voxel. Values from kFirstPiece on are its piece.
enum Mark : int { kBackground, kOfLabel, kOutside, kFirstPiece };

// The states of the voxels in a box.
struct Marks {
  explicit Marks(const Eigen::Array3i& box_size)
      : size(box_size),
        marks(box_size.cast<std::int64_t>().prod(), kBackground) {}

  std::int64_t At(int i, int j, int k) const {
    return (std::int64_t{k} * size[1] + j) * size[0] + i;
  }
  Eigen::Array3i PlaceOf(std::int64_t at) const {
    return {static_cast<int>(at % size[0]),
            static_cast<int>(at / size[0] % size[1]),
            static_cast<int>(at / size[0] / size[1])};
  }

  Eigen::Array3i size;
  std::vector<int> marks;
};

// Changes the mark `from` to `to` for all voxels that are connected to `seed`
// through faces of voxels with that mark. Returns their box.
LabelBox Flood(std::int64_t seed, int from, int to, Marks* marks) {
  const Eigen::Array3i& size = marks->size;
  std::vector<std::int64_t> front = {seed};
  marks->marks[seed] = to;
  LabelBox box;
  box.lowest = box.highest = marks->PlaceOf(seed);
  while (!front.empty()) {
    const Eigen::Array3i place = marks->PlaceOf(front.back());
    front.pop_back();
    ++box.voxels;
    box.lowest = box.lowest.min(place);
    box.highest = box.highest.max(place);
    for (int face = 0; face < 6; ++face) {
      Eigen::Array3i next = place;
      next[face / 2] += face % 2 == 0 ? -1 : 1;
      if ((next < 0).any() || (next >= size).any()) continue;
      const std::int64_t at = marks->At(next[0], next[1], next[2]);
      if (marks->marks[at] != from) continue;
      marks->marks[at] = to;
      front.push_back(at);
    }
  }
  return box;
}

// Returns the voxels of a label in its box, without a margin.
Marks MarksOfLabel(const LabelImage& image, int label, const LabelBox& box) {
  Marks marks(box.highest - box.lowest + 1);
  const Eigen::Array3i& size = image.grid.size;
  for (int k = box.lowest[2]; k <= box.highest[2]; ++k) {
    for (int j = box.lowest[1]; j <= box.highest[1]; ++j) {
      for (int i = box.lowest[0]; i <= box.highest[0]; ++i) {
        if (image.labels[(std::int64_t{k} * size[1] + j) * size[0] + i] !=
            label) {
          continue;
        }
        const Eigen::Array3i at = Eigen::Array3i(i, j, k) - box.lowest;
        marks.marks[marks.At(at[0], at[1], at[2])] = kOfLabel;
      }
    }
  }
  return marks;
}

// A piece of a label, with its mark and box.
struct Piece {
  int mark = kFirstPiece;
  LabelBox box;
};

// Returns the region of a piece, with a margin and without cavities. `first` is
// the index of the first of `voxels` in the image.
LabelRegion RegionOf(const Marks& voxels,
                     const Piece& piece,
                     const Eigen::Array3i& first) {
  LabelRegion region;
  const LabelBox& box = piece.box;
  region.first = first + box.lowest - kRegionMargin;
  region.size = box.highest - box.lowest + 1 + 2 * kRegionMargin;
  Marks marks(region.size);
  for (int k = box.lowest[2]; k <= box.highest[2]; ++k) {
    for (int j = box.lowest[1]; j <= box.highest[1]; ++j) {
      for (int i = box.lowest[0]; i <= box.highest[0]; ++i) {
        if (voxels.marks[voxels.At(i, j, k)] != piece.mark) continue;
        const Eigen::Array3i at =
            Eigen::Array3i(i, j, k) - box.lowest + kRegionMargin;
        marks.marks[marks.At(at[0], at[1], at[2])] = kOfLabel;
      }
    }
  }
  Flood(0, kBackground, kOutside, &marks);
  region.is_inside.resize(marks.marks.size());
  for (std::size_t at = 0; at < marks.marks.size(); ++at) {
    if (marks.marks[at] == kBackground) ++region.cavity_voxels;
    region.is_inside[at] = marks.marks[at] != kOutside;
  }
  region.voxels = box.voxels + region.cavity_voxels;
  return region;
}

}  // namespace

std::map<int, LabelBox> BoxesOfLabels(const LabelImage& image) {
  std::map<int, LabelBox> boxes;
  const Eigen::Array3i& size = image.grid.size;
  std::int64_t at = 0;
  // Labels come in runs, so that the next voxel usually has the same box.
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

LabelPieces PiecesOfLabel(const LabelImage& image,
                          int label,
                          const LabelBox& box) {
  Marks marks = MarksOfLabel(image, label, box);
  LabelPieces result;
  std::vector<Piece> pieces;
  for (std::size_t at = 0; at < marks.marks.size(); ++at) {
    if (marks.marks[at] != kOfLabel) continue;
    Piece piece;
    piece.mark = kFirstPiece + static_cast<int>(pieces.size());
    piece.box =
        Flood(static_cast<std::int64_t>(at), kOfLabel, piece.mark, &marks);
    pieces.push_back(piece);
  }
  std::stable_sort(
      pieces.begin(), pieces.end(), [](const Piece& a, const Piece& b) {
        return a.box.voxels > b.box.voxels;
      });
  for (const Piece& piece : pieces) {
    // Cavities count: a thin shell may enclose many voxels.
    LabelRegion region = RegionOf(marks, piece, box.lowest);
    if (region.voxels < kFewestVoxels && !result.regions.empty()) {
      ++result.small_pieces;
      result.small_voxels += piece.box.voxels;
    } else {
      result.regions.push_back(std::move(region));
    }
  }
  return result;
}

}  // namespace musclewarp
