// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/mesh_files/mesh_path.h"

#include <filesystem>

#include "musclewarp/base/portable_path.h"
#include "musclewarp/mesh_files/mesh_io.h"
#include "musclewarp/mesh_files/mesh_parts.h"

namespace musclewarp {
namespace {

namespace fs = std::filesystem;

constexpr char kMark = '#';

// Returns the first "#" before which `is_file` holds, or npos.
template <typename IsFile>
size_t FindMark(const std::string& path, const IsFile& is_file) {
  size_t mark = path.find(kMark);
  while (mark != std::string::npos && !is_file(path.substr(0, mark))) {
    mark = path.find(kMark, mark + 1);
  }
  return mark;
}

}  // namespace

MeshPath SplitMeshPath(const std::string& path) {
  const auto is_there = [](const std::string& file) {
    std::error_code error;
    return fs::is_regular_file(file, error);
  };
  if (path.find(kMark) == std::string::npos || is_there(path))
    return {path, {}};
  size_t mark = FindMark(path, is_there);
  if (mark == std::string::npos) {
    mark = FindMark(path, [](const std::string& file) {
      return IsMeshExtension(fs::path(file).extension().string());
    });
  }
  if (mark == std::string::npos) return {path, {}};
  return {path.substr(0, mark), path.substr(mark + 1)};
}

std::string MeshFileOf(const std::string& path) {
  return SplitMeshPath(path).file;
}

std::string MeshNameOf(const std::string& path) {
  const MeshPath split = SplitMeshPath(path);
  return split.part ? PartName(*split.part)
                    : fs::path(split.file).stem().string();
}

std::string MeshPathFrom(const std::string& folder, const std::string& path) {
  const MeshPath split = SplitMeshPath(path);
  const std::string file = PathFrom(folder, split.file);
  return split.part ? file + kMark + *split.part : file;
}

}  // namespace musclewarp
