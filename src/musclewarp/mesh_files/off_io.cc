// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/mesh_files/off_io.h"

#include <set>
#include <vector>

#include "musclewarp/base/input_error.h"
#include "musclewarp/mesh_files/export_advice.h"
#include "musclewarp/mesh_files/soup_builder.h"
#include "musclewarp/mesh_files/text_cursor.h"

namespace musclewarp {
namespace {

struct Counts {
  std::int64_t vertices;
  std::int64_t faces;
};

// A header is the keyword, then the numbers of vertices, faces and edges, on
// the same line or on the next.
Counts ReadHeader(const std::string& path, TextCursor* cursor) {
  // Each prefix adds values behind the coordinates of a vertex.
  static const std::set<std::string_view> kKeywords = {
      "OFF", "COFF", "NOFF", "STOFF", "CNOFF", "STCOFF", "STNOFF", "STCNOFF"};
  Words words;
  cursor->NextWords(&words);
  if (words.empty() || kKeywords.count(words[0]) == 0 ||
      (words.size() > 1 && words[1] == "BINARY")) {
    throw InputError(path,
                     "is not an ASCII OFF file: it starts with " +
                         Quoted(words.empty() ? "" : words[0]) +
                         (words.size() > 1 ? " " + Quoted(words[1]) : "") +
                         " instead of 'OFF'",
                     "name the file by what it holds, or export it as ASCII");
  }
  words.erase(words.begin());
  if (words.empty()) cursor->NextWords(&words);
  if (words.size() < 2) {
    throw InputError(path,
                     "is truncated: the numbers of vertices and faces are "
                     "missing",
                     kCopyAgain);
  }
  const Counts counts = {cursor->Integer(words[0], "the number of vertices"),
                         cursor->Integer(words[1], "the number of faces")};
  if (counts.vertices < 0 || counts.faces < 0) {
    throw InputError(cursor->Where(),
                     "a number of vertices or faces is negative",
                     kCopyAgain);
  }
  return counts;
}

// Reads the words of the next vertex or face.
void NextItem(const std::string& path,
              const std::string& items,
              std::int64_t index,
              std::int64_t count,
              TextCursor* cursor,
              Words* words) {
  if (cursor->NextWords(words)) return;
  throw InputError(path,
                   "is truncated: the header promises " +
                       std::to_string(count) + " " + items +
                       ", the file ends after " + std::to_string(index),
                   kCopyAgain);
}

[[noreturn]] void ThrowTooFew(const TextCursor& cursor,
                              std::size_t seen,
                              std::int64_t needed) {
  throw InputError(cursor.Where(),
                   "has " + std::to_string(seen) + " values, " +
                       std::to_string(needed) + " needed",
                   kExportAgain);
}

void AddOffVertex(const TextCursor& cursor,
                  const Words& words,
                  SoupBuilder* builder) {
  if (words.size() < 3) ThrowTooFew(cursor, words.size(), 3);
  Eigen::Vector3d point;
  for (int i = 0; i < 3; ++i) point[i] = cursor.Real(words[i], "a coordinate");
  builder->AddPoint(point, cursor.line());
}

void AddFace(const TextCursor& cursor,
             const Words& words,
             SoupBuilder* builder) {
  const std::int64_t size = cursor.Integer(words[0], "the number of corners");
  const auto listed = static_cast<std::int64_t>(words.size()) - 1;
  if (size < 0 || size > listed) ThrowTooFew(cursor, words.size(), size);
  std::vector<std::int64_t> corners;
  for (std::int64_t i = 1; i <= size; ++i) {
    corners.push_back(cursor.Integer(words[i], "a vertex index"));
  }
  builder->AddPolygon(corners, cursor.line());
}

}  // namespace

TriangleSoup ReadOff(const std::string& path, std::string_view bytes) {
  TextCursor cursor(path, bytes, '#');
  const Counts counts = ReadHeader(path, &cursor);
  SoupBuilder builder(path);
  Words words;
  for (std::int64_t i = 0; i < counts.vertices; ++i) {
    NextItem(path, "vertices", i, counts.vertices, &cursor, &words);
    AddOffVertex(cursor, words, &builder);
  }
  for (std::int64_t i = 0; i < counts.faces; ++i) {
    NextItem(path, "faces", i, counts.faces, &cursor, &words);
    AddFace(cursor, words, &builder);
  }
  if (cursor.NextWords(&words)) {
    throw InputError(cursor.Where(),
                     "data follow the last face, the header promises less than "
                     "the file holds",
                     kCopyAgain);
  }
  return builder.Build();
}

std::string OffBytes(const TriangleSoup& soup) {
  std::string out = "OFF\n" + std::to_string(soup.points.rows()) + " " +
                    std::to_string(soup.triangles.rows()) + " 0\n";
  for (Eigen::Index i = 0; i < soup.points.rows(); ++i) {
    for (int a = 0; a < 3; ++a) {
      AppendReal(soup.points(i, a), &out);
      out += a < 2 ? ' ' : '\n';
    }
  }
  for (Eigen::Index f = 0; f < soup.triangles.rows(); ++f) {
    out += '3';
    for (const int v : soup.triangles.row(f)) out += ' ' + std::to_string(v);
    out += '\n';
  }
  return out;
}

}  // namespace musclewarp
