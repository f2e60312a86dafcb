// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/opensim/geometry_files.h"

#include <algorithm>
#include <filesystem>

#include "musclewarp/base/input_error.h"

namespace musclewarp {
namespace {

namespace fs = std::filesystem;

constexpr char kGeometryFolder[] = "Geometry";

void AddFolder(const fs::path& folder, std::vector<std::string>* folders) {
  std::error_code error;
  if (!fs::is_directory(folder, error)) return;
  const std::string name = folder.lexically_normal().string();
  if (std::count(folders->begin(), folders->end(), name) == 0) {
    folders->push_back(name);
  }
}

bool IsFile(const fs::path& path) {
  std::error_code error;
  return fs::is_regular_file(path, error);
}

// True for paths of Windows, too, such as "C:/geometry/femur.vtp".
bool IsAbsolute(const std::string& file) {
  return fs::path(file).is_absolute() ||
         (file.size() > 2 && file[1] == ':' && file[2] == '/');
}

}  // namespace

std::vector<std::string> GeometryFolders(
    const Model& model, const std::vector<std::string>& folders) {
  const fs::path folder = fs::absolute(model.path).parent_path();
  std::vector<std::string> all;
  AddFolder(folder, &all);
  for (const char* name : {kGeometryFolder, "geometry"}) {
    AddFolder(folder / name, &all);
  }
  for (const std::string& given : folders) AddFolder(fs::absolute(given), &all);
  for (fs::path above = folder; above != above.parent_path();) {
    above = above.parent_path();
    AddFolder(above / kGeometryFolder, &all);
  }
  return all;
}

std::string FindGeometry(const ModelGeometry& geometry,
                         const std::vector<std::string>& folders) {
  fs::path file = geometry.file;
  if (IsAbsolute(geometry.file)) {
    if (IsFile(file)) return file.string();
    file = file.filename();
  }
  for (const std::string& folder : folders) {
    const fs::path path = fs::path(folder) / file;
    if (IsFile(path)) return path.lexically_normal().string();
  }
  return "";
}

std::string GeometryFile(const Model& model,
                         const ModelGeometry& geometry,
                         const std::vector<std::string>& folders) {
  const auto searched = GeometryFolders(model, folders);
  const std::string path = FindGeometry(geometry, searched);
  if (!path.empty()) return path;
  std::string list;
  for (const std::string& folder : searched) {
    list += (list.empty() ? "" : ", ") + folder;
  }
  throw InputError(model.path,
                   "names the geometry file \"" + geometry.file +
                       "\", which is in none of the folders " + list,
                   "give its folder with {geometry} or \"geometry\" in the "
                   "scene, put it beside the model, or give the bone a "
                   "\"mesh\"");
}

}  // namespace musclewarp
