// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/opensim/offset_frames.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <string>

#include "opensim/read_models.h"

namespace musclewarp {
namespace {

using Eigen::AngleAxisd;
using Eigen::Vector3d;

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
  const FrameOnBody thigh = frames.Resolve(xml.root().child("s"), "");
  EXPECT_EQ(thigh.body, 1);
  EXPECT_TRUE(thigh.body_from_frame.isIdentity(0));
  EXPECT_EQ(frames.Resolve(xml.root().child("t"), "").body, 0);
}

TEST(OffsetFrames, FramesOnFramesAreComposed) {
  const OsimXml xml =
      Xml("<a><s>upper</s>" + FrameXml("upper", "lower", "0 0.2 0", "0.3 0 0") +
          FrameXml("lower", "/bodyset/thigh", "0.1 0 0", "0 0 1") + "</a>");
  const Model model = TwoBodies();
  const OffsetFrames frames(xml, model);
  ASSERT_EQ(frames.nodes().size(), 2u);
  const FrameOnBody frame = frames.Resolve(xml.root().child("s"), "");
  EXPECT_EQ(frame.body, 1);
  const Eigen::Matrix4d expected = OffsetTransform({0.1, 0, 0}, {0, 0, 1}) *
                                   OffsetTransform({0, 0.2, 0}, {0.3, 0, 0});
  ExpectNear(frame.body_from_frame, expected);
  ExpectNear(frames.Place(frames.nodes()[0]).body_from_frame, expected);
}

TEST(OffsetFrames, OfSeveralFramesOfOneNameThePathOrTheOwnerDecides) {
  const OsimXml xml =
      Xml("<a><s>f</s><t>/jointset/hip/f</t><PinJoint name=\"hip\">" +
          FrameXml("f", "thigh", "0.1 0 0") +
          "</PinJoint><PinJoint name=\"knee\">" +
          FrameXml("f", "thigh", "0.2 0 0") + "</PinJoint></a>");
  const Model model = TwoBodies();
  const OffsetFrames frames(xml, model);
  const auto x = [&](const char* socket, const char* owner) {
    return frames.Resolve(xml.root().child(socket), owner)
        .body_from_frame(0, 3);
  };
  EXPECT_EQ(x("s", "hip"), 100);
  EXPECT_EQ(x("s", "knee"), 200);
  EXPECT_EQ(x("t", "knee"), 100);
  // The first one, if nothing tells them apart.
  EXPECT_EQ(x("s", "ankle"), 100);
}

TEST(OffsetFrames, RefusesNamesThatNothingHas) {
  ExpectRefused(Replaced(PinModel(),
                         "/bodyset/shank</socket_parent>",
                         "/bodyset/foot</socket_parent>"),
                {"line", "socket_parent", "/bodyset/foot"});
}

TEST(OffsetFrames, RefusesFramesThatRestOnThemselves) {
  const OsimXml xml = Xml("<a>" + FrameXml("f", "g", "0 0 0") +
                          FrameXml("g", "f", "0 0 0") + "</a>");
  const Model model = TwoBodies();
  const OffsetFrames frames(xml, model);
  ExpectInputError([&] { frames.Place(frames.nodes()[0]); },
                   {"part.osim", "PhysicalOffsetFrame", "rests on itself"});
}

}  // namespace
}  // namespace musclewarp
