// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/page/joints_page.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <nlohmann/json.hpp>

#include "page/packed_text.h"
#include "support/meshes.h"

namespace musclewarp {
namespace {

using OrderedJson = nlohmann::ordered_json;
using ::testing::HasSubstr;
using ::testing::Not;

OrderedJson DataOf(const std::string& html) { return PageJson(html, "joints"); }

Bone MadeBone(const std::string& name,
              const std::string& body,
              const TriangleSoup& mesh) {
  Bone bone;
  bone.name = name;
  bone.body = body;
  bone.side = Side::kRight;
  bone.mesh = mesh;
  return bone;
}

// A pelvis and a femur with a hip, and a tibia whose knee was not found.
Articulation MadeArticulation(const std::string& femur = "femur_r") {
  Articulation made;
  made.bones = {MadeBone("pelvis", "pelvis", Icosphere(40, 2)),
                MadeBone(femur, "femur_r", Icosphere(23, 2)),
                MadeBone("tibia_r", "tibia_r", Icosphere(20, 2))};
  made.bodies = {"pelvis", "femur_r", "tibia_r"};
  made.welds = {{"ground", "pelvis"}, {"femur_r", "tibia_r"}};
  FoundJoint hip;
  hip.parent = "pelvis";
  hip.child = "femur_r";
  hip.center = {1, 2, 3};
  // Forward, up and right in axes that point left, back and up.
  hip.parent_axes << 0, 0, -1, -1, 0, 0, 0, 1, 0;
  hip.child_axes = hip.parent_axes;
  FittedShape socket, head;
  socket.what = "socket";
  socket.is_on_parent = true;
  head.what = "head";
  head.radius = 23;
  hip.shapes = {socket, head};
  FoundJoint knee;
  knee.kind = JointKind::kKnee;
  knee.parent = "femur_r";
  knee.child = "tibia_r";
  knee.verdict.Fail("</script><img src=x onerror=alert(1)> no condyles");
  made.joints = {hip, knee};
  made.notes = {"a note"};
  return made;
}

JointsPageOptions OptionsWithAxes(const std::string& axes) {
  JointsPageOptions options;
  options.name = "somebody";
  options.axes = axes;
  return options;
}

TEST(JointsPage, HoldsJointsAndBones) {
  const Articulation made = MadeArticulation();
  const std::string html = JointsPageHtml(made, OptionsWithAxes("LPS"));
  EXPECT_THAT(html, HasSubstr("<!doctype html>"));
  EXPECT_THAT(html, HasSubstr("Made by musclewarp-articulate."));
  EXPECT_THAT(html, Not(HasSubstr("musclewarp:data")));
  EXPECT_THAT(html, Not(HasSubstr("{{")));
  const OrderedJson data = DataOf(html);
  EXPECT_EQ(data["name"], "somebody");
  ASSERT_EQ(data["bones"].size(), 3u);
  EXPECT_EQ(data["bones"][1]["body"], "femur_r");
  const std::string numbers = ScriptText(html, "numbers");
  const double step = data["step_mm"];
  for (std::size_t i = 0; i < made.bones.size(); ++i) {
    const Points& points = made.bones[i].mesh.points;
    const std::vector<int> packed =
        UnpackedNumbers(numbers, data["bones"][i]["points"]);
    ASSERT_EQ(packed.size(), static_cast<std::size_t>(points.size()));
    for (Eigen::Index k = 0; k < points.size(); ++k) {
      EXPECT_NEAR(packed[k] * step, points(k / 3, k % 3), step);
    }
  }
}

// What the page needs to move bones, and what it says of joints.
TEST(JointsPage, HasTheReportOfTheJoints) {
  const OrderedJson file = DataOf(JointsPageHtml(
      MadeArticulation(), OptionsWithAxes("LPS")))["joints_file"];
  EXPECT_EQ(file["bodies"], OrderedJson({"pelvis", "femur_r", "tibia_r"}));
  EXPECT_EQ(file["welds"][1]["parent"], "femur_r");
  EXPECT_EQ(file["welds"][1]["child"], "tibia_r");
  EXPECT_EQ(file["notes"][0], "a note");
  const OrderedJson& hip = file["joints"][0];
  EXPECT_EQ(hip["shapes"][0]["body"], "pelvis");
  EXPECT_EQ(hip["shapes"][1]["body"], "femur_r");
  const OrderedJson& flexion = hip["coordinates"][0];
  EXPECT_EQ(flexion["name"], "hip_flexion_r");
  EXPECT_EQ(flexion["axis_in_joint"], OrderedJson({0.0, 0.0, 1.0}));
  EXPECT_EQ(flexion["axis"], OrderedJson({-1.0, 0.0, 0.0}));
  const OrderedJson& knee = file["joints"][1];
  EXPECT_EQ(knee["quality"], "failed");
  EXPECT_THAT(knee["reasons"][0].get<std::string>(), HasSubstr("no condyles"));
}

TEST(JointsPage, NeedsNothingFromAnywhere) {
  const std::string html =
      JointsPageHtml(MadeArticulation(), OptionsWithAxes("LPS"));
  EXPECT_THAT(html, HasSubstr("default-src 'none'"));
  for (const char* reference :
       {" src=\"", "url(http", "@import", "href=\"http", "import(\"http"}) {
    EXPECT_THAT(html, Not(HasSubstr(reference)));
  }
}

TEST(JointsPage, TextsCannotEndTheScript) {
  const std::string name = "<img src=x onerror=alert(1)><!--<script>";
  const std::string html =
      JointsPageHtml(MadeArticulation(name), OptionsWithAxes("LPS"));
  EXPECT_THAT(html, Not(HasSubstr("<img src=x")));
  const OrderedJson data = DataOf(html);
  EXPECT_EQ(data["bones"][1]["name"], name);
  EXPECT_THAT(data["joints_file"]["joints"][1]["reasons"][0].get<std::string>(),
              HasSubstr("</script><img src=x"));
}

TEST(JointsPage, ViewsFollowTheAxesOrTheJoints) {
  const auto right = [](const Articulation& made, const std::string& axes) {
    const OrderedJson data =
        DataOf(JointsPageHtml(made, OptionsWithAxes(axes)));
    const OrderedJson& view = data["views"]["right"]["toward_viewer"];
    return Eigen::Vector3d(view[0], view[1], view[2]);
  };
  Articulation made = MadeArticulation();
  EXPECT_EQ(right(made, "LPS"), Eigen::Vector3d(-1, 0, 0));
  EXPECT_EQ(right(made, "ASR"), Eigen::Vector3d(0, 0, 1));
  made.joints[0].parent_axes.setIdentity();
  EXPECT_EQ(right(made, ""), Eigen::Vector3d(0, 0, 1));
  // Without axes and joints it is a guess.
  made.joints.erase(made.joints.begin());
  EXPECT_EQ(right(made, ""), Eigen::Vector3d(-1, 0, 0));
}

}  // namespace
}  // namespace musclewarp
