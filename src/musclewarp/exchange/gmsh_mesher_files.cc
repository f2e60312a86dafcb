// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/exchange/gmsh_mesher_files.h"

#include <array>
#include <filesystem>
#include <sstream>
#include <vector>

#include "musclewarp/base/input_file.h"
#include "musclewarp/base/output_file.h"
#include "musclewarp/exchange/number_reader.h"
#include "musclewarp/mesh/connectivity.h"
#include "musclewarp/mesh_files/text_cursor.h"

namespace musclewarp {
namespace {

namespace fs = std::filesystem;

constexpr char kSurfaceFile[] = "surface.msh";
constexpr int kTriangle = 2;  // numbers of types of elements
constexpr int kTetrahedron = 4;
constexpr int kMostCorners = 4;  // of points, lines, triangles, tetrahedra

// The surface in the format 2.2, in which elements are a line each.
std::string SurfaceText(const TriangleSoup& surface,
                        const std::vector<int>& piece) {
  std::string text = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n" +
                     std::to_string(surface.points.rows()) + "\n";
  for (Eigen::Index i = 0; i < surface.points.rows(); ++i) {
    text += std::to_string(i + 1);
    for (const double x : surface.points.row(i)) {
      text += ' ';
      AppendReal(x, &text);
    }
    text += '\n';
  }
  text += "$EndNodes\n$Elements\n" + std::to_string(surface.triangles.rows()) +
          "\n";
  for (Eigen::Index f = 0; f < surface.triangles.rows(); ++f) {
    const std::string entity = std::to_string(piece[f] + 1);
    text += std::to_string(f + 1) + ' ' + std::to_string(kTriangle) + " 2 " +
            entity + ' ' + entity;
    for (const int v : surface.triangles.row(f)) {
      text += ' ' + std::to_string(v + 1);
    }
    text += '\n';
  }
  return text + "$EndElements\n";
}

}  // namespace

void WriteGmshInput(const std::string& dir, const TriangleSoup& surface) {
  const Components pieces =
      ConnectedComponents(surface.triangles, EdgeUses(surface.triangles), 2);
  WriteTextAtomically((fs::path(dir) / kSurfaceFile).string(),
                      SurfaceText(surface, pieces.label));
  std::ostringstream script;
  script << "Mesh.MshFileVersion = 2.2;\nMesh.SaveAll = 1;\n"
         << "Merge \"" << kSurfaceFile << "\";\n";
  for (int i = 1; i <= pieces.count; ++i) {
    script << "Surface Loop(" << i << ") = {" << i << "}; Volume(" << i
           << ") = {" << i << "};\n";
  }
  WriteTextAtomically((fs::path(dir) / kGmshScript).string(), script.str());
}

TetrahedralMesh ReadGmshResult(const std::string& dir) {
  const std::string path = (fs::path(dir) / kGmshResult).string();
  NumberReader file(path, ReadFile(path));
  TetrahedralMesh mesh;
  file.Find("$Nodes");
  const int count = file.Count(4, kMostElements);
  mesh.points.resize(count, 3);
  for (int i = 0; i < count; ++i) {
    file.Expect(i + 1);
    for (int k = 0; k < 3; ++k) mesh.points(i, k) = file.Real();
  }
  file.Find("$Elements");
  std::vector<std::array<int, 4>> tetrahedra;
  const int elements = file.Count(1, kMostElements);
  for (int e = 0; e < elements; ++e) {
    file.Skip(1);
    const int type = file.Count(1, 15);
    file.Skip(file.Count(0, 16));  // tags
    const int corners = type == 15 ? 1 : type == 1 ? 2 : type == 2 ? 3 : 4;
    std::array<int, kMostCorners> element;
    for (int k = 0; k < corners; ++k) element[k] = file.Count(1, count) - 1;
    if (type == kTetrahedron) tetrahedra.push_back(element);
  }
  mesh.tetrahedra.resize(tetrahedra.size(), 4);
  for (size_t t = 0; t < tetrahedra.size(); ++t) {
    for (int k = 0; k < 4; ++k) mesh.tetrahedra(t, k) = tetrahedra[t][k];
  }
  return mesh;
}

}  // namespace musclewarp
