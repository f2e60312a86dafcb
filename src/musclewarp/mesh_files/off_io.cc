// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/mesh_files/off_io.h"

#include <limits>
#include <vector>

#include "musclewarp/base/input_error.h"
#include "musclewarp/mesh_files/binary_scalar.h"
#include "musclewarp/mesh_files/export_advice.h"
#include "musclewarp/mesh_files/off_records.h"
#include "musclewarp/mesh_files/soup_builder.h"
#include "musclewarp/mesh_files/text_cursor.h"

namespace musclewarp {
namespace {

[[noreturn]] void ThrowMoreThanPromised(const std::string& where) {
  throw InputError(where,
                   "data follow the last face, the header promises less than "
                   "the file holds",
                   kCopyAgain);
}

// Reads the vertices and faces of a text file, which follow its header.
class OffText {
 public:
  OffText(const std::string& path, const OffHeader& header, TextCursor* cursor)
      : path_(path),
        header_(header),
        layout_(LayoutOfOff(header, *cursor)),
        cursor_(*cursor) {}

  void Read(SoupBuilder* builder) {
    for (std::int64_t i = 0; i < header_.vertices; ++i) {
      BeginRecord("vertices", i, header_.vertices);
      // What stands behind the coordinates may be missing, but in records that
      // end nowhere else.
      const bool is_whole = layout_ != OffLayout::kLines;
      const int of_colour = layout_ == OffLayout::kStream ? 4 : 3;
      Need(is_whole ? NumbersOfVertex(header_, of_colour) : 3);
      Eigen::Vector3d point;
      for (int k = 0; k < 3; ++k) {
        point[k] = cursor_.Real(words_[at_ + k], "a coordinate");
      }
      builder->AddPoint(point, cursor_.line());
      at_ += NumbersOfVertex(header_, of_colour);
    }
    std::vector<std::int64_t> corners;
    for (std::int64_t i = 0; i < header_.faces; ++i) {
      BeginRecord("faces", i, header_.faces);
      const std::int64_t size =
          cursor_.Integer(words_[at_], "the number of corners");
      if (size < 0 || size > std::numeric_limits<int>::max()) {
        throw InputError(cursor_.Where(),
                         "has a face of " + std::to_string(size) +
                             " corners; allowed: 3 or more",
                         kExportAgain);
      }
      Need(1 + size);
      corners.clear();
      for (std::int64_t k = 1; k <= size; ++k) {
        corners.push_back(cursor_.Integer(words_[at_ + k], "a vertex index"));
      }
      builder->AddPolygon(corners, cursor_.line());
      at_ += 1 + size;
    }
    if (!cursor_.NextWords(&words_)) return;
    ThrowMoreThanPromised(cursor_.Where());
  }

 private:
  // Goes to the first word of the next record.
  void BeginRecord(const std::string& records,
                   std::int64_t index,
                   std::int64_t count) {
    if (layout_ == OffLayout::kStream && at_ < words_.size()) return;
    at_ = 0;
    if (cursor_.NextWords(&words_)) return;
    throw InputError(path_,
                     "is truncated: the header promises " +
                         std::to_string(count) + " " + records +
                         ", the file ends after " + std::to_string(index),
                     kCopyAgain);
  }

  // Goes on to the next lines, where records do so, until there are `count`
  // words of the record.
  void Need(std::int64_t count) {
    Words more;
    const auto seen = [&] {
      return static_cast<std::int64_t>(words_.size() - at_);
    };
    while (seen() < count) {
      if (layout_ == OffLayout::kLines || !cursor_.NextWords(&more)) {
        throw InputError(cursor_.Where(),
                         "has " + std::to_string(seen()) + " values, " +
                             std::to_string(count) + " needed",
                         kExportAgain);
      }
      // Only what is still needed is kept: a stream may be one record a line.
      words_.erase(words_.begin(), words_.begin() + at_);
      at_ = 0;
      words_.insert(words_.end(), more.begin(), more.end());
    }
  }

  const std::string& path_;
  const OffHeader& header_;
  const OffLayout layout_;
  TextCursor& cursor_;
  Words words_;         // of the line, or of the lines of the record
  std::size_t at_ = 0;  // the first word of the record
};

// Reads the counts, vertices and faces behind "OFF BINARY", 4 bytes a number,
// the highest first (geomview.org/docs/html/OFF.html).
class OffBinary {
 public:
  OffBinary(const std::string& path,
            const OffHeader& header,
            TextCursor* cursor)
      : path_(path), header_(header), cursor_(*cursor) {}

  void Read(SoupBuilder* builder) {
    const std::int64_t vertices = Count("numbers of vertices and faces");
    const std::int64_t faces = Count("numbers of vertices and faces");
    Count("number of edges");
    const std::int64_t numbers = NumbersOfVertex(header_, 4);
    for (std::int64_t i = 0; i < vertices; ++i) {
      const char* const bytes = Take(numbers, "vertices");
      Eigen::Vector3d point;
      for (int k = 0; k < 3; ++k) {
        point[k] = LoadAs<float>(bytes + kNumber * k, ByteOrder::kBig);
      }
      builder->AddPoint(point);
    }
    std::vector<std::int64_t> corners;
    for (std::int64_t i = 0; i < faces; ++i) {
      const std::int64_t size = Count("faces");
      const char* const bytes = Take(size, "faces");
      corners.clear();
      for (std::int64_t k = 0; k < size; ++k) {
        corners.push_back(
            LoadAs<std::int32_t>(bytes + kNumber * k, ByteOrder::kBig));
      }
      builder->AddPolygon(corners);
      Take(Count("colours of faces"), "colours of faces");
    }
    std::string_view word;  // blanks at the end do no harm
    if (cursor_.NextWord(&word)) ThrowMoreThanPromised(cursor_.Where());
  }

 private:
  static constexpr int kNumber = 4;  // bytes

  const char* Take(std::int64_t numbers, const char* what) {
    const std::size_t bytes = static_cast<std::size_t>(numbers) * kNumber;
    if (bytes <= cursor_.bytes_left()) return cursor_.TakeBytes(bytes).data();
    throw InputError(path_,
                     "is truncated: the file ends in its " + std::string(what),
                     kCopyAgain);
  }

  std::int64_t Count(const char* what) {
    const auto count = LoadAs<std::int32_t>(Take(1, what), ByteOrder::kBig);
    if (count >= 0) return count;
    throw InputError(cursor_.Where(),
                     "the count " + std::to_string(count) + " stands in its " +
                         what + "; allowed: 0 or more",
                     kExportAgain);
  }

  const std::string& path_;
  const OffHeader& header_;
  TextCursor& cursor_;
};

}  // namespace

TriangleSoup ReadOff(const std::string& path, std::string_view bytes) {
  TextCursor cursor(path, bytes, '#');
  const OffHeader header = ReadOffHeader(path, &cursor);
  SoupBuilder builder(path);
  if (header.is_binary) {
    OffBinary(path, header, &cursor).Read(&builder);
  } else {
    OffText(path, header, &cursor).Read(&builder);
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
