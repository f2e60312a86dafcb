// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/phantom/hip_scene.h"

#include <Eigen/LU>
#include <cmath>
#include <functional>

#include "musclewarp/phantom/hip_model.h"
#include "musclewarp/phantom/hip_solids.h"
#include "musclewarp/phantom/scene_parts.h"

namespace musclewarp {
namespace {

using phantom::Field;

constexpr char kPelvis[] = "pelvis";
constexpr char kFemur[] = "femur_r";

// The solids are drawn around the hip centre; in the scene x = 0 is the
// body's plane of symmetry.
const Eigen::Vector3d kHipCentre(85, 0, 0);

// The point of the psoas line that wraps around the head, and where it is at 60
// degrees of flexion, from the hip centre.
constexpr int kWrapped = 5;
constexpr int kFlexed60 = 2;  // the pose
const Eigen::Vector3d kWrappedFlexed(1, 47, 4);

// duplicate points, degenerate triangles, flaps, stray pieces, missing
// triangles: numbers of the order found in segmented muscles.
std::vector<phantom::Solid> Solids(const Field& pelvis, const Field& femur) {
  const Field bones = phantom::Union(pelvis, femur, 0);
  const Field minimus = phantom::GluteusMinimusField(bones);
  const Field medius = phantom::GluteusMediusField(bones, minimus);
  const Field psoas = phantom::PsoasField(bones);
  return {
      {"gluteus_medius_r",
       medius,
       {Eigen::Vector3d(-60, -110, -60), Eigen::Vector3d(100, 55, 135)},
       3.6,
       {1, 2, 3, 0, 0}},
      {"gluteus_minimus_r",
       minimus,
       {Eigen::Vector3d(-45, -75, -50), Eigen::Vector3d(90, 50, 110)},
       3.0,
       {1, 0, 1, 0, 1}},
      {"psoas_major_r",
       psoas,
       {Eigen::Vector3d(-85, -40, -95), Eigen::Vector3d(50, 75, 230)},
       3.5,
       {2, 4, 2, 1, 0}},
      {kPelvis,
       pelvis,
       {Eigen::Vector3d(-100, -125, -100), Eigen::Vector3d(50, 75, 150)},
       4.1,
       {1, 0, 3, 0, 0}},
      {kFemur,
       femur,
       {Eigen::Vector3d(-40, -50, -250), Eigen::Vector3d(90, 40, 40)},
       3.3,
       {}},
  };
}

// Returns a line through the middle of a fan; the points are given by (y, z).
ActionLine FanLine(const std::string& name,
                   const Field& fan,
                   const std::vector<Eigen::Vector2d>& yz,
                   const std::vector<std::string>& bodies) {
  ActionLine line;
  line.name = name;
  line.bodies = bodies;
  line.rest.resize(yz.size(), 3);
  for (size_t i = 0; i < yz.size(); ++i) {
    const double x = phantom::MiddleAlongX(fan, yz[i].x(), yz[i].y());
    line.rest.row(i) << x, yz[i].x(), yz[i].y();
  }
  return line;
}

std::vector<ActionLine> MediusLines(const Field& fan) {
  const std::vector<std::string> bodies = {kPelvis, kPelvis, kFemur, kFemur};
  return {
      FanLine("glut_med1_r",
              fan,
              {{26, 84}, {14, 44}, {-6, -4}, {-11, -28}},
              bodies),
      FanLine("glut_med2_r",
              fan,
              {{-24, 106}, {-19, 44}, {-14, -8}, {-14, -32}},
              bodies),
      FanLine("glut_med3_r",
              fan,
              {{-70, 84}, {-48, 46}, {-22, -4}, {-17, -26}},
              bodies),
  };
}

std::vector<ActionLine> MinimusLines(const Field& fan) {
  const std::vector<std::string> bodies = {kPelvis, kPelvis, kFemur};
  return {
      FanLine("glut_min1_r", fan, {{24, 60}, {17, 20}, {6, -20}}, bodies),
      FanLine("glut_min2_r", fan, {{-8, 80}, {1, 30}, {4, -22}}, bodies),
      FanLine("glut_min3_r", fan, {{-40, 66}, {-12, 22}, {4, -20}}, bodies),
  };
}

ActionLine PsoasLine() {
  ActionLine line;
  line.name = "psoas_r";
  line.bodies = {
      kPelvis, kPelvis, kPelvis, kPelvis, kPelvis, kFemur, kFemur, kFemur};
  line.rest.resize(8, 3);
  line.rest << -50, -8, 200, -53, 0, 145, -48, 12, 95, -34, 30, 50, -17, 43, 18,
      0, 39, -16, 17, 13, -46, 25, -10, -64;
  return line;
}

void AddMuscles(const std::vector<phantom::Solid>& solids,
                const std::vector<PhantomMesh>& meshes,
                const Field& pelvis,
                const Field& femur,
                Scene* scene) {
  const auto on_wing = [&](const Eigen::Vector3d& p) {
    return p.z() > 45 && pelvis(p) < 0;
  };
  const auto on_femur_below = [&](double z) {
    return [&femur, z](const Eigen::Vector3d& p) {
      return p.z() < z && femur(p) < 0;
    };
  };
  // The vertebrae are not in the scene: the upper end stands for them.
  const auto on_spine = [&](const Eigen::Vector3d& p) { return p.z() > 190; };
  SceneMuscle medius =
      phantom::MuscleOf(meshes[0], MediusLines(solids[0].field));
  medius.attachments = {
      phantom::AttachmentTo(kPelvis, meshes[0], on_wing, 24),
      phantom::AttachmentTo(kFemur, meshes[0], on_femur_below(-14), 5)};
  SceneMuscle minimus =
      phantom::MuscleOf(meshes[1], MinimusLines(solids[1].field));
  minimus.attachments = {
      phantom::AttachmentTo(kPelvis, meshes[1], on_wing, 20),
      phantom::AttachmentTo(kFemur, meshes[1], on_femur_below(-14), 4)};
  SceneMuscle psoas = phantom::MuscleOf(meshes[2], {PsoasLine()});
  psoas.attachments = {
      phantom::AttachmentTo(kPelvis, meshes[2], on_spine, 8),
      phantom::AttachmentTo(kFemur, meshes[2], on_femur_below(-60), 4)};
  scene->muscles = {medius, minimus, psoas};
}

ScenePose PoseOf(const std::string& name,
                 double time,
                 const Eigen::Vector3d& axis,
                 double degrees) {
  ScenePose pose;
  pose.name = name;
  pose.time = time;
  pose.bodies[kFemur] = phantom::RotationAbout(kHipCentre, axis, degrees);
  return pose;
}

std::vector<ScenePose> Poses(const ActionLine& psoas) {
  const Eigen::Vector3d flexion = Eigen::Vector3d::UnitX();
  const Eigen::Vector3d abduction = -Eigen::Vector3d::UnitY();
  std::vector<ScenePose> poses = {
      PoseOf("rest", 0, flexion, 0),
      PoseOf("flexion_30", 1, flexion, 30),
      PoseOf("flexion_60", 2, flexion, 60),
      PoseOf("extension_10", 3, flexion, -10),
      PoseOf("abduction_20", 4, abduction, 20),
  };
  // The point in front of the head would turn up and behind the one before it;
  // a real line wraps on the way, which only a target can say.
  Points target = phantom::MovedLine(psoas, poses[kFlexed60].bodies);
  target.row(kWrapped) = (kHipCentre + kWrappedFlexed).transpose();
  poses[kFlexed60].lines[psoas.name] = target;
  return poses;
}

void MoveBy(const Eigen::Vector3d& shift, PhantomScene* hip) {
  for (PhantomMesh& mesh : hip->meshes) {
    mesh.surface.points.rowwise() += shift.transpose();
    mesh.delivered.points.rowwise() += shift.transpose();
  }
  for (SceneMuscle& muscle : hip->scene.muscles) {
    for (ActionLine& line : muscle.lines) {
      line.rest.rowwise() += shift.transpose();
    }
    for (Attachment& attachment : muscle.attachments) {
      attachment.points.rowwise() += shift.transpose();
    }
  }
}

}  // namespace

PhantomScene MakeHipScene(uint32_t seed) {
  const Field pelvis = phantom::PelvisField();
  const Field femur = phantom::FemurField();
  const std::vector<phantom::Solid> solids = Solids(pelvis, femur);
  PhantomScene hip;
  hip.scene.axes = "RAS";
  hip.scene.name = "hip";
  hip.meshes.resize(solids.size());
#pragma omp parallel for schedule(dynamic)
  for (size_t i = 0; i < solids.size(); ++i) {
    hip.meshes[i] = phantom::MeshOf(solids[i], seed + i);
  }
  AddMuscles(solids, hip.meshes, pelvis, femur, &hip.scene);
  hip.scene.bones = {{kPelvis, {}, {}, kPelvis, "pelvis.ply"},
                     {kFemur, {}, {}, kFemur, "femur_r.ply"}};
  MoveBy(kHipCentre, &hip);
  const ActionLine& psoas = hip.scene.muscles[2].lines[0];
  hip.scene.poses = Poses(psoas);
  const Eigen::Vector4d flexed =
      hip.scene.poses[kFlexed60].bodies.at(kFemur).inverse() *
      (kHipCentre + kWrappedFlexed).homogeneous();
  hip.model_text = phantom::HipModelText(
      hip.scene, kHipCentre, {psoas.name, kWrapped, flexed.head<3>()});
  hip.motion_text = phantom::HipMotionText();
  return hip;
}

}  // namespace musclewarp
