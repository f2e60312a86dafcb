// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "musclewarp/label_images/label_meshes.h"
#include "musclewarp/scene/scene.h"
#include "tools/separate_command.h"

namespace musclewarp {

// What of a mesh file became no mesh.
struct LostPieces {
  std::string name;      // of the file, or its part
  double volume = 0;     // mm^3
  double delivered = 0;  // of all that the file holds, mm^3
};

// What musclewarp-separate reads.
struct SeparateInput {
  // The meshes are its muscles, which have no lines, and its bones. Meshes of
  // files are named by their path and have been read once, so that bad ones are
  // found early; those of labels are in memory.
  Scene scene;

  // The label image among the files, empty if there is none, and what became of
  // it. The points and triangles are in `scene` alone.
  std::string image;
  LabelMeshes labels;

  // By mesh file of which each piece became a mesh; what was left out is also
  // among the warnings of the scene.
  std::vector<LostPieces> lost;
};

// Reads the files: meshes, and at most one label image, of which every label
// becomes a mesh. With PieceChoice::kAll each closed piece of a file that is no
// bone becomes one (PiecesOfMuscle), in memory. `options.bones` names those
// that must not move: files, and labels by their names; labels that the table
// calls bones are bones, too.
//
// Throws InputError for files that cannot be read or, with kAll, repaired, two
// meshes of one name, a name in `options.bones` that is neither a label nor a
// file, options for label images without one, and results that would replace a
// file that is read.
SeparateInput ReadSeparateInput(const std::vector<std::string>& files,
                                const SeparateOptions& options);

}  // namespace musclewarp
