// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/mesh_files/stl_io.h"

#include <Eigen/Geometry>
#include <array>
#include <unordered_map>

#include "musclewarp/base/input_error.h"
#include "musclewarp/mesh_files/binary_scalar.h"
#include "musclewarp/mesh_files/export_advice.h"
#include "musclewarp/mesh_files/soup_builder.h"
#include "musclewarp/mesh_files/text_cursor.h"

namespace musclewarp {
namespace {

// A binary STL file starts with a text and the number of facets. For each facet
// follow the normal, three corners and two unused bytes.
constexpr std::size_t kTextSize = 80;
constexpr std::size_t kHeaderSize = kTextSize + 4;
constexpr std::size_t kFacetSize = 4 * 12 + 2;

using Position = std::array<double, 3>;

struct PositionHash {
  std::size_t operator()(const Position& p) const {
    std::size_t hash = 0;
    for (const double x : p) hash = hash * 1000003 + std::hash<double>()(x);
    return hash;
  }
};

// Adds triangles given by the positions of their corners.
class CornerMerger {
 public:
  explicit CornerMerger(const std::string& path) : builder_(path) {}

  void AddFacet(const Eigen::Matrix3d& corners, std::size_t line) {
    std::vector<std::int64_t> face;
    for (int i = 0; i < 3; ++i) face.push_back(Index(corners.row(i), line));
    builder_.AddPolygon(face, line);
  }
  std::int64_t num_facets() const { return builder_.num_faces(); }
  TriangleSoup Build(std::vector<int>* facet_of_triangle = nullptr) const {
    return builder_.Build(facet_of_triangle);
  }

 private:
  std::int64_t Index(const Eigen::Vector3d& point, std::size_t line) {
    const auto [entry, is_new] = index_.emplace(
        Position{point.x(), point.y(), point.z()}, builder_.num_points());
    if (is_new) builder_.AddPoint(point, line);
    return entry->second;
  }

  SoupBuilder builder_;
  std::unordered_map<Position, std::int64_t, PositionHash> index_;
};

std::size_t BinarySize(std::string_view bytes) {
  return kHeaderSize +
         kFacetSize * LoadAs<std::uint32_t>(bytes.data() + kTextSize,
                                            ByteOrder::kLittle);
}

// True if the file starts with "solid" and has no control character where a
// binary file has the number of facets and the first normal: binary files may
// start with "solid" as well.
bool LooksLikeAscii(std::string_view bytes) {
  const std::string_view start = bytes.substr(0, kHeaderSize + kFacetSize);
  const std::size_t word = start.find_first_not_of(" \t\r\n");
  if (word == std::string_view::npos ||
      LowerCase(start.substr(word, 5)) != "solid") {
    return false;
  }
  for (const char c : start) {
    const bool is_blank = c == '\t' || c == '\r' || c == '\n';
    if (static_cast<unsigned char>(c) < 0x20 && !is_blank) return false;
  }
  return true;
}

TriangleSoup ReadBinary(const std::string& path, std::string_view bytes) {
  CornerMerger merger(path);
  const std::size_t end = BinarySize(bytes);
  for (std::size_t at = kHeaderSize; at < end; at += kFacetSize) {
    Eigen::Matrix3d corners;
    for (int i = 0; i < 9; ++i) {
      corners(i / 3, i % 3) =
          LoadAs<float>(bytes.data() + at + 12 + 4 * i, ByteOrder::kLittle);
    }
    merger.AddFacet(corners, 0);
  }
  return merger.Build();
}

class AsciiReader {
 public:
  AsciiReader(const std::string& path, std::string_view bytes)
      : path_(path), cursor_(path, bytes), merger_(path) {}

  TriangleSoup Read(MeshParts* parts) {
    std::string_view word;
    std::string_view rest;
    for (int number = 1; cursor_.NextWord(&word); ++number) {
      Expect("solid", word);
      rest = {};
      cursor_.NextLine(&rest);
      const std::string name = PartName(rest);
      solids_.Start(name.empty() ? "solid_" + std::to_string(number) : name);
      ReadFacets();
      cursor_.NextLine(&rest);
    }
    std::vector<int> facet_of_triangle;
    TriangleSoup soup = merger_.Build(&facet_of_triangle);
    if (parts) *parts = solids_.Parts("solid", facet_of_triangle);
    return soup;
  }

 private:
  void ReadFacets() {
    while (true) {
      const std::string_view word = Word();
      if (LowerCase(word) == "endsolid") return;
      Expect("facet", word);
      Expect("normal", Word());
      for (int i = 0; i < 3; ++i) Word();
      Expect("outer", Word());
      Expect("loop", Word());
      Eigen::Matrix3d corners;
      for (int corner = 0; corner < 3; ++corner) {
        Expect("vertex", Word());
        for (int i = 0; i < 3; ++i) {
          corners(corner, i) = cursor_.Real(Word(), "a coordinate");
        }
      }
      Expect("endloop", Word());
      Expect("endfacet", Word());
      merger_.AddFacet(corners, cursor_.line());
      solids_.AddFace();
    }
  }

  std::string_view Word() {
    std::string_view word;
    if (!cursor_.NextWord(&word)) {
      throw InputError(path_,
                       "is truncated: it ends after " +
                           std::to_string(merger_.num_facets()) +
                           " facets without 'endsolid'",
                       kCopyAgain);
    }
    return word;
  }

  void Expect(const char* expected, std::string_view word) const {
    if (LowerCase(word) == expected) return;
    throw InputError(
        cursor_.Where(),
        Quoted(word) + " stands where '" + expected + "' is expected",
        "check that this is an STL file, or export it again");
  }

  std::string path_;
  TextCursor cursor_;
  CornerMerger merger_;
  PartCollector solids_{PartCollector::Again::kStarts, ""};
};

}  // namespace

TriangleSoup ReadStl(const std::string& path,
                     std::string_view bytes,
                     std::vector<std::string>* notes,
                     MeshParts* parts) {
  if (parts) *parts = MeshParts();
  const bool has_header = bytes.size() >= kHeaderSize;
  // The size decides first: an ASCII file would have the size of a binary one
  // only by a freak chance.
  if (has_header && bytes.size() == BinarySize(bytes)) {
    return ReadBinary(path, bytes);
  }
  if (LooksLikeAscii(bytes)) return AsciiReader(path, bytes).Read(parts);
  if (has_header && bytes.size() > BinarySize(bytes)) {
    const std::size_t facets = (BinarySize(bytes) - kHeaderSize) / kFacetSize;
    const std::string note = path + ": the last " +
                             std::to_string(bytes.size() - BinarySize(bytes)) +
                             " bytes were skipped: they follow the " +
                             std::to_string(facets) +
                             " facets that its header promises";
    if (notes) notes->push_back(note);
    return ReadBinary(path, bytes);
  }
  throw InputError(
      path,
      has_header ? "is truncated or not an STL file: as binary STL its header "
                   "promises " +
                       std::to_string(BinarySize(bytes)) +
                       " bytes, the file has " + std::to_string(bytes.size())
                 : "is truncated or not an STL file: it has " +
                       std::to_string(bytes.size()) +
                       " bytes and does not start with 'solid'",
      kCopyAgain);
}

std::string StlBytes(const TriangleSoup& soup) {
  // Must not start with "solid".
  std::string out = "binary STL, written by musclewarp";
  out.resize(kTextSize, ' ');
  AppendBytes<std::uint32_t>(soup.triangles.rows(), ByteOrder::kLittle, &out);
  for (Eigen::Index f = 0; f < soup.triangles.rows(); ++f) {
    Eigen::Matrix3f corners;
    for (int i = 0; i < 3; ++i) {
      corners.row(i) = soup.points.row(soup.triangles(f, i)).cast<float>();
    }
    const Eigen::Matrix3d exact = corners.cast<double>();
    // The normal is zero for a face without area.
    const Eigen::Vector3d normal = (exact.row(1) - exact.row(0))
                                       .cross(exact.row(2) - exact.row(0))
                                       .normalized();
    for (const double x : normal) {
      AppendBytes<float>(x, ByteOrder::kLittle, &out);
    }
    for (int i = 0; i < 9; ++i) {
      AppendBytes<float>(corners(i / 3, i % 3), ByteOrder::kLittle, &out);
    }
    out.append(2, '\0');
  }
  return out;
}

}  // namespace musclewarp
