// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "musclewarp/joints/bone.h"
#include "tools/articulate_command.h"

namespace musclewarp {

// A mesh that musclewarp-articulate was given: a file, or a label of an image.
struct ArticulateMesh {
  std::string name;
  std::string file;   // empty for a label
  TriangleSoup soup;  // mm

  // Of a muscle: the bodies or bones of its ends, by the table; may be empty.
  std::string origin = {}, insertion = {};
};

// What musclewarp-articulate reads.
struct ArticulateInput {
  // The bones, and where they come from, by the same index. Bones have their
  // meshes, whose sources then have none.
  std::vector<Bone> bones;
  std::vector<ArticulateMesh> bone_sources;
  std::vector<ArticulateMesh> muscles;

  // The label image among the files, empty if there is none, and whether it
  // says where left, back and head are.
  std::string image;
  bool is_oriented = true;

  // What became of labels, and names that are not known, each a sentence.
  std::vector<std::string> notes;
};

// Reads the files: meshes of bones, and at most one label image, of which every
// label becomes a mesh (label_meshes.h). A label is a bone if the table or
// `options.bones` says so, or if it has the name of one (bone_names.h), else a
// muscle. What a bone is and on which side is said by the columns of the table
// or by its name; the table may have rows for meshes, too, by their names.
//
// A label of a bone that there is on both sides, without a side, is taken
// apart, and so is that of a pelvis: each piece with at least 1 % of its volume
// becomes a bone.
//
// Throws InputError for files that cannot be read, two meshes of one name, a
// column whose value is not allowed (the message names the table and the row),
// and names in `options.bones` that are no labels.
ArticulateInput ReadArticulateInput(const std::vector<std::string>& files,
                                    const ArticulateOptions& options);

}  // namespace musclewarp
