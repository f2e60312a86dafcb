// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/label_images/nrrd_header.h"

#include <cstdlib>
#include <fstream>
#include <map>

#include "musclewarp/base/input_error.h"
#include "musclewarp/mesh_files/export_advice.h"
#include "musclewarp/mesh_files/text_cursor.h"

namespace musclewarp {
namespace {

using Fields = std::map<std::string, std::string>;

struct NrrdText {
  Fields fields;                // "sizes: 5 6 7"
  Fields values;                // "Segment0_Name:=femur"
  std::uint64_t data_from = 0;  // the byte behind the header
};

std::string Trimmed(const std::string& text) {
  const std::size_t begin = text.find_first_not_of(" \t\r");
  if (begin == std::string::npos) return "";
  return text.substr(begin, text.find_last_not_of(" \t\r") - begin + 1);
}

// A header ends with an empty line, or with the file if it has no data.
NrrdText ReadText(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  char magic[4] = {};
  file.read(magic, 4);
  if (!file || std::string_view(magic, 4) != "NRRD") {
    throw InputError(path,
                     "is not an NRRD file: it starts with " +
                         Quoted(std::string_view(magic, file.gcount())),
                     "name the file by what it holds");
  }
  NrrdText text;
  std::string line;
  std::getline(file, line);
  while (std::getline(file, line)) {
    line = Trimmed(line);
    if (line.empty()) {
      text.data_from = static_cast<std::uint64_t>(file.tellg());
      return text;
    }
    if (line[0] == '#') continue;
    const std::size_t value = line.find(":="), field = line.find(": ");
    if (value < field) {
      text.values[line.substr(0, value)] = line.substr(value + 2);
    } else if (field != std::string::npos) {
      text.fields[LowerCase(line.substr(0, field))] =
          Trimmed(line.substr(field + 2));
    }
  }
  throw InputError(path, "is truncated: its header has no end", kCopyAgain);
}

const std::string& Field(const std::string& path,
                         const Fields& fields,
                         const std::string& name) {
  const auto found = fields.find(name);
  if (found != fields.end()) return found->second;
  throw InputError(path, "has no field " + Quoted(name), kCopyAgain);
}

std::string Optional(const Fields& fields, const std::string& name) {
  const auto found = fields.find(name);
  return found == fields.end() ? "" : found->second;
}

void CheckIsRead(const std::string& path, const Fields& fields) {
  const std::string dimension = Field(path, fields, "dimension");
  if (dimension != "3") {
    throw InputError(
        path + ": dimension",
        "is " + Quoted(dimension) + "; allowed: 3, one number a voxel",
        "export one label map (3D Slicer: Segmentations, Export to labelmap; "
        "segments that overlap make a fourth dimension)");
  }
  for (const char* name : {"data file", "datafile"}) {
    if (fields.count(name) == 0) continue;
    throw InputError(path + ": " + name,
                     "names another file; allowed: data in the same file",
                     "save the image as one .nrrd file");
  }
  const std::string encoding = LowerCase(Field(path, fields, "encoding"));
  if (encoding != "raw" && encoding != "gzip" && encoding != "gz") {
    throw InputError(path + ": encoding",
                     "is " + Quoted(encoding) + "; allowed: raw, gzip",
                     "save the image again, compressed or raw");
  }
}

// What a unit of the file is in mm; `unstated` if it does not say.
double MillimetresOf(const std::string& path,
                     const Fields& fields,
                     double unstated) {
  const std::string units = Optional(fields, "space units");
  if (units.empty()) return unstated;
  const std::map<std::string, double> known = {
      {"mm", 1}, {"cm", 10}, {"m", 1000}, {"um", 1e-3}, {"", unstated}};
  const std::size_t begin = units.find('"');
  const std::size_t end = units.find('"', begin + 1);
  const std::string unit = begin == std::string::npos
                               ? units.substr(0, units.find(' '))
                               : units.substr(begin + 1, end - begin - 1);
  const auto found = known.find(unit);
  if (found != known.end()) return found->second;
  throw InputError(path + ": space units",
                   "is " + Quoted(units) + "; allowed: mm, cm, m, um",
                   "save the image in mm");
}

// The steps from voxel to voxel, from "space directions" or "spacings".
void SetSteps(const std::string& path,
              const Fields& fields,
              double mm_per_unit,
              ImageGrid* grid) {
  const std::string directions = Optional(fields, "space directions");
  if (!directions.empty()) {
    const std::vector<double> numbers =
        HeaderNumbers(path + ": space directions", directions, 9);
    for (int axis = 0; axis < 3; ++axis) {
      for (int k = 0; k < 3; ++k) {
        grid->world_from_index(k, axis) = numbers[3 * axis + k];
      }
    }
  } else {
    const std::vector<double> spacings =
        HeaderNumbers(path + ": spacings", Field(path, fields, "spacings"), 3);
    for (int axis = 0; axis < 3; ++axis) {
      grid->world_from_index(axis, axis) = spacings[axis];
    }
  }
  const std::string origin = Optional(fields, "space origin");
  if (!origin.empty()) {
    const std::vector<double> place =
        HeaderNumbers(path + ": space origin", origin, 3);
    for (int k = 0; k < 3; ++k) grid->world_from_index(k, 3) = place[k];
  }
  grid->world_from_index.topRows<3>() *=
      MillimetresOf(path, fields, mm_per_unit);
}

void Orient(const std::string& path, const Fields& fields, ImageGrid* grid) {
  const std::string space = LowerCase(Optional(fields, "space"));
  if (space == "left-posterior-superior" || space == "lps") {
    grid->is_oriented = true;
  } else if (space == "right-anterior-superior" || space == "ras") {
    TurnFromRas(grid);
  } else if (!space.empty() && space != "scanner-xyz" &&
             space != "3d-right-handed") {
    throw InputError(path + ": space",
                     "is " + Quoted(space) +
                         "; allowed: left-posterior-superior, "
                         "right-anterior-superior, scanner-xyz, "
                         "3D-right-handed",
                     "save the image in left-posterior-superior");
  }
}

// VTK gives each type the size that it has here; the names are those of NRRD.
int BytesOf(const std::string& path, const std::string& type) {
  static const std::map<std::string, int> kBytes = {
      {"signed char", 1},
      {"int8", 1},
      {"int8_t", 1},
      {"uchar", 1},
      {"unsigned char", 1},
      {"uint8", 1},
      {"uint8_t", 1},
      {"short", 2},
      {"short int", 2},
      {"signed short", 2},
      {"signed short int", 2},
      {"int16", 2},
      {"int16_t", 2},
      {"ushort", 2},
      {"unsigned short", 2},
      {"unsigned short int", 2},
      {"uint16", 2},
      {"uint16_t", 2},
      {"int", 4},
      {"signed int", 4},
      {"int32", 4},
      {"int32_t", 4},
      {"uint", 4},
      {"unsigned int", 4},
      {"uint32", 4},
      {"uint32_t", 4},
      {"longlong", 8},
      {"long long", 8},
      {"long long int", 8},
      {"signed long long", 8},
      {"signed long long int", 8},
      {"int64", 8},
      {"int64_t", 8},
      {"ulonglong", 8},
      {"unsigned long long", 8},
      {"unsigned long long int", 8},
      {"uint64", 8},
      {"uint64_t", 8},
      {"float", 4},
      {"double", 8}};
  const auto found = kBytes.find(type);
  if (found != kBytes.end()) return found->second;
  throw InputError(path + ": type",
                   "is " + Quoted(type) + "; allowed: whole and real numbers",
                   "save the image as labels of 8 or 16 bits");
}

void ReadSegments(const Fields& values, ImageGrid* grid) {
  for (const auto& [key, name] : values) {
    const std::size_t end = key.find("_Name");
    if (key.rfind("Segment", 0) != 0 || end == std::string::npos ||
        end + 5 != key.size()) {
      continue;
    }
    const auto label = values.find(key.substr(0, end) + "_LabelValue");
    if (label == values.end()) continue;
    grid->names[std::atoi(label->second.c_str())] = Trimmed(name);
  }
}

}  // namespace

ImageGrid ReadNrrdHeader(const std::string& path, double mm_per_unit) {
  const NrrdText text = ReadText(path);
  CheckIsRead(path, text.fields);
  ImageGrid grid;
  grid.size = HeaderSizes(path + ": sizes", Field(path, text.fields, "sizes"));
  SetSteps(path, text.fields, mm_per_unit, &grid);
  Orient(path, text.fields, &grid);
  ReadSegments(text.values, &grid);
  CheckGrid(path, grid);
  const int bytes = BytesOf(path, Field(path, text.fields, "type"));
  if (LowerCase(Field(path, text.fields, "encoding")) == "raw") {
    CheckDataSize(path, text.data_from, grid.NumVoxels() * bytes);
  }
  return grid;
}

}  // namespace musclewarp
