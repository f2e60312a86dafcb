// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/mesh_files/mesh_parts.h"

#include <algorithm>

#include "musclewarp/base/input_error.h"
#include "musclewarp/base/short_list.h"
#include "musclewarp/mesh/connectivity.h"

namespace musclewarp {
namespace {

bool Has(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

// A name that several parts have is listed once.
std::vector<std::string> DifferentNames(const std::vector<std::string>& names) {
  std::vector<std::string> different;
  for (const std::string& name : names) {
    if (!Has(different, name)) different.push_back(name);
  }
  return different;
}

[[noreturn]] void FailWithoutPart(const std::string& file,
                                  const std::string& name,
                                  const MeshParts& parts) {
  if (parts.kind.empty()) {
    throw InputError(
        file,
        "has no part \"" + name +
            "\": only the objects and groups of .obj and the solids of ASCII "
            ".stl files have names, and this file has none",
        "leave out \"#" + name + "\"");
  }
  const bool is_empty = Has(parts.empty, name);
  throw InputError(
      file,
      is_empty ? "has no face in its " + parts.kind + " \"" + name + "\""
               : "has no " + parts.kind + " \"" + name + "\"",
      "allowed: " + ShortList(DifferentNames(parts.names), 30));
}

}  // namespace

std::string PartName(std::string_view text) {
  const auto is_blank = [](char c) {
    return c == ' ' || c == '\t' || c == '\v' || c == '\f' || c == '\r';
  };
  std::string name;
  bool has_gap = false;
  for (const char c : text) {
    if (is_blank(c)) {
      has_gap = !name.empty();
      continue;
    }
    if (has_gap) name += ' ';
    has_gap = false;
    name += c;
  }
  return name;
}

PartCollector::PartCollector(Again again, const char* first)
    : again_(again), names_({first}) {}

void PartCollector::Start(const std::string& name) {
  has_parts_ = true;
  if (again_ == Again::kContinues) {
    const auto same = std::find(names_.begin(), names_.end(), name);
    if (same != names_.end()) {
      current_ = static_cast<int>(same - names_.begin());
      return;
    }
  }
  current_ = static_cast<int>(names_.size());
  names_.push_back(name);
}

MeshParts PartCollector::Parts(const char* kind,
                               const std::vector<int>& face_of_triangle) const {
  MeshParts parts;
  if (!has_parts_) return parts;
  parts.kind = kind;
  std::vector<bool> is_used(names_.size());
  for (const int face : face_of_triangle) is_used[part_of_face_[face]] = true;
  std::vector<int> new_index(names_.size());
  for (size_t i = 0; i < names_.size(); ++i) {
    new_index[i] = static_cast<int>(parts.names.size());
    // The first stands for what is before all parts.
    if (is_used[i]) {
      parts.names.push_back(names_[i]);
    } else if (i > 0) {
      parts.empty.push_back(names_[i]);
    }
  }
  for (const int face : face_of_triangle) {
    parts.part_of.push_back(new_index[part_of_face_[face]]);
  }
  return parts;
}

TriangleSoup MeshOfPart(const TriangleSoup& soup,
                        const MeshParts& parts,
                        int part) {
  std::vector<bool> keep(parts.part_of.size());
  for (size_t f = 0; f < keep.size(); ++f) keep[f] = parts.part_of[f] == part;
  TriangleSoup mesh = soup;
  KeepTriangles(keep, &mesh.triangles);
  DropUnreferencedPoints(&mesh);
  return mesh;
}

void KeepPart(const std::string& file,
              const std::string& name,
              TriangleSoup* soup,
              MeshParts* parts) {
  const std::string wanted = PartName(name);
  if (!Has(parts->names, wanted)) FailWithoutPart(file, wanted, *parts);
  MeshParts kept;
  kept.kind = parts->kind;
  std::vector<int> new_index(parts->names.size(), -1);
  for (size_t i = 0; i < parts->names.size(); ++i) {
    if (parts->names[i] != wanted) continue;
    new_index[i] = static_cast<int>(kept.names.size());
    kept.names.push_back(wanted);
  }
  std::vector<bool> keep(parts->part_of.size());
  for (size_t f = 0; f < keep.size(); ++f) {
    const int part = new_index[parts->part_of[f]];
    keep[f] = part >= 0;
    if (keep[f]) kept.part_of.push_back(part);
  }
  KeepTriangles(keep, &soup->triangles);
  DropUnreferencedPoints(soup);
  *parts = std::move(kept);
}

}  // namespace musclewarp
