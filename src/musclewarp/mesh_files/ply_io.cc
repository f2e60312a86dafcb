// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/mesh_files/ply_io.h"

#include <algorithm>
#include <array>
#include <memory>
#include <vector>

#include "musclewarp/base/input_error.h"
#include "musclewarp/mesh_files/binary_scalar.h"
#include "musclewarp/mesh_files/export_advice.h"
#include "musclewarp/mesh_files/ply_header.h"
#include "musclewarp/mesh_files/soup_builder.h"
#include "musclewarp/mesh_files/text_cursor.h"

namespace musclewarp {
namespace {

// Reads what follows the header, item by item and value by value.
class PlyBody {
 public:
  PlyBody(std::string path, TextCursor* cursor)
      : path_(std::move(path)), cursor_(cursor) {}
  virtual ~PlyBody() = default;

  void BeginItem(const PlyElement& element, std::int64_t index) {
    element_ = &element;
    index_ = index;
    DoBeginItem();
  }
  virtual double Real(ScalarType type) = 0;
  virtual std::int64_t Integer(ScalarType type) = 0;
  virtual void Skip(ScalarType type) = 0;
  virtual void EndItem() {}
  virtual std::size_t line() const { return 0; }
  // False if data follow the last item, which means that the header is wrong.
  virtual bool AtEnd() = 0;

 protected:
  virtual void DoBeginItem() {}

  [[noreturn]] void ThrowTruncated() const {
    throw InputError(path_,
                     "is truncated: the header promises " +
                         std::to_string(element_->count) + " of element " +
                         Quoted(element_->name) + ", the file ends in number " +
                         std::to_string(index_ + 1),
                     kCopyAgain);
  }
  TextCursor& cursor() const { return *cursor_; }

 private:
  std::string path_;
  TextCursor* cursor_;
  const PlyElement* element_ = nullptr;
  std::int64_t index_ = 0;
};

class BinaryBody : public PlyBody {
 public:
  BinaryBody(std::string path, TextCursor* cursor, ByteOrder order)
      : PlyBody(std::move(path), cursor), order_(order) {}

  double Real(ScalarType type) override {
    return LoadReal(Take(type), type, order_);
  }
  std::int64_t Integer(ScalarType type) override {
    return LoadInteger(Take(type), type, order_);
  }
  void Skip(ScalarType type) override { Take(type); }
  bool AtEnd() override {
    std::string_view word;  // blanks at the end do no harm
    return !cursor().NextWord(&word);
  }

 private:
  const char* Take(ScalarType type) {
    const std::size_t size = SizeOf(type);
    if (size > cursor().bytes_left()) ThrowTruncated();
    return cursor().TakeBytes(size).data();
  }

  ByteOrder order_;
};

// Each item has a line of its own. Where there are more or fewer lines than
// items, numbers are read without regard to lines, as other readers do.
class AsciiBody : public PlyBody {
 public:
  AsciiBody(std::string path, const PlyHeader& header, TextCursor* cursor)
      : PlyBody(std::move(path), cursor),
        has_lines_(NumItems(header) == NumLines(*cursor)) {}

  double Real(ScalarType) override {
    return cursor().Real(Take(), "a coordinate");
  }
  std::int64_t Integer(ScalarType) override {
    return cursor().Integer(Take(), "a list length or vertex index");
  }
  void Skip(ScalarType) override { Take(); }
  void EndItem() override {
    if (has_lines_ && next_ < words_.size()) ThrowCount("more");
  }
  std::size_t line() const override { return cursor().line(); }
  bool AtEnd() override {
    return next_ == words_.size() && !cursor().NextWords(&words_);
  }

 protected:
  void DoBeginItem() override {
    if (!has_lines_ && next_ < words_.size()) return;
    next_ = 0;
    if (!cursor().NextWords(&words_)) ThrowTruncated();
  }

 private:
  std::string_view Take() {
    if (next_ == words_.size()) {
      if (has_lines_ && cursor().bytes_left() > 0) ThrowCount("fewer");
      next_ = 0;
      if (has_lines_ || !cursor().NextWords(&words_)) ThrowTruncated();
    }
    return words_[next_++];
  }

  [[noreturn]] void ThrowCount(const char* more_or_fewer) const {
    throw InputError(cursor().Where(),
                     "has " + std::string(more_or_fewer) + " values (" +
                         std::to_string(words_.size()) +
                         ") than the properties in the header need",
                     kExportAgain);
  }

  // Items of elements without properties have no lines.
  static double NumItems(const PlyHeader& header) {
    double items = 0;  // whatever the header promises
    for (const PlyElement& element : header.elements) {
      if (!element.properties.empty()) items += element.count;
    }
    return items;
  }
  static double NumLines(TextCursor cursor) {
    Words words;
    double lines = 0;
    while (cursor.NextWords(&words)) ++lines;
    return lines;
  }

  bool has_lines_;
  Words words_;
  std::size_t next_ = 0;
};

std::unique_ptr<PlyBody> MakeBody(const std::string& path,
                                  const PlyHeader& header,
                                  TextCursor* cursor) {
  if (header.format == PlyFormat::kAscii) {
    return std::make_unique<AsciiBody>(path, header, cursor);
  }
  return std::make_unique<BinaryBody>(path,
                                      cursor,
                                      header.format == PlyFormat::kBinaryBig
                                          ? ByteOrder::kBig
                                          : ByteOrder::kLittle);
}

std::int64_t ListLength(const std::string& path,
                        const PlyProperty& property,
                        std::int64_t item,
                        PlyBody* body) {
  const std::int64_t length = body->Integer(property.count_type);
  if (length < 0) {
    throw InputError(path + ": item " + std::to_string(item),
                     "list " + Quoted(property.name) + " has the length " +
                         std::to_string(length),
                     kExportAgain);
  }
  return length;
}

void SkipProperty(const std::string& path,
                  const PlyProperty& property,
                  std::int64_t item,
                  PlyBody* body) {
  const std::int64_t length =
      property.is_list ? ListLength(path, property, item, body) : 1;
  for (std::int64_t i = 0; i < length; ++i) body->Skip(property.type);
}

[[noreturn]] void ThrowMissing(const std::string& path, const char* what) {
  throw InputError(path,
                   "is a PLY file without " + std::string(what),
                   "export the surface as a triangle mesh");
}

void ReadVertices(const std::string& path,
                  const PlyElement& element,
                  PlyBody* body,
                  SoupBuilder* builder) {
  // The axis that each property is a coordinate of, -1 for other properties.
  std::vector<int> axis(element.properties.size(), -1);
  constexpr std::array<const char*, 3> kAxes = {"x", "y", "z"};
  for (int a = 0; a < 3; ++a) {
    bool found = false;
    for (std::size_t p = 0; p < axis.size() && !found; ++p) {
      const PlyProperty& property = element.properties[p];
      found = property.name == kAxes[a] && !property.is_list;
      if (found) axis[p] = a;
    }
    if (!found) ThrowMissing(path, "the properties x, y and z of its vertices");
  }
  for (std::int64_t item = 0; item < element.count; ++item) {
    Eigen::Vector3d point;
    body->BeginItem(element, item);
    for (std::size_t p = 0; p < axis.size(); ++p) {
      const PlyProperty& property = element.properties[p];
      if (axis[p] < 0) {
        SkipProperty(path, property, item, body);
      } else {
        point[axis[p]] = body->Real(property.type);
      }
    }
    body->EndItem();
    builder->AddPoint(point, body->line());
  }
}

bool IsCornerList(const PlyProperty& property) {
  return property.is_list && IsInteger(property.type) &&
         (property.name == "vertex_indices" || property.name == "vertex_index");
}

// Adds the faces of an element, each item of which has the corners of one.
void AddPlyFace(const std::vector<std::int64_t>& corners,
                std::size_t line,
                SoupBuilder* builder) {
  builder->AddPolygon(corners, line);
}

// The same for an element whose items have strips of triangles, with -1 behind
// each but the last. A strip of fewer corners has no triangle.
void AddPlyStrips(const std::vector<std::int64_t>& corners,
                  std::size_t line,
                  SoupBuilder* builder) {
  auto begin = corners.begin();
  while (begin != corners.end()) {
    const auto end = std::find(begin, corners.end(), -1);
    if (end - begin >= 3) builder->AddStrip({begin, end}, line);
    begin = end == corners.end() ? end : end + 1;
  }
}

// Reads the lists of corners of an element, and gives each to `add`.
template <typename Add>
void ReadFaces(const std::string& path,
               const PlyElement& element,
               const Add& add,
               PlyBody* body,
               SoupBuilder* builder) {
  std::size_t corner_list = 0;
  while (corner_list < element.properties.size() &&
         !IsCornerList(element.properties[corner_list])) {
    ++corner_list;
  }
  if (corner_list == element.properties.size()) {
    ThrowMissing(path, "the list vertex_indices (integers) of its faces");
  }
  std::vector<std::int64_t> corners;
  for (std::int64_t item = 0; item < element.count; ++item) {
    body->BeginItem(element, item);
    for (std::size_t p = 0; p < element.properties.size(); ++p) {
      const PlyProperty& property = element.properties[p];
      if (p != corner_list) {
        SkipProperty(path, property, item, body);
        continue;
      }
      corners.clear();
      const std::int64_t length = ListLength(path, property, item, body);
      for (std::int64_t i = 0; i < length; ++i) {
        corners.push_back(body->Integer(property.type));
      }
    }
    body->EndItem();
    add(corners, body->line(), builder);
  }
}

void SkipElement(const std::string& path,
                 const PlyElement& element,
                 PlyBody* body) {
  if (element.properties.empty()) return;  // such items take no room
  for (std::int64_t item = 0; item < element.count; ++item) {
    body->BeginItem(element, item);
    for (const PlyProperty& property : element.properties) {
      SkipProperty(path, property, item, body);
    }
    body->EndItem();
  }
}

}  // namespace

TriangleSoup ReadPly(const std::string& path, std::string_view bytes) {
  TextCursor cursor(path, bytes);
  const PlyHeader header = ReadPlyHeader(path, &cursor);
  const auto body = MakeBody(path, header, &cursor);
  SoupBuilder builder(path);
  for (const PlyElement& element : header.elements) {
    if (element.name == "vertex") {
      ReadVertices(path, element, body.get(), &builder);
    } else if (element.name == "face") {
      ReadFaces(path, element, AddPlyFace, body.get(), &builder);
    } else if (element.name == "tristrips") {
      ReadFaces(path, element, AddPlyStrips, body.get(), &builder);
    } else {
      SkipElement(path, element, body.get());
    }
  }
  if (!body->AtEnd()) {
    throw InputError(cursor.Where(),
                     "data follow the last element, the header promises less "
                     "than the file holds",
                     kCopyAgain);
  }
  return builder.Build();
}

std::string PlyBytes(const TriangleSoup& soup) {
  std::string out =
      "ply\n"
      "format binary_little_endian 1.0\n"
      "element vertex " +
      std::to_string(soup.points.rows()) +
      "\n"
      "property double x\n"
      "property double y\n"
      "property double z\n"
      "element face " +
      std::to_string(soup.triangles.rows()) +
      "\n"
      "property list uchar int vertex_indices\n"
      "end_header\n";
  out.reserve(out.size() + 24 * soup.points.rows() +
              13 * soup.triangles.rows());
  for (Eigen::Index i = 0; i < soup.points.size(); ++i) {
    AppendBytes(soup.points.data()[i], ByteOrder::kLittle, &out);
  }
  for (Eigen::Index f = 0; f < soup.triangles.rows(); ++f) {
    AppendBytes<std::uint8_t>(3, ByteOrder::kLittle, &out);
    for (const int v : soup.triangles.row(f)) {
      AppendBytes<std::int32_t>(v, ByteOrder::kLittle, &out);
    }
  }
  return out;
}

}  // namespace musclewarp
