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

// The location and encoding of the values of the voxels.
struct NrrdSource {
  // The files in order; each contains the same number of voxels.
  std::vector<std::string> files;
  std::uint64_t begin = 0;  // the first byte after the header, if any
  NrrdEncoding encoding = NrrdEncoding::kRaw;
  ScalarType type = ScalarType::kUInt8;
  ByteOrder order = ByteOrder::kLittle;

  // The numbers of lines, and then of bytes after decompression, to skip in
  // each file; a byte_skip of -1 skips all but the values at the end.
  std::int64_t line_skip = 0;
  std::int64_t byte_skip = 0;
};

struct NrrdHeader {
  ImageGrid grid;
  NrrdSource source;
};

// Reads the header of an NRRD file (teem.sourceforge.net/nrrd/format.html),
// attached to its data (.nrrd) or detached (.nhdr). The vtkNrrdReader of VTK
// 9.1 ignores the directions of the axes, interprets an axis of at most 9
// voxels as vector components, and pads truncated data.
//
// There are three spatial axes. Other axes must have one voxel and may be
// anywhere among the axes, as 3D Slicer writes them into .seg.nrrd.
//
// The grid is in LPS. "space" right-anterior-superior is converted; a file
// without "space", or with one that does not refer to the patient (scanner-xyz,
// 3D-right-handed), keeps its axes and is not oriented. "space units" m, cm, mm
// and um are converted; without them lengths are in `mm_per_unit`. The segments
// of 3D Slicer (Segment0_Name and Segment0_LabelValue) provide the names.
//
// Throws InputError that names the field for a file that is not NRRD, does not
// have three spatial axes, has several numbers per voxel, is left-handed, has
// an encoding other than raw, gzip and text, or refers to missing files.
NrrdHeader ReadNrrdHeader(const std::string& path, double mm_per_unit = 1);

}  // namespace musclewarp
