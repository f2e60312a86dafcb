// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <vector>

#include "musclewarp/joints/joint_limits.h"

namespace musclewarp {
namespace {

constexpr JointQuality kGood = JointQuality::kGood;
constexpr JointQuality kWeak = JointQuality::kWeak;
constexpr JointQuality kFailed = JointQuality::kFailed;

// What bones have been measured to have, or have by geometry, and what a joint
// then is. Each limit lies between two of them, which are less than twice apart
// from it.
struct Evidence {
  double value;
  JointQuality expected;
  const char* why;
};

void ExpectJudgedBy(const JointSign& sign,
                    const std::vector<Evidence>& evidence) {
  for (const Evidence& known : evidence) {
    EXPECT_EQ(QualityOf({sign, known.value}), known.expected) << known.why;
  }
}

// The persons are those of benchmarks/joint_accuracy.md.
TEST(JointEvidence, OfTheHip) {
  const HipLimits& hip = kJointLimits.hip;
  ExpectJudgedBy(hip.coverage,
                 {{64, kGood, "the most of three whole heads"},
                  {58, kGood, "the least of three whole heads"},
                  {37, kWeak, "the most without the medial third"},
                  {33, kWeak, "the least without the medial third"},
                  {24, kFailed, "the next best place of a femur"}});
  ExpectJudgedBy(hip.ball,
                 {{64, kGood, "the most of three whole heads"},
                  {100, kFailed, "a ball has no neck"}});
  ExpectJudgedBy(hip.spread,
                 {{0.5, kGood, "the most of three persons"},
                  {1.0, kWeak, "twice as much"}});
  ExpectJudgedBy(hip.distance,
                 {{1.2, kGood, "the widest of three sockets"},
                  {2.0, kFailed, "a gap as wide as the head is thick"}});
  ExpectJudgedBy(hip.offset,
                 {{2.0, kGood, "the cartilage of one side, as on an edge"},
                  {3.7, kWeak, "BodyParts3D"},
                  {5.0, kWeak, "TLEM2, whose head and socket are apart"}});
}

TEST(JointEvidence, OfTheKnee) {
  const KneeLimits& knee = kJointLimits.knee;
  ExpectJudgedBy(knee.back_to_front,
                 {{2.0, kGood, "condyles 34 mm back, a front 17 mm forward"},
                  {1.0, kFailed, "a shaft"}});
  ExpectJudgedBy(knee.length,
                 {{17, kGood, "395 mm by 23 mm"},
                  {10, kGood, "three fifths of that: short limbs"},
                  {6, kFailed, "the upper third of a femur"}});
  ExpectJudgedBy(knee.turn,
                 {{20, kGood, "starts at 7 degrees about two axes, and again"},
                  {45, kFailed, "as much to the back as to the left"}});
  // Centres of condyles are 45 mm apart.
  ExpectJudgedBy(knee.sphere_angle,
                 {{2.4, kGood, "the most of good knees"},
                  {3.0, kGood, "each centre off by 1.2 mm"},
                  {8.0, kWeak, "an osteophyte of 6 mm on one of them"},
                  {15, kWeak, "both off by 6 mm"},
                  {30, kFailed, "both off by more than half a condyle"}});
  ExpectJudgedBy(knee.angle,
                 {{115, kGood, "the least of three persons"},
                  {50, kWeak, "less than half of that"},
                  {20, kFailed, "twice what the wrong end had"}});
  ExpectJudgedBy(knee.spread,
                 {{0.8, kGood, "the most of three persons"},
                  {1.6, kWeak, "twice as much"}});
  ExpectJudgedBy(knee.gap,
                 {{1.2, kGood, "the largest condyles"},
                  {2.7, kFailed, "the thickness of condyles below them"}});
}

TEST(JointEvidence, OfThePatella) {
  const PatellaLimits& patella = kJointLimits.patella;
  ExpectJudgedBy(
      patella.spread,
      {{1.3, kGood, "the most of two persons"}, {2.6, kWeak, "twice as much"}});
  // The angle of the patella is found every 5 degrees of the knee.
  ExpectJudgedBy(patella.held_back,
                 {{4, kGood, "less than a step is no step"},
                  {7.5, kWeak, "a step is missing"}});
}

TEST(JointEvidence, OfTheAnkle) {
  const AnkleLimits& ankle = kJointLimits.ankle;
  ExpectJudgedBy(ankle.angle,
                 {{100, kGood, "TLEM2, flattened, which other signs tell"},
                  {50, kWeak, "half of that"}});
  ExpectJudgedBy(ankle.radius,
                 {{0.9, kGood, "LHDL"},
                  {1.3, kWeak, "TLEM2, flattened and off by 6 mm"},
                  {1.4, kWeak, "the other side, off by 7 mm"}});
  ExpectJudgedBy(ankle.spread,
                 {{0.4, kGood, "LHDL and BodyParts3D"}, {0.6, kWeak, "TLEM2"}});
  // Isman and Inman (1969): the axis passes 5 mm (deviation 3) below the inner
  // tip and 3 mm (deviation 2) below the outer one, of a leg whose head has a
  // radius of 23 mm.
  ExpectJudgedBy(ankle.height,
                 {{4 / 23.0, kGood, "the mean of the tips"},
                  {9 / 23.0, kWeak, "two deviations more on both sides"}});
}

TEST(JointEvidence, OfTheFoot) {
  const SubtalarLimits& subtalar = kJointLimits.subtalar;
  ExpectJudgedBy(subtalar.facet,
                 {{203, kWeak, "TLEM2, off by 8 degrees"},
                  {168, kWeak, "BodyParts3D"},
                  {125.1, kWeak, "TLEM2, off by 11 degrees"},
                  {300, kGood, "20 mm by 15 mm, as facets are"}});
  // A centre off by 1.2 mm turns an axis between centres 23 mm apart by 3
  // degrees, which good ones are within, and 46 mm apart by half of that.
  ExpectJudgedBy(subtalar.distance, {{2, kGood, "46 mm"}, {1, kWeak, "23 mm"}});
}

TEST(JointEvidence, OfTheArm) {
  const ShoulderLimits& shoulder = kJointLimits.shoulder;
  ExpectJudgedBy(shoulder.coverage,
                 {{50, kGood, "a head is half a ball"},
                  {42, kGood, "BodyParts3D"},
                  {30, kWeak, "a head without a third"},
                  {20, kFailed, "two fifths of a head"}});
  ExpectJudgedBy(shoulder.spread,
                 {{0.5, kGood, "BodyParts3D"}, {1.0, kWeak, "twice as much"}});
  // The trochlear notch of the ulna goes half around.
  const ElbowLimits& elbow = kJointLimits.elbow;
  ExpectJudgedBy(elbow.angle,
                 {{180, kGood, "all of the notch"},
                  {90, kWeak, "half of it"},
                  {45, kFailed, "a quarter of it"}});
  ExpectJudgedBy(elbow.spread,
                 {{1.2, kGood, "as far as points are apart"},
                  {2.4, kWeak, "twice as much"}});
  // Points stand for 1.4 mm2 each.
  ExpectJudgedBy(kJointLimits.forearm.not_facing,
                 {{14, kGood, "a spot 5 mm across"},
                  {7, kFailed, "one of 3.5 mm: the rim of another head"}});
}

TEST(JointEvidence, OfBothSides) {
  ExpectJudgedBy(kJointLimits.sides.radius,
                 {{6, kGood, "condyles of 20 mm that are off by a voxel"},
                  {10.4, kWeak, "the knees of TLEM2"}});
}

TEST(JointEvidence, OfAllThatIsSeenOrNot) {
  for (const JointSign& sign : {kJointLimits.hip.no_socket,
                                kJointLimits.hip.no_axes,
                                kJointLimits.knee.is_up_unknown,
                                kJointLimits.shoulder.no_axes,
                                kJointLimits.elbow.no_right}) {
    EXPECT_EQ(QualityOf({sign}), kWeak) << sign.weak_sentence;
    EXPECT_EQ(QualityOf({sign, 0}), kGood) << sign.weak_sentence;
  }
  for (const JointSign& sign : {kJointLimits.knee.no_cylinder,
                                kJointLimits.patella.no_knee,
                                kJointLimits.patella.no_groove,
                                kJointLimits.ankle.not_facing,
                                kJointLimits.subtalar.no_spheres}) {
    EXPECT_EQ(QualityOf({sign}), kFailed) << sign.failed_sentence;
    EXPECT_EQ(QualityOf({sign, 0}), kGood) << sign.failed_sentence;
  }
}

}  // namespace
}  // namespace musclewarp
