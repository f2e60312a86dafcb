// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/proximity/triangle_bvh.h"

#include <glog/logging.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numeric>

#include "musclewarp/proximity/triangle_distance.h"
#include "musclewarp/proximity/triangle_halves.h"

namespace musclewarp {

using Eigen::RowVector3d;

TriangleBvh::TriangleBvh(const Points& points, const Triangles& triangles)
    : triangles_(triangles), corners_(triangles.rows()) {
  const int count = num_triangles();
  const Points centroids = CentroidsOf(points, triangles);
  std::vector<int> order(count);
  std::iota(order.begin(), order.end(), 0);
  nodes_.reserve(std::max(0, 2 * count - 1));
  if (count > 0) {
    Build(centroids, order.data(), order.data() + count);
    wide_nodes_.reserve(count / 2 + 1);  // they are large, and slow to move
    BuildWide(0);
  }
  Refit(points);
}

int TriangleBvh::Build(const Points& centroids, int* begin, int* end) {
  const int index = static_cast<int>(nodes_.size());
  nodes_.push_back(Node{{}, -1, -1});
  if (end - begin == 1) {
    nodes_[index].triangle = *begin;
    return index;
  }
  int* const middle = begin + (end - begin) / 2;
  SplitAlongLongestSide(centroids, begin, middle, end);
  Build(centroids, begin, middle);
  const int second = Build(centroids, middle, end);
  nodes_[index].second = second;
  return index;
}

int TriangleBvh::BuildWide(int node) {
  // Counts the triangles below a node: of 2 n - 1 nodes n are leaves.
  const auto count_triangles = [&](int i) {
    int size = 1;
    for (; !nodes_[i].IsLeaf(); i = nodes_[i].second) {
      size += nodes_[i].second - i;
    }
    return (size + 1) / 2;
  };
  // Parts that fit into a wide node of their own are not divided, so that wide
  // nodes are full of triangles.
  const int enough =
      count_triangles(node) > BoxOctet::kSize ? BoxOctet::kSize : 1;
  std::vector<int> below = {node};
  for (int level = 0; level < 3; ++level) {
    std::vector<int> next;
    for (const int i : below) {
      const bool is_divided = count_triangles(i) > enough;
      next.push_back(is_divided ? i + 1 : i);
      if (is_divided) next.push_back(nodes_[i].second);
    }
    below = std::move(next);
  }
  const int index = static_cast<int>(wide_nodes_.size());
  wide_nodes_.emplace_back().boxes.count = static_cast<int>(below.size());
  for (size_t lane = 0; lane < below.size(); ++lane) {
    const Node& child = nodes_[below[lane]];
    const int number =
        child.IsLeaf() ? ~child.triangle : BuildWide(below[lane]);
    wide_nodes_[index].nodes[lane] = below[lane];
    wide_nodes_[index].children[lane] = number;
  }
  return index;
}

void TriangleBvh::Refit(const Points& points) {
  for (int f = 0; f < num_triangles(); ++f) {
    for (int corner = 0; corner < 3; ++corner) {
      corners_[f].row(corner) = points.row(triangles_(f, corner));
    }
  }
  RefitNodes([&](int triangle) { return BoxOf(corners_[triangle]); });
}

std::vector<Box3> TriangleBvh::BoxesOfNodes(
    const std::vector<Box3>& of_triangles) const {
  CHECK_EQ(of_triangles.size(), corners_.size());
  std::vector<Box3> boxes(nodes_.size());
  // Children come after their parents.
  for (int i = static_cast<int>(nodes_.size()) - 1; i >= 0; --i) {
    const Node& node = nodes_[i];
    boxes[i] = node.IsLeaf() ? of_triangles[node.triangle]
                             : BoxOf(boxes[i + 1], boxes[node.second]);
  }
  return boxes;
}

template <typename BoxOfTriangle>
void TriangleBvh::RefitNodes(const BoxOfTriangle& box_of) {
  // Children come after their parents.
  for (int i = static_cast<int>(nodes_.size()) - 1; i >= 0; --i) {
    Node& node = nodes_[i];
    node.box = node.IsLeaf()
                   ? box_of(node.triangle)
                   : BoxOf(nodes_[i + 1].box, nodes_[node.second].box);
  }
  for (WideNode& wide : wide_nodes_) {
    for (int lane = 0; lane < wide.boxes.count; ++lane) {
      wide.boxes.SetBox(lane, nodes_[wide.nodes[lane]].box);
    }
  }
}

std::vector<TriangleBvh::NodePair> TriangleBvh::SelfPairs() const {
  std::vector<NodePair> pairs;
  for (int i = 0; i < static_cast<int>(nodes_.size()); ++i) {
    if (!nodes_[i].IsLeaf()) pairs.emplace_back(i + 1, nodes_[i].second);
  }
  return pairs;
}

template <typename Visit>
void TriangleBvh::VisitAround(const RowVector3d& point,
                              const Visit& visit,
                              const double* limit) const {
  if (wide_nodes_.empty()) return;
  struct Entry {
    float bound;
    int child;
  };
  // A level leaves seven nodes at most, and a tree has less than eleven.
  std::array<Entry, 96> stack;
  int size = 0;
  stack[size++] = {0, 0};
  const OctetQuery query(point);
  while (size > 0) {
    const Entry entry = stack[--size];
    if (entry.bound > *limit) continue;
    if (entry.child < 0) {
      visit(~entry.child);
      continue;
    }
    const WideNode& wide = wide_nodes_[entry.child];
    const BoxOctet::Values bounds = BoundSquaredDistances(wide.boxes, query);
    const int first = size;
    for (int lane = 0; lane < wide.boxes.count; ++lane) {
      if (bounds[lane] > *limit) continue;
      // Far ones first, so that the nearest comes off the stack next.
      int at = size++;
      for (; at > first && stack[at - 1].bound < bounds[lane]; --at) {
        stack[at] = stack[at - 1];
      }
      stack[at] = {bounds[lane], wide.children[lane]};
    }
  }
}

TriangleBvh::Closest TriangleBvh::ClosestPoint(const RowVector3d& point,
                                               double max_distance) const {
  Closest closest;
  double least = max_distance * max_distance;
  VisitAround(
      point,
      [&](int triangle) {
        const RowVector3d candidate =
            ClosestPointOfTriangle(point, corners_[triangle]);
        const double square = (point - candidate).squaredNorm();
        if (!(square <= least)) return;
        if (square == least && closest.triangle >= 0 &&
            closest.triangle < triangle) {
          return;
        }
        least = square;
        closest.triangle = triangle;
        closest.point = candidate;
      },
      &least);
  if (closest.triangle >= 0) closest.distance = std::sqrt(least);
  return closest;
}

bool TriangleBvh::IsWithin(const RowVector3d& point, double distance) const {
  if (distance < 0) return false;
  const double square = distance * distance;
  bool is_within = false;
  double limit = square;
  VisitAround(
      point,
      [&](int triangle) {
        const RowVector3d candidate =
            ClosestPointOfTriangle(point, corners_[triangle]);
        if ((point - candidate).squaredNorm() > square) return;
        is_within = true;
        limit = -1;  // the end
      },
      &limit);
  return is_within;
}

}  // namespace musclewarp
