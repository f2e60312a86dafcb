// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "musclewarp/certificate/scene_intersections.h"
#include "musclewarp/exchange/tetrahedral_mesh.h"
#include "musclewarp/run/attachments_file.h"
#include "musclewarp/run/recorded_pose.h"

namespace musclewarp {

// A frame as a finite element program sees it. Numbers count from zero; files
// count from one.

// A muscle in the mesh of all muscles. The elements of each are together, and
// so are the nodes of its surface.
struct MuscleElements {
  std::string name;
  int first_element = 0;
  int num_elements = 0;
  Triangles surface;               // by nodes of the mesh, facing outward
  std::vector<ElementFace> faces;  // of each triangle of the surface

  // The nodes attached to each body, in rising order.
  std::vector<AttachedArea> attachments;
};

// A bone, which is a rigid surface. Its nodes follow those of the muscles in
// files.
struct RigidSurface {
  std::string name;
  std::string body;  // the name of the bone, if the run does not say
  TriangleSoup surface;
};

// Two meshes that may come into contact: those that are at most kMeshGapLimit
// apart.
struct ContactPair {
  std::string a;      // a muscle
  std::string b;      // a muscle or a bone
  double gap_mm = 0;  // at least; proved

  // The numbers of the triangles of each that may be as near to the other as
  // contact reaches, in rising order.
  std::vector<int> triangles_a, triangles_b;
};

struct ElementModel {
  std::string title;  // what it is of, in a line
  int frame = 0;      // its number in the run
  double time = 0;    // s; in runs that are no motions the number
  TetrahedralMesh mesh;
  std::vector<MuscleElements> muscles;
  std::vector<RigidSurface> bones;
  std::vector<ContactPair> contacts;

  // The direction of the fibres in each element, #T x 3, of unit length: that
  // of the nearest piece of the fibres of the muscle, or of its action lines if
  // the run has no fibres. Zero in muscles without either.
  Points fibres;
};

// Returns the surfaces of all muscles of a frame as one. Points and triangles
// of a muscle follow those of the muscle before.
TriangleSoup JoinedSurface(const std::vector<TriangleSoup>& muscles);

// Returns the model of a frame. `mesh` fills JoinedSurface(pose.muscles);
// `attachments` may be empty; `gaps` are those of the frame; triangles within
// `contact_reach` of each other, mm, may come into contact. Precondition
// (CHECKed): the triangles of the muscles are the border of the mesh.
ElementModel ElementModelOf(const std::string& title,
                            const RecordedNames& names,
                            const RecordedPose& pose,
                            const RecordedAttachments& attachments,
                            const std::vector<MeshGap>& gaps,
                            double contact_reach,
                            TetrahedralMesh mesh);

}  // namespace musclewarp
