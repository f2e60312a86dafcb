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

// The parts that made-up scenes are built from: meshes, lines, attachments and
// motions. All results are rounded so that they are the same on every machine.

// A muscle or bone before it is a mesh.
struct Solid {
  std::string name;
  Field field;
  // Contains the solid, with room for the bumps.
  Eigen::AlignedBox3d box;
  // The edge length of the mesh, about, mm.
  double cell;
  PlantedDefects defects;
  // The height of the bumps of the surface, mm.
  double roughness = 0.25;
};

// Returns the mesh of a solid with its bumps, and the same with its defects.
PhantomMesh MeshOf(const Solid& solid, uint32_t seed);

// Returns the entry of the scene file for a muscle with these lines; its mesh
// file is named after the muscle.
SceneMuscle MuscleOf(const PhantomMesh& mesh, std::vector<ActionLine> lines);

// Returns an attachment of a muscle to a body: `count` points of its mesh out
// of those that `is_in` accepts, spread evenly (SpreadPoints). Precondition
// (CHECKed): there are so many.
Attachment AttachmentTo(
    const std::string& body,
    const PhantomMesh& mesh,
    const std::function<bool(const Eigen::Vector3d&)>& is_in,
    int count);

// Returns the attachments of a muscle to the bodies of its lines: two for each
// line, of five points of its mesh within 12 mm of an end (more, if its mesh is
// too coarse to have five there). Precondition: the lines have bodies.
std::vector<Attachment> AttachmentsAtEnds(const PhantomMesh& mesh,
                                          const std::vector<ActionLine>& lines);

// Returns true if a mesh is one closed, outward oriented manifold without
// handles that does not cross itself.
bool IsSoundSurface(const TriangleSoup& mesh);

// Returns the x of the middle of the longest stretch of the line (., y, z) that
// is inside the field, searched for within 200 mm of x = 0. Precondition
// (CHECKed): there is one.
double MiddleAlongX(const Field& field, double y, double z);

// Returns target_from_rest of a rotation about an axis (unit length) through
// `centre`, by the right-hand rule.
Eigen::Matrix4d RotationAbout(const Eigen::Vector3d& centre,
                              const Eigen::Vector3d& axis,
                              double degrees);

// Returns the points of a line (#P x 3) moved with their bodies; `bodies` has
// target_from_rest of each moved body, and points on other bodies stay.
// Precondition (CHECKed): the line has a body for every point.
Points MovedLine(const ActionLine& line,
                 const std::map<std::string, Eigen::Matrix4d>& bodies);

}  // namespace musclewarp::phantom
