// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/mesh_files/ply_header.h"

#include <algorithm>
#include <map>

#include "musclewarp/base/input_error.h"
#include "musclewarp/mesh_files/export_advice.h"

namespace musclewarp {
namespace {

ScalarType PlyTypeFromName(const TextCursor& cursor, std::string_view name) {
  static const std::map<std::string_view, ScalarType> kTypes = {
      {"char", ScalarType::kInt8},
      {"int8", ScalarType::kInt8},
      {"uchar", ScalarType::kUInt8},
      {"uint8", ScalarType::kUInt8},
      {"short", ScalarType::kInt16},
      {"int16", ScalarType::kInt16},
      {"ushort", ScalarType::kUInt16},
      {"uint16", ScalarType::kUInt16},
      {"int", ScalarType::kInt32},
      {"int32", ScalarType::kInt32},
      {"uint", ScalarType::kUInt32},
      {"uint32", ScalarType::kUInt32},
      {"int64", ScalarType::kInt64},
      {"uint64", ScalarType::kUInt64},
      {"float", ScalarType::kFloat32},
      {"float32", ScalarType::kFloat32},
      {"double", ScalarType::kFloat64},
      {"float64", ScalarType::kFloat64},
  };
  const auto found = kTypes.find(name);
  if (found == kTypes.end()) {
    throw InputError(cursor.Where(),
                     Quoted(name) +
                         " is not a PLY type (char, uchar, short, "
                         "ushort, int, uint, float, double)",
                     kExportAgain);
  }
  return found->second;
}

PlyFormat FormatFromName(const TextCursor& cursor, std::string_view name) {
  if (name == "ascii") return PlyFormat::kAscii;
  if (name == "binary_little_endian") return PlyFormat::kBinaryLittle;
  if (name == "binary_big_endian") return PlyFormat::kBinaryBig;
  throw InputError(cursor.Where(),
                   Quoted(name) +
                       " is not a PLY format (ascii, "
                       "binary_little_endian, binary_big_endian)",
                   kExportAgain);
}

void AddElement(const TextCursor& cursor,
                const Words& words,
                PlyHeader* header) {
  PlyElement element;
  element.name = words[1];
  element.count = cursor.Integer(words[2], "the number of elements");
  const bool repeated = std::any_of(
      header->elements.begin(), header->elements.end(), [&](const auto& other) {
        return other.name == element.name;
      });
  if (element.count < 0 || repeated) {
    throw InputError(
        cursor.Where(),
        repeated ? "element " + Quoted(words[1]) + " stands twice in the header"
                 : "the number of elements is " +
                       std::to_string(element.count) + ", it must be 0 or more",
        kExportAgain);
  }
  header->elements.push_back(element);
}

void AddProperty(const TextCursor& cursor,
                 const Words& words,
                 PlyHeader* header) {
  PlyProperty property;
  property.is_list = words[1] == "list";
  if (header->elements.empty() || (property.is_list && words.size() < 5)) {
    throw InputError(cursor.Where(),
                     header->elements.empty()
                         ? "a property stands before the first element"
                         : "a list property needs two types and a name",
                     kExportAgain);
  }
  if (property.is_list) {
    property.count_type = PlyTypeFromName(cursor, words[2]);
    if (!IsInteger(property.count_type)) {
      throw InputError(cursor.Where(),
                       "the length of a list is a " + Quoted(words[2]) +
                           ", it must be a whole number",
                       kExportAgain);
    }
  }
  const std::size_t type = property.is_list ? 3 : 1;
  property.type = PlyTypeFromName(cursor, words[type]);
  property.name = words[type + 1];
  header->elements.back().properties.push_back(property);
}

[[noreturn]] void ThrowNoHeaderLine(const std::string& where,
                                    std::string_view keyword) {
  throw InputError(
      where, Quoted(keyword) + " is not a line of a PLY header", kExportAgain);
}

bool IsHeaderKeyword(std::string_view word) {
  return word == "format" || word == "element" || word == "property" ||
         word == "end_header";
}

}  // namespace

PlyHeader ReadPlyHeader(const std::string& path, TextCursor* cursor) {
  PlyHeader header;
  Words words;
  cursor->NextWords(&words);
  if (words != Words{"ply"}) {
    throw InputError(path,
                     "is not a PLY file: it starts with " +
                         Quoted(words.empty() ? "" : words[0]) +
                         " instead of 'ply'",
                     "name the file by what it holds");
  }
  bool has_format = false;
  // A line of another kind is skipped as other readers do, unless properties
  // follow: then it is an element that lost its keyword.
  std::string unknown, unknown_where;
  while (cursor->NextWords(&words)) {
    const std::string_view keyword = words[0];
    if (keyword == "comment" || keyword == "obj_info") continue;
    if (keyword == "property" && !unknown.empty()) {
      ThrowNoHeaderLine(unknown_where, unknown);
    }
    unknown.clear();
    if (keyword == "end_header" && has_format) return header;
    if (keyword == "format" && words.size() >= 2) {
      header.format = FormatFromName(*cursor, words[1]);
      has_format = true;
    } else if (keyword == "element" && words.size() >= 3) {
      AddElement(*cursor, words, &header);
    } else if (keyword == "property" && words.size() >= 3) {
      AddProperty(*cursor, words, &header);
    } else if (IsHeaderKeyword(keyword)) {
      ThrowNoHeaderLine(cursor->Where(), keyword);
    } else {
      unknown = keyword;
      unknown_where = cursor->Where();
    }
  }
  throw InputError(path,
                   "is truncated: it ends in the header, 'end_header' is "
                   "missing",
                   kCopyAgain);
}

}  // namespace musclewarp
