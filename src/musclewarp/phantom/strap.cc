// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/phantom/strap.h"

#include <glog/logging.h>

#include <algorithm>
#include <limits>

#include "musclewarp/phantom/curves.h"

namespace musclewarp::phantom {
namespace {

// Edges of the polyline between two nodes.
constexpr int kSamplesPerStrapSpan = 2;

// Farther away than this, mm, a lower bound replaces the distance.
constexpr double kFarFromStrap = 30;

// How much thinner the strap is at its edges, as a share of its thickness.
constexpr double kEdgeLoss = 0.4;

// Centre, half width times `across`, and half thickness of a cross section.
using Section = Eigen::Matrix<double, 7, 1>;

struct StrapSpan {
  std::vector<Section> sections;
  // Contains the ruled surface.
  Eigen::AlignedBox3d box;
  double largest_thickness = 0;
};

// The distance to the part of a strap between two sections.
double DistanceToPiece(const Section& start,
                       const Section& end,
                       const Eigen::Vector3d& p) {
  const Eigen::Vector3d axis = end.head<3>() - start.head<3>();
  const double length2 = std::max(axis.squaredNorm(), 1e-12);
  double u = 0;
  Section section = start;
  // The place along the axis and that across it depend on each other a little.
  for (int turn = 0; turn < 2; ++turn) {
    const Eigen::Vector3d in_middle = p - u * section.segment<3>(3);
    const double t =
        std::clamp((in_middle - start.head<3>()).dot(axis) / length2, 0.0, 1.0);
    section = start + t * (end - start);
    const double width2 = section.segment<3>(3).squaredNorm();
    if (width2 < 1e-6) {
      u = 0;
    } else {
      u = std::clamp(
          (p - section.head<3>()).dot(section.segment<3>(3)) / width2,
          -1.0,
          1.0);
    }
  }
  return (p - section.head<3>() - u * section.segment<3>(3)).norm() -
         section[6] * (1 - kEdgeLoss * u * u);
}

double DistanceToStrapSpan(const StrapSpan& span, const Eigen::Vector3d& p) {
  double distance = std::numeric_limits<double>::infinity();
  for (size_t i = 0; i + 1 < span.sections.size(); ++i) {
    distance = std::min(
        distance, DistanceToPiece(span.sections[i], span.sections[i + 1], p));
  }
  return distance;
}

std::vector<StrapSpan> SpansOf(const std::vector<StrapNode>& nodes) {
  CHECK_GE(nodes.size(), 2u);
  std::vector<Section> controls;
  for (const StrapNode& node : nodes) {
    Section section;
    section << node.centre, node.half_width * node.across, node.half_thickness;
    controls.push_back(section);
  }
  const std::vector<Section> curve =
      SampleCatmullRom(controls, kSamplesPerStrapSpan, false);
  std::vector<StrapSpan> spans;
  for (size_t first = 0; first + 1 < curve.size();
       first += kSamplesPerStrapSpan) {
    StrapSpan span;
    span.sections.assign(curve.begin() + first,
                         curve.begin() + first + kSamplesPerStrapSpan + 1);
    for (const Section& section : span.sections) {
      span.box.extend(section.head<3>() + section.segment<3>(3));
      span.box.extend(section.head<3>() - section.segment<3>(3));
      span.largest_thickness = std::max(span.largest_thickness, section[6]);
    }
    spans.push_back(span);
  }
  return spans;
}

}  // namespace

Field Strap(const std::vector<StrapNode>& nodes) {
  return [spans = SpansOf(nodes)](const Eigen::Vector3d& p) {
    // The span with the nearest box goes first: it is likely the nearest span,
    // and then most others need not be looked at.
    const auto least = [&](const StrapSpan& span) {
      return span.box.exteriorDistance(p) - span.largest_thickness;
    };
    size_t first = 0;
    double least_of_all = std::numeric_limits<double>::infinity();
    for (size_t i = 0; i < spans.size(); ++i) {
      if (least(spans[i]) >= least_of_all) continue;
      least_of_all = least(spans[i]);
      first = i;
    }
    if (least_of_all > kFarFromStrap) return least_of_all;
    double distance = DistanceToStrapSpan(spans[first], p);
    for (size_t i = 0; i < spans.size(); ++i) {
      if (i == first || least(spans[i]) >= distance) continue;
      distance = std::min(distance, DistanceToStrapSpan(spans[i], p));
    }
    return distance;
  };
}

Eigen::AlignedBox3d StrapBox(const std::vector<StrapNode>& nodes,
                             double margin) {
  Eigen::AlignedBox3d box;
  for (const StrapSpan& span : SpansOf(nodes)) {
    const Eigen::Vector3d room =
        Eigen::Vector3d::Constant(span.largest_thickness + margin);
    box.extend(span.box.min() - room);
    box.extend(span.box.max() + room);
  }
  return box;
}

}  // namespace musclewarp::phantom
