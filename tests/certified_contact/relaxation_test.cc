// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/certified_contact/relaxation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "certified_contact/contact_group.h"
#include "musclewarp/mesh/measures.h"
#include "support/meshes.h"

namespace musclewarp {
namespace {

// The energy of relaxation.h of the offsets of one muscle.
double Energy(const StepOptions& options,
              const MuscleSurface& surface,
              const Points& targets,
              const Points& offsets) {
  const RelaxationOptions& relaxation = options.relaxation;
  const double length = relaxation.smoothing_length;
  double energy = 0;
  for (int v = 0; v < surface.num_vertices(); ++v) {
    energy +=
        surface.areas[v] / (length * length) * offsets.row(v).squaredNorm() / 2;
    for (int e = surface.first[v]; e < surface.first[v + 1]; ++e) {
      const int u = surface.neighbours[e];
      const double rest = surface.lengths[e];
      const Eigen::RowVector3d of_target = targets.row(v) - targets.row(u);
      const Eigen::RowVector3d strain = offsets.row(v) - offsets.row(u);
      const double square = strain.squaredNorm();
      const double excess = std::max(
          0.0,
          (of_target + strain).norm() -
              std::max(relaxation.stretch_limit * rest, of_target.norm()));
      // Every edge is seen from both ends.
      energy += surface.weights[e] / 4 *
                (square * (1 + relaxation.strain_hardening / 2 * square /
                                   (rest * rest)) +
                 relaxation.rope_factor * excess * excess);
    }
  }
  return energy;
}

struct Relaxed {
  ContactGroup group;
  std::vector<Points> targets;
  StepOptions options;

  explicit Relaxed(ContactGroup contact_group)
      : group(std::move(contact_group)), targets(group.state.targets) {}

  RelaxedPoints Run(int sweeps) const {
    const ContactStep step = MakeContactStep(
        group.scene, group.state, targets, group.state.bones_from_rest);
    PlaneSet planes(options, step);
    planes.Add(AllPlanes(options, step));
    return Relax(options,
                 step,
                 targets,
                 UniformStiffness(group.scene),
                 sweeps,
                 &planes,
                 StartOf(step));
  }
};

// Two muscles side by side, one of which lacks a tenth of its volume.
TEST(Relax, PressureRestoresVolumeAndPushesOthersBack) {
  const TriangleSoup left = SphereAt({-10.1, 0, 0}, 10, 3);
  const TriangleSoup right = SphereAt({10.1, 0, 0}, 10, 3);
  Relaxed relaxed(ContactGroup({left, right}, {}));
  const double volume = relaxed.group.scene.muscles[0].volume;
  relaxed.group.scene.muscles[0].volume *= 1.1;
  const RelaxedPoints result = relaxed.Run(24);
  EXPECT_GT(SignedVolume(result.points[0], left.triangles), 1.05 * volume);
  EXPECT_LT(SignedVolume(result.points[0], left.triangles), 1.1 * volume);
  // The other one has to make room.
  EXPECT_GT(result.points[1].col(0).minCoeff(),
            right.points.col(0).minCoeff() + 0.05);
  EXPECT_GT(SignedVolume(result.points[1], right.triangles), 0.99 * volume);
  relaxed.options.relaxation.pressure_gain = 0;
  EXPECT_NEAR(SignedVolume(relaxed.Run(24).points[0], left.triangles),
              volume,
              1e-6 * volume);
}

TEST(Relax, BringsOffsetsToZeroWhereNothingIsInTheWay) {
  Relaxed relaxed(ContactGroup({SphereAt({0, 0, 0}, 10, 2)}, {}));
  // An offset from before, within the reach.
  relaxed.group.state.points[0].col(0).array() += 0.4;
  const RelaxedPoints result = relaxed.Run(2000);
  EXPECT_LT((result.points[0] - relaxed.targets[0]).norm(), 1e-9);
  EXPECT_EQ(result.points[0], result.unprojected[0]);
}

TEST(Relax, LowersTheEnergyWithEverySweep) {
  Relaxed relaxed(ContactGroup({SphereAt({0, 0, 0}, 10, 2)}, {}));
  relaxed.group.state.points[0] += 0.3 * RandomPoints(162, 1);
  double before = 1e300;
  for (int sweeps = 0; sweeps < 6; ++sweeps) {
    const double energy =
        Energy(relaxed.options,
               relaxed.group.scene.muscles[0],
               relaxed.targets[0],
               relaxed.Run(sweeps).points[0] - relaxed.targets[0]);
    EXPECT_LT(energy, before);
    before = energy;
  }
}

// A sphere of which one half is held and the top pulled out of the other by
// twice its radius: the energy has no slope at the vertices between.
TEST(Relax, FindsTheMinimumOfTheEnergy) {
  const ContactGroup group({SphereAt({0, 0, 0}, 4, 2)}, {});
  const MuscleSurface& surface = group.scene.muscles[0];
  const Points& targets = group.state.targets[0];
  StepOptions options;
  options.reach = 20;
  options.relaxation.pressure_gain = 0;
  Eigen::Index top;
  targets.col(2).maxCoeff(&top);
  std::vector<int> held;
  for (int v = 0; v < surface.num_vertices(); ++v) {
    if (targets(v, 2) <= 0 || v == top) held.push_back(v);
  }
  AttachedPoints attached{held, targets(held, Eigen::all)};
  for (size_t i = 0; i < held.size(); ++i) {
    if (held[i] == top) attached.positions(i, 2) += 8;
  }
  const ContactStep step = MakeContactStep(
      group.scene, group.state, group.state.targets, {}, {attached});
  PlaneSet planes(options, step);
  const Points points = Relax(options,
                              step,
                              group.state.targets,
                              UniformStiffness(group.scene),
                              2000,
                              &planes,
                              StartOf(step))
                            .points[0];
  const auto energy = [&](const Points& p) {
    return Energy(options, surface, targets, p - targets);
  };
  // Ropes are taut.
  StepOptions without_ropes = options;
  without_ropes.relaxation.rope_factor = 0;
  EXPECT_GT(energy(points),
            Energy(without_ropes, surface, targets, points - targets) + 1);
  constexpr double kStep = 1e-4;
  for (int v = 0; v < surface.num_vertices(); ++v) {
    if (std::binary_search(held.begin(), held.end(), v)) continue;
    for (int axis = 0; axis < 3; ++axis) {
      Points above = points, below = points;
      above(v, axis) += kStep;
      below(v, axis) -= kStep;
      // Rounding of an energy of about a thousand over the step.
      EXPECT_NEAR((energy(above) - energy(below)) / (2 * kStep), 0, 1e-6) << v;
    }
  }
}

// Where a single vertex is stiff, the edges to all its neighbours are.
TEST(Relax, AnEdgeHasTheLargerStiffnessOfItsEnds) {
  const ContactGroup group({SphereAt({0, 0, 0}, 10, 1)}, {});
  const MuscleSurface& surface = group.scene.muscles[0];
  StepOptions options;
  options.relaxation.strain_hardening = 0;
  options.relaxation.rope_factor = 0;
  options.relaxation.pressure_gain = 0;
  const Points& targets = group.state.targets[0];
  constexpr int kHeld = 0;
  const int stiff = surface.neighbours[surface.first[kHeld]];
  AttachedPoints attached{{kHeld}, targets.row(kHeld)};
  attached.positions(0, 0) += 0.5;
  const ContactStep step = MakeContactStep(
      group.scene, group.state, group.state.targets, {}, {attached});
  Stiffness stiffness = UniformStiffness(group.scene);
  stiffness[0][stiff] = 50;
  PlaneSet planes(options, step);
  const Points offsets = Relax(options,
                               step,
                               group.state.targets,
                               stiffness,
                               2000,
                               &planes,
                               StartOf(step))
                             .points[0] -
                         targets;
  const double length = options.relaxation.smoothing_length;
  for (int v = 0; v < surface.num_vertices(); ++v) {
    if (v == kHeld) continue;
    Eigen::RowVector3d gradient =
        surface.areas[v] / (length * length) * offsets.row(v);
    for (int e = surface.first[v]; e < surface.first[v + 1]; ++e) {
      const int u = surface.neighbours[e];
      gradient += surface.weights[e] *
                  std::max(stiffness[0][u], stiffness[0][v]) *
                  (offsets.row(v) - offsets.row(u));
    }
    EXPECT_LT(gradient.norm(), 1e-9) << v;
  }
}

TEST(Relax, KeepsTheGapToABone) {
  Relaxed relaxed(SpheresOverABone());
  relaxed.options.relaxation.smoothing_length = 4;
  relaxed.targets[0].col(2).array() -= 0.7;  // 0.2 into the bone
  const RelaxedPoints result = relaxed.Run(200);
  // The last sweep has every vertex in its half-spaces.
  EXPECT_GE(result.points[0].col(2).minCoeff(), relaxed.options.gap - 1e-8);
  // What is far from contact is not moved by it.
  const Points moves = result.points[0] - relaxed.targets[0];
  Eigen::Index top;
  relaxed.targets[0].col(2).maxCoeff(&top);
  EXPECT_LT(moves.row(top).norm(), 0.05 * moves.rowwise().norm().maxCoeff());
}

TEST(Relax, MovesNoVertexFartherThanTheReachFromWhereItIsCarried) {
  Relaxed relaxed(ContactGroup({SphereAt({0, 0, 0}, 10, 2)}, {}));
  // Carried far from the target: the offset of before is 7 mm.
  relaxed.group.state.points[0].col(0).array() += 7;
  const RelaxedPoints result = relaxed.Run(10);
  const Points moves = result.points[0] - relaxed.group.state.points[0];
  EXPECT_NEAR(moves.rowwise().norm().maxCoeff(), relaxed.options.reach, 1e-9);
}

TEST(Relax, TakesAttachedVerticesWhereTheirBoneHasThemUnlessABoneIsInTheWay) {
  const ContactGroup group = SpheresOverABone();
  const StepOptions options;
  const Points& rest = group.state.targets[0];
  // The top goes up by half a millimetre, the lowest vertex into the bone.
  std::vector<int> vertices(2);
  rest.col(2).maxCoeff(&vertices[0]);
  rest.col(2).minCoeff(&vertices[1]);
  ASSERT_NE(vertices[0], vertices[1]);
  std::vector<double> moves = {0.5, -0.9};
  if (vertices[1] < vertices[0]) {
    std::swap(vertices[0], vertices[1]);
    std::swap(moves[0], moves[1]);
  }
  AttachedPoints attached{vertices, rest(vertices, Eigen::all)};
  for (int i = 0; i < 2; ++i) attached.positions(i, 2) += moves[i];
  const ContactStep step = MakeContactStep(group.scene,
                                           group.state,
                                           group.state.targets,
                                           group.state.bones_from_rest,
                                           {attached});
  PlaneSet planes(options, step);
  planes.Add(AllPlanes(options, step));
  const Points points = Relax(options,
                              step,
                              group.state.targets,
                              UniformStiffness(group.scene),
                              50,
                              &planes,
                              StartOf(step))
                            .points[0];
  for (int i = 0; i < 2; ++i) {
    if (moves[i] > 0) {
      EXPECT_EQ(points.row(vertices[i]), attached.positions.row(i));
    } else {
      EXPECT_LT(points(vertices[i], 2), rest(vertices[i], 2) - 0.1);
      EXPECT_GE(points(vertices[i], 2), options.gap - 1e-8);
    }
  }
}

TEST(Relax, StiffTrianglesMoveAsOnePiece) {
  ContactGroup group({SphereAt({0, 0, 0}, 10, 2)}, {});
  const StepOptions options;
  const ContactStep step =
      MakeContactStep(group.scene, group.state, group.state.targets, {});
  // A plane pushes one vertex outwards by 0.5.
  const int pushed = 100;
  const Eigen::RowVector3d out = step.predicted[0].row(pushed).normalized();
  SeparatingPlane plane;
  plane.muscle_above = 0;
  plane.above = Eigen::RowVector3i::Constant(pushed);
  plane.normal = out;
  plane.level = out.dot(step.predicted[0].row(pushed)) + 0.5;
  const MuscleSurface& surface = group.scene.muscles[0];
  const int neighbour = surface.neighbours[surface.first[pushed]];
  const auto share_of_neighbour = [&](double stiffness) {
    PlaneSet planes(options, step);
    planes.Add({plane});
    const RelaxedPoints result =
        Relax(options,
              step,
              group.state.targets,
              {Eigen::VectorXd::Constant(surface.num_vertices(), stiffness)},
              200,
              &planes,
              StartOf(step));
    const Points moves = result.points[0] - group.state.targets[0];
    EXPECT_NEAR(moves.row(pushed).dot(out), 0.5, 1e-8);
    return moves.row(neighbour).dot(out) / 0.5;
  };
  // The decay takes its part on the way to the neighbour, the less the stiffer
  // the edge is.
  EXPECT_GT(share_of_neighbour(1), 0.1);
  EXPECT_GT(share_of_neighbour(1000), 1.2 * share_of_neighbour(1));
}

}  // namespace
}  // namespace musclewarp
