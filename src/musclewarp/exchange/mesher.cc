// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/exchange/mesher.h"

#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <sstream>

#include "musclewarp/base/child_process.h"
#include "musclewarp/base/input_error.h"
#include "musclewarp/exchange/element_improvement.h"
#include "musclewarp/exchange/gmsh_mesher_files.h"
#include "musclewarp/exchange/tetgen_files.h"

namespace musclewarp {
namespace {

namespace fs = std::filesystem;

// A folder that is removed with everything in it.
class WorkFolder {
 public:
  WorkFolder() {
    std::error_code error;
    const fs::path parent = fs::temp_directory_path(error);
    std::string name = (parent / "musclewarp_XXXXXX").string();
    if (error || mkdtemp(name.data()) == nullptr) {
      throw InputError(parent.string(),
                       "no folder can be made there for the mesher",
                       "set TMPDIR to a folder that can be written");
    }
    path_ = name;
  }
  ~WorkFolder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  WorkFolder(const WorkFolder&) = delete;
  WorkFolder& operator=(const WorkFolder&) = delete;

  const std::string& path() const { return path_; }

 private:
  std::string path_;
};

std::vector<std::string> Arguments(const MesherOptions& options) {
  if (options.kind == MesherOptions::Kind::kGmsh) {
    return {options.program, "-3", "-nt", "1", kGmshScript, "-o", kGmshResult};
  }
  // p: fill a surface, Y: keep its triangles, q: add points inside for better
  // shapes, a: for smaller elements, Q: say less, F: no file of faces.
  std::ostringstream flags;
  flags << "-pYq" << options.radius_edge_ratio;
  if (options.max_volume > 0) flags << "a" << std::fixed << options.max_volume;
  flags << "QF";
  return {options.program, flags.str(), kTetgenSurface};
}

// Meshers write 16 digits, of coordinates up to 1e7 mm.
constexpr double kDigitsOfMeshers = 1e-8;

// Gives the first points of a mesh, those of the surface, all their digits.
// Returns false if they are other points.
bool RestoreSurface(const Points& surface, TetrahedralMesh* mesh) {
  const Eigen::Index count = surface.rows();
  if (mesh->points.rows() < count) return false;
  auto first = mesh->points.topRows(count);
  const double moved = (first - surface).cwiseAbs().maxCoeff();
  first = surface;
  return moved <= kDigitsOfMeshers;
}

// Turns tetrahedra whose volume is negative.
void Orient(TetrahedralMesh* mesh) {
  const Eigen::VectorXd volumes = Volumes(*mesh);
  for (Eigen::Index t = 0; t < volumes.size(); ++t) {
    if (volumes[t] < 0) {
      std::swap(mesh->tetrahedra(t, 0), mesh->tetrahedra(t, 1));
    }
  }
}

}  // namespace

MesherOptions FindMesher(const std::string& mesher) {
  MesherOptions options;
  const std::string name = fs::path(mesher).filename().string();
  const bool is_gmsh = name.rfind("gmsh", 0) == 0;
  if (!is_gmsh && name.rfind("tetgen", 0) != 0) {
    throw InputError("{mesher}=" + mesher,
                     "is neither TetGen nor Gmsh",
                     "allowed: tetgen, gmsh, or the path of one of them");
  }
  options.kind =
      is_gmsh ? MesherOptions::Kind::kGmsh : MesherOptions::Kind::kTetgen;
  options.program = FindProgram(mesher);
  if (options.program.empty()) {
    throw InputError("{mesher}=" + mesher,
                     "there is no such program",
                     "install it (on Debian: apt-get install " +
                         std::string(is_gmsh ? "gmsh" : "tetgen") +
                         "), or give its path");
  }
  return options;
}

MesherResult FillWithTetrahedra(const TriangleSoup& surface,
                                const MesherOptions& options) {
  const WorkFolder folder;
  if (options.kind == MesherOptions::Kind::kGmsh) {
    WriteGmshInput(folder.path(), surface);
  } else {
    WriteTetgenInput(folder.path(), surface);
  }
  const ChildResult ended =
      RunChild(Arguments(options), folder.path(), options.timeout_s);
  if (!ended.IsFine()) return {std::nullopt, "the mesher " + ended.Text()};
  try {
    TetrahedralMesh mesh = options.kind == MesherOptions::Kind::kGmsh
                               ? ReadGmshResult(folder.path())
                               : ReadTetgenResult(folder.path());
    if (!RestoreSurface(surface.points, &mesh) ||
        BorderFaces(mesh.tetrahedra, surface.triangles).empty()) {
      return {std::nullopt,
              "the mesher did not keep the triangles of the surfaces"};
    }
    Orient(&mesh);
    if (options.goal_dihedral_deg > 0) {
      ImproveElements(options.goal_dihedral_deg, surface.points.rows(), &mesh);
    }
    return {std::move(mesh), ""};
  } catch (const InputError& error) {
    return {std::nullopt,
            std::string("the mesher left no whole mesh: ") + error.what()};
  }
}

}  // namespace musclewarp
