// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/scene/scene_checks.h"

#include <gtest/gtest.h>

#include <functional>
#include <limits>

#include "support/input_errors.h"

namespace musclewarp {
namespace {

// One muscle from the pelvis to the femur, which one pose moves.
Scene GoodScene() {
  Scene scene;
  scene.name = "hip";
  scene.path = "scene.json";
  scene.muscles.resize(1);
  SceneMuscle& muscle = scene.muscles[0];
  muscle.name = "iliacus";
  muscle.lines.resize(1);
  muscle.lines[0].name = "line";
  muscle.lines[0].rest.resize(2, 3);
  muscle.lines[0].rest << 0, 0, 0, 0, 0, 9;
  muscle.lines[0].bodies = {"pelvis", "femur"};
  scene.bones.resize(2);
  scene.bones[0].name = scene.bones[0].body = "pelvis";
  scene.bones[1].name = scene.bones[1].body = "femur";
  scene.poses.resize(1);
  scene.poses[0].name = "bent";
  scene.poses[0].bodies["femur"] = Eigen::Matrix4d::Identity();
  scene.poses[0].lines["line"] = muscle.lines[0].rest;
  return scene;
}

// Expects that the good scene is refused once it has been changed.
void ExpectSceneRefused(const std::function<void(Scene*)>& change,
                        std::vector<std::string> words) {
  Scene scene = GoodScene();
  change(&scene);
  words.push_back("scene.json: ");
  ExpectInputError([&] { CheckScene(scene); }, words);
}

// How often a text is in the message of a scene that is refused.
int CountInMessage(const Scene& scene, const std::string& text) {
  try {
    CheckScene(scene);
  } catch (const InputError& error) {
    const std::string message = error.what();
    int count = 0;
    for (size_t at = message.find(text); at != std::string::npos;
         at = message.find(text, at + 1)) {
      ++count;
    }
    return count;
  }
  return 0;
}

TEST(CheckScene, AcceptsAGoodScene) { CheckScene(GoodScene()); }

TEST(CheckScene, RefusesNamesThatCannotBeWritten) {
  ExpectSceneRefused([](Scene* s) { s->muscles[0].name = "a\nb"; },
                     {"muscle", R"("a\nb")", "control character"});
  ExpectSceneRefused([](Scene* s) { s->bones[0].name = "a/b"; },
                     {"bone", "\"a/b\"", "file name"});
  ExpectSceneRefused([](Scene* s) { s->bones[0].name = std::string(201, 'x'); },
                     {"bone", "201 bytes"});
  ExpectSceneRefused([](Scene* s) { s->muscles[0].lines[0].name = "a\tb"; },
                     {"line of muscle iliacus", R"("a\tb")"});
  ExpectSceneRefused([](Scene* s) { s->poses[0].name = "a\rb"; },
                     {"pose", R"("a\rb")"});
  ExpectSceneRefused([](Scene* s) { s->name = std::string("a\0", 2); },
                     {"scene", R"("a\u0000")"});
}

TEST(CheckScene, RefusesNamesThatAreGivenTwice) {
  ExpectSceneRefused([](Scene* s) { s->muscles[0].name = "femur"; },
                     {"\"femur\"", "twice"});
  ExpectSceneRefused([](Scene* s) { s->poses.push_back(s->poses[0]); },
                     {"pose \"bent\"", "twice"});
  ExpectSceneRefused(
      [](Scene* s) { s->muscles[0].lines.push_back(s->muscles[0].lines[0]); },
      {"line \"line\"", "twice"});
}

TEST(CheckScene, RefusesCoordinatesBeyondTheLimit) {
  // From a model they come without the checks of a scene file.
  const double too_far = 1e9;
  ExpectSceneRefused(
      [&](Scene* s) { s->muscles[0].lines[0].rest(1, 2) = too_far; },
      {"line \"line\" of muscle iliacus: point 1", "1e+09", "1e7"});
  ExpectSceneRefused(
      [&](Scene* s) { s->poses[0].lines["line"](0, 1) = too_far; },
      {"target of line \"line\" in pose \"bent\": point 0"});
  ExpectSceneRefused(
      [&](Scene* s) { s->poses[0].bodies["femur"](0, 3) = too_far; },
      {"pose \"bent\": body \"femur\"", "1e+09"});
  ExpectSceneRefused(
      [](Scene* s) {
        s->poses[0].bodies["femur"](0, 0) =
            std::numeric_limits<double>::quiet_NaN();
      },
      {"pose \"bent\": body \"femur\""});
  ExpectSceneRefused(
      [&](Scene* s) {
        Attachment attachment;
        attachment.body = "femur";
        attachment.points = Points::Constant(1, 3, too_far);
        s->muscles[0].attachments.push_back(attachment);
      },
      {"attachment of muscle iliacus: point 0"});
}

TEST(CheckScene, BodiesThatPosesMoveNeedNoBone) {
  Scene scene = GoodScene();
  scene.bones.pop_back();
  CheckScene(scene);
  scene.muscles[0].attachments.resize(1);
  scene.muscles[0].attachments[0].body = "femur";
  CheckScene(scene);
}

TEST(CheckScene, RefusesToEndOnWhatIsNoOtherMuscle) {
  ExpectSceneRefused([](Scene* s) { s->muscles[0].ends_on = {{"tendon"}}; },
                     {"\"ends_on\" of muscle iliacus", "\"tendon\""});
  ExpectSceneRefused([](Scene* s) { s->muscles[0].ends_on = {{"iliacus"}}; },
                     {"\"ends_on\" of muscle iliacus", "\"iliacus\""});
  Scene scene = GoodScene();
  scene.muscles[0].ends_on.emplace();
  CheckScene(scene);
}

TEST(CheckScene, RefusesToEndOnOtherThanTwoBodiesWithBones) {
  ExpectSceneRefused([](Scene* s) { s->muscles[0].end_bodies = {"femur"}; },
                     {"\"end_bodies\" of muscle iliacus", "two"});
  ExpectSceneRefused(
      [](Scene* s) {
        s->muscles[0].end_bodies = {"pelvis", "thing"};
      },
      {"\"end_bodies\" of muscle iliacus", "\"thing\""});
}

TEST(CheckScene, RefusesBodiesOfWhichNothingIsKnown) {
  ExpectSceneRefused(
      [](Scene* s) { s->muscles[0].lines[0].bodies[1] = "tibia"; },
      {"line \"line\"", "\"tibia\"", "known bodies: femur, pelvis"});
  ExpectSceneRefused(
      [](Scene* s) {
        s->muscles[0].attachments.resize(1);
        s->muscles[0].attachments[0].body = "tibia";
      },
      {"attachment of muscle iliacus", "\"tibia\""});
  // A misspelt body of a pose would stay where it is in silence.
  ExpectSceneRefused(
      [](Scene* s) {
        s->poses[0].bodies["femr"] = Eigen::Matrix4d::Identity();
      },
      {"pose \"bent\"",
       "\"femr\"",
       "; did you mean femur? bodies in use: femur, pelvis"});
}

TEST(CheckScene, RefusesLinesThatAreNone) {
  ExpectSceneRefused(
      [](Scene* s) { s->muscles[0].lines[0].rest.conservativeResize(1, 3); },
      {"1 points", "at least 2"});
  ExpectSceneRefused([](Scene* s) { s->muscles[0].lines[0].rest.setZero(); },
                     {"repeats point 0 as point 1"});
  ExpectSceneRefused([](Scene* s) { s->muscles[0].lines[0].bodies.pop_back(); },
                     {"1 bodies for 2 points"});
  ExpectSceneRefused(
      [](Scene* s) { s->poses[0].lines["line"].conservativeResize(1, 3); },
      {"has 1 points, the rest line has 2"});
  ExpectSceneRefused([](Scene* s) { s->poses[0].lines["other"] = Points(); },
                     {"\"other\"", "no muscle"});
}

TEST(CheckScene, NamesTheFileOnce) {
  Scene scene = GoodScene();
  scene.muscles[0].lines[0].bodies[1] = "tibia";
  EXPECT_EQ(CountInMessage(scene, "scene.json"), 1);
  scene = GoodScene();
  scene.poses[0].bodies["femr"] = Eigen::Matrix4d::Identity();
  EXPECT_EQ(CountInMessage(scene, "scene.json"), 1);
}

TEST(CheckScene, RefusesMotionsThatAreNotRigid) {
  ExpectSceneRefused([](Scene* s) { s->poses[0].bodies["femur"](0, 0) = 2; },
                     {"pose \"bent\": body \"femur\"", "not a rigid motion"});
}

TEST(CheckScene, NamesASceneInMemoryWithoutAFile) {
  Scene scene = GoodScene();
  scene.path.clear();
  scene.muscles[0].name = "femur";
  ExpectInputError([&] { CheckScene(scene); }, {"the scene: ", "given twice"});
}

// Names that would give a column of a table twice.
TEST(CheckScene, RefusesNamesThatShareAColumn) {
  ExpectSceneRefused([](Scene* s) { s->muscles[0].name = "time"; },
                     {"the column \"time\" twice", "the muscle \"time\""});
  ExpectSceneRefused([](Scene* s) { s->muscles[0].lines[0].name = "time"; },
                     {"the column \"time\" twice", "the line \"time\""});
  ExpectSceneRefused(
      [](Scene* s) {
        ActionLine other = s->muscles[0].lines[0];
        s->muscles[0].lines[0].name = "a b";
        other.name = "a_b";
        s->muscles[0].lines.push_back(other);
        s->poses.clear();
      },
      {"the column \"a_b\" twice", "\"a b\"", "choose another name"});
  ExpectSceneRefused(
      [](Scene* s) {
        ActionLine other = s->muscles[0].lines[0];
        other.name += "_path";
        s->muscles[0].lines.push_back(other);
      },
      {"_path\" twice"});
}

TEST(CheckPose, TakesAPoseThatTheSceneDoesNotHave) {
  const Scene scene = GoodScene();
  ScenePose pose;
  CheckPose(scene, pose);
  pose.bodies["femur"] = Eigen::Matrix4d::Identity();
  pose.lines["line"] = scene.muscles[0].lines[0].rest;
  CheckPose(scene, pose);
}

TEST(CheckPose, RefusesUnknownBodiesAndLinesOfOtherSizes) {
  const Scene scene = GoodScene();
  ScenePose pose;
  pose.name = "odd";
  pose.bodies["tibia"] = Eigen::Matrix4d::Identity();
  ExpectInputError([&] { CheckPose(scene, pose); },
                   {"scene.json: ", "pose \"odd\"", "tibia", "in use"});
  pose.bodies.clear();
  pose.lines["line"] = Points::Zero(3, 3);
  ExpectInputError([&] { CheckPose(scene, pose); },
                   {"\"line\"", "has 3 points"});
}

}  // namespace
}  // namespace musclewarp
