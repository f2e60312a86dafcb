// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/skeleton/posed_lines.h"

#include <glog/logging.h>

#include <cmath>

#include "musclewarp/mesh/transformed.h"

namespace musclewarp {
namespace {

// Returns z with k P'(z) = load.
double Offset(double load, double stiffness, double onset) {
  if (stiffness <= 0) return 0;
  const double push = load / stiffness;
  return push > onset / 2 ? push + onset / 2 : std::sqrt(2 * onset * push);
}

PosedLine Posed(const ActionLine& line, const PointMotions& motions) {
  const Eigen::Index count = line.rest.rows();
  CHECK_EQ(static_cast<Eigen::Index>(motions.size()), count);
  const LineSupports& supports = *line.supports;
  PosedLine posed;
  posed.supports = &supports;
  posed.lengths =
      (line.rest.bottomRows(count - 1) - line.rest.topRows(count - 1))
          .rowwise()
          .norm();
  posed.offsets.resize(count);
  posed.carried.resize(count, 3);
  posed.bends.resize(count, 3);
  posed.outward.resize(count, 3);
  for (Eigen::Index i = 0; i < count; ++i) {
    posed.offsets[i] =
        Offset(supports.loads[i], supports.stiffness[i], supports.onset);
    posed.carried.row(i) = Transformed(line.rest.row(i), motions[i]);
    posed.bends.row(i) = TurnedBy(motions[i], supports.bends.row(i));
    posed.outward.row(i) = TurnedBy(motions[i], supports.outward.row(i));
  }
  return posed;
}

PosedGroup GroupOf(int first,
                   const std::vector<ActionLine>& lines,
                   const std::vector<PointMotions>& motions) {
  PosedGroup group;
  group.members = {first};
  for (const LineTie& tie : lines[first].supports->ties) {
    CHECK_LT(tie.other, static_cast<int>(lines.size()));
    group.members.push_back(tie.other);
  }
  group.num_points = lines[first].rest.rows();
  for (const int member : group.members) {
    CHECK_EQ(lines[member].rest.rows(), group.num_points);
    CHECK(lines[member].supports);
    group.lines.push_back(Posed(lines[member], motions[member]));
  }
  for (int a = 0; a < group.size(); ++a) {
    for (const LineTie& tie : lines[group.members[a]].supports->ties) {
      for (int b = a + 1; b < group.size(); ++b) {
        if (group.members[b] != tie.other) continue;
        PosedTie& posed = group.ties.emplace_back();
        posed = {a, b, &tie.stiffness, {}};
        const Points at_rest =
            lines[group.members[a]].rest - lines[tie.other].rest;
        posed.difference.resize(group.num_points, 3);
        for (Eigen::Index i = 0; i < group.num_points; ++i) {
          posed.difference.row(i) =
              (TurnedBy(motions[group.members[a]][i], at_rest.row(i)) +
               TurnedBy(motions[tie.other][i], at_rest.row(i))) /
              2;
        }
      }
    }
  }
  return group;
}

}  // namespace

Eigen::RowVector3d TurnedBy(const Eigen::Matrix4d& motion,
                            const Eigen::RowVector3d& direction) {
  return direction * motion.topLeftCorner<3, 3>().transpose();
}

// Returns the groups of the taut lines among `lines`.
std::vector<PosedGroup> PosedGroups(const std::vector<ActionLine>& lines,
                                    const std::vector<PointMotions>& motions) {
  std::vector<PosedGroup> groups;
  std::vector<char> is_taken(lines.size(), 0);
  for (size_t i = 0; i < lines.size(); ++i) {
    if (is_taken[i] || !lines[i].supports) continue;
    groups.push_back(GroupOf(static_cast<int>(i), lines, motions));
    for (const int member : groups.back().members) is_taken[member] = 1;
  }
  return groups;
}

}  // namespace musclewarp
