// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "musclewarp/joints/bone.h"
#include "musclewarp/joints/bone_names.h"
#include "musclewarp/label_images/label_meshes.h"
#include "musclewarp/mesh/triangle_soup.h"
#include "musclewarp/mesh_repair/repair.h"
#include "musclewarp/scene/scene.h"

namespace musclewarp {

// A muscle or a bone of a subject: a mesh file, a label of an image, or a piece
// of either.
struct SubjectMesh {
  std::string name;

  // The file that holds this mesh and no other, empty for labels and pieces.
  std::string file;

  TriangleSoup mesh;  // mm; that of a file as delivered

  // If true, `file` is in the other space (LPS or RAS) than the subject.
  bool is_turned = false;

  // The volume of a label before its surface was made (LabelMesh), mm^3; 0: the
  // volume of the mesh.
  double delivered_volume = 0;

  // Of a bone: what it is, and the body to which it belongs (Bone).
  NamedBone bone;
  std::string body;

  // Of a muscle: the bodies or bones on which it ends; may be empty.
  std::string origin, insertion;
};

// The volume of a bone, or of a file that was taken apart, that became no mesh.
struct LostVolume {
  std::string name;
  double volume = 0;     // mm^3
  double delivered = 0;  // of all of it, mm^3
};

// The meshes of one person, all in one space and in mm.
struct Subject {
  std::vector<SubjectMesh> bones, muscles;  // labels first, then files

  // The label image among the input, empty if there is none, and its labels,
  // whose points and triangles are in the meshes above.
  std::string image;
  LabelMeshes labels;

  std::vector<LostVolume> lost;

  // What was left out, filled or not known, and what is likely wrong, each a
  // sentence.
  std::vector<std::string> notes, warnings;

  // Returns false if there is an image that does not say where left, back and
  // head are.
  bool IsOriented() const { return image.empty() || labels.frame == "LPS"; }
};

// The use of a subject, which decides what its meshes are.
enum class SubjectUse {
  // A separation. Files are muscles, but for those among the bones that are
  // named; labels are bones if the table says so or they are named. Files of
  // two spaces (LPS and RAS) are turned into one.
  kSeparation,

  // Joints. Files are bones, but for those of muscles; labels are bones if the
  // table says so, they are named, or their name is that of a bone. A bone that
  // exists on both sides of the body is taken apart, and each piece with at
  // least 1 % of the volume of its label becomes a bone. Files of two spaces
  // are refused, as models name them as they are.
  kJoints,
};

// The input of a subject.
struct SubjectInput {
  SubjectUse use = SubjectUse::kSeparation;

  // Mesh files, and at most one label image.
  std::vector<std::string> files;

  // Meshes of muscles beside the files (kJoints).
  std::vector<std::string> muscle_files;

  // Names of labels that are bones; for kSeparation also mesh files of bones.
  std::vector<std::string> bones;

  // The table of labels, the edges of their surfaces, their pieces, and the
  // unit of the files. With PieceChoice::kAll each closed piece of a file of a
  // muscle becomes a mesh, too (kSeparation).
  LabelMeshOptions labels;

  // Repairs of files that are taken apart.
  RepairOptions repair;
};

// Reads the meshes of a subject. Throws InputError for files that cannot be
// read or, if they are taken apart, repaired; for two meshes of one name, a
// second label image, and a column of the table whose value is not allowed; for
// named bones that are neither labels nor files; and for options of label
// images without one (kSeparation).
Subject ReadSubject(const SubjectInput& input);

// Returns the same of a label image in memory. `input.files` has mesh files
// alone, and `image.path` is the name of the image in messages.
Subject ReadSubject(const SubjectInput& input, const LabelImage& image);

// Returns the scene of a subject in its rest pose: muscles without lines, and
// each bone is a body. Meshes of files are named by their paths.
Scene SceneOfSubject(const Subject& subject, double mm_per_unit);

// Returns the bones of a subject, for Articulate().
std::vector<Bone> BonesOf(const Subject& subject);

}  // namespace musclewarp
