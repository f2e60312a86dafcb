// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/opensim/storage_table.h"

#include <glog/logging.h>

#include <charconv>
#include <cmath>
#include <limits>
#include <set>
#include <string_view>

#include "musclewarp/base/input_error.h"
#include "musclewarp/base/input_file.h"
#include "musclewarp/base/short_list.h"
#include "musclewarp/mesh_files/text_cursor.h"

namespace musclewarp {
namespace {

constexpr char kTime[] = "time";

std::string_view Trimmed(std::string_view text) {
  const auto begin = text.find_first_not_of(" \t");
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(" \t") + 1 - begin);
}

struct Header {
  std::string name;
  std::optional<bool> in_degrees;
  std::optional<bool> degrees_in_remark;
  std::optional<int> rows;
  std::optional<int> columns;  // with time
};

bool ParseDegrees(const TextCursor& cursor, std::string_view value) {
  const std::string word = LowerCase(value);
  if (word == "yes" || word == "true" || word == "y" || word == "1") {
    return true;
  }
  if (word == "no" || word == "false" || word == "n" || word == "0") {
    return false;
  }
  throw InputError(
      cursor.Where(), "inDegrees is " + Quoted(value), "allowed: yes, no");
}

// Takes OpenSim's remark about the unit of angles at its word.
void ReadRemark(std::string_view line, Header* header) {
  const std::string text = LowerCase(line);
  const auto has = [&](const char* words) {
    return text.find(words) != std::string::npos;
  };
  if (has("angles are in degrees")) header->degrees_in_remark = true;
  if (has("angles are in radians")) header->degrees_in_remark = false;
}

// Reads one line of the header. Lines without a setting are remarks.
void ReadHeaderLine(const TextCursor& cursor,
                    std::string_view line,
                    Header* header) {
  ReadRemark(line, header);
  const auto split = line.find_first_of("= \t");
  if (split == std::string_view::npos) return;
  const std::string key = LowerCase(Trimmed(line.substr(0, split)));
  std::string_view value = Trimmed(line.substr(split + 1));
  if (!value.empty() && value[0] == '=') value = Trimmed(value.substr(1));
  if (key == "indegrees") {
    header->in_degrees = ParseDegrees(cursor, value);
  } else if (key == "nrows" || key == "datarows") {
    header->rows =
        static_cast<int>(cursor.Integer(value, "the number of rows"));
  } else if (key == "ncolumns" || key == "datacolumns") {
    header->columns =
        static_cast<int>(cursor.Integer(value, "the number of columns"));
  }
}

Header ReadHeader(const std::string& path, TextCursor* cursor) {
  Header header;
  std::string_view line;
  bool is_first = true;
  while (cursor->NextLine(&line)) {
    line = Trimmed(line);
    if (LowerCase(line) == "endheader") return header;
    if (is_first) header.name = std::string(line);
    is_first = false;
    ReadHeaderLine(*cursor, line, &header);
  }
  throw InputError(
      path, "has no line \"endheader\"", "give an OpenSim .mot or .sto file");
}

std::vector<std::string> ReadLabels(const std::string& path,
                                    TextCursor* cursor) {
  Words words;
  if (!cursor->NextWords(&words) || LowerCase(words[0]) != kTime) {
    throw InputError(words.empty() ? path : cursor->Where(),
                     "the labels of the columns do not begin with \"time\"",
                     "export the table again");
  }
  return {words.begin() + 1, words.end()};
}

// Reads a number. What programs for Windows write in place of NaN, such as
// "-1.#IND", is NaN.
double ReadValue(const TextCursor& cursor,
                 std::string_view word,
                 const std::string& label) {
  double value = 0;
  if (word.find("#IND") != std::string_view::npos ||
      word.find("#QNAN") != std::string_view::npos) {
    return std::numeric_limits<double>::quiet_NaN();
  }
  const char* const end = word.data() + word.size();
  const auto result =
      std::from_chars(word.data() + (word[0] == '+'), end, value);
  if (result.ptr != end || result.ec != std::errc()) {
    throw InputError(cursor.Where(),
                     "column \"" + label + "\" has " + Quoted(word),
                     "every value must be a number");
  }
  return value;
}

void AddCountWarning(const std::string& path,
                     const std::string& what,
                     std::optional<int> promised,
                     int found,
                     std::vector<std::string>* warnings) {
  if (!promised || *promised == found) return;
  warnings->push_back(path + ": the header promises " +
                      std::to_string(*promised) + " " + what + ", " +
                      std::to_string(found) + " are there and used");
}

// Reads the rows and returns their number, with those that are left out.
int ReadRows(const std::string& path, TextCursor* cursor, StorageTable* table) {
  const size_t columns = table->labels.size() + 1;
  int count = 0;
  std::vector<double> values;
  std::vector<std::string> repeated;  // their lines
  Words words, before;
  for (; cursor->NextWords(&words); ++count, before = words) {
    if (words.size() != columns) {
      throw InputError(cursor->Where(),
                       "the row has " + std::to_string(words.size()) +
                           " values, but there are " + std::to_string(columns) +
                           " columns",
                       "complete the row or remove it");
    }
    if (words == before) {
      repeated.push_back(std::to_string(cursor->line()));
      continue;
    }
    const double time = ReadValue(*cursor, words[0], kTime);
    if (!std::isfinite(time) ||
        (!table->times.empty() && time <= table->times.back())) {
      throw InputError(cursor->Where(),
                       "time " + std::string(words[0]) +
                           " is not after that of the row before",
                       "sort the rows by time");
    }
    table->times.push_back(time);
    table->lines.push_back(static_cast<int>(cursor->line()));
    for (size_t i = 1; i < columns; ++i) {
      values.push_back(ReadValue(*cursor, words[i], table->labels[i - 1]));
    }
  }
  if (!repeated.empty()) {
    table->warnings.push_back(
        path + ": rows that repeat the one before are left out, in line " +
        ShortList(repeated));
  }
  using RowMajor =
      Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  table->values = Eigen::Map<const RowMajor>(
      values.data(), table->times.size(), table->labels.size());
  return count;
}

}  // namespace

StorageTable ReadStorageTable(const std::string& path) {
  const std::string text = ReadFile(path);
  TextCursor cursor(path, text);
  const Header header = ReadHeader(path, &cursor);
  StorageTable table;
  table.name = header.name;
  table.in_degrees =
      header.in_degrees ? header.in_degrees : header.degrees_in_remark;
  table.labels = ReadLabels(path, &cursor);
  const int rows = ReadRows(path, &cursor, &table);
  if (table.times.empty()) {
    throw InputError(path, "has no rows", "export the table again");
  }
  AddCountWarning(path, "rows", header.rows, rows, &table.warnings);
  AddCountWarning(path,
                  "columns",
                  header.columns,
                  static_cast<int>(table.labels.size()) + 1,
                  &table.warnings);
  return table;
}

std::string StorageText(const StorageTable& table) {
  CHECK_EQ(table.values.rows(), static_cast<int>(table.times.size()));
  CHECK_EQ(table.values.cols(), static_cast<int>(table.labels.size()));
  const bool in_degrees = table.in_degrees.value_or(false);
  std::string text =
      table.name + "\nversion=1\nnRows=" + std::to_string(table.times.size()) +
      "\nnColumns=" + std::to_string(table.labels.size() + 1) +
      "\ninDegrees=" + (in_degrees ? "yes" : "no") + "\nendheader\n" + kTime;
  std::set<std::string> seen;
  for (const std::string& label : table.labels) {
    CHECK(!label.empty());
    CHECK_EQ(label.find_first_of(" \t\r\n"), std::string::npos) << label;
    CHECK(seen.insert(label).second) << label;
    text += "\t" + label;
  }
  text += "\n";
  for (Eigen::Index row = 0; row < table.values.rows(); ++row) {
    AppendReal(table.times[row], &text);
    for (Eigen::Index i = 0; i < table.values.cols(); ++i) {
      text += "\t";
      AppendReal(table.values(row, i), &text);
    }
    text += "\n";
  }
  return text;
}

}  // namespace musclewarp
