// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "musclewarp/exchange/element_model.h"

namespace musclewarp {

// Return the file of a model in the format of a finite element program. All
// coordinates are those of the meshes, mm, with 17 digits. Names are made fit
// by ElementNames; docs/export.md says what the parts of each file are called.
// meshio (python3-meshio) reads .inp, .msh and .vtu with all that it knows of.

// Abaqus and CalculiX (.inp): C3D4 elements in a set for each muscle, surfaces,
// contact pairs, node sets of attachments, bones as rigid bodies of S3
// elements, an orientation for each element along the fibres, and materials to
// be replaced. Without a step.
std::string AbaqusText(const ElementModel& model);

// FEBio 4 (.feb): tet4 elements in a domain for each muscle, surfaces and
// surface pairs with sliding-elastic contact, node sets of attachments that are
// fixed to rigid bodies, fibre directions as mat_axis, and materials to be
// replaced. Without a step.
std::string FebioText(const ElementModel& model);

// Gmsh 4.1 (.msh, text): volumes and surfaces as physical groups by name, the
// attachments as groups of triangles with all three corners attached, fibre
// directions as element data of all elements (zero in surfaces), at the time of
// the frame.
std::string GmshText(const ElementModel& model);

#ifdef MUSCLEWARP_WITH_VTK
// VTK (.vtu): tetrahedra and the triangles of bones, with the cell data
// "muscle" (its number from 1 on, 0 in bones), "bone" (the same) and "fibre",
// and the point data "attachment" (the number of a body from 1 on, else 0).
// The field data "muscle_NAME", "bone_NAME" and "body_NAME" are these numbers,
// "frame" is the number of the frame and "TimeValue" its time.
std::string VtuBytes(const ElementModel& model);
#endif

}  // namespace musclewarp
