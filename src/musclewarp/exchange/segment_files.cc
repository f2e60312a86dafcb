// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/exchange/segment_files.h"

#include <glog/logging.h>

#include <cstdint>
#include <filesystem>
#include <vector>

#include "musclewarp/base/output_file.h"
#include "musclewarp/mesh_files/binary_scalar.h"
#include "musclewarp/mesh_files/text_cursor.h"
#ifdef MUSCLEWARP_WITH_VTK
#include "musclewarp/mesh_files/vtp_writer.h"
#endif

namespace musclewarp {
namespace {

std::string PlyOfSegments(const SegmentSoup& curve) {
  std::string out =
      "ply\nformat binary_little_endian 1.0\nelement vertex " +
      std::to_string(curve.points.rows()) +
      "\nproperty double x\nproperty double y\nproperty double z\n"
      "element edge " +
      std::to_string(curve.segments.rows()) +
      "\nproperty int vertex1\nproperty int vertex2\nend_header\n";
  for (const double x : curve.points.reshaped<Eigen::RowMajor>()) {
    AppendBytes(x, ByteOrder::kLittle, &out);
  }
  for (const int v : curve.segments.reshaped<Eigen::RowMajor>()) {
    AppendBytes<std::int32_t>(v, ByteOrder::kLittle, &out);
  }
  return out;
}

std::string ObjOfSegments(const SegmentSoup& curve) {
  std::string out;
  for (Eigen::Index i = 0; i < curve.points.rows(); ++i) {
    out += 'v';
    for (const double x : curve.points.row(i)) {
      out += ' ';
      AppendReal(x, &out);
    }
    out += '\n';
  }
  for (Eigen::Index i = 0; i < curve.segments.rows(); ++i) {
    out += "l " + std::to_string(curve.segments(i, 0) + 1) + ' ' +
           std::to_string(curve.segments(i, 1) + 1) + '\n';
  }
  return out;
}

#ifdef MUSCLEWARP_WITH_VTK
std::string VtpOfSegments(const SegmentSoup& curve) {
  std::vector<Points> lines;
  for (Eigen::Index i = 0; i < curve.segments.rows(); ++i) {
    lines.push_back(curve.points(curve.segments.row(i), Eigen::all));
  }
  return VtpOfLines(lines, {});
}
#endif

}  // namespace

void WriteSegments(const std::string& path, const SegmentSoup& curve) {
  const std::string extension = std::filesystem::path(path).extension();
  std::string bytes;
  if (extension == ".ply") {
    bytes = PlyOfSegments(curve);
  } else if (extension == ".obj") {
    bytes = ObjOfSegments(curve);
#ifdef MUSCLEWARP_WITH_VTK
  } else if (extension == ".vtp") {
    bytes = VtpOfSegments(curve);
#endif
  } else {
    LOG(FATAL) << path << " is not of a format for curves";
  }
  WriteTextAtomically(path, bytes);
}

}  // namespace musclewarp
