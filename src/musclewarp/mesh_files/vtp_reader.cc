// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/mesh_files/vtp_reader.h"

#include <algorithm>
#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include "musclewarp/base/base64.h"
#include "musclewarp/base/input_error.h"
#include "musclewarp/base/nesting.h"
#include "musclewarp/mesh_files/export_advice.h"
#include "musclewarp/mesh_files/soup_builder.h"
#include "musclewarp/mesh_files/text_cursor.h"
#include "musclewarp/mesh_files/vtp_packing.h"
#include "musclewarp/mesh_files/xml_tags.h"

namespace musclewarp {
namespace {

struct Array {
  XmlTag tag;
  std::string_view content;  // between its tags
};

struct Piece {
  XmlTag tag;
  // By names such as "Points", "Polys connectivity" and "Strips offsets".
  std::map<std::string, Array> arrays;
};

std::optional<ScalarType> VtpTypeFromName(std::string_view name) {
  static const std::map<std::string_view, ScalarType> kTypes = {
      {"Int8", ScalarType::kInt8},
      {"UInt8", ScalarType::kUInt8},
      {"Int16", ScalarType::kInt16},
      {"UInt16", ScalarType::kUInt16},
      {"Int32", ScalarType::kInt32},
      {"UInt32", ScalarType::kUInt32},
      {"Int64", ScalarType::kInt64},
      {"UInt64", ScalarType::kUInt64},
      {"Float32", ScalarType::kFloat32},
      {"Float64", ScalarType::kFloat64},
  };
  const auto found = kTypes.find(name);
  if (found == kTypes.end()) return std::nullopt;
  return found->second;
}

class VtpReader {
 public:
  VtpReader(const std::string& path, std::string_view bytes)
      : path_(path), bytes_(bytes), builder_(path) {}

  TriangleSoup Read() {
    CheckIsWhole();
    ReadTags();
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
      where_ = path_ + ": piece " + std::to_string(i);
      ReadPiece(pieces_[i]);
    }
    return builder_.Build();
  }

 private:
  void CheckIsWhole() const;
  void ReadTags();
  void CheckRoot(const XmlTag& root);
  void CheckClosing(const XmlTag& tag, std::vector<std::string_view>* open);
  void AddArray(const XmlTag& tag, const std::vector<std::string_view>& open);
  void SetAppended(const XmlTag& tag);

  void ReadPiece(const Piece& piece);
  void ReadPoints(const Piece& piece);
  std::vector<std::vector<std::int64_t>> ReadCells(const Piece& piece,
                                                   const std::string& section);

  std::uint64_t Count(const Piece& piece, const std::string& elements) const;
  // Returns the values of an array, of which there must be `count`. A value is
  // read by binary(bytes, type) or by ascii(cursor, word).
  template <typename Value, typename Binary, typename Ascii>
  std::vector<Value> Values(const Piece& piece,
                            const std::string& name,
                            std::uint64_t count,
                            const Binary& binary,
                            const Ascii& ascii) const;
  std::vector<double> Reals(const Piece& piece,
                            const std::string& name,
                            std::uint64_t count) const;
  std::vector<std::int64_t> Integers(const Piece& piece,
                                     const std::string& name,
                                     std::uint64_t count) const;
  std::string Unpacked(const Array& array, const std::string& where) const;

  [[noreturn]] void Throw(const std::string& where,
                          const std::string& problem) const {
    throw InputError(where, problem, kCopyAgain);
  }

  std::string path_;
  std::string_view bytes_;
  SoupBuilder builder_;
  std::string where_;  // the piece being read
  VtpPacking packing_;
  std::vector<Piece> pieces_;
  std::string_view appended_;
  bool appended_is_base64_ = false;
};

void VtpReader::CheckIsWhole() const {
  if (bytes_.substr(0, 1024).find("<VTKFile") == std::string_view::npos) {
    throw InputError(
        path_,
        "is not a VTK XML file: it starts with " + Quoted(bytes_.substr(0, 16)),
        "name the file by what it holds");
  }
  constexpr std::string_view kEnd = "</VTKFile>";
  const std::string_view text =
      bytes_.substr(0, bytes_.find_last_not_of(kXmlBlanks) + 1);
  if (text.size() < kEnd.size() ||
      text.substr(text.size() - kEnd.size()) != kEnd) {
    Throw(path_, "is truncated: it does not end with '</VTKFile>'");
  }
}

// Finds the pieces and their arrays. The search ends at <AppendedData>, because
// any bytes may follow that tag.
void VtpReader::ReadTags() {
  std::vector<std::string_view> open;
  XmlTag tag;
  bool has_root = false;
  while (NextXmlTag(bytes_, tag.end, &tag)) {
    if (tag.is_closing()) {
      CheckClosing(tag, &open);
      continue;
    }
    const std::string_view name = tag.name();
    if (!has_root) {
      CheckRoot(tag);
      has_root = true;
    } else if (name == "AppendedData") {
      SetAppended(tag);
      return;
    } else if (name == "Piece") {
      pieces_.push_back({tag, {}});
    } else if (name == "DataArray") {
      AddArray(tag, open);
    }
    if (!tag.is_empty_element()) open.push_back(name);
    CheckNesting(path_, static_cast<int>(open.size()));
  }
  if (!open.empty()) {
    Throw(path_, "has an element " + Quoted(open.back()) + " without end");
  }
}

void VtpReader::CheckRoot(const XmlTag& root) {
  if (root.name() != "VTKFile" || root.Attribute("type") != "PolyData") {
    throw InputError(path_,
                     "holds " + Quoted(root.name()) + " of type " +
                         Quoted(root.Attribute("type")) +
                         ", only VTKFile of type PolyData is read",
                     "export the surface as polydata");
  }
  packing_ = VtpPackingFromTag(path_, root);
}

void VtpReader::CheckClosing(const XmlTag& tag,
                             std::vector<std::string_view>* open) {
  if (open->empty() || open->back() != tag.name()) {
    Throw(path_,
          "is damaged: " + Quoted(tag.text) + " closes " +
              (open->empty() ? "nothing" : Quoted(open->back())));
  }
  open->pop_back();
}

void VtpReader::AddArray(const XmlTag& tag,
                         const std::vector<std::string_view>& open) {
  const std::string_view section = open.empty() ? "" : open.back();
  const bool is_points = section == "Points";
  if (!is_points && section != "Polys" && section != "Strips") return;
  if (pieces_.empty()) Throw(path_, "has an array outside of a piece");
  std::string name(section);
  if (!is_points) name += " " + std::string(tag.Attribute("Name"));
  const std::size_t end =
      tag.is_empty_element() ? tag.end : bytes_.find('<', tag.end);
  const Array array = {tag, bytes_.substr(tag.end, end - tag.end)};
  if (!pieces_.back().arrays.emplace(name, array).second) {
    Throw(path_,
          "piece " + std::to_string(pieces_.size() - 1) + " has two arrays " +
              Quoted(name));
  }
}

// The data start behind an underscore.
void VtpReader::SetAppended(const XmlTag& tag) {
  const std::size_t underscore = bytes_.find_first_not_of(kXmlBlanks, tag.end);
  if (underscore == std::string_view::npos || bytes_[underscore] != '_') {
    Throw(path_, "has appended data that do not start with '_'");
  }
  appended_ = bytes_.substr(underscore + 1);
  appended_is_base64_ = tag.Attribute("encoding") == "base64";
}

void VtpReader::ReadPiece(const Piece& piece) {
  const std::int64_t first = builder_.num_points();
  ReadPoints(piece);
  // Corners count within the piece; one beyond it would name another's point.
  const std::int64_t size = builder_.num_points() - first;
  for (const std::string section : {"Polys", "Strips"}) {
    for (std::vector<std::int64_t>& corners : ReadCells(piece, section)) {
      for (std::int64_t& corner : corners) {
        if (corner < 0 || corner >= size) {
          Throw(where_,
                "face " + std::to_string(builder_.num_faces()) +
                    " names vertex " + std::to_string(corner) +
                    ", the piece has " + std::to_string(size) +
                    " vertices, numbered from 0");
        }
        corner += first;
      }
      if (section == "Polys") {
        builder_.AddPolygon(corners);
      } else {
        builder_.AddStrip(corners);
      }
    }
  }
}

void VtpReader::ReadPoints(const Piece& piece) {
  const std::uint64_t count = Count(piece, "Points");
  if (count == 0) return;
  const std::vector<double> values = Reals(piece, "Points", 3 * count);
  for (std::size_t i = 0; i < values.size(); i += 3) {
    builder_.AddPoint({values[i], values[i + 1], values[i + 2]});
  }
}

// The offset of a cell is the number of corners up to its end.
std::vector<std::vector<std::int64_t>> VtpReader::ReadCells(
    const Piece& piece, const std::string& section) {
  std::vector<std::vector<std::int64_t>> cells;
  const std::uint64_t count = Count(piece, section);
  if (count == 0) return cells;
  const auto ends = Integers(piece, section + " offsets", count);
  std::int64_t begin = 0;
  for (std::size_t i = 0; i < ends.size(); ++i) {
    if (ends[i] < begin) {
      Throw(where_,
            Quoted(section) + ": offset " + std::to_string(i) + " is " +
                std::to_string(ends[i]) + " after " + std::to_string(begin) +
                ", offsets must not fall");
    }
    begin = ends[i];
  }
  const auto corners = Integers(piece, section + " connectivity", begin);
  begin = 0;
  for (const std::int64_t end : ends) {
    cells.emplace_back(corners.begin() + begin, corners.begin() + end);
    begin = end;
  }
  return cells;
}

// Returns 0 if the piece does not have the attribute.
std::uint64_t VtpReader::Count(const Piece& piece,
                               const std::string& elements) const {
  const std::string attribute = "NumberOf" + elements;
  const std::string_view text = piece.tag.Attribute(attribute);
  if (text.empty()) return 0;
  // More digits than any file can hold elements would overflow 3 * count.
  if (text.size() > 15 ||
      text.find_first_not_of("0123456789") != std::string_view::npos) {
    Throw(
        where_,
        attribute + " is " + Quoted(text) + ", which is not a sensible number");
  }
  std::uint64_t count = 0;
  for (const char digit : text) count = 10 * count + (digit - '0');
  return count;
}

template <typename Value, typename Binary, typename Ascii>
std::vector<Value> VtpReader::Values(const Piece& piece,
                                     const std::string& name,
                                     std::uint64_t count,
                                     const Binary& binary,
                                     const Ascii& ascii) const {
  const std::string where = where_ + ", array " + Quoted(name);
  const auto found = piece.arrays.find(name);
  if (found == piece.arrays.end()) Throw(where, "is missing");
  const Array& array = found->second;
  const auto type = VtpTypeFromName(array.tag.Attribute("type"));
  if (!type) {
    Throw(where, "type " + Quoted(array.tag.Attribute("type")) + " is unknown");
  }
  std::vector<Value> values;
  if (array.tag.Attribute("format") == "ascii") {
    TextCursor cursor(where, array.content);
    std::string_view word;
    while (cursor.NextWord(&word)) values.push_back(ascii(cursor, word));
  } else {
    const std::string bytes = Unpacked(array, where);
    const std::size_t size = SizeOf(*type);
    if (bytes.size() % size != 0) Throw(where, "ends within a number");
    values.reserve(bytes.size() / size);
    for (std::size_t at = 0; at < bytes.size(); at += size) {
      values.push_back(binary(bytes.data() + at, *type));
    }
  }
  if (values.size() != count) {
    Throw(where,
          "holds " + std::to_string(values.size()) + " numbers, " +
              std::to_string(count) + " are promised");
  }
  return values;
}

std::vector<double> VtpReader::Reals(const Piece& piece,
                                     const std::string& name,
                                     std::uint64_t count) const {
  return Values<double>(
      piece,
      name,
      count,
      [&](const char* bytes, ScalarType type) {
        return LoadReal(bytes, type, packing_.order);
      },
      [](const TextCursor& cursor, std::string_view word) {
        return cursor.Real(word, "a coordinate");
      });
}

std::vector<std::int64_t> VtpReader::Integers(const Piece& piece,
                                              const std::string& name,
                                              std::uint64_t count) const {
  return Values<std::int64_t>(
      piece,
      name,
      count,
      [&](const char* bytes, ScalarType type) {
        if (!IsInteger(type)) {
          Throw(where_, "array " + Quoted(name) + " holds no whole numbers");
        }
        return LoadInteger(bytes, type, packing_.order);
      },
      [](const TextCursor& cursor, std::string_view word) {
        return cursor.Integer(word, "a vertex index or offset");
      });
}

std::string VtpReader::Unpacked(const Array& array,
                                const std::string& where) const {
  const std::string_view format = array.tag.Attribute("format");
  if (format == "binary") {
    return UnpackVtpArray(where, DecodeBase64(array.content), packing_);
  }
  if (format != "appended") {
    Throw(
        where,
        "format " + Quoted(format) + " is not one of ascii, binary, appended");
  }
  const TextCursor cursor(where, "");
  const std::int64_t offset =
      cursor.Integer(array.tag.Attribute("offset"), "the offset");
  if (offset < 0 || static_cast<std::uint64_t>(offset) >= appended_.size()) {
    Throw(where,
          "starts at byte " + std::to_string(offset) + " of " +
              std::to_string(appended_.size()) + " appended bytes");
  }
  const std::string_view data = appended_.substr(offset);
  return appended_is_base64_
             ? UnpackVtpArray(where, DecodeBase64(data), packing_)
             : UnpackVtpArray(where, data, packing_);
}

}  // namespace

TriangleSoup ReadVtp(const std::string& path, std::string_view bytes) {
  return VtpReader(path, bytes).Read();
}

}  // namespace musclewarp
