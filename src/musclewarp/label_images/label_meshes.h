// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "musclewarp/label_images/label_image.h"
#include "musclewarp/label_images/label_table.h"
#include "musclewarp/mesh/triangle_soup.h"

namespace musclewarp {

// A label, or a piece of one, that became a mesh.
struct LabelMesh {
  int label = 0;
  std::string name;
  bool is_bone = false;  // by the table; false if it does not say
  LabelEntry entry;      // the row of the table, or what stands in for it
  TriangleSoup mesh;     // mm, closed, outward oriented, one piece

  // The volumes (mm^3) of the voxels from which the mesh was made, including
  // cavities but not the pieces that were left out, and of the mesh.
  double voxel_volume = 0;
  double volume = 0;

  // The volume of the same voxels and of those that were left out, mm^3: the
  // volume that the mesh would have if nothing were lost.
  double delivered_volume = 0;
};

// The treatment of a label with several pieces (label_regions.h).
enum class PieceChoice {
  kLargest,  // the largest becomes a mesh; the others are left out
  kAll,      // each becomes a mesh: "femur_1", "femur_2", the largest first
};

// The result of ReadLabelMeshes().
struct LabelMeshes {
  std::vector<LabelMesh> meshes;  // by label

  // The frame of the points: "LPS" (+x left, +y back, +z head), or "of the
  // file" if the file does not state it.
  std::string frame;

  // Sentences for the user about parts that were left out, filled or not found.
  std::vector<std::string> notes;
};

struct LabelMeshOptions {
  // The path of the table of labels (label_table.h). Labels that it does not
  // contain are left out. Empty: all labels except 0 are used, with their names
  // in the file (.seg.nrrd) or else "label_<number>".
  std::string table;

  // The rows of the table, if it is in memory; `table` is then its name in
  // messages.
  std::vector<LabelEntry> rows;

  // The length of the edges of triangles, mm; 0: twice the edge of a cube with
  // the volume of a voxel.
  double edge_length = 0;

  PieceChoice pieces = PieceChoice::kLargest;

  // Returns the choice for a label; if empty, `pieces` applies to all.
  std::function<PieceChoice(const LabelEntry&)> pieces_of;
  double mm_per_unit = 1;  // of an image that does not state its unit
};

// Returns the rows of the table, from memory or from its file. Throws
// InputError as ReadLabelTable does. Precondition: `options.table` is not
// empty.
std::vector<LabelEntry> RowsOfTable(const LabelMeshOptions& options);

// Returns true if a surface has lost so much of the volume of its voxels (both
// mm^3) that a note says so: more than 2 %.
bool IsLossWorthANote(double lost_volume, double voxel_volume);

// Reads a label image (label_image.h) and makes a mesh of each label, with
// cavities filled (label_regions.h, label_surface.h).
//
// Throws InputError as these do, for an image that has none of the labels of
// the table, only label 0, or more than 1000 different labels without a table,
// and in a build without VTK. Preconditions: IsLabelImageFile(path); the edge
// length is not negative.
LabelMeshes ReadLabelMeshes(const std::string& path,
                            const LabelMeshOptions& options);

// Returns the same of an image in memory.
LabelMeshes MeshesOfLabels(const LabelImage& image,
                           const LabelMeshOptions& options);

}  // namespace musclewarp
