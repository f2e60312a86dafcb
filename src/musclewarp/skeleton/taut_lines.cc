// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/skeleton/taut_lines.h"

#include <glog/logging.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "musclewarp/skeleton/banded_cholesky.h"
#include "musclewarp/skeleton/posed_lines.h"

namespace musclewarp {
namespace {

using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::RowVector3d;
using Eigen::VectorXd;

// The potential P of a support that is pressed by g, with its derivatives: the
// stiffness grows from 0 to 1 over `onset`.
double Potential(double g, double onset) {
  if (g <= 0) return 0;
  if (g <= onset) return g * g * g / (6 * onset);
  return (g - onset / 2) * (g - onset / 2) / 2 + onset * onset / 24;
}
double Push(double g, double onset) {
  if (g <= 0) return 0;
  return g <= onset ? g * g / (2 * onset) : g - onset / 2;
}
double PushSlope(double g, double onset) {
  return g <= 0 ? 0 : std::min(g / onset, 1.0);
}

// The functions below take the points of the lines of a group, x.

double Energy(const PosedGroup& group, const std::vector<Points>& x) {
  double energy = 0;
  for (int a = 0; a < group.size(); ++a) {
    const PosedLine& line = group.lines[a];
    const LineSupports& on = *line.supports;
    for (Index i = 0; i + 1 < group.num_points; ++i) {
      energy +=
          (x[a].row(i + 1) - x[a].row(i)).squaredNorm() / (2 * line.lengths[i]);
      const RowVector3d moved = x[a].row(i) - line.carried.row(i);
      energy += on.stiffness[i] *
                    Potential(line.bends.row(i).dot(moved) + line.offsets[i],
                              on.onset) +
                on.plane_stiffness[i] *
                    Potential(-line.outward.row(i).dot(moved), on.plane_onset) +
                on.hold[i] / 2 * moved.squaredNorm();
    }
  }
  for (const PosedTie& tie : group.ties) {
    energy += ((x[tie.a] - x[tie.b] - tie.difference).rowwise().squaredNorm())
                  .dot(*tie.stiffness) /
              2;
  }
  return energy;
}

// Returns -dE/dx at the inner points.
VectorXd Forces(const PosedGroup& group, const std::vector<Points>& x) {
  VectorXd forces = VectorXd::Zero(group.num_unknowns());
  const auto at = [&](Index i, int a) {
    return forces.segment<3>(group.Row(i, a));
  };
  for (int a = 0; a < group.size(); ++a) {
    const PosedLine& line = group.lines[a];
    const LineSupports& on = *line.supports;
    for (Index i = 1; i + 1 < group.num_points; ++i) {
      const RowVector3d moved = x[a].row(i) - line.carried.row(i);
      const RowVector3d bend = line.bends.row(i), out = line.outward.row(i);
      const RowVector3d force =
          (x[a].row(i + 1) - x[a].row(i)) / line.lengths[i] -
          (x[a].row(i) - x[a].row(i - 1)) / line.lengths[i - 1] -
          on.stiffness[i] * Push(bend.dot(moved) + line.offsets[i], on.onset) *
              bend +
          on.plane_stiffness[i] * Push(-out.dot(moved), on.plane_onset) * out -
          on.hold[i] * moved;
      at(i, a) += force.transpose();
    }
  }
  for (const PosedTie& tie : group.ties) {
    for (Index i = 1; i + 1 < group.num_points; ++i) {
      const RowVector3d pull =
          (*tie.stiffness)[i] *
          (x[tie.a].row(i) - x[tie.b].row(i) - tie.difference.row(i));
      at(i, tie.a) -= pull.transpose();
      at(i, tie.b) += pull.transpose();
    }
  }
  return forces;
}

// Adds a symmetric block of three unknowns to the diagonal.
void AddToDiagonal(Index row, const Matrix3d& block, SymmetricBand* hessian) {
  for (int c = 0; c < 3; ++c) {
    for (int r = c; r < 3; ++r) (*hessian)(r - c, row + c) += block(r, c);
  }
}

SymmetricBand Hessian(const PosedGroup& group, const std::vector<Points>& x) {
  const Index width = 3 * group.size();
  SymmetricBand hessian = SymmetricBand::Zero(width + 1, group.num_unknowns());
  for (int a = 0; a < group.size(); ++a) {
    const PosedLine& line = group.lines[a];
    const LineSupports& on = *line.supports;
    for (Index i = 1; i + 1 < group.num_points; ++i) {
      const RowVector3d moved = x[a].row(i) - line.carried.row(i);
      const RowVector3d bend = line.bends.row(i), out = line.outward.row(i);
      const double along =
          1 / line.lengths[i - 1] + 1 / line.lengths[i] + on.hold[i];
      const double support =
          on.stiffness[i] *
          PushSlope(bend.dot(moved) + line.offsets[i], on.onset);
      const double plane =
          on.plane_stiffness[i] * PushSlope(-out.dot(moved), on.plane_onset);
      const Index row = group.Row(i, a);
      AddToDiagonal(row,
                    along * Matrix3d::Identity() +
                        support * bend.transpose() * bend +
                        plane * out.transpose() * out,
                    &hessian);
      if (i + 2 == group.num_points) continue;
      for (int c = 0; c < 3; ++c) {
        hessian(width, row + c) -= 1 / line.lengths[i];
      }
    }
  }
  for (const PosedTie& tie : group.ties) {
    for (Index i = 1; i + 1 < group.num_points; ++i) {
      const double stiffness = (*tie.stiffness)[i];
      for (const int member : {tie.a, tie.b}) {
        AddToDiagonal(
            group.Row(i, member), stiffness * Matrix3d::Identity(), &hessian);
      }
      for (int c = 0; c < 3; ++c) {
        hessian(3 * (tie.b - tie.a), group.Row(i, tie.a) + c) -= stiffness;
      }
    }
  }
  return hessian;
}

std::vector<Points> Moved(const PosedGroup& group,
                          std::vector<Points> x,
                          double share,
                          const VectorXd& step) {
  for (int a = 0; a < group.size(); ++a) {
    for (Index i = 1; i + 1 < group.num_points; ++i) {
      x[a].row(i) += share * step.segment<3>(group.Row(i, a)).transpose();
    }
  }
  return x;
}

// Newton's method. The energy is strictly convex with a continuous gradient, so
// that halved steps always lead to the minimum.
std::vector<Points> Minimum(const PosedGroup& group) {
  constexpr int kMaxSteps = 100;
  constexpr double kBalanced = 1e-11;   // forces: a rounding of the tension
  constexpr double kLeastStep = 1e-10;  // mm
  constexpr double kLeastShare = 1e-6;
  std::vector<Points> x;
  for (const PosedLine& line : group.lines) x.push_back(line.carried);
  if (group.num_points <= 2) return x;
  double energy = Energy(group, x);
  for (int step = 0; step < kMaxSteps; ++step) {
    VectorXd way = Forces(group, x);
    if (way.cwiseAbs().maxCoeff() < kBalanced) break;
    const VectorXd forces = way;
    SymmetricBand hessian = Hessian(group, x);
    CHECK(FactorBand(&hessian));
    SolveBand(hessian, &way);
    // The rounding of a sum of some hundred terms.
    const double rounding = 1e-12 * (1 + energy);
    double share = 1;
    std::vector<Points> next = Moved(group, x, share, way);
    double lower = Energy(group, next);
    while (lower > energy - 1e-4 * share * forces.dot(way) + rounding &&
           share > kLeastShare) {
      share /= 2;
      next = Moved(group, x, share, way);
      lower = Energy(group, next);
    }
    x = std::move(next);
    energy = lower;
    if (way.cwiseAbs().maxCoeff() < kLeastStep) break;
  }
  return x;
}

RowVector3d VelocityOf(const RowVector3d& point, const Eigen::Matrix4d& rate) {
  return (rate.topLeftCorner<3, 3>() * point.transpose() +
          rate.topRightCorner<3, 1>())
      .transpose();
}

// Returns the derivative of Forces() at fixed inner points, and sets the
// velocities of the ends.
VectorXd ForceRates(const PosedGroup& group,
                    const std::vector<Points>& x,
                    const std::vector<ActionLine>& lines,
                    const std::vector<PointMotions>& motions,
                    const std::vector<PointMotions>& rates,
                    std::vector<Points>* velocities) {
  VectorXd forces = VectorXd::Zero(group.num_unknowns());
  const auto at = [&](Index i, int a) {
    return forces.segment<3>(group.Row(i, a));
  };
  const Index last = group.num_points - 1;
  for (int a = 0; a < group.size(); ++a) {
    const PosedLine& line = group.lines[a];
    const LineSupports& on = *line.supports;
    const PointMotions& rate = rates[group.members[a]];
    Points& velocity = (*velocities)[a];
    for (const Index end : {Index{0}, last}) {
      velocity.row(end) = VelocityOf(line.carried.row(end), rate[end]);
    }
    if (last < 2) continue;
    at(1, a) += velocity.row(0).transpose() / line.lengths[0];
    at(last - 1, a) += velocity.row(last).transpose() / line.lengths[last - 1];
    for (Index i = 1; i < last; ++i) {
      const RowVector3d moved = x[a].row(i) - line.carried.row(i);
      const RowVector3d bend = line.bends.row(i), out = line.outward.row(i);
      const RowVector3d bend_rate = TurnedBy(rate[i], bend);
      const RowVector3d out_rate = TurnedBy(rate[i], out);
      const RowVector3d speed = VelocityOf(line.carried.row(i), rate[i]);
      const double bent = bend.dot(moved) + line.offsets[i];
      const double pressed = -out.dot(moved);
      at(i, a) += (-on.stiffness[i] *
                       (PushSlope(bent, on.onset) *
                            (bend_rate.dot(moved) - bend.dot(speed)) * bend +
                        Push(bent, on.onset) * bend_rate) +
                   on.plane_stiffness[i] *
                       (PushSlope(pressed, on.plane_onset) *
                            (out.dot(speed) - out_rate.dot(moved)) * out +
                        Push(pressed, on.plane_onset) * out_rate) +
                   on.hold[i] * speed)
                      .transpose();
    }
  }
  for (const PosedTie& tie : group.ties) {
    const int a = group.members[tie.a], b = group.members[tie.b];
    const Points at_rest = lines[a].rest - lines[b].rest;
    for (Index i = 1; i < last; ++i) {
      const RowVector3d turning =
          TurnedBy(rates[a][i], TurnedBy(motions[a][i], at_rest.row(i))) +
          TurnedBy(rates[b][i], TurnedBy(motions[b][i], at_rest.row(i)));
      const RowVector3d pull = (*tie.stiffness)[i] / 2 * turning;
      at(i, tie.a) += pull.transpose();
      at(i, tie.b) -= pull.transpose();
    }
  }
  return forces;
}

}  // namespace

std::vector<Points> TautPoints(const std::vector<ActionLine>& lines,
                               const std::vector<PointMotions>& motions) {
  CHECK_EQ(lines.size(), motions.size());
  std::vector<Points> points(lines.size());
  for (const PosedGroup& group : PosedGroups(lines, motions)) {
    std::vector<Points> solved = Minimum(group);
    for (int a = 0; a < group.size(); ++a) {
      points[group.members[a]] = std::move(solved[a]);
    }
  }
  return points;
}

double TautEnergy(const std::vector<ActionLine>& lines,
                  const std::vector<PointMotions>& motions,
                  const std::vector<Points>& points) {
  double energy = 0;
  for (const PosedGroup& group : PosedGroups(lines, motions)) {
    std::vector<Points> x;
    for (const int member : group.members) x.push_back(points[member]);
    energy += Energy(group, x);
  }
  return energy;
}

std::vector<Points> TautRates(const std::vector<ActionLine>& lines,
                              const std::vector<PointMotions>& motions,
                              const std::vector<Points>& points,
                              const std::vector<PointMotions>& rates) {
  CHECK_EQ(lines.size(), rates.size());
  std::vector<Points> velocities(lines.size());
  for (const PosedGroup& group : PosedGroups(lines, motions)) {
    std::vector<Points> x, of_group;
    for (const int member : group.members) {
      x.push_back(points[member]);
      of_group.push_back(Points::Zero(group.num_points, 3));
    }
    VectorXd inner = ForceRates(group, x, lines, motions, rates, &of_group);
    if (inner.size() > 0) {
      SymmetricBand hessian = Hessian(group, x);
      CHECK(FactorBand(&hessian));
      SolveBand(hessian, &inner);
    }
    of_group = Moved(group, std::move(of_group), 1, inner);
    for (int a = 0; a < group.size(); ++a) {
      velocities[group.members[a]] = std::move(of_group[a]);
    }
  }
  return velocities;
}

}  // namespace musclewarp
