// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/label_images/label_table.h"

#include <algorithm>
#include <limits>
#include <set>
#include <utility>

#include "musclewarp/base/input_error.h"
#include "musclewarp/base/input_file.h"
#include "musclewarp/base/text_encoding.h"
#include "musclewarp/mesh_files/text_cursor.h"
#include "musclewarp/scene/scene_names.h"

namespace musclewarp {
namespace {

using Cells = std::vector<std::string>;

constexpr char kTableAdvice[] =
    "write lines such as 3,femur,bone (docs/separate.md)";

// The indices of the columns in a line; -1 for a column that is missing.
struct Columns {
  int label = 0, name = 1, kind = 2;
  int bone = -1, side = -1, body = -1, origin = -1, insertion = -1;
};

// Returns a text from within quotes, in which two quotes stand for one.
std::string WithSingleQuotes(std::string_view text) {
  std::string out;
  for (std::size_t i = 0; i < text.size(); ++i) {
    out += text[i];
    if (text.substr(i, 2) == "\"\"") ++i;
  }
  return out;
}

// Returns a text without surrounding blanks, and without the quotes within
// these.
std::string CellText(std::string_view text) {
  constexpr std::string_view kBlanks = " \t\r";
  const std::size_t begin = text.find_first_not_of(kBlanks);
  if (begin == std::string_view::npos) return "";
  text = text.substr(begin, text.find_last_not_of(kBlanks) - begin + 1);
  if (text.size() >= 2 && text.front() == '"' && text.back() == '"') {
    return CellText(WithSingleQuotes(text.substr(1, text.size() - 2)));
  }
  return std::string(text);
}

// Splits a line at separators, except those within quotes.
Cells CellsOf(std::string_view line, char separator) {
  Cells cells;
  std::string cell;
  bool is_quoted = false;
  for (const char letter : line) {
    if (letter == '"') is_quoted = !is_quoted;
    const bool ends = !is_quoted && (letter == separator ||
                                     (separator == ' ' && letter == '\t'));
    if (!ends) {
      cell += letter;
    } else if (separator != ' ' || !cell.empty()) {
      cells.push_back(CellText(cell));
      cell.clear();
    }
  }
  if (separator != ' ' || !cell.empty()) cells.push_back(CellText(cell));
  return cells;
}

bool IsNumber(const std::string& text) {
  return !text.empty() &&
         text.find_first_not_of("+-.0123456789") == std::string::npos;
}

bool AreNumbers(const Cells& cells, std::size_t begin, std::size_t end) {
  return std::all_of(cells.begin() + begin, cells.begin() + end, IsNumber);
}

// Returns the name of a column in the form used for comparison.
std::string ColumnName(const std::string& cell) {
  std::string name;
  for (const char letter : LowerCase(cell)) {
    if (letter != ' ' && letter != '_') name += letter;
  }
  return name;
}

int ColumnOf(const Cells& header, const std::set<std::string>& names) {
  for (std::size_t i = 0; i < header.size(); ++i) {
    if (names.count(ColumnName(header[i]))) return static_cast<int>(i);
  }
  return -1;
}

class TableReader {
 public:
  explicit TableReader(const std::string& path) : path_(path) {}

  std::vector<LabelEntry> Read() {
    const std::string text = TextWithoutMark(ReadFile(path_));
    TextCursor cursor(path_, text);
    std::string_view line;
    while (cursor.NextLine(&line)) {
      where_ = cursor.Where();
      // Spreadsheets write empty rows as separators.
      const std::size_t begin = line.find_first_not_of(" \t\r,;\"");
      if (begin == std::string_view::npos || line[begin] == '#') continue;
      ReadLine(std::string(line));
    }
    if (entries_.empty()) {
      throw InputError(path_, "has no label above 0", kTableAdvice);
    }
    return entries_;
  }

 private:
  void ReadLine(const std::string& line) {
    if (is_first_ && TakeSeparator(line)) return;
    for (const char separator : {separator_, '\t', ',', ';'}) {
      if (separator == 0 || CellsOf(line, separator).size() < 2) continue;
      separator_ = separator;
      ReadColumns(CellsOf(line, separator));
      return;
    }
    ReadWords(CellsOf(line, ' '));
  }

  // Sets the separator that a first line "sep=;" names, a convention of Excel,
  // and returns true for such a line. Otherwise sets the separator that results
  // in the most columns.
  bool TakeSeparator(const std::string& line) {
    constexpr std::string_view kNamed = "sep=";
    const std::string word = CellText(line);
    if (word.size() == kNamed.size() + 1 &&
        LowerCase(word).substr(0, kNamed.size()) == kNamed) {
      separator_ = word.back();
      return true;
    }
    if (separator_ != 0) return false;
    std::size_t most = 1;
    for (const char separator : {'\t', ',', ';'}) {
      const std::size_t count = CellsOf(line, separator).size();
      if (count <= most) continue;
      most = count;
      separator_ = separator;
    }
    return false;
  }

  void ReadColumns(const Cells& cells) {
    if (is_first_ && !IsNumber(cells[0])) {
      SetColumns(cells);
      return;
    }
    const auto cell = [&](int column) {
      const bool is_there =
          column >= 0 && column < static_cast<int>(cells.size());
      return is_there ? cells[column] : std::string();
    };
    LabelEntry entry;
    entry.bone = cell(columns_.bone);
    entry.side = LowerCase(cell(columns_.side));
    entry.body = cell(columns_.body);
    entry.origin = cell(columns_.origin);
    entry.insertion = cell(columns_.insertion);
    Add(cell(columns_.label),
        cell(columns_.name),
        cell(columns_.kind),
        std::move(entry));
  }

  void SetColumns(const Cells& cells) {
    is_first_ = false;
    columns_.label =
        ColumnOf(cells, {"label", "labelvalue", "value", "index", "idx", "id"});
    columns_.name = ColumnOf(cells, {"name", "labelname", "structure"});
    columns_.kind = ColumnOf(cells, {"kind", "type"});
    columns_.bone = ColumnOf(cells, {"bone"});
    columns_.side = ColumnOf(cells, {"side"});
    columns_.body = ColumnOf(cells, {"body"});
    columns_.origin = ColumnOf(cells, {"origin"});
    columns_.insertion = ColumnOf(cells, {"insertion"});
    for (const auto& [column, name] :
         {std::pair(columns_.label, "label"), {columns_.name, "name"}}) {
      if (column >= 0) continue;
      throw InputError(where_,
                       "names the columns, and none of them is " + Quoted(name),
                       "name the columns label, name, kind");
    }
  }

  void ReadWords(const Cells& cells) {
    if (is_first_ && ColumnOf(cells, {"label"}) == 0) {
      is_first_ = false;  // "label name kind" over plain words
    } else if (cells.size() == 8 && AreNumbers(cells, 0, 7)) {
      Add(cells[0], cells[7], "");  // ITK-SNAP
    } else if (cells.size() == 6 && AreNumbers(cells, 2, 6)) {
      Add(cells[0], cells[1], "");  // 3D Slicer
    } else if (cells.size() == 2 || cells.size() == 3) {
      Add(cells[0], cells[1], cells.size() == 3 ? cells[2] : "");
    } else {
      throw InputError(where_,
                       "has " + std::to_string(cells.size()) +
                           " words; allowed: label, name and kind",
                       kTableAdvice);
    }
  }

  void Add(const std::string& label_text,
           const std::string& name,
           const std::string& kind_text,
           LabelEntry entry = {}) {
    is_first_ = false;
    entry.label = Label(label_text);
    if (entry.label == 0) return;
    if (name.empty()) {
      throw InputError(
          where_, "label " + label_text + " has no name", kTableAdvice);
    }
    CheckFileName(where_, "label", name);
    entry.name = name;
    const std::string kind = LowerCase(kind_text);
    if (kind == "muscle" || kind == "bone") {
      entry.is_bone = kind == "bone";
    } else if (!kind.empty()) {
      throw InputError(where_,
                       "has the kind " + Quoted(kind_text) +
                           "; allowed: muscle, bone, or nothing",
                       "correct it, or leave the column out");
    }
    CheckIsNew(entry);
    entries_.push_back(entry);
  }

  int Label(const std::string& text) const {
    constexpr std::size_t kMostDigits = 10;
    // Spreadsheets may write 1.0, or 1,0, for 1.
    const std::size_t point = std::min(text.find_first_of(".,"), text.size());
    const std::string digits = text.substr(0, point);
    const bool is_whole =
        !digits.empty() && digits.size() <= kMostDigits &&
        digits.find_first_not_of("0123456789") == std::string::npos &&
        text.find_first_not_of('0', point + 1) == std::string::npos;
    const long long label = is_whole ? std::stoll(digits) : -1;
    if (label >= 0 && label <= std::numeric_limits<int>::max()) {
      return static_cast<int>(label);
    }
    throw InputError(where_,
                     "has the label " + Quoted(text) +
                         "; allowed: whole numbers from 0 to 2147483647",
                     kTableAdvice);
  }

  void CheckIsNew(const LabelEntry& entry) const {
    for (const LabelEntry& other : entries_) {
      if (other.label == entry.label) {
        throw InputError(where_,
                         "has label " + std::to_string(entry.label) +
                             ", as an earlier line has",
                         "name each label once");
      }
      if (other.name == entry.name) {
        throw InputError(where_,
                         "has the name " + QuotedName(entry.name) +
                             ", as label " + std::to_string(other.label) +
                             " has",
                         "give each label a name of its own");
      }
    }
  }

  std::string path_;
  std::string where_;  // the line that is being read
  bool is_first_ = true;
  char separator_ = 0;  // of columns; 0: none yet
  Columns columns_;
  std::vector<LabelEntry> entries_;
};

}  // namespace

std::vector<LabelEntry> ReadLabelTable(const std::string& path) {
  return TableReader(path).Read();
}

}  // namespace musclewarp
