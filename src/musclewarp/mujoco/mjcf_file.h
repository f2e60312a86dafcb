// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <map>
#include <string>
#include <vector>

#include "musclewarp/mesh/triangle_soup.h"
#include "musclewarp/mujoco/mjcf_tree.h"
#include "musclewarp/mujoco/site_path.h"
#include "musclewarp/mujoco/skin_weights.h"
#include "musclewarp/opensim/dynamics.h"
#include "musclewarp/opensim/model.h"

namespace musclewarp {

// A bone of the model: its mesh in the frame of a body.
struct MjcfBone {
  std::string name;
  int body = -1;      // of the model
  TriangleSoup mesh;  // mm
};

// A muscle that pulls along a path.
struct MjcfMuscle {
  std::string name;
  SitePath path;
  std::array<double, 2> length_range = {0, 0};  // mm
  double force = 0;                             // N; 0: as MuJoCo scales it
};

// A body that carries a skin.
struct MjcfSkinBone {
  std::string body;
  Eigen::Matrix4d rest_from_body;  // mm
};

// The surface of a muscle.
struct MjcfSkin {
  std::string name;
  SkinWeights skin;  // over `bones`, places in the rest pose, mm
  Triangles triangles;
  std::vector<MjcfSkinBone> bones;  // bodies of the model, then slides
  int num_slides = 0;
};

// A model for MuJoCo.
struct MjcfModel {
  std::string name;
  MjcfTree tree;
  std::map<std::string, BodyMass> masses;  // by the names of bodies
  std::vector<MjcfBone> bones;
  std::vector<MjcfMuscle> muscles;
  std::vector<MjcfSkin> skins;
};

// Returns the MJCF document of a model: m, kg, N and rad, y up as in OpenSim.
// Bones are in assets/NAME.obj and skins in assets/NAME.skn beside it. Bodies
// without a mass get kLeastMass, and muscles without a force are scaled by
// MuJoCo.
std::string MjcfText(const MjcfModel& mjcf, const Model& model);

// The mass of a body that has none, kg: MuJoCo moves no body without one.
constexpr double kLeastMass = 1e-3;

// Returns the bytes of a .skn file of MuJoCo. Throws InputError if the name of
// a body has more than 39 bytes, which the format does not hold.
std::string SknBytes(const MjcfSkin& skin);

// Returns the text of an .obj file of a mesh, in m.
std::string MeshText(const TriangleSoup& mesh);

}  // namespace musclewarp
