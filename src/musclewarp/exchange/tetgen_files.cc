// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/exchange/tetgen_files.h"

#include <filesystem>

#include "musclewarp/base/input_file.h"
#include "musclewarp/base/output_file.h"
#include "musclewarp/exchange/number_reader.h"
#include "musclewarp/mesh_files/text_cursor.h"

namespace musclewarp {
namespace {

namespace fs = std::filesystem;

}  // namespace

void WriteTetgenInput(const std::string& dir, const TriangleSoup& surface) {
  std::string text = std::to_string(surface.points.rows()) + " 3 0 0\n";
  for (Eigen::Index i = 0; i < surface.points.rows(); ++i) {
    text += std::to_string(i);
    for (const double x : surface.points.row(i)) {
      text += ' ';
      AppendReal(x, &text);
    }
    text += '\n';
  }
  text += std::to_string(surface.triangles.rows()) + " 0\n";
  for (Eigen::Index f = 0; f < surface.triangles.rows(); ++f) {
    text += '3';
    for (const int v : surface.triangles.row(f)) {
      text += ' ' + std::to_string(v);
    }
    text += '\n';
  }
  text += "0\n0\n";  // holes, regions
  WriteTextAtomically((fs::path(dir) / kTetgenSurface).string(), text);
}

TetrahedralMesh ReadTetgenResult(const std::string& dir) {
  TetrahedralMesh mesh;
  const std::string nodes = (fs::path(dir) / "surface.1.node").string();
  NumberReader node(nodes, ReadFile(nodes));
  const int count = node.Count(4, kMostElements);
  node.Skip(3);  // dimension, attributes, markers
  mesh.points.resize(count, 3);
  for (int i = 0; i < count; ++i) {
    node.Expect(i);
    for (int k = 0; k < 3; ++k) mesh.points(i, k) = node.Real();
  }
  const std::string elements = (fs::path(dir) / "surface.1.ele").string();
  NumberReader element(elements, ReadFile(elements));
  mesh.tetrahedra.resize(element.Count(1, kMostElements), 4);
  element.Skip(2);  // corners, attributes
  for (Eigen::Index t = 0; t < mesh.tetrahedra.rows(); ++t) {
    element.Skip(1);
    for (int k = 0; k < 4; ++k) {
      mesh.tetrahedra(t, k) = element.Count(0, count - 1);
    }
  }
  return mesh;
}

}  // namespace musclewarp
