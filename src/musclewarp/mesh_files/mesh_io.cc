// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/mesh_files/mesh_io.h"

#include <glog/logging.h>

#include <filesystem>
#include <fstream>
#include <limits>
#include <string_view>
#include <vector>

#include "musclewarp/base/input_error.h"
#include "musclewarp/base/input_file.h"
#include "musclewarp/base/output_file.h"
#include "musclewarp/mesh_files/legacy_vtk_io.h"
#include "musclewarp/mesh_files/mesh_path.h"
#include "musclewarp/mesh_files/obj_io.h"
#include "musclewarp/mesh_files/off_io.h"
#include "musclewarp/mesh_files/ply_io.h"
#include "musclewarp/mesh_files/stl_io.h"
#include "musclewarp/mesh_files/text_cursor.h"
#ifdef MUSCLEWARP_WITH_VTK
#include "musclewarp/mesh_files/vtp_reader.h"
#include "musclewarp/mesh_files/vtp_writer.h"
#endif

namespace musclewarp {
namespace {

namespace fs = std::filesystem;

struct Format {
  const char* extension;
  TriangleSoup (*read)(const std::string& path,
                       std::string_view bytes,
                       std::vector<std::string>* notes,
                       MeshParts* parts);
  std::string (*write)(const TriangleSoup& soup);
};

// For the readers of formats without named parts, which have nothing to say.
template <TriangleSoup (*kRead)(const std::string&, std::string_view)>
TriangleSoup ReadQuietly(const std::string& path,
                         std::string_view bytes,
                         std::vector<std::string>*,
                         MeshParts*) {
  return kRead(path, bytes);
}

const std::vector<Format>& Formats() {
  static const std::vector<Format> kFormats = {
      {".ply", ReadQuietly<ReadPly>, PlyBytes},
      {".obj", ReadObj, ObjBytes},
      {".off", ReadQuietly<ReadOff>, OffBytes},
      {".stl", ReadStl, StlBytes},
      {".vtk", ReadQuietly<ReadLegacyVtk>, LegacyVtkBytes},
#ifdef MUSCLEWARP_WITH_VTK
      {".vtp",
       ReadQuietly<ReadVtp>,
       [](const TriangleSoup& soup) { return VtpOfMesh(soup); }},
#endif
  };
  return kFormats;
}

// Returns null if there is no such format.
const Format* FindFormat(const std::string& extension) {
  for (const Format& format : Formats()) {
    if (extension == format.extension) return &format;
  }
  return nullptr;
}

const Format& FormatOf(const std::string& path) {
  const std::string extension = LowerCase(fs::path(path).extension().string());
  if (const Format* format = FindFormat(extension)) return *format;
  const std::string allowed = MeshFormats();
  if (extension == ".vtp") {
    throw InputError(
        path,
        ".vtp needs VTK, which this build of musclewarp lacks",
        "use " + allowed + ", or build with -DMUSCLEWARP_WITH_VTK=ON");
  }
  throw InputError(path,
                   extension.empty()
                       ? "has no extension to tell its format"
                       : Quoted(extension) + " is not a known mesh format",
                   "use " + allowed);
}

void CheckIsSound(const TriangleSoup& soup) {
  CHECK(soup.points.allFinite());
  if (soup.triangles.size() == 0) return;
  CHECK_GE(soup.triangles.minCoeff(), 0);
  CHECK_LT(soup.triangles.maxCoeff(), soup.points.rows());
}

void CheckFitsStl(const std::string& path, const TriangleSoup& soup) {
  constexpr double kLargest = std::numeric_limits<float>::max();
  if (soup.points.size() == 0) return;
  const double largest = soup.points.cwiseAbs().maxCoeff();
  if (largest <= kLargest) return;
  std::string text;
  AppendReal(largest, &text);
  throw InputError(
      path,
      "cannot hold a coordinate of size " + text + ", .stl ends at 3.4e38",
      "write another format");
}

}  // namespace

TriangleSoup ReadTriangleSoup(const std::string& path,
                              std::vector<std::string>* notes,
                              MeshParts* parts) {
  const MeshPath split = SplitMeshPath(path);
  const Format& format = FormatOf(split.file);
  std::vector<std::string> unheard;
  MeshParts found;
  TriangleSoup soup = format.read(
      split.file, ReadFile(split.file), notes ? notes : &unheard, &found);
  if (split.part) KeepPart(split.file, *split.part, &soup, &found);
  if (parts) *parts = std::move(found);
  return soup;
}

void WriteTriangleSoup(const std::string& path, const TriangleSoup& soup) {
  const Format& format = FormatOf(path);
  CheckIsSound(soup);
  if (format.write == StlBytes) CheckFitsStl(path, soup);
  WriteTextAtomically(path, format.write(soup));
}

std::string MeshFormats() {
  std::string formats;
  for (const Format& format : Formats()) {
    if (!formats.empty()) formats += ", ";
    formats += format.extension;
  }
  return formats;
}

bool IsMeshExtension(const std::string& extension) {
  const bool has_dot = !extension.empty() && extension[0] == '.';
  return FindFormat((has_dot ? "" : ".") + LowerCase(extension)) != nullptr;
}

}  // namespace musclewarp
