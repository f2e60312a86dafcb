// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/label_images/nrrd_header.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <optional>
#include <sstream>

#include "musclewarp/base/input_error.h"
#include "musclewarp/label_images/nrrd_text.h"
#include "musclewarp/mesh_files/export_advice.h"
#include "musclewarp/mesh_files/text_cursor.h"

namespace musclewarp {
namespace {

namespace fs = std::filesystem;

constexpr int kMostAxes = 16;  // of the format

const char* const kOneLayer =
    "make one label map of it: in 3D Slicer, Segmentations, Export to "
    "labelmap, "
    "or Binary labelmap layers, Force collapse to single layer";

std::string Required(const std::string& path,
                     const NrrdText& text,
                     const std::string& name) {
  const std::string field = text.Find(name);
  if (!field.empty()) return field;
  throw InputError(path, "has no field " + Quoted(name), kCopyAgain);
}

// An axis of the file.
struct NrrdAxis {
  double size = 0;
  std::string kind;

  // None: the axis is not spatial. A spacing is along x.
  std::optional<Eigen::Vector3d> step;

  bool IsSpace() const {
    return kind.empty() || kind == "domain" || kind == "space" || kind == "???";
  }
};

std::vector<NrrdAxis> AxesOf(const std::string& path, const NrrdText& text) {
  const std::string dimension = Required(path, text, "dimension");
  int count = 0;
  const auto [rest, error] = std::from_chars(
      dimension.data(), dimension.data() + dimension.size(), count);
  if (error != std::errc() || rest != dimension.data() + dimension.size() ||
      count < 3 || count > kMostAxes) {
    throw InputError(path + ": dimension",
                     "is " + Quoted(dimension) +
                         "; allowed: 3, and more with axes of one voxel",
                     "export one label map of three dimensions");
  }
  std::vector<NrrdAxis> axes(count);
  const std::string sizes = Required(path, text, "sizes");
  const std::vector<double> numbers =
      HeaderNumbers(path + ": sizes", sizes, count);
  std::istringstream kinds(LowerCase(text.Find("kinds")));
  for (int axis = 0; axis < count; ++axis) {
    const double size = numbers[axis];
    if (size != std::floor(size) || size < 1 || size > 1e9) {
      throw InputError(
          path + ": sizes",
          "is " + Quoted(sizes) + "; allowed: whole numbers above 0",
          kCopyAgain);
    }
    axes[axis].size = size;
    kinds >> axes[axis].kind;
  }
  return axes;
}

// Splits "none (1,0,0) (0,1,0)" before blanks and parentheses.
std::vector<std::string> VectorsIn(const std::string& text) {
  std::vector<std::string> vectors;
  std::size_t begin = 0;
  while ((begin = text.find_first_not_of(" \t", begin)) != std::string::npos) {
    std::size_t end = text[begin] == '(' ? text.find(')', begin)
                                         : text.find_first_of(" \t(", begin);
    if (end == std::string::npos) end = text.size();
    if (end < text.size() && text[end] == ')') ++end;
    vectors.push_back(text.substr(begin, end - begin));
    begin = end;
  }
  return vectors;
}

// Sets the steps from "space directions", with a vector or "none" for each
// axis, or from "spacings", with a length or "nan".
void SetSteps(const std::string& path,
              const NrrdText& text,
              std::vector<NrrdAxis>* axes) {
  const std::string directions = text.Find("space directions");
  const bool has_directions = !directions.empty();
  const std::string name = has_directions ? "space directions" : "spacings";
  const std::string where = path + ": " + name;
  const std::vector<std::string> steps = VectorsIn(Required(path, text, name));
  if (steps.size() != axes->size()) {
    throw InputError(where,
                     "has " + std::to_string(steps.size()) + " for " +
                         std::to_string(axes->size()) + " axes",
                     kCopyAgain);
  }
  for (std::size_t axis = 0; axis < steps.size(); ++axis) {
    NrrdAxis& of = (*axes)[axis];
    const std::string step = LowerCase(steps[axis]);
    if (step == "none" || step.find("nan") != std::string::npos) continue;
    const std::vector<double> numbers =
        HeaderNumbers(where, step, has_directions ? 3 : 1);
    of.step = Eigen::Vector3d::Zero();
    if (has_directions) {
      *of.step = Eigen::Map<const Eigen::Vector3d>(numbers.data());
    } else {
      (*of.step)[0] = numbers[0];
    }
  }
}

// Keeps the three spatial axes. Other axes, which must have one voxel, are
// removed: those without a direction in space, and surplus ones.
void KeepSpace(const std::string& path, std::vector<NrrdAxis>* axes) {
  const auto leave_out = [&](const auto& is_meant) {
    for (std::size_t i = axes->size(); i-- > 0;) {
      const NrrdAxis& axis = (*axes)[i];
      if (axis.size == 1 && is_meant(axis)) axes->erase(axes->begin() + i);
    }
  };
  leave_out([](const NrrdAxis& axis) { return !axis.step; });
  leave_out([&](const NrrdAxis& axis) {
    return axes->size() > 3 && !axis.IsSpace();
  });
  leave_out([&](const NrrdAxis&) { return axes->size() > 3; });
  const auto layers =
      std::find_if(axes->begin(), axes->end(), [](const NrrdAxis& axis) {
        return !axis.step || !axis.IsSpace();
      });
  if (axes->size() == 3 && (layers == axes->end() || layers->step)) return;
  const std::string count =
      layers == axes->end()
          ? ""
          : " of " + std::to_string(std::llround(layers->size)) + " numbers";
  throw InputError(
      path + ": sizes",
      axes->size() < 3
          ? "leaves " + std::to_string(axes->size()) +
                " axes with a direction in space; allowed: 3"
          : "has an axis" + count +
                " beside those of space, as segments that overlap make one; "
                "allowed: one number a voxel",
      kOneLayer);
}

// Returns the unit of the file in mm; `unstated` if it states none.
double MillimetresOf(const std::string& path,
                     const NrrdText& text,
                     double unstated) {
  const std::string units = text.Find("space units");
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

// Returns the grid in the frame of the file.
ImageGrid GridOf(const std::string& path,
                 const NrrdText& text,
                 double mm_per_unit) {
  std::vector<NrrdAxis> axes = AxesOf(path, text);
  SetSteps(path, text, &axes);
  KeepSpace(path, &axes);
  const bool has_directions = !text.Find("space directions").empty();
  ImageGrid grid;
  for (int axis = 0; axis < 3; ++axis) {
    const Eigen::Vector3d& step = *axes[axis].step;
    grid.size[axis] = static_cast<int>(axes[axis].size);
    grid.world_from_index.col(axis).head<3>() =
        has_directions ? step
                       : Eigen::Vector3d(step[0] * Eigen::Vector3d::Unit(axis));
  }
  const std::string origin = text.Find("space origin");
  if (!origin.empty()) {
    const std::vector<double> place =
        HeaderNumbers(path + ": space origin", origin, 3);
    for (int k = 0; k < 3; ++k) grid.world_from_index(k, 3) = place[k];
  }
  grid.world_from_index.topRows<3>() *= MillimetresOf(path, text, mm_per_unit);
  return grid;
}

void Orient(const std::string& path, const NrrdText& text, ImageGrid* grid) {
  const std::string space = LowerCase(text.Find("space"));
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

ScalarType TypeOf(const std::string& path, const std::string& type) {
  static const std::map<std::string, ScalarType> kTypes = {
      {"signed char", ScalarType::kInt8},
      {"int8", ScalarType::kInt8},
      {"int8_t", ScalarType::kInt8},
      {"uchar", ScalarType::kUInt8},
      {"unsigned char", ScalarType::kUInt8},
      {"uint8", ScalarType::kUInt8},
      {"uint8_t", ScalarType::kUInt8},
      {"short", ScalarType::kInt16},
      {"short int", ScalarType::kInt16},
      {"signed short", ScalarType::kInt16},
      {"signed short int", ScalarType::kInt16},
      {"int16", ScalarType::kInt16},
      {"int16_t", ScalarType::kInt16},
      {"ushort", ScalarType::kUInt16},
      {"unsigned short", ScalarType::kUInt16},
      {"unsigned short int", ScalarType::kUInt16},
      {"uint16", ScalarType::kUInt16},
      {"uint16_t", ScalarType::kUInt16},
      {"int", ScalarType::kInt32},
      {"signed int", ScalarType::kInt32},
      {"int32", ScalarType::kInt32},
      {"int32_t", ScalarType::kInt32},
      {"uint", ScalarType::kUInt32},
      {"unsigned int", ScalarType::kUInt32},
      {"uint32", ScalarType::kUInt32},
      {"uint32_t", ScalarType::kUInt32},
      {"longlong", ScalarType::kInt64},
      {"long long", ScalarType::kInt64},
      {"long long int", ScalarType::kInt64},
      {"signed long long", ScalarType::kInt64},
      {"signed long long int", ScalarType::kInt64},
      {"int64", ScalarType::kInt64},
      {"int64_t", ScalarType::kInt64},
      {"ulonglong", ScalarType::kUInt64},
      {"unsigned long long", ScalarType::kUInt64},
      {"unsigned long long int", ScalarType::kUInt64},
      {"uint64", ScalarType::kUInt64},
      {"uint64_t", ScalarType::kUInt64},
      {"float", ScalarType::kFloat32},
      {"double", ScalarType::kFloat64},
  };
  const auto found = kTypes.find(LowerCase(type));
  if (found != kTypes.end()) return found->second;
  throw InputError(path + ": type",
                   "is " + Quoted(type) + "; allowed: whole and real numbers",
                   "save the image as labels of 8 or 16 bits");
}

NrrdEncoding EncodingOf(const std::string& path, const NrrdText& text) {
  static const std::map<std::string, NrrdEncoding> kEncodings = {
      {"raw", NrrdEncoding::kRaw},
      {"gzip", NrrdEncoding::kGzip},
      {"gz", NrrdEncoding::kGzip},
      {"ascii", NrrdEncoding::kText},
      {"text", NrrdEncoding::kText},
      {"txt", NrrdEncoding::kText}};
  const std::string encoding = LowerCase(Required(path, text, "encoding"));
  const auto found = kEncodings.find(encoding);
  if (found != kEncodings.end()) return found->second;
  throw InputError(path + ": encoding",
                   "is " + Quoted(encoding) + "; allowed: raw, gzip, ascii",
                   "save the image again, compressed by gzip or raw");
}

// Returns the number of bytes or lines to skip; 0 if the field is missing.
std::int64_t SkipOf(const std::string& path,
                    const NrrdText& text,
                    const std::string& name,
                    std::int64_t least) {
  const std::string field = text.Find(name);
  if (field.empty()) return 0;
  std::int64_t skip = least - 1;
  const char* const end = field.data() + field.size();
  const auto [rest, error] = std::from_chars(field.data(), end, skip);
  if (error == std::errc() && rest == end && skip >= least) return skip;
  throw InputError(path + ": " + name,
                   "is " + Quoted(field) + "; allowed: whole numbers from " +
                       std::to_string(least) + " on",
                   kCopyAgain);
}

// Returns the location of the data: after the header, or in other files.
NrrdSource SourceOf(const std::string& path, const NrrdText& text) {
  NrrdSource source;
  source.type = TypeOf(path, Required(path, text, "type"));
  source.encoding = EncodingOf(path, text);
  if (LowerCase(text.Find("endian")) == "big") source.order = ByteOrder::kBig;
  source.line_skip = SkipOf(path, text, "line skip", 0);
  // -1 skips everything before raw data, regardless of its size.
  const bool is_raw = source.encoding == NrrdEncoding::kRaw;
  source.byte_skip = SkipOf(path, text, "byte skip", is_raw ? -1 : 0);
  for (const std::string& name : text.data_files) {
    const fs::path file = fs::path(path).parent_path() / name;
    std::error_code error;
    if (!fs::is_regular_file(file, error)) {
      throw InputError(path + ": data file",
                       "names " + file.string() + ", which does not exist",
                       "copy it beside the header");
    }
    source.files.push_back(file.string());
  }
  if (source.files.empty()) {
    source.files = {path};
    source.begin = text.data_from;
  }
  return source;
}

void ReadSegments(const std::map<std::string, std::string>& values,
                  ImageGrid* grid) {
  for (const auto& [key, name] : values) {
    const std::size_t end = key.find("_Name");
    if (key.rfind("Segment", 0) != 0 || end == std::string::npos ||
        end + 5 != key.size()) {
      continue;
    }
    const auto label = values.find(key.substr(0, end) + "_LabelValue");
    if (label == values.end()) continue;
    grid->names[std::atoi(label->second.c_str())] = name;
  }
}

}  // namespace

NrrdHeader ReadNrrdHeader(const std::string& path, double mm_per_unit) {
  const NrrdText text = ReadNrrdText(path);
  NrrdHeader header;
  header.grid = GridOf(path, text, mm_per_unit);
  Orient(path, text, &header.grid);
  ReadSegments(text.values, &header.grid);
  CheckGrid(path, header.grid);
  header.source = SourceOf(path, text);
  return header;
}

}  // namespace musclewarp
