// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/mesh_files/stated_space.h"

#include <algorithm>
#include <cctype>
#include <filesystem>

#include "musclewarp/base/input_error.h"
#include "musclewarp/base/input_file.h"
#include "musclewarp/base/short_list.h"
#include "musclewarp/mesh_files/mesh_path.h"
#include "musclewarp/mesh_files/text_cursor.h"
#ifdef MUSCLEWARP_WITH_VTK
#include "musclewarp/mesh_files/vtp_texts.h"
#endif

namespace musclewarp {
namespace {

constexpr std::string_view kLps = "LPS", kRas = "RAS";

// Returns the space whose name the text starts with, or "".
std::string SpaceNamed(std::string_view text) {
  const std::string_view name = text.substr(0, kLps.size());
  const bool ends = text.size() == name.size() ||
                    !std::isalnum(static_cast<unsigned char>(text[3]));
  return ends && (name == kLps || name == kRas) ? std::string(name) : "";
}

// Returns the space behind "SPACE=" in a text.
std::string SpaceIn(std::string_view text) {
  constexpr std::string_view kKey = "SPACE=";
  const std::size_t key = text.find(kKey);
  return key == std::string_view::npos
             ? ""
             : SpaceNamed(text.substr(key + kKey.size()));
}

// A text of 80 bytes, or a first line.
std::string SpaceOfStl(std::string_view bytes) {
  constexpr std::size_t kTextSize = 80;
  return SpaceIn(bytes.substr(0, std::min(kTextSize, bytes.find('\n'))));
}

// Lines at the beginning of the file that start with `marks`, or `others`.
std::string SpaceOfComments(std::string_view bytes,
                            const std::vector<std::string_view>& marks,
                            const std::vector<std::string_view>& others) {
  const auto starts_with = [](std::string_view line, const auto& words) {
    return std::any_of(words.begin(), words.end(), [&](std::string_view word) {
      return line.substr(0, word.size()) == word;
    });
  };
  TextCursor cursor("", bytes);
  for (std::string_view line; cursor.NextLine(&line);) {
    if (starts_with(line, marks)) {
      const std::string space = SpaceIn(line);
      if (!space.empty()) return space;
    } else if (!line.empty() && !starts_with(line, others)) {
      break;
    }
  }
  return "";
}

// The title is the second line. Field data come before the points.
std::string SpaceOfLegacyVtk(std::string_view bytes) {
  std::string_view title;
  TextCursor cursor("", bytes);
  cursor.NextLine(&title);
  cursor.NextLine(&title);
  const std::string space = SpaceIn(title);
  if (!space.empty()) return space;
  constexpr std::string_view kField = "\nSPACE 1 1 string\n";
  const std::size_t field =
      bytes.substr(0, bytes.find("\nPOINTS ")).find(kField);
  if (field == std::string_view::npos) return "";
  std::string_view text = bytes.substr(field + kField.size());
  constexpr char kThreeBytes = '\xc3';  // before a text in binary data
  if (!text.empty() && text[0] == kThreeBytes) text = text.substr(1);
  return SpaceNamed(text.substr(0, kLps.size()));
}

std::string FilesText(const std::vector<std::string>& files) {
  return ShortList(files) + (files.size() == 1 ? " states" : " state");
}

}  // namespace

std::string StatedSpaceIn(const std::string& extension,
                          std::string_view bytes) {
  if (extension == ".stl") return SpaceOfStl(bytes);
  if (extension == ".vtk") return SpaceOfLegacyVtk(bytes);
  if (extension == ".obj") return SpaceOfComments(bytes, {"#"}, {"mtllib"});
  if (extension == ".ply") {
    return SpaceOfComments(bytes,
                           {"comment", "obj_info"},
                           {"ply", "format", "element", "property"});
  }
#ifdef MUSCLEWARP_WITH_VTK
  if (extension == ".vtp") return SpaceNamed(VtpFieldText(bytes, "SPACE"));
#endif
  return "";
}

std::string StatedSpace(const std::string& path) {
  const std::string file = MeshFileOf(path);
  try {
    return StatedSpaceIn(
        LowerCase(std::filesystem::path(file).extension().string()),
        ReadFile(file));
  } catch (const InputError&) {
    return "";
  }
}

CommonSpace FindCommonSpace(const std::vector<StatedFile>& files,
                            const std::string& axes,
                            const std::string& axes_place) {
  CommonSpace common;
  common.is_turned.resize(files.size());
  const StatedFile* first[2] = {nullptr, nullptr};  // in LPS, in RAS
  const StatedFile* reference = nullptr;
  std::vector<std::string> stated, silent;
  for (const StatedFile& file : files) {
    (file.space.empty() ? silent : stated).push_back(file.file);
    if (file.space.empty()) continue;
    if (!reference) reference = &file;
    const StatedFile*& same = first[file.space == kRas];
    if (!same) same = &file;
  }
  if (!reference) return common;
  common.space = reference->space;
  if (!first[0] || !first[1]) {
    if (axes.empty() || axes == reference->space) return common;
    common.warnings.push_back(
        FilesText(stated) + " the space " + reference->space + ", and " +
        axes_place + " says " + axes +
        ": the meshes are taken as they are; correct what is wrong");
    return common;
  }
  const bool is_given = axes == kLps || axes == kRas;
  const std::string space = is_given ? axes : reference->space;
  common.space = space;
  const StatedFile& other = *first[space == kRas];
  for (size_t i = 0; i < files.size(); ++i) {
    if (files[i].space.empty() || files[i].space == space) continue;
    common.is_turned[i] = true;
    common.warnings.push_back(
        files[i].file + " states the space " + files[i].space + ", and " +
        other.file + " " + other.space + ": x and y of " + files[i].file +
        " change their signs, so that it is in " + space + ", too");
  }
  if (!silent.empty()) {
    common.warnings.push_back(
        FilesText(silent) + " no space, while others state " +
        "LPS and RAS: "
        "taken as " +
        (silent.size() == 1 ? "it is" : "they are") + ", in " + space);
  }
  return common;
}

void CheckOneSpace(const std::vector<StatedFile>& files) {
  const StatedFile* first = nullptr;
  for (const StatedFile& file : files) {
    if (file.space.empty()) continue;
    if (!first) first = &file;
    if (file.space == first->space) continue;
    throw InputError(file.file,
                     "states the space " + file.space + ", and " + first->file +
                         " " + first->space + "; allowed: one for all meshes",
                     "export all meshes in one space");
  }
}

void TurnToOtherSpace(Points* points) { points->leftCols<2>() *= -1; }

}  // namespace musclewarp
