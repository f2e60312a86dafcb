// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/mesh_files/off_records.h"

#include <algorithm>
#include <charconv>
#include <vector>

#include "musclewarp/base/input_error.h"
#include "musclewarp/mesh_files/export_advice.h"

namespace musclewarp {
namespace {

// Removes `prefix` from the front of a word. Returns false if it is not there.
bool TakePrefix(std::string_view prefix, std::string_view* word) {
  if (word->substr(0, prefix.size()) != prefix) return false;
  word->remove_prefix(prefix.size());
  return true;
}

// Reads [ST][C][N][4][n]OFF. Returns false for any other word.
bool ReadKeyword(const std::string& path,
                 std::string_view word,
                 OffHeader* header) {
  const std::string_view all = word;
  header->has_textures = TakePrefix("ST", &word);
  header->has_colours = TakePrefix("C", &word);
  header->has_normals = TakePrefix("N", &word);
  const bool has_dimension = TakePrefix("4n", &word) ||
                             TakePrefix("4", &word) || TakePrefix("n", &word);
  if (word != "OFF") return false;
  if (!has_dimension) return true;
  throw InputError(path,
                   "has vertices in another space (" + Quoted(all) +
                       "); allowed: OFF with three coordinates",
                   "export the mesh as plain OFF, or in another format");
}

bool IsWhole(std::string_view word, std::int64_t* number) {
  const auto [rest, error] =
      std::from_chars(word.data(), word.data() + word.size(), *number);
  return error == std::errc() && rest == word.data() + word.size();
}

// The keyword may be left out: then the file starts with its three counts.
bool AreCounts(const Words& words) {
  std::int64_t number = 0;
  return words.size() == 3 &&
         std::all_of(words.begin(), words.end(), [&](std::string_view word) {
           return IsWhole(word, &number);
         });
}

[[noreturn]] void ThrowNotOff(const std::string& path, const Words& words) {
  throw InputError(path,
                   "is not an OFF file: it starts with " +
                       Quoted(words.empty() ? "" : words[0]) +
                       " instead of 'OFF'",
                   "name the file by what it holds");
}

// True if words are the vertices and faces of a file and nothing else.
bool IsStream(const OffHeader& header,
              const std::vector<std::string_view>& all) {
  const auto size = static_cast<std::int64_t>(all.size());
  if (header.vertices > size || header.faces > size) return false;
  std::int64_t at = header.vertices * NumbersOfVertex(header, 4);
  for (std::int64_t f = 0; f < header.faces; ++f) {
    std::int64_t corners = 0;
    if (at >= size || !IsWhole(all[at], &corners)) return false;
    if (corners < 0 || corners > size) return false;
    at += 1 + corners;
  }
  return at == size;
}

}  // namespace

std::int64_t NumbersOfVertex(const OffHeader& header, int of_colour) {
  return 3 + (header.has_normals ? 3 : 0) +
         (header.has_colours ? of_colour : 0) + (header.has_textures ? 2 : 0);
}

OffHeader ReadOffHeader(const std::string& path, TextCursor* cursor) {
  OffHeader header;
  Words words;
  cursor->NextWords(&words);
  if (!AreCounts(words)) {
    if (words.empty() || !ReadKeyword(path, words[0], &header)) {
      ThrowNotOff(path, words);
    }
    words.erase(words.begin());
    header.is_binary = !words.empty() && words[0] == "BINARY";
    if (header.is_binary) return header;
    if (words.empty()) cursor->NextWords(&words);
  }
  if (words.size() < 2) {
    throw InputError(path,
                     "is truncated: the numbers of vertices and faces are "
                     "missing",
                     kCopyAgain);
  }
  header.vertices = cursor->Integer(words[0], "the number of vertices");
  header.faces = cursor->Integer(words[1], "the number of faces");
  if (header.vertices < 0 || header.faces < 0) {
    throw InputError(cursor->Where(),
                     "a number of vertices or faces is negative",
                     kCopyAgain);
  }
  return header;
}

OffLayout LayoutOfOff(const OffHeader& header, TextCursor cursor) {
  const TextCursor begin = cursor;
  Words words;
  std::int64_t lines = 0;
  while (cursor.NextWords(&words)) ++lines;
  // Neither count is believed until so many lines are there.
  const std::int64_t records = header.vertices > lines || header.faces > lines
                                   ? lines + 1
                                   : header.vertices + header.faces;
  if (lines == records) return OffLayout::kLines;
  if (lines > records) return OffLayout::kOver;
  cursor = begin;
  std::vector<std::string_view> all;
  while (cursor.NextWords(&words)) {
    all.insert(all.end(), words.begin(), words.end());
  }
  return IsStream(header, all) ? OffLayout::kStream : OffLayout::kLines;
}

}  // namespace musclewarp
