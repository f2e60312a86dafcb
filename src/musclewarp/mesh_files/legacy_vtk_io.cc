// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/mesh_files/legacy_vtk_io.h"

#include <vector>

#include "musclewarp/base/input_error.h"
#include "musclewarp/mesh_files/binary_scalar.h"
#include "musclewarp/mesh_files/export_advice.h"
#include "musclewarp/mesh_files/legacy_vtk_arrays.h"
#include "musclewarp/mesh_files/soup_builder.h"
#include "musclewarp/mesh_files/text_cursor.h"

namespace musclewarp {
namespace {

using Integers = std::vector<std::int64_t>;

class LegacyVtkReader {
 public:
  LegacyVtkReader(const std::string& path, std::string_view bytes)
      : path_(path), cursor_(path, bytes), builder_(path) {}

  TriangleSoup Read() {
    ReadHeader();
    while (cursor_.NextWords(&words_)) {
      const std::string keyword = LowerCase(words_[0]);
      if (keyword == "cell_data" || keyword == "point_data") break;
      ReadSection(keyword);
    }
    return builder_.Build();
  }

 private:
  void ReadHeader();
  void ReadSection(const std::string& keyword);
  void ReadPoints();
  void ReadCells(const std::string& keyword);
  void AddCell(const std::string& keyword, const Integers& corners);
  void ReadCellArrays(const std::string& keyword,
                      std::int64_t num_offsets,
                      std::int64_t num_corners);
  Integers ReadNamedArray(const char* name, std::int64_t size);
  void SkipField();
  bool NextWordsBehindMetadata();

  // `count` numbers of one type, in either encoding.
  template <typename Use>
  void ReadReals(std::int64_t count,
                 ScalarType type,
                 const char* what,
                 const Use& use);
  Integers ReadIntegers(std::int64_t count, ScalarType type, const char* what);
  std::string_view Binary(std::int64_t count,
                          ScalarType type,
                          const char* what);
  std::string_view Word(const char* what);

  ScalarType TypeFromName(std::string_view name) const {
    return LegacyVtkScalarType(cursor_, name);
  }
  std::int64_t Count(std::size_t word, std::size_t size) const;
  [[noreturn]] void ThrowTruncated(const char* what, std::int64_t count) const {
    ThrowLegacyVtkTruncated(cursor_, what, count);
  }
  [[noreturn]] void ThrowDamaged(const std::string& problem) const {
    throw InputError(cursor_.Where(), problem, kCopyAgain);
  }

  std::string path_;
  TextCursor cursor_;
  SoupBuilder builder_;
  Words words_;
  bool is_binary_ = false;
  int version_ = 0;
};

void LegacyVtkReader::ReadHeader() {
  constexpr std::string_view kMagic = "# vtk DataFile Version ";
  std::string_view line;
  cursor_.NextLine(&line);
  if (line.substr(0, kMagic.size()) != kMagic || line.size() == kMagic.size()) {
    throw InputError(path_,
                     "is not a legacy VTK file: it starts with " + Quoted(line),
                     "name the file by what it holds");
  }
  version_ = line[kMagic.size()] - '0';
  cursor_.NextLine(&line);  // Title.
  cursor_.NextWords(&words_);
  const std::string encoding = words_.empty() ? "" : LowerCase(words_[0]);
  if (encoding != "ascii" && encoding != "binary") {
    ThrowDamaged(Quoted(encoding) + " is neither ASCII nor BINARY");
  }
  is_binary_ = encoding == "binary";
  cursor_.NextWords(&words_);
  if (words_.size() != 2 || LowerCase(words_[0]) != "dataset" ||
      LowerCase(words_[1]) != "polydata") {
    throw InputError(cursor_.Where(),
                     "holds " + Quoted(words_.empty() ? "" : words_.back()) +
                         ", only DATASET POLYDATA is read",
                     "export the surface as polydata");
  }
}

void LegacyVtkReader::ReadSection(const std::string& keyword) {
  if (keyword == "points") {
    ReadPoints();
  } else if (keyword == "vertices" || keyword == "lines" ||
             keyword == "polygons" || keyword == "triangle_strips") {
    ReadCells(keyword);
  } else if (keyword == "field") {
    SkipField();
  } else if (keyword == "metadata") {
    SkipLegacyVtkMetadata(&cursor_);
  } else {
    ThrowDamaged(Quoted(words_[0]) + " is not a section of polydata");
  }
}

void LegacyVtkReader::ReadPoints() {
  if (builder_.num_points() > 0) ThrowDamaged("POINTS stands twice");
  const std::int64_t count = Count(1, 3);
  const ScalarType type = TypeFromName(words_[2]);
  Eigen::Vector3d point;
  int axis = 0;
  ReadReals(3 * count, type, "POINTS", [&](double x) {
    point[axis] = x;
    axis = (axis + 1) % 3;
    if (axis == 0) builder_.AddPoint(point, is_binary_ ? 0 : cursor_.line());
  });
}

void LegacyVtkReader::ReadCells(const std::string& keyword) {
  const std::int64_t first = Count(1, 3);
  const std::int64_t second = Count(2, 3);
  if (version_ >= 5) {
    ReadCellArrays(keyword, first, second);
    return;
  }
  // One list holds all cells, each as its number of corners and the corners.
  const Integers list =
      ReadIntegers(second, ScalarType::kInt32, "the list of cells");
  const auto size = static_cast<std::int64_t>(list.size());
  std::int64_t at = 0;
  for (std::int64_t cell = 0; cell < first; ++cell) {
    if (at >= size || list[at] < 0 || list[at] >= size - at) {
      ThrowDamaged(
          Quoted(keyword) + ": cell " + std::to_string(cell) + " of " +
          std::to_string(first) + " " +
          (at < size ? "has " + std::to_string(list[at]) + " corners, which"
                     : "is missing, it") +
          " the list of " + std::to_string(size) + " entries does not hold");
    }
    const auto begin = list.begin() + at + 1;
    AddCell(keyword, Integers(begin, begin + list[at]));
    at += 1 + list[at];
  }
  if (at != size) {
    ThrowDamaged(Quoted(keyword) + ": the cells take " + std::to_string(at) +
                 " of the " + std::to_string(size) + " entries promised");
  }
}

void LegacyVtkReader::AddCell(const std::string& keyword,
                              const Integers& corners) {
  if (keyword == "polygons") builder_.AddPolygon(corners);
  if (keyword == "triangle_strips") builder_.AddStrip(corners);
}

// Version 5: the corners of cell i are the entries offsets[i] up to
// offsets[i + 1] of a second array.
void LegacyVtkReader::ReadCellArrays(const std::string& keyword,
                                     std::int64_t num_offsets,
                                     std::int64_t num_corners) {
  const Integers offsets = ReadNamedArray("offsets", num_offsets);
  const Integers corners = ReadNamedArray("connectivity", num_corners);
  if (offsets.empty() ? num_corners > 0
                      : offsets[0] != 0 || offsets.back() != num_corners) {
    ThrowDamaged(Quoted(keyword) + ": the offsets must run from 0 to " +
                 std::to_string(num_corners));
  }
  for (std::size_t i = 1; i < offsets.size(); ++i) {
    if (offsets[i] < offsets[i - 1] || offsets[i] > num_corners) {
      ThrowDamaged(Quoted(keyword) + ": offset " + std::to_string(i) + " is " +
                   std::to_string(offsets[i]) + " after " +
                   std::to_string(offsets[i - 1]) + ", offsets must rise to " +
                   std::to_string(num_corners));
    }
    AddCell(keyword,
            Integers(corners.begin() + offsets[i - 1],
                     corners.begin() + offsets[i]));
  }
}

Integers LegacyVtkReader::ReadNamedArray(const char* name, std::int64_t size) {
  if (!NextWordsBehindMetadata()) ThrowTruncated(name, size);
  if (words_.size() != 2 || LowerCase(words_[0]) != name) {
    ThrowDamaged(Quoted(words_[0]) + " stands where '" + name +
                 "' is expected");
  }
  const ScalarType type = TypeFromName(words_[1]);
  if (!IsInteger(type)) {
    ThrowDamaged(Quoted(words_[1]) + " is not a type of whole numbers");
  }
  return ReadIntegers(size, type, name);
}

void LegacyVtkReader::SkipField() {
  const std::int64_t num_arrays = Count(2, 3);
  for (std::int64_t i = 0; i < num_arrays; ++i) {
    // name, number of components, number of tuples, type
    if (!NextWordsBehindMetadata()) ThrowTruncated("FIELD", num_arrays);
    if (words_.size() == 1 && LowerCase(words_[0]) == "null_array") continue;
    const std::int64_t components = Count(1, 4);
    const std::int64_t tuples = Count(2, 4);
    const auto left = static_cast<std::int64_t>(cursor_.bytes_left());
    // A value takes a bit at least.
    if (components > 0 && tuples > 8 * left / components) {
      ThrowTruncated("FIELD", tuples);
    }
    SkipLegacyVtkArray(words_[3], components * tuples, is_binary_, &cursor_);
  }
}

bool LegacyVtkReader::NextWordsBehindMetadata() {
  while (cursor_.NextWords(&words_)) {
    if (LowerCase(words_[0]) != "metadata") return true;
    SkipLegacyVtkMetadata(&cursor_);
  }
  return false;
}

template <typename Use>
void LegacyVtkReader::ReadReals(std::int64_t count,
                                ScalarType type,
                                const char* what,
                                const Use& use) {
  if (is_binary_) {
    const std::string_view bytes = Binary(count, type, what);
    for (std::size_t at = 0; at < bytes.size(); at += SizeOf(type)) {
      use(LoadReal(bytes.data() + at, type, ByteOrder::kBig));
    }
  } else {
    for (std::int64_t i = 0; i < count; ++i) {
      use(cursor_.Real(Word(what), what));
    }
  }
}

Integers LegacyVtkReader::ReadIntegers(std::int64_t count,
                                       ScalarType type,
                                       const char* what) {
  Integers values;
  if (is_binary_) {
    const std::string_view bytes = Binary(count, type, what);
    for (std::size_t at = 0; at < bytes.size(); at += SizeOf(type)) {
      values.push_back(LoadInteger(bytes.data() + at, type, ByteOrder::kBig));
    }
  } else {
    for (std::int64_t i = 0; i < count; ++i) {
      values.push_back(cursor_.Integer(Word(what), what));
    }
  }
  return values;
}

std::string_view LegacyVtkReader::Binary(std::int64_t count,
                                         ScalarType type,
                                         const char* what) {
  const auto size = static_cast<std::int64_t>(SizeOf(type));
  const auto left = static_cast<std::int64_t>(cursor_.bytes_left());
  if (count > left / size) ThrowTruncated(what, count);
  return cursor_.TakeBytes(count * size);
}

std::string_view LegacyVtkReader::Word(const char* what) {
  std::string_view word;
  if (!cursor_.NextWord(&word)) {
    throw InputError(
        path_, "is truncated: it ends within " + std::string(what), kCopyAgain);
  }
  return word;
}

// Returns the count that is a word of the section line, which must have `size`
// words.
std::int64_t LegacyVtkReader::Count(std::size_t word, std::size_t size) const {
  if (words_.size() != size) {
    ThrowDamaged(Quoted(words_[0]) + " needs " + std::to_string(size - 1) +
                 " values on its line, it has " +
                 std::to_string(words_.size() - 1));
  }
  const std::int64_t count = cursor_.Integer(words_[word], "a count");
  constexpr std::int64_t kLargest = std::int64_t{1} << 40;
  if (count < 0 || count > kLargest) {
    ThrowDamaged("count " + std::to_string(count) + " must be 0 to 2^40");
  }
  return count;
}

}  // namespace

TriangleSoup ReadLegacyVtk(const std::string& path, std::string_view bytes) {
  return LegacyVtkReader(path, bytes).Read();
}

std::string LegacyVtkBytes(const TriangleSoup& soup) {
  const Eigen::Index num_triangles = soup.triangles.rows();
  std::string out =
      "# vtk DataFile Version 3.0\n"
      "surface mesh in millimetres\n"
      "BINARY\n"
      "DATASET POLYDATA\n"
      "POINTS " +
      std::to_string(soup.points.rows()) + " double\n";
  for (Eigen::Index i = 0; i < soup.points.size(); ++i) {
    AppendBytes(soup.points.data()[i], ByteOrder::kBig, &out);
  }
  out += "\nPOLYGONS " + std::to_string(num_triangles) + " " +
         std::to_string(4 * num_triangles) + "\n";
  for (Eigen::Index f = 0; f < num_triangles; ++f) {
    AppendBytes<std::int32_t>(3, ByteOrder::kBig, &out);
    for (const int v : soup.triangles.row(f)) {
      AppendBytes<std::int32_t>(v, ByteOrder::kBig, &out);
    }
  }
  return out + "\n";
}

}  // namespace musclewarp
