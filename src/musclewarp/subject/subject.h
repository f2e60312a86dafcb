// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "musclewarp/anatomy/bone.h"
#include "musclewarp/anatomy/bone_names.h"
#include "musclewarp/label_images/label_meshes.h"
#include "musclewarp/mesh/triangle_soup.h"
#include "musclewarp/mesh_repair/repair.h"
#include "musclewarp/scene/scene.h"

namespace musclewarp {

// A muscle or a bone of a subject: a mesh file, a label of an image, or a piece
// of either.
struct SubjectMesh {
  std::string name;

  // The file that contains this mesh and no other; empty for labels and pieces.
  std::string file;

  TriangleSoup mesh;  // mm; not repaired if it is from a file

  // True if `file` is in the other space (LPS or RAS) than the subject.
  bool is_turned = false;

  // The volume of a label before its surface was made (LabelMesh), mm^3, or 0,
  // which stands for the volume of the mesh.
  double delivered_volume = 0;

  // The kind and side of a bone, and the body to which it belongs (Bone).
  NamedBone bone;
  std::string body;

  // The bodies or bones on which a muscle ends; may be empty.
  std::string origin, insertion;
};

// The volume that a label of a bone, or a file that was taken apart, has lost.
struct LostVolume {
  std::string name;
  double volume = 0;     // mm^3
  double delivered = 0;  // before the loss, mm^3
};

// The meshes of one person, all in one space and in mm.
struct Subject {
  std::vector<SubjectMesh> bones, muscles;  // labels first, then files

  // The path of the label image, empty if there is none, and its labels. The
  // points and triangles of these are in the meshes above.
  std::string image;
  LabelMeshes labels;

  std::vector<LostVolume> lost;

  // Sentences about parts that were left out, filled or not recognised, and
  // about likely mistakes.
  std::vector<std::string> notes, warnings;

  // Returns false if there is a label image that does not say where left, back
  // and head are.
  bool IsOriented() const { return image.empty() || labels.frame == "LPS"; }
};

// The use of a subject, which decides which meshes are bones and which are
// muscles.
enum class SubjectUse {
  // A separation. Files are muscles unless they are among the named bones.
  // Labels are bones if the table says so or they are among the named bones.
  // Files of two spaces (LPS and RAS) are turned into one.
  kSeparation,

  // A search for joints. `files` are bones. Labels are bones if the table says
  // so, they are among the named bones, or their name is that of a bone. A
  // label of a bone that exists on both sides of the body is taken apart, and
  // each piece with at least 1 % of the volume of the label becomes a bone.
  // Files of two spaces are refused, because models name the files as they are.
  kJoints,
};

// The input of a subject.
struct SubjectInput {
  SubjectUse use = SubjectUse::kSeparation;

  // Mesh files, and at most one label image.
  std::vector<std::string> files;

  // Mesh files of muscles (kJoints).
  std::vector<std::string> muscle_files;

  // The names of labels that are bones; for kSeparation also mesh files of
  // bones.
  std::vector<std::string> bones;

  // The table of labels, the edges of their surfaces, the choice of their
  // pieces, and the unit of the files. With PieceChoice::kAll, each closed
  // piece of a file of muscles also becomes a mesh (kSeparation).
  LabelMeshOptions labels;

  // The repair of files that are taken apart.
  RepairOptions repair;
};

// Reads the meshes of a subject. Throws InputError for files that cannot be
// read or, if they are taken apart, repaired; for two meshes of the same name,
// a second label image, and a column of the table whose value is not allowed;
// for named bones that are neither labels nor files; and, for kSeparation, for
// options of label images without an image.
Subject ReadSubject(const SubjectInput& input);

// Does the same with a label image in memory. `input.files` has mesh files
// only, and `image.path` is the name of the image in messages.
Subject ReadSubject(const SubjectInput& input, const LabelImage& image);

// Returns the scene of a subject in its rest pose: muscles have no lines, and
// each bone is a body. Meshes of files are given by their paths.
Scene SceneOfSubject(const Subject& subject, double mm_per_unit);

// Returns the bones of a subject, for Articulate().
std::vector<Bone> BonesOf(const Subject& subject);

}  // namespace musclewarp
