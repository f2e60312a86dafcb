// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "musclewarp/joints/articulation.h"
#include "musclewarp/joints/line_muscle.h"

namespace musclewarp {

// Returns the text of an OpenSim 4 model (.osim, version 40000) of a skeleton.
//
// The frame of every body is the frame of the image, and both frames of a joint
// sit at its centre: in the pose of the scan, which the defaults of the
// coordinates are, the frames of all bodies coincide with the ground. Joints
// are CustomJoints; failed joints and bones of no joint become WeldJoints. A
// comment before each joint has its verdict. The mesh of a bone is <name>.obj,
// looked for in the folder Geometry beside the model, in mm.
//
// Masses come from the volumes of the bones; they are no data for dynamics,
// and a comment says so.
//
// Each of `muscles`, which may be none, becomes a Millard2012EquilibriumMuscle
// (muscle_elements.h) whose forces and lengths are estimates, and a comment
// says so. Precondition (CHECKed): their points are on bodies of the
// articulation.
//
// Sources: the elements are those of opensim-core 4 (Joint, CustomJoint,
// SpatialTransform, PhysicalOffsetFrame, Mesh), as its own models have them.
std::string ArticulatedModelText(const Articulation& articulation,
                                 const std::string& name,
                                 const std::vector<LineMuscle>& muscles = {});

// Writes that text to `path`, and the mesh of every bone to the folder Geometry
// beside it; folders are made. Throws InputError, which names the file, for one
// that cannot be written.
void WriteArticulatedModel(const Articulation& articulation,
                           const std::string& name,
                           const std::string& path,
                           const std::vector<LineMuscle>& muscles = {});

// Returns the angles a, b, c (rad) of a rotation Rx(a) Ry(b) Rz(c), as
// OpenSim's <orientation> has it.
Eigen::Vector3d BodyFixedAngles(const Eigen::Matrix3d& rotation);

}  // namespace musclewarp
