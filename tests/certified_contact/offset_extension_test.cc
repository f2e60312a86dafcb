// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/certified_contact/offset_extension.h"

#include <gtest/gtest.h>

#include "certified_contact/contact_group.h"
#include "musclewarp/certified_contact/relaxation.h"

namespace musclewarp {
namespace {

// A sphere whose first twenty vertices are given offsets.
struct GivenOffsets {
  ContactGroup group{{SphereAt({0, 0, 0}, 10, 2)}, {}};
  std::vector<int> given;
  Points offsets = 0.5 * RandomPoints(20, 1);
  StepOptions options;

  GivenOffsets() {
    for (int v = 0; v < 20; ++v) given.push_back(7 * v);
  }
  Points Extended() const {
    return OffsetExtension(group.scene.muscles[0],
                           given,
                           options.relaxation.smoothing_length)
        .Extended(offsets);
  }
};

TEST(OffsetExtension, LeavesGivenOffsetsAsTheyAre) {
  const GivenOffsets sphere;
  const Points extended = sphere.Extended();
  for (size_t i = 0; i < sphere.given.size(); ++i) {
    EXPECT_EQ(extended.row(sphere.given[i]), sphere.offsets.row(i));
  }
}

// Of small strains, where the energy is quadratic.
TEST(OffsetExtension, IsWhatARelaxationWithoutContactConvergesTo) {
  GivenOffsets sphere;
  sphere.options.relaxation.strain_hardening = 0;
  sphere.options.relaxation.rope_factor = 0;
  sphere.options.relaxation.pressure_gain = 0;
  const ContactStep step = MakeContactStep(
      sphere.group.scene,
      sphere.group.state,
      sphere.group.state.targets,
      {},
      {{sphere.given,
        sphere.group.state.targets[0](sphere.given, Eigen::all) +
            sphere.offsets}});
  PlaneSet planes(sphere.options, step);
  const Points relaxed = Relax(sphere.options,
                               step,
                               sphere.group.state.targets,
                               UniformStiffness(sphere.group.scene),
                               2000,
                               &planes,
                               StartOf(step))
                             .points[0];
  EXPECT_LT(
      (relaxed - sphere.group.state.targets[0] - sphere.Extended()).norm(),
      1e-9);
}

TEST(OffsetExtension, OfNothingIsZero) {
  const ContactGroup group({SphereAt({0, 0, 0}, 10, 1)}, {});
  const OffsetExtension extension(group.scene.muscles[0], {}, 8);
  EXPECT_EQ(extension.Extended(Points(0, 3)), Points::Zero(42, 3));
}

}  // namespace
}  // namespace musclewarp
