// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/proximity/self_crossing_search.h"

#include <glog/logging.h>

#include <algorithm>
#include <array>
#include <map>
#include <numeric>

#include "musclewarp/base/infinity.h"
#include "musclewarp/base/wide_registers.h"
#include "musclewarp/base/work_counts.h"
#include "musclewarp/cgal/triangle_intersection.h"
#include "musclewarp/mesh/triangle.h"
#include "musclewarp/proximity/triangle_halves.h"

namespace musclewarp {
namespace {

// overlaps[j] = 1 if box j of eight overlaps one, without short cuts.
MUSCLEWARP_WIDE void CompareWithEight(const double* lower,
                                      const double* upper,
                                      const double (*lowers)[8],
                                      const double (*uppers)[8],
                                      std::int64_t* overlaps) {
#pragma omp simd
  for (int j = 0; j < 8; ++j) {
    overlaps[j] = (lower[0] <= uppers[0][j]) & (upper[0] >= lowers[0][j]) &
                  (lower[1] <= uppers[1][j]) & (upper[1] >= lowers[1][j]) &
                  (lower[2] <= uppers[2][j]) & (upper[2] >= lowers[2][j]);
  }
}

double Extent(const Box3& box) {
  return box.upper[0] - box.lower[0] + box.upper[1] - box.lower[1] +
         box.upper[2] - box.lower[2];
}

}  // namespace

SelfCrossingSearch::SelfCrossingSearch(const Points& rest,
                                       const Triangles& triangles)
    : triangles_(triangles), rings_(triangles, rest.rows()) {
  const int count = static_cast<int>(triangles.rows());
  const Points centroids = CentroidsOf(rest, triangles);
  std::vector<int> order(count);
  std::iota(order.begin(), order.end(), 0);
  if (count > 0) Build(centroids, order.data(), order.data() + count);
  first_.assign(rest.rows() + 1, 0);
  for (int k = 0; k < triangles_.size(); ++k)
    ++first_[triangles_.data()[k] + 1];
  std::partial_sum(first_.begin(), first_.end(), first_.begin());
  around_.resize(triangles_.size());
  std::vector<int> next = first_;
  for (int f = 0; f < count; ++f) {
    for (const int v : triangles_.row(f)) around_[next[v]++] = f;
  }
  FindNeighbours();
}

int SelfCrossingSearch::Build(const Points& centroids, int* begin, int* end) {
  const int index = static_cast<int>(nodes_.size());
  nodes_.emplace_back();
  const int count = static_cast<int>(end - begin);
  if (count <= kGroup) {
    nodes_[index].group = static_cast<int>(members_.size()) / kGroup;
    members_.insert(members_.end(), begin, end);
    members_.resize(members_.size() + kGroup - count, -1);
    return index;
  }
  // All groups but the last are full.
  int* const middle = begin + (count / 2 + kGroup - 1) / kGroup * kGroup;
  SplitAlongLongestSide(centroids, begin, middle, end);
  Build(centroids, begin, middle);
  const int second = Build(centroids, middle, end);
  nodes_[index].second = second;
  return index;
}

void SelfCrossingSearch::FindNeighbours() {
  std::vector<int> place(triangles_.rows());  // of a triangle in members_
  for (size_t k = 0; k < members_.size(); ++k) {
    if (members_[k] >= 0) place[members_[k]] = static_cast<int>(k);
  }
  neighbours_.resize(members_.size() / kGroup);
  for (size_t a = 0; a < neighbours_.size(); ++a) {
    std::map<int, PairMask> masks;
    for (int i = 0; i < kGroup; ++i) {
      const int f = members_[kGroup * a + i];
      if (f < 0) continue;
      for (const int v : triangles_.row(f)) {
        for (int k = first_[v]; k < first_[v + 1]; ++k) {
          const auto [b, j] = std::div(place[around_[k]], kGroup);
          if (b < static_cast<int>(a)) continue;
          masks[b] |= PairMask{1} << (kGroup * i + j);
        }
      }
    }
    for (const auto& [b, pairs] : masks) neighbours_[a].push_back({b, pairs});
  }
}

SelfCrossingSearch::PairMask SelfCrossingSearch::PairsToTest(
    int a, int b, const std::vector<GroupBoxes>& boxes) const {
  const GroupBoxes &of_a = boxes[a], &of_b = boxes[b];
  PairMask pairs = 0;
  for (int i = 0; i < kGroup; ++i) {
    const double lower[] = {
        of_a.lower[0][i], of_a.lower[1][i], of_a.lower[2][i]};
    const double upper[] = {
        of_a.upper[0][i], of_a.upper[1][i], of_a.upper[2][i]};
    std::int64_t overlaps[kGroup];
    CompareWithEight(lower, upper, of_b.lower, of_b.upper, overlaps);
    for (int j = 0; j < kGroup; ++j) {
      pairs |= static_cast<PairMask>(overlaps[j]) << (kGroup * i + j);
    }
  }
  for (const Neighbour& neighbour : neighbours_[a]) {
    if (neighbour.group == b) pairs &= ~neighbour.pairs;
  }
  return pairs;
}

template <typename Visit>
void SelfCrossingSearch::VisitPairs(int a,
                                    int b,
                                    const std::vector<Box3>& node_boxes,
                                    const Visit& visit) const {
  std::array<std::pair<int, int>, 128> stack;  // at most the sum of both depths
  int size = 0;
  stack[size++] = {a, b};
  while (size > 0) {
    const auto [first, second] = stack[--size];
    if (!node_boxes[first].Overlaps(node_boxes[second])) continue;
    const Node &node_a = nodes_[first], &node_b = nodes_[second];
    if (node_a.group >= 0 && node_b.group >= 0) {
      visit(node_a.group, node_b.group);
    } else if (node_b.group >= 0 ||
               (node_a.group < 0 &&
                Extent(node_boxes[first]) >= Extent(node_boxes[second]))) {
      stack[size++] = {node_a.second, second};
      stack[size++] = {first + 1, second};
    } else {
      stack[size++] = {first, node_b.second};
      stack[size++] = {first, second + 1};
    }
  }
}

SelfCrossingSearch::Boxes SelfCrossingSearch::BoxesAt(
    const Points& points) const {
  const int num_groups = static_cast<int>(neighbours_.size());
  Boxes boxes;
  boxes.groups.resize(num_groups);
  std::vector<Box3> around(num_groups);
#pragma omp parallel for schedule(static)
  for (int a = 0; a < num_groups; ++a) {
    GroupBoxes& group = boxes.groups[a];
    for (int i = 0; i < kGroup; ++i) {
      const int f = members_[kGroup * a + i];
      Box3 box;
      box.lower.fill(kInfinity);
      box.upper.fill(-kInfinity);
      if (f >= 0) box = BoxOf(CornersOf(points, triangles_.row(f)));
      for (int axis = 0; axis < 3; ++axis) {
        group.lower[axis][i] = box.lower[axis];
        group.upper[axis][i] = box.upper[axis];
      }
      around[a] = i == 0 ? box : BoxOf(around[a], box);
    }
  }
  boxes.nodes.resize(nodes_.size());
  // Children come after their parents.
  for (int n = static_cast<int>(nodes_.size()) - 1; n >= 0; --n) {
    const Node& node = nodes_[n];
    boxes.nodes[n] = node.group >= 0
                         ? around[node.group]
                         : BoxOf(boxes.nodes[n + 1], boxes.nodes[node.second]);
  }
  return boxes;
}

void SelfCrossingSearch::AddIfCrossing(const Points& points,
                                       int f,
                                       int g,
                                       PairList* found) const {
  if (TrianglesIntersectBeyondCommon(CornersOf(points, triangles_.row(f)),
                                     CornersOf(points, triangles_.row(g)))) {
    found->emplace_back(std::minmax(f, g));
  }
}

void SelfCrossingSearch::TestGroups(const Points& points,
                                    const Boxes& boxes,
                                    int a,
                                    int b,
                                    PairList* found) const {
  PairMask pairs = PairsToTest(a, b, boxes.groups);
  for (int bit = 0; pairs != 0; ++bit, pairs >>= 1) {
    const int i = bit / kGroup, j = bit % kGroup;
    if ((pairs & 1) == 0 || (a == b && j <= i)) continue;
    AddIfCrossing(
        points, members_[kGroup * a + i], members_[kGroup * b + j], found);
  }
}

void SelfCrossingSearch::TestStar(const Points& points,
                                  const std::vector<char>& is_proper,
                                  int v,
                                  PairList* found) const {
  for (int k = first_[v]; k < first_[v + 1]; ++k) {
    for (int l = first_[v]; l < k; ++l) {
      const int f = around_[k], g = around_[l];
      if (ShareProperStar(triangles_, is_proper, f, g)) continue;
      AddIfCrossing(points, f, g, found);
    }
  }
}

SelfCrossingSearch::PairList SelfCrossingSearch::Find(
    const Points& points) const {
  CHECK_EQ(points.rows() + 1, static_cast<Eigen::Index>(first_.size()));
  const Boxes boxes = BoxesAt(points);
  const std::vector<char> is_proper = ProperStars(rings_, points);
  PairList all;
#pragma omp parallel
  {
    PairList found;
    std::int64_t visited = 0;
    const auto test = [&](int a, int b) {
      ++visited;
      TestGroups(points, boxes, a, b, &found);
    };
#pragma omp for schedule(dynamic, 16) nowait
    for (int n = 0; n < static_cast<int>(nodes_.size()); ++n) {
      const Node& node = nodes_[n];
      if (node.group >= 0) {
        test(node.group, node.group);
      } else {
        VisitPairs(n + 1, node.second, boxes.nodes, test);
      }
    }
#pragma omp for schedule(static) nowait
    for (int v = 0; v < static_cast<int>(points.rows()); ++v) {
      if (!is_proper[v]) TestStar(points, is_proper, v, &found);
    }
    CountWork(WorkUnit::kPairsVisited, kGroup * kGroup * visited);
#pragma omp critical(self_crossings)
    all.insert(all.end(), found.begin(), found.end());
  }
  std::sort(all.begin(), all.end());
  // A pair may share two vertices.
  all.erase(std::unique(all.begin(), all.end()), all.end());
  return all;
}

}  // namespace musclewarp
