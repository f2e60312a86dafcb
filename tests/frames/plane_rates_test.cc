// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/frames/plane_rates.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "musclewarp/scene/perturbed_poses.h"
#include "support/meshes.h"
#include "support/muscles.h"

namespace musclewarp {
namespace {

using Eigen::RowVector3d;

// Of differences of places of some hundred mm over 2e-4, by rad.
constexpr double kRatesRounding = 1e-7;

// A rigid motion about and along z, as a rate.
Eigen::Matrix4d RateAboutZ(double spin, double speed) {
  Eigen::Matrix4d rate = Eigen::Matrix4d::Zero();
  rate(0, 1) = -spin;
  rate(1, 0) = spin;
  rate(2, 3) = speed;
  return rate;
}

// A spindle with a row whose plane is 2 mm above its vertex `v`, and one that
// is not active.
struct SpindleWithRows {
  explicit SpindleWithRows(const PlaneOwner& owner) {
    const RowVector3d place = model.fine_rest.row(7);
    contact.rows =
        OneSidedRowsOf({{7, {normal, normal.dot(place) + 2}},
                        {9, {normal, normal.dot(model.fine_rest.row(9)) - 1}}},
                       0.3);
    contact.owners = {owner, owner};
    foot = place + 2 * normal;
  }

  TargetRate Rates(const CarrierRates& owners) const {
    TargetRate rate;
    const Points places = model.fine_rest(contact.rows.vertices, Eigen::all);
    AddPlaneRates(contact, places, owners, &rate);
    return rate;
  }

  const MuscleModel model = SpindleModel();
  const RowVector3d normal = RowVector3d(1, 2, 2) / 3;
  RowVector3d foot;
  ContactRows contact;
};

TEST(AddPlaneRates, APlaneOfABoneGoesWithIt) {
  PlaneOwner owner;
  owner.bone = 1;
  const SpindleWithRows spindle(owner);
  CarrierRates owners;
  owners.bones = {RateAboutZ(5, 100), RateAboutZ(0.5, 3)};
  const TargetRate rate = spindle.Rates(owners);
  const RowVector3d spin(0, 0, 0.5);
  EXPECT_NEAR(
      rate.plane_speeds[0],
      spindle.normal.dot(spin.cross(spindle.foot)) + 3 * spindle.normal[2],
      1e-12);
  EXPECT_LT((RowVector3d(rate.plane_turns.row(0)) - spin.cross(spindle.normal))
                .norm(),
            1e-12);
  // What is not active does not count.
  EXPECT_EQ(rate.plane_speeds[1], 0);
  EXPECT_EQ(rate.plane_turns.row(1).norm(), 0);
}

TEST(AddPlaneRates, APlaneBetweenMusclesGoesWithBothTriangles) {
  const TriangleSoup above = MovedBy(Icosphere(10, 1), {3, 4, 5});
  const TriangleSoup below = MovedBy(Icosphere(10, 1), {-20, 4, 5});
  PlaneOwner owner;
  owner.muscle_above = 0;
  owner.muscle_below = 1;
  owner.above = above.triangles.row(3);
  owner.below = below.triangles.row(5);
  owner.share_above = 0.25;
  const SpindleWithRows spindle(owner);
  // The one above turns by 0.8 about z through the origin beside a body that
  // goes up at 6, the one below goes along y.
  const RowVector3d spin(0, 0, 0.8);
  Points turned(above.points.rows(), 3);
  for (int v = 0; v < turned.rows(); ++v) {
    turned.row(v) = spin.cross(RowVector3d(above.points.row(v)));
  }
  Points shifted = Points::Zero(below.points.rows(), 3);
  shifted.col(1).setConstant(-2);
  CarrierRates owners;
  owners.muscles = {{&above.points, &turned, RateAboutZ(0, 6)},
                    {&below.points, &shifted, RateAboutZ(0, 0)}};
  const TargetRate rate = spindle.Rates(owners);
  EXPECT_NEAR(rate.plane_speeds[0],
              0.25 * spindle.normal.dot(spin.cross(spindle.foot) +
                                        RowVector3d(0, 0, 6)) +
                  0.75 * spindle.normal.dot(RowVector3d(0, -2, 0)),
              kRatesRounding);
  EXPECT_LT(
      (RowVector3d(rate.plane_turns.row(0)) - spin.cross(spindle.normal) / 2)
          .norm(),
      kRatesRounding);
}

// As contact has it: a triangle without area does not turn a plane.
TEST(AddPlaneRates, AVertexInPlaceOfATriangleDoesNotTurnAPlane) {
  const TriangleSoup soup = Icosphere(10, 1);
  PlaneOwner owner;
  owner.muscle_above = owner.muscle_below = 0;
  owner.above = Eigen::RowVector3i::Constant(4);
  owner.below = soup.triangles.row(5);
  const SpindleWithRows spindle(owner);
  const RowVector3d spin(0.3, 0, 0.8);
  Points turned(soup.points.rows(), 3);
  for (int v = 0; v < turned.rows(); ++v) {
    turned.row(v) = spin.cross(RowVector3d(soup.points.row(v)));
  }
  CarrierRates owners;
  owners.muscles = {{&soup.points, &turned, Eigen::Matrix4d::Zero()}};
  const TargetRate rate = spindle.Rates(owners);
  EXPECT_LT((RowVector3d(rate.plane_turns.row(0)) - spin.cross(spindle.normal))
                .norm(),
            kRatesRounding);
}

}  // namespace
}  // namespace musclewarp
