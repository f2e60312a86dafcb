// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "tools/check_command.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iomanip>
#include <limits>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>

#include "musclewarp/base/input_error.h"
#include "musclewarp/base/output_file.h"
#include "musclewarp/base/text.h"
#include "musclewarp/label_images/label_image_file.h"
#include "musclewarp/mesh/defects.h"
#include "musclewarp/mesh/measures.h"
#include "musclewarp/mesh_files/mesh_io.h"
#include "musclewarp/mesh_files/mesh_path.h"
#include "musclewarp/mesh_files/stated_space.h"
#include "musclewarp/program/program.h"
#include "musclewarp/proximity/mesh_intersection.h"
#include "musclewarp/proximity/triangle_distance.h"
#include "musclewarp/run/report_json.h"
#include "musclewarp/run/run_files.h"
#include "musclewarp/scene/length_unit.h"
#include "musclewarp/settings/checked_settings.h"

namespace musclewarp {
namespace {

using OrderedJson = nlohmann::ordered_json;

struct CheckedFile {
  std::string path;
  std::string name;  // for the table
  std::unique_ptr<SearchableMesh> mesh;
  MeshDefects defects;
  double volume = 0;  // mm^3; undefined unless the mesh is oriented
  bool is_oriented = false;
  double area = 0;  // mm^2
  size_t self_pairs = 0;
  bool is_bone = false;
};

struct CheckedPair {
  const CheckedFile* a;
  const CheckedFile* b;
  MeshIntersection found;
  double distance = 0;  // mm; 0 if the meshes touch

  // Bones do not move; their crossings do not count.
  bool AreBones() const { return a->is_bone && b->is_bone; }
  bool IsNearerThan(double gap) const { return !AreBones() && distance < gap; }
};

CheckedFile CheckFile(const std::string& path, TriangleSoup soup) {
  CheckedFile file;
  file.path = path;
  file.name = MeshNameOf(path);
  file.defects = CountDefects(soup);
  file.volume = SignedVolume(soup.points, soup.triangles);
  file.is_oriented = IsConsistentlyOriented(soup.triangles);
  file.area = SurfaceArea(soup.points, soup.triangles);
  file.mesh = std::make_unique<SearchableMesh>(std::move(soup));
  file.self_pairs = SelfIntersections(file.mesh->bvh()).size();
  return file;
}

// Adds a note if a mesh is too small or too large for one of a body, as one in
// another unit is.
void AskForUnit(const std::string& path,
                const Points& points,
                double mm_per_unit,
                std::vector<std::string>* notes) {
  try {
    CheckMuscleSize(
        path, BoundingBoxDiagonal(points), std::nullopt, mm_per_unit);
  } catch (const InputError& error) {
    notes->push_back(path + " " + error.problem());
  }
}

// Calls visit(path, mesh) for the mesh of a file, or each mesh of a folder.
template <typename Visitor>
void VisitMeshes(const std::string& path,
                 std::vector<std::string>* notes,
                 const Visitor& visit) {
  if (IsLabelImageFile(path)) {
    throw InputError(
        path,
        "is a label image; allowed here: meshes (" + MeshFormats() + ")",
        "musclewarp-separate makes meshes of its labels");
  }
  if (!std::filesystem::is_directory(path)) {
    visit(path, ReadTriangleSoup(path, notes));
    return;
  }
  const FrameFiles frame = FrameFilesIn(path);
  for (const auto& [name, file] : frame.meshes) {
    const auto file_name = std::filesystem::path(file).filename();
    visit((std::filesystem::path(path) / file_name).string(),
          ReadMeshOfFrame(frame, name));
  }
}

// Returns the files that have to be turned so that all meshes are in one space,
// and adds a note on each to `notes`.
std::set<std::string> TurnedFiles(const std::vector<std::string>& files,
                                  const std::vector<std::string>& bones,
                                  std::vector<std::string>* notes) {
  std::vector<StatedFile> stated;
  std::set<std::string> seen;
  for (const auto* paths : {&files, &bones}) {
    for (const std::string& path : *paths) {
      // Bones may also be names of meshes among the files.
      if (!std::filesystem::is_regular_file(MeshFileOf(path))) continue;
      if (!seen.insert(path).second) continue;
      stated.push_back({path, StatedSpace(path)});
    }
  }
  const CommonSpace common = FindCommonSpace(stated);
  std::set<std::string> turned;
  for (size_t i = 0; i < stated.size(); ++i) {
    if (common.is_turned[i]) turned.insert(stated[i].file);
  }
  notes->insert(notes->end(), common.warnings.begin(), common.warnings.end());
  return turned;
}

// Returns the smallest distance of two meshes that do not touch, mm, or
// infinity if one of them has no triangles.
double SmallestDistance(const TriangleBvh& a, const TriangleBvh& b) {
  if (a.num_triangles() > b.num_triangles()) return SmallestDistance(b, a);
  double least = std::numeric_limits<double>::infinity();  // squared
#pragma omp parallel for reduction(min : least) schedule(dynamic, 256)
  for (int f = 0; f < a.num_triangles(); ++f) {
    const Corners& triangle = a.corners(f);
    const Box3 box = BoxOf(triangle);
    b.TraverseNearestFirst(
        [&](const Box3& other) { return box.SquaredDistance(other); },
        [&](int g) {
          const auto pair = ClosestPointsOfTriangles(triangle, b.corners(g));
          least = std::min(least, pair.squared_distance);
        },
        &least);
  }
  return std::sqrt(least);
}

std::vector<CheckedPair> CheckPairs(const std::vector<CheckedFile>& files) {
  std::vector<CheckedPair> pairs;
  for (size_t a = 0; a < files.size(); ++a) {
    for (size_t b = a + 1; b < files.size(); ++b) {
      pairs.push_back({&files[a],
                       &files[b],
                       IntersectMeshes(*files[a].mesh, *files[b].mesh)});
      if (!pairs.back().found.IsEmpty()) continue;
      pairs.back().distance =
          SmallestDistance(files[a].mesh->bvh(), files[b].mesh->bvh());
    }
  }
  return pairs;
}

OrderedJson ToJson(const CheckedFile& file) {
  const Points& points = file.mesh->points();
  const Eigen::RowVector3d low = points.colwise().minCoeff();
  const Eigen::RowVector3d high = points.colwise().maxCoeff();
  return {{"file", file.path},
          {"bone", file.is_bone},
          {"vertices", points.rows()},
          {"triangles", file.mesh->triangles().rows()},
          {"closed_manifold", file.defects.is_closed_manifold},
          {"clean", file.defects.IsClean()},
          {"defects", DefectsJson(file.defects)},
          {"volume_mm3", file.volume},
          {"oriented", file.is_oriented},
          {"area_mm2", file.area},
          {"bounding_box_mm",
           {{low[0], low[1], low[2]}, {high[0], high[1], high[2]}}},
          {"self_pairs", file.self_pairs}};
}

OrderedJson ToJson(const CheckedPair& pair) {
  return {{"a", pair.a->path},
          {"b", pair.b->path},
          {"triangle_pairs", pair.found.triangle_pairs.size()},
          {"a_vertices_inside_b", pair.found.a_inside_b.size()},
          {"b_vertices_inside_a", pair.found.b_inside_a.size()},
          {"a_depth_mm", pair.found.a_depth_mm},
          {"b_depth_mm", pair.found.b_depth_mm},
          {"max_depth_mm", pair.found.max_depth_mm},
          {"distance_mm", pair.distance},
          {"bones", pair.AreBones()}};
}

// Returns the volume of a mesh in cm3, or "-" if the mesh is not consistently
// oriented.
std::string VolumeText(const CheckedFile& file) {
  if (!file.is_oriented) return "-";
  return FixedText(file.volume / 1000, 2);
}

std::string DefectsText(const MeshDefects& defects) {
  std::string text;
  const auto add = [&](int count, const std::string& what) {
    if (count == 0) return;
    text += (text.empty() ? "" : ", ") + std::to_string(count) + " " + what;
  };
  add(defects.duplicate_points, "duplicate points");
  add(defects.unreferenced_points, "unused points");
  add(defects.degenerate_triangles, "degenerate triangles");
  add(defects.duplicate_triangles, "duplicate triangles");
  add(defects.border_edges, "border edges");
  add(defects.non_manifold_edges, "non-manifold edges");
  add(defects.non_manifold_vertices, "non-manifold vertices");
  add(defects.misoriented_edges, "misoriented edges");
  if (defects.components > 1) add(defects.components, "pieces");
  if (defects.is_inside_out)
    text += (text.empty() ? "" : ", ") + std::string("inside out");
  return text.empty() ? "none" : text;
}

void PrintFiles(const std::vector<CheckedFile>& files,
                int width,
                std::ostream& screen) {
  screen << std::left << std::setw(width) << "mesh" << std::right
         << "  vertices  triangles  volume cm3  self pairs  defects\n";
  for (const CheckedFile& file : files) {
    screen << std::left << std::setw(width) << file.name << std::right
           << std::setw(10) << file.mesh->points().rows() << std::setw(11)
           << file.mesh->triangles().rows() << std::setw(12) << VolumeText(file)
           << std::setw(12) << file.self_pairs << "  "
           << DefectsText(file.defects) << "\n";
  }
}

void PrintDistances(const std::vector<CheckedPair>& pairs,
                    int width,
                    std::ostream& screen) {
  screen << "\n"
         << std::left << std::setw(width) << "a"
         << "  " << std::setw(width) << "b" << std::right << "  distance mm\n";
  for (const CheckedPair& pair : pairs) {
    if (!pair.found.IsEmpty()) continue;
    screen << std::left << std::setw(width) << pair.a->name << "  "
           << std::setw(width) << pair.b->name << std::right
           << std::defaultfloat << std::setprecision(4) << std::setw(13)
           << pair.distance << "\n";
  }
}

void PrintPairs(const std::vector<CheckedPair>& pairs,
                double gap,
                int width,
                std::ostream& screen) {
  int apart = 0;
  for (const CheckedPair& pair : pairs) apart += pair.found.IsEmpty();
  if (apart < static_cast<int>(pairs.size())) {
    screen << "\n"
           << std::left << std::setw(width) << "a"
           << "  " << std::setw(width) << "b" << std::right
           << "  crossing pairs  a inside b  b inside a  depth mm\n";
  }
  for (const CheckedPair& pair : pairs) {
    if (pair.found.IsEmpty()) continue;
    screen << std::left << std::setw(width) << pair.a->name << "  "
           << std::setw(width) << pair.b->name << std::right << std::setw(16)
           << pair.found.triangle_pairs.size() << std::setw(12)
           << pair.found.a_inside_b.size() << std::setw(12)
           << pair.found.b_inside_a.size() << std::fixed << std::setprecision(2)
           << std::setw(10) << pair.found.max_depth_mm << "\n";
  }
  if (apart > 0) PrintDistances(pairs, width, screen);
  if (!pairs.empty()) {
    screen << "\n"
           << pairs.size() - apart << " of " << pairs.size()
           << " pairs of meshes touch, " << apart << " are apart\n";
  }
  if (gap > 0) {
    const auto near =
        std::count_if(pairs.begin(), pairs.end(), [&](const CheckedPair& pair) {
          return pair.IsNearerThan(gap);
        });
    screen << near << " of " << pairs.size()
           << " pairs of meshes are less than " << std::defaultfloat << gap
           << " mm apart\n";
  }
}

void PrintBonePairs(const std::vector<CheckedPair>& pairs,
                    std::ostream& screen) {
  for (const CheckedPair& pair : pairs) {
    if (!pair.AreBones() || pair.found.IsEmpty()) continue;
    screen << pair.a->name << " and " << pair.b->name
           << " are bones: that they cross does not count\n";
  }
}

}  // namespace

int CheckCommand(const std::vector<std::string>& files,
                 const CheckOptions& options,
                 std::ostream& screen) {
  if (files.empty() && options.bone.empty()) {
    throw InputError("files", "none given", "name at least one mesh file");
  }
  CheckSettings(options);
  UseThreads(options);
  std::vector<std::string> bones = Split(options.bone, ',');
  std::vector<CheckedFile> checked;
  std::vector<std::string> notes;
  const std::set<std::string> turned = TurnedFiles(files, bones, &notes);
  size_t width = 4;
  const auto check = [&](const std::string& path, TriangleSoup soup) {
    if (turned.count(path) > 0) TurnToOtherSpace(&soup.points);
    soup.points *= options.MmPerUnit();
    AskForUnit(path, soup.points, options.MmPerUnit(), &notes);
    checked.push_back(CheckFile(path, std::move(soup)));
    width = std::max(width, checked.back().name.size());
  };
  for (const std::string& path : files) VisitMeshes(path, &notes, check);
  for (CheckedFile& file : checked) {
    const auto named =
        std::find_if(bones.begin(), bones.end(), [&](const std::string& bone) {
          return bone == file.name || bone == file.path;
        });
    file.is_bone = named != bones.end();
    if (file.is_bone) bones.erase(named);
  }
  for (const std::string& path : bones) {
    check(path, ReadTriangleSoup(path, &notes));
    checked.back().is_bone = true;
  }
  const std::vector<CheckedPair> pairs = CheckPairs(checked);

  if (!options.json.empty()) {
    OrderedJson json = {{"files", OrderedJson::array()},
                        {"pairs", OrderedJson::array()}};
    for (const auto& file : checked) json["files"].push_back(ToJson(file));
    for (const auto& pair : pairs) json["pairs"].push_back(ToJson(pair));
    json["notes"] = notes;
    WriteTextAtomically(options.json, json.dump(2) + "\n");
  }
  for (const std::string& note : notes) screen << note << "\n";
  PrintFiles(checked, static_cast<int>(width), screen);
  PrintPairs(pairs, options.gap, static_cast<int>(width), screen);
  PrintBonePairs(pairs, screen);
  for (const CheckedPair& pair : pairs) {
    if (options.require_clean && !pair.found.IsEmpty() && !pair.AreBones()) {
      return kExitNotUsable;
    }
    if (pair.IsNearerThan(options.gap)) return kExitNotUsable;
  }
  return kExitUsable;
}

}  // namespace musclewarp
