// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/label_images/meta_image_header.h"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <initializer_list>
#include <map>

#include "musclewarp/base/input_error.h"
#include "musclewarp/mesh_files/export_advice.h"
#include "musclewarp/mesh_files/text_cursor.h"

namespace musclewarp {
namespace {

namespace fs = std::filesystem;

// A header has a few kilobytes; a file with more lines is not a MetaImage.
constexpr int kMostHeaderLines = 1000;

struct MetaText {
  std::map<std::string, std::string> fields;
  std::uint64_t data_from = 0;  // the first byte after the header
};

std::string WithoutBlanks(const std::string& text) {
  const std::size_t begin = text.find_first_not_of(" \t\r");
  if (begin == std::string::npos) return "";
  return text.substr(begin, text.find_last_not_of(" \t\r") - begin + 1);
}

// ElementDataFile is the last field.
MetaText ReadMetaText(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  MetaText text;
  std::string line;
  for (int i = 0; i < kMostHeaderLines && std::getline(file, line); ++i) {
    const std::size_t equals = line.find('=');
    if (equals == std::string::npos) break;
    const std::string name = WithoutBlanks(line.substr(0, equals));
    text.fields[name] = WithoutBlanks(line.substr(equals + 1));
    if (name != "ElementDataFile") continue;
    text.data_from = static_cast<std::uint64_t>(file.tellg());
    return text;
  }
  throw InputError(path,
                   "is not a MetaImage, or its header is truncated: it has no "
                   "field ElementDataFile",
                   kCopyAgain);
}

// Returns the field with the first of several names that exists, or "".
std::string FieldOf(const MetaText& text,
                    const std::initializer_list<const char*>& names) {
  for (const char* name : names) {
    const auto found = text.fields.find(name);
    if (found != text.fields.end()) return found->second;
  }
  return "";
}

int BytesOfElement(const std::string& path, const std::string& type) {
  static const std::map<std::string, int> kBytes = {{"MET_CHAR", 1},
                                                    {"MET_UCHAR", 1},
                                                    {"MET_SHORT", 2},
                                                    {"MET_USHORT", 2},
                                                    {"MET_INT", 4},
                                                    {"MET_UINT", 4},
                                                    {"MET_FLOAT", 4},
                                                    {"MET_DOUBLE", 8}};
  const auto found = kBytes.find(type);
  if (found != kBytes.end()) return found->second;
  throw InputError(path + ": ElementType",
                   "is " + Quoted(type) +
                       "; allowed: MET_CHAR, MET_UCHAR, MET_SHORT, MET_USHORT, "
                       "MET_INT, MET_UINT, MET_FLOAT, MET_DOUBLE",
                   "save the image as labels of 8 or 16 bits");
}

void CheckFields(const std::string& path, const MetaText& text) {
  const std::string dimensions = FieldOf(text, {"NDims"});
  if (dimensions != "3") {
    throw InputError(path + ": NDims",
                     "is " + Quoted(dimensions) + "; allowed: 3",
                     "export one label map");
  }
  const std::string channels = FieldOf(text, {"ElementNumberOfChannels"});
  if (!channels.empty() && channels != "1") {
    throw InputError(
        path + ": ElementNumberOfChannels",
        "is " + Quoted(channels) + "; allowed: 1, one number a voxel",
        "export one label map");
  }
}

void SetMetaSteps(const std::string& path,
                  const MetaText& text,
                  ImageGrid* grid) {
  Eigen::Matrix3d directions = Eigen::Matrix3d::Identity();
  const std::string matrix =
      FieldOf(text, {"TransformMatrix", "Rotation", "Orientation"});
  if (!matrix.empty()) {
    const std::vector<double> numbers =
        HeaderNumbers(path + ": TransformMatrix", matrix, 9);
    for (int axis = 0; axis < 3; ++axis) {
      for (int k = 0; k < 3; ++k) directions(k, axis) = numbers[3 * axis + k];
    }
  }
  const std::string spacing = FieldOf(text, {"ElementSpacing", "ElementSize"});
  const std::vector<double> steps = HeaderNumbers(
      path + ": ElementSpacing", spacing.empty() ? "1 1 1" : spacing, 3);
  const std::string offset = FieldOf(text, {"Offset", "Position", "Origin"});
  const std::vector<double> origin =
      HeaderNumbers(path + ": Offset", offset.empty() ? "0 0 0" : offset, 3);
  for (int axis = 0; axis < 3; ++axis) {
    grid->world_from_index.col(axis).head<3>() =
        directions.col(axis) * steps[axis];
    grid->world_from_index(axis, 3) = origin[axis];
  }
  grid->is_oriented = true;
}

// Checks the size of the data. The header states the size of compressed data,
// unless they are in a separate file.
void CheckData(const std::string& path,
               const MetaText& text,
               std::uint64_t bytes) {
  const std::string name = FieldOf(text, {"ElementDataFile"});
  if (name == "LIST" || name.find('%') != std::string::npos) {
    throw InputError(path + ": ElementDataFile",
                     "is " + Quoted(name) + "; allowed: LOCAL, or one file",
                     "save the image as one .mha file");
  }
  const std::string compressed = LowerCase(FieldOf(text, {"CompressedData"}));
  const bool is_compressed = compressed == "true" || compressed == "1";
  if (is_compressed) {
    bytes = std::strtoull(
        FieldOf(text, {"CompressedDataSize"}).c_str(), nullptr, 10);
  }
  const bool is_local = LowerCase(name) == "local";
  const fs::path file =
      is_local ? fs::path(path) : fs::path(path).parent_path() / name;
  std::error_code error;
  if (!fs::is_regular_file(file, error)) {
    throw InputError(path + ": ElementDataFile",
                     "names " + file.string() + ", which does not exist",
                     "copy it beside the header");
  }
  CheckDataSize(file.string(), is_local ? text.data_from : 0, bytes);
}

}  // namespace

ImageGrid ReadMetaImageHeader(const std::string& path, double mm_per_unit) {
  const MetaText text = ReadMetaText(path);
  CheckFields(path, text);
  ImageGrid grid;
  grid.size = HeaderSizes(path + ": DimSize", FieldOf(text, {"DimSize"}));
  SetMetaSteps(path, text, &grid);
  grid.world_from_index.topRows<3>() *= mm_per_unit;
  CheckGrid(path, grid);
  CheckData(
      path,
      text,
      grid.NumVoxels() * BytesOfElement(path, FieldOf(text, {"ElementType"})));
  return grid;
}

}  // namespace musclewarp
