// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/phantom/stress_scenes.h"

#include <glog/logging.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <functional>
#include <map>
#include <utility>

#include "musclewarp/phantom/scene_parts.h"

namespace musclewarp {
namespace {

using Eigen::Vector3d;
using phantom::Field;
using phantom::SweepNode;

constexpr char kGround[] = "ground";
constexpr char kArm[] = "arm";

// A scene under construction, to which meshes are added with their lines,
// bodies and poses.
class StressScene {
 public:
  StressScene(const std::string& name, uint32_t seed) : seed_(seed) {
    made_.scene.name = name;
    made_.scene.axes = "RAS";
  }

  // Adds a muscle along a curve. Each node moves with a body, and the muscle is
  // attached to the bodies of the first and the last node.
  void AddSpindle(const std::string& name,
                  const std::vector<SweepNode>& nodes,
                  const std::vector<std::string>& bodies,
                  double cell) {
    Eigen::AlignedBox3d box;
    for (const SweepNode& node : nodes) {
      box.extend(node.centre + Vector3d::Constant(2 * node.radius));
      box.extend(node.centre - Vector3d::Constant(2 * node.radius));
    }
    ActionLine line;
    line.name = name + "_line";
    line.bodies = bodies;
    line.rest.resize(nodes.size(), 3);
    for (size_t i = 0; i < nodes.size(); ++i) {
      line.rest.row(i) = nodes[i].centre.transpose();
    }
    AddMuscle({name, phantom::Sweep(nodes), box, cell, {}}, {line});
  }

  // Adds a muscle that is attached at the ends of its lines.
  void AddMuscle(const phantom::Solid& solid, std::vector<ActionLine> lines) {
    PhantomMesh mesh = phantom::MeshOf(solid, seed_ + made_.meshes.size());
    SceneMuscle muscle = phantom::MuscleOf(mesh, std::move(lines));
    muscle.attachments = phantom::AttachmentsAtEnds(mesh, muscle.lines);
    made_.scene.muscles.push_back(std::move(muscle));
    made_.meshes.push_back(std::move(mesh));
  }

  // Adds a bone. Precondition: all muscles have been added.
  void AddBone(const std::string& name,
               const Field& field,
               const Eigen::AlignedBox3d& box,
               double cell,
               const std::string& body,
               double roughness = 0.25) {
    made_.meshes.push_back(phantom::MeshOf(
        {name, field, box, cell, {}, roughness}, seed_ + made_.meshes.size()));
    made_.scene.bones.push_back({name, {}, {}, body, name + ".ply"});
  }

  // Adds a ball at the end of a muscle, to which the muscle is attached.
  void AddKnob(const std::string& name,
               const Vector3d& centre,
               const std::string& body) {
    constexpr double kRadius = 8;
    AddBone(name,
            phantom::Sphere(centre, kRadius),
            {centre - Vector3d::Constant(1.4 * kRadius),
             centre + Vector3d::Constant(1.4 * kRadius)},
            2.5,
            body);
  }

  void AddPose(const std::string& name,
               const std::map<std::string, Eigen::Matrix4d>& bodies) {
    ScenePose pose;
    pose.name = name;
    pose.time = static_cast<double>(made_.scene.poses.size());
    pose.bodies = bodies;
    made_.scene.poses.push_back(pose);
  }

  // Adds a pose for each rotation of the arm about an axis, degrees.
  void AddTurns(const Vector3d& centre,
                const Vector3d& axis,
                const std::vector<int>& angles) {
    for (const int angle : angles) {
      AddPose("turn_" + std::to_string(angle),
              {{kArm, phantom::RotationAbout(centre, axis, angle)}});
    }
  }

  PhantomScene Made() const { return made_; }

 private:
  uint32_t seed_;
  PhantomScene made_;
};

Field Block(const Vector3d& half_size) {
  Field block = phantom::HalfSpace(Vector3d::UnitX(), half_size.x());
  block = phantom::Intersection(
      block, phantom::HalfSpace(-Vector3d::UnitX(), half_size.x()), 0);
  for (const int k : {1, 2}) {
    for (const double sign : {1.0, -1.0}) {
      block = phantom::Intersection(
          block, phantom::HalfSpace(sign * Vector3d::Unit(k), half_size[k]), 0);
    }
  }
  return block;
}

Field MovedTo(const Vector3d& place, Field field) {
  return [place, field = std::move(field)](const Vector3d& p) {
    return field(p - place);
  };
}

Eigen::AlignedBox3d BoxAround(const Vector3d& centre,
                              const Vector3d& half_size) {
  return {centre - half_size, centre + half_size};
}

// Three muscles run from a common base upward and apart. Their lower ends have
// a radius of 12 mm and are 14 mm from each other.
void Attachment3(StressScene* scene) {
  for (int i = 0; i < 3; ++i) {
    const Vector3d out =
        Eigen::AngleAxisd(i * 2 * M_PI / 3, Vector3d::UnitZ()) *
        Vector3d::UnitX();
    std::vector<SweepNode> nodes;
    for (const auto& [z, r, radius] :
         {std::tuple(2, 8, 12), {30, 12, 12}, {60, 18, 10}, {85, 24, 7}}) {
      nodes.push_back(
          {double(r) * out + double(z) * Vector3d::UnitZ(), double(radius)});
    }
    scene->AddSpindle("muscle_" + std::to_string(i + 1),
                      nodes,
                      {kGround, kGround, kArm, kArm},
                      2.5);
  }
  const Vector3d base(0, 0, -8), arm(0, 0, 100);
  scene->AddBone(
      "base",
      MovedTo(base, phantom::Ellipsoid(Vector3d::Zero(), {45, 45, 10})),
      BoxAround(base, {50, 50, 14}),
      3,
      kGround);
  scene->AddBone(
      "arm",
      MovedTo(arm, phantom::Ellipsoid(Vector3d::Zero(), {40, 40, 12})),
      BoxAround(arm, {45, 45, 16}),
      3,
      kArm);
  scene->AddTurns({0, 0, 45}, Vector3d::UnitY(), {0, 15, 30});
}

// A muscle runs over a wedge; the arm pulls it down on the other side.
void Edge(StressScene* scene) {
  scene->AddSpindle(
      "muscle",
      {{{-55, 0, 8}, 6}, {{-20, 0, 9}, 11}, {{20, 0, 9}, 11}, {{55, 0, 8}, 6}},
      {kGround, kGround, kArm, kArm},
      2.5);
  // The edge runs along y, has about 60 degrees, and is slightly rounded.
  Field wedge = phantom::Intersection(
      phantom::HalfSpace(Vector3d(2, 0, 1).normalized(), 0),
      phantom::HalfSpace(Vector3d(-2, 0, 1).normalized(), 0),
      1);
  wedge = phantom::Intersection(
      wedge, phantom::HalfSpace(-Vector3d::UnitZ(), 40), 1);
  for (const double sign : {1.0, -1.0}) {
    wedge = phantom::Intersection(
        wedge, phantom::HalfSpace(sign * Vector3d::UnitY(), 30), 1);
  }
  scene->AddBone(
      "wedge", wedge, BoxAround({0, 0, -20}, {30, 36, 28}), 2, kGround);
  scene->AddKnob("knob", {66, 0, 6}, kArm);
  scene->AddTurns({0, 0, -10}, Vector3d::UnitY(), {0, 20, 40, 60});
}

// A rod turns in the plane of the muscle's axis; its end passes 6 mm inside the
// muscle.
void SweepPast(StressScene* scene) {
  scene->AddSpindle(
      "muscle",
      {{{-60, 0, 0}, 6}, {{-25, 0, 0}, 12}, {{25, 0, 0}, 12}, {{60, 0, 0}, 6}},
      {kGround, kGround, kGround, kGround},
      2.5);
  scene->AddKnob("knob_left", {-70, 0, 0}, kGround);
  scene->AddKnob("knob_right", {70, 0, 0}, kGround);
  const Vector3d hinge(0, 0, 70);
  scene->AddBone("rod",
                 phantom::Sweep({{hinge, 8}, {{-56, 0, 70}, 8}}),
                 BoxAround({-27, 0, 70}, {42, 15, 15}),
                 2.5,
                 kArm);
  scene->AddTurns(hinge, -Vector3d::UnitY(), {0, 30, 60, 90, 120, 150});
}

// A thin sheet is between two bones that come 2 mm nearer and slide.
void Sheet(StressScene* scene) {
  const auto line = [](const std::string& name, double y) {
    ActionLine made;
    made.name = name;
    made.bodies = {kGround, kGround, kArm, kArm};
    made.rest.resize(4, 3);
    made.rest << -36, y, 0, -12, y, 0, 12, y, 0, 36, y, 0;
    return made;
  };
  scene->AddMuscle({"sheet",
                    phantom::Ellipsoid(Vector3d::Zero(), {46, 34, 2.4}),
                    BoxAround(Vector3d::Zero(), {50, 38, 5}),
                    1.4,
                    {}},
                   {line("left", -12), line("right", 12)});
  const Vector3d below(-8, 0, -14), above(8, 0, 14);
  scene->AddBone(
      "below",
      MovedTo(below, phantom::Ellipsoid(Vector3d::Zero(), {30, 40, 12.5})),
      BoxAround(below, {36, 46, 18}),
      2.5,
      kGround);
  scene->AddBone(
      "above",
      MovedTo(above, phantom::Ellipsoid(Vector3d::Zero(), {30, 40, 12.5})),
      BoxAround(above, {36, 46, 18}),
      2.5,
      kArm);
  for (const int i : {0, 1, 2}) {
    Eigen::Matrix4d shift = Eigen::Matrix4d::Identity();
    shift.topRightCorner<3, 1>() = i * Vector3d(5, 0, -1);
    scene->AddPose("step_" + std::to_string(i), {{kArm, shift}});
  }
}

// A plate of 1 mm is between two muscles, which reach 3 to 4 mm beyond it. The
// plate turns and comes nearer to one of them.
void Plate(StressScene* scene) {
  for (const int side : {-1, 1}) {
    scene->AddSpindle(side < 0 ? "below" : "above",
                      {{{-45, 0, 8.0 * side}, 5},
                       {{-18, 0, 6.0 * side}, 10},
                       {{18, 0, 6.0 * side}, 10},
                       {{45, 0, 8.0 * side}, 5}},
                      {kGround, kGround, kGround, kGround},
                      2.5);
  }
  scene->AddKnob("knob_left", {-54, 0, 0}, kGround);
  scene->AddKnob("knob_right", {54, 0, 0}, kGround);
  scene->AddBone("plate",
                 Block({48, 20, 0.5}),
                 BoxAround(Vector3d::Zero(), {54, 26, 5}),
                 0.55,
                 kArm,
                 /*roughness=*/0);
  for (const int i : {0, 1, 2}) {
    Eigen::Matrix4d pose =
        phantom::RotationAbout(Vector3d::Zero(), Vector3d::UnitX(), 10 * i);
    pose(2, 3) += i;
    scene->AddPose("step_" + std::to_string(i), {{kArm, pose}});
  }
}

// Three muscles, with edges of 6, 2 and 0.6 mm, are 6 mm into each other beside
// a bone.
void Resolution(StressScene* scene) {
  const auto spindle = [&](const std::string& name, double y, double cell) {
    scene->AddSpindle(name,
                      {{{-40, y, 0}, 6},
                       {{-15, y, 0}, 10},
                       {{15, y, 0}, 10},
                       {{40, y, 0}, 6}},
                      {kGround, kGround, kArm, kArm},
                      cell);
  };
  spindle("coarse", -14, 6);
  spindle("middle", 0, 2);
  spindle("fine", 14, 0.6);
  scene->AddBone("bone",
                 phantom::Sweep({{{0, -40, -22}, 14}, {{0, 40, -22}, 14}}),
                 BoxAround({0, 0, -22}, {20, 60, 20}),
                 4,
                 kGround);
  for (const int i : {-1, 0, 1}) {
    scene->AddKnob("knob_" + std::to_string(i + 2), {50, 17.0 * i, 0}, kArm);
  }
  scene->AddTurns({0, 0, -22}, Vector3d::UnitY(), {0, 20, 40});
}

const std::map<std::string, std::function<void(StressScene*)>>& Makers() {
  static const auto& makers =
      *new std::map<std::string, std::function<void(StressScene*)>>{
          {"stress_attachment", Attachment3},
          {"stress_edge", Edge},
          {"stress_sweep", SweepPast},
          {"stress_sheet", Sheet},
          {"stress_plate", Plate},
          {"stress_resolution", Resolution}};
  return makers;
}

}  // namespace

std::vector<std::string> StressSceneNames() {
  std::vector<std::string> names;
  for (const auto& [name, make] : Makers()) names.push_back(name);
  return names;
}

PhantomScene MakeStressScene(const std::string& name, uint32_t seed) {
  const auto maker = Makers().find(name);
  CHECK(maker != Makers().end()) << name;
  StressScene scene(name, seed);
  maker->second(&scene);
  return scene.Made();
}

}  // namespace musclewarp
