// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/mesh_files/legacy_vtk_arrays.h"

#include <map>

#include "musclewarp/base/input_error.h"
#include "musclewarp/mesh_files/export_advice.h"

namespace musclewarp {
namespace {

constexpr char kField[] = "FIELD";

// Returns null if the type is not one of numbers.
const ScalarType* FindScalarType(std::string_view name) {
  // vtkIdType is written as 32 bits whatever it is in memory.
  static const std::map<std::string, ScalarType> kTypes = {
      {"char", ScalarType::kInt8},
      {"signed_char", ScalarType::kInt8},
      {"unsigned_char", ScalarType::kUInt8},
      {"short", ScalarType::kInt16},
      {"unsigned_short", ScalarType::kUInt16},
      {"int", ScalarType::kInt32},
      {"vtkidtype", ScalarType::kInt32},
      {"vtktypeint32", ScalarType::kInt32},
      {"unsigned_int", ScalarType::kUInt32},
      {"long", ScalarType::kInt64},
      {"vtktypeint64", ScalarType::kInt64},
      {"unsigned_long", ScalarType::kUInt64},
      {"vtktypeuint64", ScalarType::kUInt64},
      {"float", ScalarType::kFloat32},
      {"double", ScalarType::kFloat64},
  };
  const auto found = kTypes.find(LowerCase(name));
  return found == kTypes.end() ? nullptr : &found->second;
}

void SkipBytes(std::int64_t count,
               std::int64_t size,
               std::int64_t promised,
               TextCursor* cursor) {
  const auto left = static_cast<std::int64_t>(cursor->bytes_left());
  if (count > left / size) ThrowLegacyVtkTruncated(*cursor, kField, promised);
  cursor->TakeBytes(count * size);
}

void SkipLines(std::int64_t count, TextCursor* cursor) {
  std::string_view line;
  for (std::int64_t i = 0; i < count; ++i) {
    if (!cursor->NextLine(&line)) {
      ThrowLegacyVtkTruncated(*cursor, kField, count);
    }
  }
}

// Of a text in binary data the length comes first: the two highest bits of its
// first byte say how many bytes it has itself, 11 for one, 10 for two, 01 for
// four and 00 for eight; the others are the number, the highest first.
void SkipBinaryTexts(std::int64_t count, TextCursor* cursor) {
  constexpr int kLengthBytes[] = {8, 4, 2, 1};
  constexpr int kLowBits = 0x3f;
  for (std::int64_t i = 0; i < count; ++i) {
    if (cursor->bytes_left() == 0) {
      ThrowLegacyVtkTruncated(*cursor, kField, count);
    }
    const auto first = static_cast<unsigned char>(cursor->TakeBytes(1)[0]);
    const std::size_t more = kLengthBytes[first >> 6] - 1;
    if (cursor->bytes_left() < more) {
      ThrowLegacyVtkTruncated(*cursor, kField, count);
    }
    std::uint64_t length = first & kLowBits;
    for (const char byte : cursor->TakeBytes(more)) {
      length = length << 8 | static_cast<unsigned char>(byte);
    }
    if (cursor->bytes_left() < length) {
      ThrowLegacyVtkTruncated(*cursor, kField, count);
    }
    cursor->TakeBytes(length);
  }
}

void SkipWords(std::int64_t count, TextCursor* cursor) {
  std::string_view word;
  for (std::int64_t i = 0; i < count; ++i) {
    if (!cursor->NextWord(&word)) {
      ThrowLegacyVtkTruncated(*cursor, kField, count);
    }
    cursor->Real(word, kField);
  }
}

}  // namespace

ScalarType LegacyVtkScalarType(const TextCursor& cursor,
                               std::string_view name) {
  if (const ScalarType* type = FindScalarType(name)) return *type;
  throw InputError(cursor.Where(),
                   Quoted(name) +
                       " is not a number type that is read here (float, "
                       "double, int, long, ...)",
                   kCopyAgain);
}

void ThrowLegacyVtkTruncated(const TextCursor& cursor,
                             const char* what,
                             std::int64_t count) {
  throw InputError(cursor.Where(),
                   std::string(what) + " promises " + std::to_string(count) +
                       " numbers, " + std::to_string(cursor.bytes_left()) +
                       " bytes follow: the file is truncated",
                   kCopyAgain);
}

void SkipLegacyVtkArray(std::string_view type,
                        std::int64_t count,
                        bool is_binary,
                        TextCursor* cursor) {
  const std::string name = LowerCase(type);
  if (name == "string" || name == "utf8_string") {
    // As text they are lines, in which blanks are written as %20.
    is_binary ? SkipBinaryTexts(count, cursor) : SkipLines(count, cursor);
  } else if (name == "variant") {
    SkipLines(count, cursor);  // in binary files, too
  } else if (name == "bit") {
    constexpr int kBitsOfByte = 8;
    const std::int64_t bytes = (count + kBitsOfByte - 1) / kBitsOfByte;
    is_binary ? SkipBytes(bytes, 1, count, cursor) : SkipWords(count, cursor);
  } else {
    const auto size =
        static_cast<std::int64_t>(SizeOf(LegacyVtkScalarType(*cursor, type)));
    is_binary ? SkipBytes(count, size, count, cursor)
              : SkipWords(count, cursor);
  }
}

void SkipLegacyVtkMetadata(TextCursor* cursor) {
  std::string_view line;
  while (cursor->NextLine(&line) && !line.empty()) {
  }
}

}  // namespace musclewarp
