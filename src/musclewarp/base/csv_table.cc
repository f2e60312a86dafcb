// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/base/csv_table.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <set>

#include "musclewarp/base/input_error.h"
#include "musclewarp/base/input_file.h"

namespace musclewarp {
namespace {

constexpr char kSave[] = "save the table as comma-separated values (UTF-8)";

// Reads the records of a text one by one.
class CsvReader {
 public:
  CsvReader(const std::string& path, std::string text)
      : path_(path), text_(std::move(text)) {
    constexpr char kByteOrderMark[] = "\xEF\xBB\xBF";
    if (text_.compare(0, 3, kByteOrderMark) == 0) at_ = 3;
  }

  // Returns false at the end of the text. Empty lines are passed over.
  bool Next(std::vector<std::string>* fields) {
    while (at_ < text_.size()) {
      first_line_ = line_;
      fields->assign(1, "");
      ReadRecord(fields);
      if (fields->size() > 1 || !fields->front().empty()) return true;
    }
    return false;
  }

  // Of the record that was read last.
  int first_line() const { return first_line_; }

 private:
  void ReadRecord(std::vector<std::string>* fields) {
    while (at_ < text_.size()) {
      const char c = text_[at_++];
      if (c == '"' && fields->back().empty()) {
        ReadQuoted(&fields->back());
      } else if (c == ',') {
        fields->emplace_back();
      } else if (c == '\n') {
        ++line_;
        return;
      } else if (c != '\r') {
        fields->back() += c;
      }
    }
  }

  void ReadQuoted(std::string* field) {
    while (at_ < text_.size()) {
      const char c = text_[at_++];
      if (c == '\n') ++line_;
      if (c == '"') {
        if (at_ == text_.size() || text_[at_] != '"') return;
        ++at_;
      }
      *field += c;
    }
    throw InputError(path_ + ": line " + std::to_string(first_line_),
                     "has a quote that does not end",
                     kSave);
  }

  const std::string& path_;
  std::string text_;
  std::size_t at_ = 0;
  int line_ = 1;
  int first_line_ = 1;
};

}  // namespace

CsvTable::CsvTable(const std::string& path) : path_(path) {
  CsvReader reader(path_, ReadFile(path));
  if (!reader.Next(&columns_)) throw InputError(path, "is empty", kSave);
  std::set<std::string> known;
  for (const std::string& column : columns_) {
    if (!known.insert(column).second) {
      throw InputError(path, "has two columns '" + column + "'", kSave);
    }
  }
  std::vector<std::string> fields;
  while (reader.Next(&fields)) {
    if (fields.size() != columns_.size()) {
      throw InputError(path + ": line " + std::to_string(reader.first_line()),
                       "has " + std::to_string(fields.size()) +
                           " fields, the header has " +
                           std::to_string(columns_.size()),
                       kSave);
    }
    rows_.push_back({reader.first_line(), fields});
  }
}

void CsvTable::Require(const std::vector<std::string>& columns) const {
  std::string missing, known;
  for (const std::string& column : columns) {
    const auto found = std::find(columns_.begin(), columns_.end(), column);
    if (found == columns_.end()) {
      missing += (missing.empty() ? "" : ", ") + column;
    }
  }
  if (missing.empty()) return;
  for (const std::string& column : columns_) {
    known += (known.empty() ? "" : ", ") + column;
  }
  throw InputError(path_,
                   "has no column " + missing + "; it has " + known,
                   "name the columns in the first line");
}

std::string CsvTable::Text(std::size_t row, const std::string& column) const {
  const auto found = std::find(columns_.begin(), columns_.end(), column);
  if (found == columns_.end()) return "";
  return rows_.at(row).fields[found - columns_.begin()];
}

std::optional<double> CsvTable::Number(std::size_t row,
                                       const std::string& column) const {
  const std::string text = Text(row, column);
  if (text.empty()) return std::nullopt;
  double value = 0;
  const char* end = text.data() + text.size();
  const auto result = std::from_chars(text.data(), end, value);
  if (result.ec != std::errc() || result.ptr != end || !std::isfinite(value)) {
    throw InputError(path_ + ": line " + std::to_string(rows_.at(row).line),
                     column + " '" + text + "' is no number",
                     "use digits with a point, or leave the field empty");
  }
  return value;
}

}  // namespace musclewarp
