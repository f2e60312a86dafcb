// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/mesh_files/obj_io.h"

#include <algorithm>
#include <set>
#include <utility>
#include <vector>

#include "musclewarp/base/input_error.h"
#include "musclewarp/mesh_files/export_advice.h"
#include "musclewarp/mesh_files/soup_builder.h"
#include "musclewarp/mesh_files/text_cursor.h"

namespace musclewarp {
namespace {

// What the format calls a group without a name.
constexpr char kNoName[] = "default";

// True for the statements of the format that do not concern points and faces.
bool IsSkipped(std::string_view statement) {
  static const std::set<std::string_view> kSkipped = {
      "vt",         "vn",     "vp",     "s",        "mg",       "usemtl",
      "mtllib",     "usemap", "maplib", "l",        "p",        "lod",
      "cstype",     "deg",    "bmat",   "step",     "curv",     "curv2",
      "surf",       "parm",   "trim",   "hole",     "scrv",     "sp",
      "end",        "con",    "bevel",  "c_interp", "d_interp", "trace_obj",
      "shadow_obj", "ctech",  "stech",  "call",     "csh"};
  return kSkipped.count(statement) > 0;
}

// What a file has that is no statement of the format.
class UnknownStatements {
 public:
  void Add(std::string_view word) {
    ++count_;
    const auto same = [&](const auto& other) { return other.first == word; };
    const auto found = std::find_if(words_.begin(), words_.end(), same);
    if (found != words_.end()) {
      ++found->second;
    } else if (words_.size() < kMostNamed) {
      words_.emplace_back(word, 1);
    } else {
      has_more_ = true;
    }
  }

  void AddNote(const std::string& path, std::vector<std::string>* notes) const {
    if (count_ == 0) return;
    std::string named;
    for (const auto& [word, count] : words_) {
      named += (named.empty() ? "" : ", ") + Quoted(word) +
               (count > 1 ? " " + std::to_string(count) + " times" : "");
    }
    notes->push_back(path + ": " + std::to_string(count_) +
                     (count_ == 1 ? " line that is no OBJ statement was"
                                  : " lines that are no OBJ statements were") +
                     " skipped: " + named + (has_more_ ? ", ..." : ""));
  }

 private:
  static constexpr std::size_t kMostNamed = 5;

  std::int64_t count_ = 0;
  std::vector<std::pair<std::string_view, std::int64_t>> words_;
  bool has_more_ = false;
};

// Sets `statement` to the words of the next one; a backslash at the end of a
// line continues the statement on the next line.
bool NextStatement(TextCursor* cursor, Words* statement) {
  if (!cursor->NextWords(statement)) return false;
  Words more;
  while (!statement->empty() && statement->back().back() == '\\') {
    statement->back().remove_suffix(1);
    if (statement->back().empty()) statement->pop_back();
    if (!cursor->NextWords(&more)) break;
    statement->insert(statement->end(), more.begin(), more.end());
  }
  return true;
}

void AddObjVertex(const TextCursor& cursor,
                  const Words& words,
                  SoupBuilder* builder) {
  // x y z, then perhaps a weight or a colour.
  if (words.size() < 4) {
    throw InputError(cursor.Where(),
                     "has " + std::to_string(words.size() - 1) +
                         " coordinates, a vertex has 3",
                     kExportAgain);
  }
  Eigen::Vector3d point;
  for (int i = 0; i < 3; ++i) {
    point[i] = cursor.Real(words[i + 1], "a coordinate");
  }
  builder->AddPoint(point, cursor.line());
}

// "v", "v/vt", "v//vn" or "v/vt/vn": v, counted from 0.
std::int64_t CornerFromWord(const TextCursor& cursor,
                            std::string_view word,
                            std::int64_t num_points) {
  const std::size_t slash = word.find('/');
  const std::int64_t index =
      cursor.Integer(word.substr(0, slash), "a vertex index");
  if (slash != std::string_view::npos) {
    const std::size_t stray =
        word.substr(slash).find_first_not_of("/-+0123456789");
    if (stray != std::string_view::npos) {
      cursor.Integer(word.substr(slash + 1), "a texture or normal index");
    }
  }
  // Negative indices count back from the last vertex so far.
  const std::int64_t vertex = index > 0 ? index - 1 : num_points + index;
  if (index == 0 || vertex < 0) {
    throw InputError(cursor.Where(),
                     "names vertex " + std::to_string(index) +
                         ", vertices count from 1, or from -1 back to -" +
                         std::to_string(num_points),
                     kExportAgain);
  }
  return vertex;
}

// The name in a statement such as "o left psoas # 3". Only a "#" after a blank
// begins a comment here; others belong to names.
std::string NameIn(std::string_view bytes, std::string_view keyword) {
  const std::size_t begin = keyword.data() - bytes.data() + keyword.size();
  std::string_view line = bytes.substr(begin);
  line = line.substr(0, line.find_first_of("\r\n"));
  for (const char* comment : {" #", "\t#"}) {
    line = line.substr(0, line.find(comment));
  }
  const std::string name = PartName(line);
  return name.empty() ? kNoName : name;
}

}  // namespace

TriangleSoup ReadObj(const std::string& path,
                     std::string_view bytes,
                     std::vector<std::string>* notes,
                     MeshParts* parts) {
  TextCursor cursor(path, bytes, '#');
  SoupBuilder builder(path, 1);
  Words words;
  std::vector<std::int64_t> corners;
  UnknownStatements unknown;
  PartCollector objects(PartCollector::Again::kStarts, kNoName);
  PartCollector groups(PartCollector::Again::kContinues, kNoName);
  while (NextStatement(&cursor, &words)) {
    if (words.empty()) continue;
    if (words[0] == "v") {
      AddObjVertex(cursor, words, &builder);
    } else if (words[0] == "f" || words[0] == "fo") {
      corners.clear();
      for (std::size_t i = 1; i < words.size(); ++i) {
        corners.push_back(
            CornerFromWord(cursor, words[i], builder.num_points()));
      }
      builder.AddPolygon(corners, cursor.line());
      objects.AddFace();
      groups.AddFace();
    } else if (words[0] == "o") {
      objects.Start(NameIn(bytes, words[0]));
    } else if (words[0] == "g") {
      groups.Start(NameIn(bytes, words[0]));
    } else if (!IsSkipped(words[0])) {
      unknown.Add(words[0]);
    }
  }
  unknown.AddNote(path, notes);
  std::vector<int> face_of_triangle;
  TriangleSoup soup = builder.Build(&face_of_triangle);
  if (parts) {
    *parts = objects.HasParts() ? objects.Parts("object", face_of_triangle)
                                : groups.Parts("group", face_of_triangle);
  }
  return soup;
}

std::string ObjBytes(const TriangleSoup& soup) {
  std::string out;
  for (Eigen::Index i = 0; i < soup.points.rows(); ++i) {
    out += 'v';
    for (const double x : soup.points.row(i)) {
      out += ' ';
      AppendReal(x, &out);
    }
    out += '\n';
  }
  for (Eigen::Index f = 0; f < soup.triangles.rows(); ++f) {
    out += 'f';
    for (const int v : soup.triangles.row(f)) {
      out += ' ' + std::to_string(v + 1);
    }
    out += '\n';
  }
  return out;
}

}  // namespace musclewarp
