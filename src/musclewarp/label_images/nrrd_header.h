// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "musclewarp/label_images/image_grid.h"
#include "musclewarp/mesh_files/binary_scalar.h"

namespace musclewarp {

enum class NrrdEncoding { kRaw, kGzip, kText };

// Where the values of the voxels are, and how they are written.
struct NrrdSource {
  // One after the other; each holds as many voxels as any other.
  std::vector<std::string> files;
  std::uint64_t begin = 0;  // the byte behind the header in a file that has one
  NrrdEncoding encoding = NrrdEncoding::kRaw;
  ScalarType type = ScalarType::kUInt8;
  ByteOrder order = ByteOrder::kLittle;

  // So many lines and then bytes come before the values of each file, the bytes
  // where they are unpacked; -1: all but the values at the end.
  std::int64_t line_skip = 0;
  std::int64_t byte_skip = 0;
};

struct NrrdHeader {
  ImageGrid grid;
  NrrdSource source;
};

// Reads the header of an NRRD file (teem.sourceforge.net/nrrd/format.html),
// attached to its data (.nrrd) or not (.nhdr). The vtkNrrdReader of VTK 9.1
// ignores where the axes point, takes an axis of at most 9 voxels for the
// components of a vector, and fills up data that end early.
//
// Three axes lead through space. Others may have one voxel, wherever they are
// among the axes, as 3D Slicer writes them into .seg.nrrd.
//
// The grid is in LPS. "space" right-anterior-superior is turned; a file that
// has no "space", or one that says nothing of the patient (scanner-xyz,
// 3D-right-handed), keeps its axes and is not oriented. "space units" m, cm, mm
// and um are converted; without them lengths are in `mm_per_unit`. Segments of
// 3D Slicer (Segment0_Name, and Segment0_LabelValue) give the names.
//
// Throws InputError that names the field for a file that is not NRRD, has not
// three axes of space, has more than one number a voxel, is left-handed, is
// neither raw nor gzip nor text, or whose other files do not exist.
NrrdHeader ReadNrrdHeader(const std::string& path, double mm_per_unit = 1);

}  // namespace musclewarp
