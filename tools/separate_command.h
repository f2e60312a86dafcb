// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <ostream>
#include <set>
#include <string>
#include <vector>

#include "musclewarp/deformer/mesh_separation.h"
#include "musclewarp/frame_solvers/rest_separation.h"
#include "musclewarp/label_images/label_meshes.h"

namespace musclewarp {

// What musclewarp-separate is asked for beside the files that may move; the
// fields are its flags.
struct SeparateOptions {
  std::string out;  // folder for the results

  // Meshes that must not move: files, and names of labels.
  std::vector<std::string> bones;

  // The unit of the files, in mm, and of label images that do not state theirs.
  double mm_per_unit = 1;

  // For a label image: the table of its labels, empty if every label is taken
  // (label_table.h), and the length of the edges of its surfaces, mm, at most
  // 100; 0: twice the edge of a voxel.
  std::string labels;
  double edge = 0;
  PieceChoice pieces = PieceChoice::kLargest;

  // The longest border of a hole that is filled whatever its shape, mm.
  double max_hole = HoleLimits().max_perimeter;

  double gap = StepOptions().gap;  // mm, that meshes keep at least

  // What happens to meshes that cannot be separated by moving their vertices.
  ReconstructionKind remake = ReconstructionKind::kAuto;

  // The share of the volume of a mesh or label, as it was delivered, that may
  // be lost; with more the result is not usable.
  double max_loss = FrameRequirements().max_volume_loss;
  double max_lost_area = FrameRequirements().max_lost_area;      // mm^2
  double max_lost_extent = FrameRequirements().max_lost_extent;  // mm
  double max_move =
      MeshSeparationOptions().requirements.displacement_allowance;  // mm

  // Which of these lengths are in mm whatever the size of the body: those that
  // the user gave (length_options.h).
  std::set<std::string> lengths_in_mm;

  std::vector<std::string> formats = {"ply"};  // of the meshes written
  bool json = false;         // if true, separation.json is written, too
  int threads = 0;           // 0: as many as OpenMP chooses
  bool is_terminal = false;  // true if the screen is a terminal
};

// Returns the options of the library. The gap is checked as SetGap does,
// nothing else is.
RestSeparationOptions RestSeparationOptionsOf(const SeparateOptions& options);

// Moves the vertices of meshes as little as it takes for no two of them to
// cross and for each to keep its volume (SeparateRest): the meshes are the
// muscles of a scene that has neither lines of action nor poses. Bones stay
// where they are. They are tested neither against each other nor with
// themselves.
//
// `files` are mesh files and at most one label image (label_image_file.h), of
// which every label becomes a mesh in millimetres and in LPS (label_meshes.h).
//
// Meshes are named by the stems of their files, those of labels by the table,
// and are repaired first. All of them, bones too, are written to
// out/<name>.<format>, and tables of what crossed and what moved to `screen`.
// With `json`, out/separation.json has the same figures under the keys of
// report.json (docs/report.md).
//
// Returns 0 if the certificate of the result has no shortcomings
// (certificate/shortcomings.h; how far meshes move does not count), and 1 if it
// has, or if the program was interrupted (SIGINT, SIGTERM). Throws InputError,
// before anything is written, for files that cannot be read or repaired, two
// files of one name, options that are not allowed, results that would replace a
// file that was read, a label image that cannot be read or has a label of which
// no surface can be made, and meshes that cannot be separated.
int SeparateCommand(const std::vector<std::string>& files,
                    const SeparateOptions& options,
                    std::ostream& screen);

}  // namespace musclewarp
