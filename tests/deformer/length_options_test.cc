// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/deformer/length_options.h"

#include <gtest/gtest.h>

#include "musclewarp/deformer/deformer.h"
#include "musclewarp/scene/scaled_scene.h"
#include "support/input_errors.h"
#include "support/small_scene.h"

namespace musclewarp {
namespace {

constexpr double kMouse = 1.0 / 32;

TEST(LengthOptions, FollowTheBodyUnlessTheyAreAskedFor) {
  for (const std::string name :
       {"gap", "max_lost_area", "max_hole", "sample_spacing"}) {
    PrepareOptions prepare;
    CertifiedContactOptions contact;
    FrameRequirements requirements;
    AskInMillimetres({name}, 2, &prepare, &contact, &requirements);
    const bool asks_gap = name == "gap";
    EXPECT_EQ(contact.step.gap,
              CertifiedContactOptions().step.gap / (asks_gap ? 2 : 1));
    const bool asks_area = name == "max_lost_area";
    EXPECT_EQ(requirements.max_lost_area,
              FrameRequirements().max_lost_area / (asks_area ? 4 : 1));
  }
}

TEST(LengthOptions, AGapInMillimetresIsKept) {
  Scene scene = SmallScene();
  ScaleLengths(1.25 * kMouse, &scene);
  DeformerOptions options;
  options.prepare.muscle.hull.coarse_vertices = 60;
  options.frames.certified.step.gap = 0.01;
  options.lengths_in_mm = {"gap"};
  Deformer deformer(scene, options);
  EXPECT_EQ(deformer.contact().gap, 0.01);
  const Frame frame = deformer.MoveTo(RestPose(scene));
  ASSERT_TRUE(frame.intersections.SmallestGap());
  EXPECT_GE(*frame.intersections.SmallestGap(), 0.01);
}

TEST(LengthOptions, AGapThatIsLargeForTheBodyIsRefused) {
  Scene scene = SmallScene();
  ScaleLengths(1.25 * kMouse, &scene);
  DeformerOptions options;
  options.lengths_in_mm = {"gap"};
  ExpectInputError(
      [&] { Deformer(scene, options); },
      {"gap", "is 0.1 mm", "is 1/32 of human size", "at most 0.0156"});
}

}  // namespace
}  // namespace musclewarp
