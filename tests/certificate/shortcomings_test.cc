// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/certificate/shortcomings.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "musclewarp/certificate/scene_intersections.h"
#include "musclewarp/geometry/folded_triangles.h"
#include "musclewarp/mesh/measures.h"
#include "support/meshes.h"

namespace musclewarp {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

// A muscle at rest and as it is deformed, measured as frames are.
struct Deformed {
  TriangleSoup rest = Icosphere(10, 3);
  Points points = rest.points;
  std::vector<TriangleSoup> bones;
  double max_contact_displacement = 0;
  double depth_without_contact = 0;
  double push_depth = 0;
  std::vector<std::string> pushed_by;

  std::vector<std::string> Shortcomings(
      const FrameRequirements& requirements = {}) const {
    const SearchableMesh deformed({points, rest.triangles});
    std::vector<std::unique_ptr<SearchableMesh>> bone_meshes;
    std::vector<NamedMesh> named_bones;
    for (const TriangleSoup& bone : bones) {
      bone_meshes.push_back(std::make_unique<SearchableMesh>(bone));
      named_bones.push_back({"femur", bone_meshes.back().get()});
    }
    const SceneIntersections intersections =
        IntersectScene({{"psoas", &deformed}}, named_bones);
    JudgedMuscle judged;
    MuscleFigures& measures = judged.figures;
    measures.name = "psoas";
    judged.delivered_volume = SignedVolume(rest.points, rest.triangles);
    measures.volume_ratio =
        SignedVolume(points, rest.triangles) / judged.delivered_volume;
    measures.volume_error = measures.volume_ratio - 1;
    judged.num_triangles = static_cast<int>(rest.triangles.rows());
    measures.folded_triangles = static_cast<int>(
        FoldedTriangles(rest.points, points, rest.triangles).size());
    measures.self_pairs = intersections.self_pairs_of_muscles[0];
    measures.max_contact_displacement = max_contact_displacement;
    measures.depth_without_contact = depth_without_contact;
    measures.push_depth = push_depth;
    measures.pushed_by = pushed_by;
    return musclewarp::Shortcomings(requirements, intersections, {judged});
  }
};

TEST(Shortcomings, AMuscleAtRestHasNone) {
  EXPECT_THAT(Deformed().Shortcomings(), IsEmpty());
}

TEST(Shortcomings, NameTrianglesThatCrossABoneAndWhere) {
  Deformed deformed;
  deformed.bones = {MovedBy(Box(4, 4, 4), {10, 0, 0})};
  const auto shortcomings = deformed.Shortcomings();
  ASSERT_EQ(shortcomings.size(), 1u);
  EXPECT_THAT(shortcomings[0], HasSubstr("psoas x femur: "));
  EXPECT_THAT(shortcomings[0],
              HasSubstr(" crossing triangle pairs around (9."));
  EXPECT_THAT(shortcomings[0], HasSubstr(" mm deep"));
}

TEST(Shortcomings, NameABoneThatLiesInsideWithoutACrossing) {
  Deformed deformed;
  deformed.bones = {Box(2, 2, 2)};
  EXPECT_THAT(deformed.Shortcomings(),
              ElementsAre(HasSubstr("psoas x femur: 0 crossing triangle pairs, "
                                    "8 vertices inside")));
}

TEST(Shortcomings, NameAVolumeThatIsNotKept) {
  Deformed deformed;
  deformed.points *= 1.001;  // 0.3 % more
  EXPECT_THAT(deformed.Shortcomings(),
              ElementsAre("psoas: volume off by 0.003, allowed 0.0004"));
  deformed.points = 1.0001 * deformed.rest.points;
  EXPECT_THAT(deformed.Shortcomings(), IsEmpty());
}

TEST(Shortcomings, NameAVolumeThatIsNoNumber) {
  JudgedMuscle muscle;
  muscle.figures.name = "psoas";
  muscle.figures.volume_ratio = muscle.figures.volume_error = std::nan("");
  EXPECT_THAT(Shortcomings({}, {}, {muscle}),
              ElementsAre(HasSubstr("volume off by nan"),
                          HasSubstr("nan % of its volume")));
}

// The solver keeps the volume that is left: the error is small, the loss is
// not.
TEST(Shortcomings, NameAVolumeThatWasLost) {
  JudgedMuscle muscle;
  muscle.figures.name = "iliacus";
  muscle.delivered_volume = 125300;
  muscle.figures.volume_ratio = 0.44;
  EXPECT_THAT(Shortcomings({}, {}, {muscle}),
              ElementsAre("iliacus: 56 % of its volume of 125 cm3 is lost, "
                          "allowed 6 %"));
  EXPECT_THAT(ShapeShortcomings({}, {muscle}),
              ElementsAre(HasSubstr("is lost")));
  muscle.figures.volume_ratio = 0.95;
  EXPECT_THAT(Shortcomings({}, {}, {muscle}), IsEmpty());
}

TEST(Shortcomings, NameAStretchThatMakesNoSense) {
  JudgedMuscle muscle;
  muscle.figures.name = "psoas";
  muscle.figures.volume_ratio = 1;
  muscle.figures.shape.max_stretch = 8728;
  EXPECT_THAT(ShapeShortcomings({}, {muscle}),
              ElementsAre("psoas: stretched to 8.73e+03 times its length, "
                          "allowed 20"));
}

TEST(Shortcomings, NameBonesThatItsLinesMiss) {
  JudgedMuscle muscle;
  muscle.figures.name = "soleus";
  muscle.figures.volume_ratio = 1;
  muscle.missed_bones = {"soleus misses the calcaneus"};
  EXPECT_THAT(Shortcomings({}, {}, {muscle}),
              ElementsAre("soleus misses the calcaneus"));
  EXPECT_THAT(ShapeShortcomings({}, {muscle}),
              ElementsAre("soleus misses the calcaneus"));
}

TEST(Shortcomings, NameTrianglesThatCrossTheMuscleItself) {
  // A vertex goes through the opposite side. Volume is not what is looked at.
  Deformed deformed;
  deformed.points.row(0) *= -1.05;
  FrameRequirements requirements;
  requirements.max_volume_error = 1;
  requirements.max_folded_fraction = 1;
  EXPECT_THAT(deformed.Shortcomings(requirements),
              ElementsAre(HasSubstr("self-intersecting triangle pairs")));
  // That the mesh came like that is no excuse.
  deformed.rest.points = deformed.points;
  EXPECT_THAT(deformed.Shortcomings(requirements),
              ElementsAre(HasSubstr("self-intersecting triangle pairs")));
}

TEST(Shortcomings, NameTrianglesThatFolded) {
  // A vertex slides over the ring of its neighbours, on the surface.
  Deformed deformed;
  const Eigen::RowVector3i t = deformed.rest.triangles.row(0);
  deformed.points.row(t[0]) +=
      2.5 * (deformed.points.row(t[1]) - deformed.points.row(t[0]));
  FrameRequirements requirements;
  requirements.max_volume_error = 1;
  const auto shortcomings = deformed.Shortcomings(requirements);
  EXPECT_THAT(shortcomings,
              testing::Contains(HasSubstr(" folded triangles, allowed 1")));
  requirements.max_folded_fraction = 1;
  for (const std::string& shortcoming : deformed.Shortcomings(requirements)) {
    EXPECT_EQ(shortcoming.find("folded"), std::string::npos);
  }
}

TEST(Shortcomings, NameAMuscleThatContactMovedTooFar) {
  Deformed deformed;
  deformed.depth_without_contact = 3;
  deformed.max_contact_displacement = 7;  // twice the depth and 1 mm
  EXPECT_THAT(deformed.Shortcomings(), IsEmpty());
  deformed.max_contact_displacement = 7.5;
  EXPECT_THAT(deformed.Shortcomings(),
              ElementsAre("psoas: moved by 7.5 mm by contact, allowed 7 (3 mm "
                          "deep without)"));
}

TEST(Shortcomings, AllowSmallDisplacements) {
  Deformed deformed;
  deformed.depth_without_contact = 0.1;
  deformed.max_contact_displacement = 1.5;
  EXPECT_THAT(deformed.Shortcomings(), IsEmpty());
  deformed.max_contact_displacement = 1.6;
  EXPECT_THAT(deformed.Shortcomings(), ElementsAre(HasSubstr("allowed 1.5 (")));
}

TEST(Shortcomings, AllowAMuscleToBePushedByOthers) {
  Deformed deformed;
  deformed.depth_without_contact = 3;
  deformed.push_depth = 5;
  deformed.pushed_by = {"iliacus", "psoas"};
  // Twice the depth, the 2 mm that the other one adds, and 1 mm.
  deformed.max_contact_displacement = 9;
  EXPECT_THAT(deformed.Shortcomings(), IsEmpty());
  deformed.max_contact_displacement = 9.5;
  EXPECT_THAT(deformed.Shortcomings(),
              ElementsAre("psoas: moved by 9.5 mm by contact, allowed 9 (3 "
                          "mm deep without, 5 mm along the chain iliacus, "
                          "psoas)"));
}

TEST(Shortcomings, NameMeshesThatAreNearerThanTheGap) {
  Deformed deformed;
  const double right = deformed.points.col(0).maxCoeff();
  deformed.bones = {MovedBy(Box(4, 4, 4), {right + 2.043, 0, 0})};
  EXPECT_THAT(deformed.Shortcomings(), IsEmpty());  // no gap is required
  FrameRequirements requirements;
  requirements.gap = 0.1;
  EXPECT_THAT(deformed.Shortcomings(requirements),
              ElementsAre(HasSubstr("psoas and femur are 0.043 mm apart, less "
                                    "than the gap of 0.1 mm, near (")));
  // Digits show that the distance is below the gap, be it by a hair.
  deformed.bones = {MovedBy(Box(4, 4, 4), {right + 2.099999, 0, 0})};
  EXPECT_THAT(deformed.Shortcomings(requirements),
              ElementsAre(HasSubstr("are 0.099999 mm apart")));
  deformed.bones = {MovedBy(Box(4, 4, 4), {right + 2.101, 0, 0})};
  EXPECT_THAT(deformed.Shortcomings(requirements), IsEmpty());
}

// What is proved counts: the distance may be anything between the bounds.
TEST(Shortcomings, TakeTheLowerBoundOfAGap) {
  SceneIntersections intersections;
  intersections.gaps = {{"psoas", "femur", 0.08, 0.12, {}}};
  FrameRequirements requirements;
  requirements.gap = 0.1;
  EXPECT_THAT(Shortcomings(requirements, intersections, {}),
              ElementsAre(HasSubstr("are 0.08 mm apart")));
  intersections.gaps[0].at_least_mm = 0.1;
  EXPECT_THAT(Shortcomings(requirements, intersections, {}), IsEmpty());
}

TEST(Shortcomings, NameASinglePairInWhichAMuscleCrossesItself) {
  JudgedMuscle muscle;
  muscle.figures.name = "psoas";
  muscle.delivered_volume = 1;
  muscle.figures.volume_ratio = 1;
  EXPECT_THAT(Shortcomings({}, {}, {muscle}), IsEmpty());
  muscle.figures.self_pairs = 1;
  EXPECT_THAT(Shortcomings({}, {}, {muscle}), ElementsAre(HasSubstr("psoas")));
}

TEST(Shortcomings, NameACrossingOnceIfAGapIsRequired) {
  Deformed deformed;
  deformed.bones = {MovedBy(Box(4, 4, 4), {10, 0, 0})};
  FrameRequirements requirements;
  requirements.gap = 0.1;
  EXPECT_THAT(deformed.Shortcomings(requirements),
              ElementsAre(HasSubstr("psoas x femur: ")));
}

// A limit of zero forbids nothing: data may ask for more than a muscle bears.
TEST(Shortcomings, TornPatchesCountIfALimitIsGiven) {
  JudgedMuscle muscle;
  muscle.figures.name = "popliteus";
  muscle.figures.volume_ratio = 1;
  muscle.figures.torn_patch = {250, {1, 2, 3}};
  FrameRequirements requirements;
  EXPECT_THAT(Shortcomings(requirements, {}, {muscle}), IsEmpty());
  requirements.max_torn_patch = 250;
  EXPECT_THAT(Shortcomings(requirements, {}, {muscle}), IsEmpty());
  requirements.max_torn_patch = 100;
  EXPECT_THAT(Shortcomings(requirements, {}, {muscle}),
              ElementsAre("popliteus: 2.5 cm2 torn by contact near "
                          "(1.0, 2.0, 3.0), allowed 1 cm2"));
}

TEST(FrameRequirements, NameWhatIsWrong) {
  FrameRequirements requirements;
  std::string error;
  EXPECT_TRUE(requirements.IsValid(&error));
  requirements.max_volume_error = -1;
  EXPECT_FALSE(requirements.IsValid(&error));
  EXPECT_EQ(error,
            "FrameRequirements::max_volume_error is -1, allowed: 0 or above");
  requirements = {};
  requirements.gap = 3;  // gaps are measured up to 2 mm
  EXPECT_FALSE(requirements.IsValid(&error));
  EXPECT_EQ(error, "FrameRequirements::gap is 3, allowed: 0 to 2");
}

TEST(Shortcomings, NameWhatAReconstructionHasLost) {
  JudgedMuscle muscle;
  muscle.figures.name = "psoas";
  muscle.figures.volume_ratio = 1;
  muscle.reconstruction.gone_area = 1500;
  muscle.reconstruction.farthest = 89;
  muscle.reconstruction.lost_extent = 63;
  muscle.reconstruction.lost_attachments = {"femur_r"};
  const std::vector<std::string> found =
      Shortcomings(FrameRequirements(), {}, {muscle});
  ASSERT_EQ(found.size(), 3u);
  EXPECT_EQ(found[0],
            "psoas: 15 cm2 of the muscle are gone, the farthest point 89 mm "
            "away, allowed 1 cm2");
  EXPECT_EQ(
      found[1],
      "psoas: ends 63 mm short of where the delivered mesh ends, allowed 5 mm");
  EXPECT_EQ(found[2], "psoas: is not attached to femur_r any more");
  FrameRequirements generous;
  generous.max_lost_area = 1500;
  generous.max_lost_extent = 63;
  EXPECT_EQ(Shortcomings(generous, {}, {muscle}).size(), 1u);
}

TEST(DeliveredShortcomings, NameBothTheCountsAndThePlace) {
  EXPECT_TRUE(DeliveredShortcomings({}, 1).empty());
  const std::vector<std::string> shortcomings =
      DeliveredShortcomings({{"psoas", "pelvis", 3, 1, {1, 2, 3}}}, 1);
  ASSERT_EQ(shortcomings.size(), 1u);
  EXPECT_NE(shortcomings[0].find(
                "psoas x pelvis as it was delivered: 3 crossing triangle pairs "
                "and 1 piece of the bone inside, around (1.0, 2.0, 3.0)"),
            std::string::npos)
      << shortcomings[0];
}

}  // namespace
}  // namespace musclewarp
