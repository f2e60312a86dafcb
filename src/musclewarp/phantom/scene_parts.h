// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "musclewarp/mesh/triangle_soup.h"
#include "musclewarp/phantom/field.h"
#include "musclewarp/phantom/phantom_scene.h"
#include "musclewarp/phantom/planted_defects.h"
#include "musclewarp/scene/scene.h"
#include "musclewarp/skeleton/action_line.h"

namespace musclewarp::phantom {

// Meshes, lines, attachments and motions of made-up scenes. All results are
// rounded so that they are the same on every machine.

struct Solid {
  std::string name;
  Field field;
  Eigen::AlignedBox3d box;
  double cell;  // mm
  PlantedDefects defects;
  double roughness = 0.25;  // height of the bumps of the surface, mm
};

// The solid's surface with bumps, and with its defects.
PhantomMesh MeshOf(const Solid& solid, uint32_t seed);

SceneMuscle MuscleOf(const PhantomMesh& mesh, std::vector<ActionLine> lines);

// `count` points of the mesh that `is_in` accepts (SpreadPoints).
// Precondition (CHECKed): there are so many.
Attachment AttachmentTo(
    const std::string& body,
    const PhantomMesh& mesh,
    const std::function<bool(const Eigen::Vector3d&)>& is_in,
    int count);

// The middle of the longest stretch of the line (., y, z) inside the field,
// within 200 mm of x = 0. Precondition (CHECKed): there is one.
double MiddleAlongX(const Field& field, double y, double z);

// target_from_rest of a turn about an axis (unit length) through `centre`, by
// the right-hand rule.
Eigen::Matrix4d RotationAbout(const Eigen::Vector3d& centre,
                              const Eigen::Vector3d& axis,
                              double degrees);

// The points of the line moved with their bodies; a body that is not named
// stays.
Points MovedLine(const ActionLine& line,
                 const std::map<std::string, Eigen::Matrix4d>& bodies);

}  // namespace musclewarp::phantom
