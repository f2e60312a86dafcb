// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/opensim/offset_frames.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <string>

#include "musclewarp/opensim/component_tree.h"
#include "opensim/read_models.h"

namespace musclewarp {
namespace {

using Eigen::AngleAxisd;
using Eigen::Vector3d;
using ::testing::HasSubstr;

Model TwoBodies() {
  Model model;
  model.bodies.resize(2);
  model.bodies[0].name = "ground";
  model.bodies[1].name = "thigh";
  return model;
}

std::string FrameXml(const std::string& name,
                     const std::string& parent,
                     const std::string& translation,
                     const std::string& orientation = "0 0 0") {
  return "<PhysicalOffsetFrame name=\"" + name + "\"><socket_parent>" + parent +
         "</socket_parent><translation>" + translation +
         "</translation><orientation>" + orientation +
         "</orientation></PhysicalOffsetFrame>";
}

TEST(OffsetTransform, TurnsAboutTurnedAxesAndMovesInTheParent) {
  const Eigen::Matrix4d transform =
      OffsetTransform({0.1, 0.2, 0.3}, {0.4, 0.5, 0.6});
  // The second axis is y after the first rotation, the third is z after both.
  const AngleAxisd first(0.4, Vector3d::UnitX());
  const AngleAxisd second(0.5, first * Vector3d::UnitY());
  const AngleAxisd third(0.6, second * (first * Vector3d::UnitZ()));
  Eigen::Matrix4d expected = Eigen::Matrix4d::Identity();
  expected.topLeftCorner<3, 3>() = (third * second * first).toRotationMatrix();
  expected.topRightCorner<3, 1>() = Vector3d(100, 200, 300);
  ExpectNear(transform, expected);
}

TEST(OffsetFrames, BodiesAndTheGroundAreFramesOfTheirOwn) {
  const OsimXml xml = Xml("<a><s>/bodyset/thigh</s><t>/ground</t></a>");
  const Model model = TwoBodies();
  const OffsetFrames frames(xml, model);
  EXPECT_TRUE(frames.nodes().empty());
  const FrameOnBody thigh = frames.Resolve(xml.root().child("s"));
  EXPECT_EQ(thigh.body, 1);
  EXPECT_TRUE(thigh.body_from_frame.isIdentity(0));
  EXPECT_EQ(frames.Resolve(xml.root().child("t")).body, 0);
}

TEST(OffsetFrames, FramesOnFramesAreComposed) {
  const OsimXml xml =
      Xml("<a><s>upper</s>" + FrameXml("upper", "lower", "0 0.2 0", "0.3 0 0") +
          FrameXml("lower", "/bodyset/thigh", "0.1 0 0", "0 0 1") + "</a>");
  const Model model = TwoBodies();
  const OffsetFrames frames(xml, model);
  ASSERT_EQ(frames.nodes().size(), 2u);
  const FrameOnBody frame = frames.Resolve(xml.root().child("s"));
  EXPECT_EQ(frame.body, 1);
  const Eigen::Matrix4d expected = OffsetTransform({0.1, 0, 0}, {0, 0, 1}) *
                                   OffsetTransform({0, 0.2, 0}, {0.3, 0, 0});
  ExpectNear(frame.body_from_frame, expected);
  ExpectNear(frames.Place(frames.nodes()[0]).body_from_frame, expected);
}

TEST(OffsetFrames, OfSeveralFramesOfOneNameThePathOrTheOwnerDecides) {
  const auto joint = [](const std::string& name, const std::string& x) {
    return "<PinJoint name=\"" + name + "\"><s>f</s><t>/set/hip/f</t>" +
           FrameXml("f", "thigh", x + " 0 0") + "</PinJoint>";
  };
  const OsimXml xml =
      Xml("<a><JointSet name=\"jointset\">" + joint("hip", "0.1") +
          joint("knee", "0.2") + "<PinJoint name=\"ankle\"><s>f</s>" +
          "</PinJoint></JointSet></a>");
  const Model model = TwoBodies();
  const OffsetFrames frames(xml, model);
  const auto x = [&](const std::string& joint_name, const char* socket) {
    const auto owner = FindComponent(xml.root(), "jointset/" + joint_name);
    return frames.Resolve(owner.child(socket)).body_from_frame(0, 3);
  };
  EXPECT_EQ(x("hip", "s"), 100);
  EXPECT_EQ(x("knee", "s"), 200);
  // The set has another name in the file, as in betas.
  EXPECT_EQ(x("knee", "t"), 100);
  // The first one, if nothing tells them apart.
  EXPECT_EQ(x("ankle", "s"), 100);
}

// OpenSim 4 has "..", which leads to the owner of the frame, in models that
// were changed in its editor.
TEST(OffsetFrames, PathsMayBeRelativeToTheOwnerOfTheSocket) {
  const std::string frames_of_thigh =
      "<components>" + FrameXml("f", "..", "0.1 0 0") +
      FrameXml("g", "../f", "0.1 0 0") +
      FrameXml("h", "../../../ground", "0.1 0 0") + "</components>";
  const OsimXml xml = Xml(
      "<Model><Ground name=\"ground\"/><BodySet name=\"bodyset\"><objects>"
      "<Body name=\"thigh\">" +
      frames_of_thigh + "</Body></objects></BodySet><s>bodyset/thigh/g</s>" +
      "<t>/bodyset/thigh/h</t></Model>");
  const Model model = TwoBodies();
  const OffsetFrames frames(xml, model);
  EXPECT_EQ(frames.Place(frames.nodes()[0]).body, 1);
  const FrameOnBody on_frame = frames.Resolve(xml.root().child("s"));
  EXPECT_EQ(on_frame.body, 1);
  EXPECT_EQ(on_frame.body_from_frame(0, 3), 200);
  EXPECT_EQ(frames.Resolve(xml.root().child("t")).body, 0);
}

// A frame may have the name of a body.
TEST(OffsetFrames, APathToABodyIsThatBody) {
  const OsimXml xml =
      Xml("<Model><BodySet name=\"bodyset\"><objects><Body name=\"thigh\">" +
          FrameXml("thigh", "..", "0.1 0 0") + "</Body></objects></BodySet>" +
          "<s>/bodyset/thigh</s><t>/bodyset/thigh/thigh</t></Model>");
  const Model model = TwoBodies();
  const OffsetFrames frames(xml, model);
  const FrameOnBody body = frames.Resolve(xml.root().child("s"));
  EXPECT_EQ(body.body, 1);
  EXPECT_TRUE(body.body_from_frame.isIdentity(0));
  EXPECT_EQ(frames.Resolve(xml.root().child("t")).body_from_frame(0, 3), 100);
}

TEST(OffsetFrames, UnknownNamesAreNoted) {
  const OsimXml xml = Xml("<a>\n<s>/bodyset/foot</s></a>");
  const Model model = TwoBodies();
  const OffsetFrames frames(xml, model);
  const FrameOnBody frame = frames.Resolve(xml.root().child("s"));
  EXPECT_EQ(frame.body, -1);
  EXPECT_THAT(frame.unknown, HasSubstr("\"/bodyset/foot\" in line 2"));
}

TEST(OffsetFrames, FramesThatRestOnThemselvesAreNoted) {
  const OsimXml xml = Xml("<a>" + FrameXml("f", "g", "0 0 0") +
                          FrameXml("g", "f", "0 0 0") + "</a>");
  const Model model = TwoBodies();
  const OffsetFrames frames(xml, model);
  const FrameOnBody frame = frames.Place(frames.nodes()[0]);
  EXPECT_EQ(frame.body, -1);
  EXPECT_THAT(frame.unknown, HasSubstr("rests on itself"));
}

}  // namespace
}  // namespace musclewarp
