// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/mesh_files/text_cursor.h"

#include <glog/logging.h>

#include <charconv>
#include <cmath>
#include <limits>

#include "musclewarp/base/input_error.h"
#include "musclewarp/mesh_files/export_advice.h"

namespace musclewarp {
namespace {

bool IsBlank(char c) { return c == ' ' || c == '\t' || c == '\v' || c == '\f'; }

bool IsLineEnd(char c) { return c == '\n' || c == '\r'; }

// std::from_chars does not accept a leading plus.
std::string_view WithoutPlus(std::string_view word) {
  if (word.size() > 1 && word[0] == '+' && word[1] != '-') {
    word.remove_prefix(1);
  }
  return word;
}

// Returns the value of a number beyond the range of double: infinite, or zero
// if the number is tiny.
double BeyondRange(std::string_view word) {
  long double value = 0;
  const auto result =
      std::from_chars(word.data(), word.data() + word.size(), value);
  const bool tiny = result.ec == std::errc() && std::abs(value) < 1;
  return tiny ? 0.0 : std::numeric_limits<double>::infinity();
}

[[noreturn]] void ThrowNotANumber(const TextCursor& cursor,
                                  std::string_view word,
                                  const char* what,
                                  const char* kind) {
  throw InputError(cursor.Where(),
                   Quoted(word) + " stands where " + what +
                       " is expected, which must be " + kind,
                   kExportAgain);
}

}  // namespace

TextCursor::TextCursor(std::string path, std::string_view text, char comment)
    : path_(std::move(path)), text_(text), comment_(comment) {}

bool TextCursor::NextLine(std::string_view* line) {
  if (position_ == text_.size()) return false;
  if (line_is_over_) ++line_;
  line_is_over_ = true;
  const std::size_t begin = position_;
  const std::size_t end =
      std::min(text_.find_first_of("\r\n", begin), text_.size());
  *line = text_.substr(begin, end - begin);
  position_ = end;
  if (position_ < text_.size()) {
    const bool crlf = text_.substr(position_, 2) == "\r\n";
    position_ += crlf ? 2 : 1;
  }
  return true;
}

bool TextCursor::NextWords(Words* words) {
  words->clear();
  std::string_view line;
  while (words->empty() && NextLine(&line)) {
    if (comment_ != 0) line = line.substr(0, line.find(comment_));
    std::size_t i = 0;
    while (true) {
      while (i < line.size() && IsBlank(line[i])) ++i;
      if (i == line.size()) break;
      const std::size_t begin = i;
      while (i < line.size() && !IsBlank(line[i])) ++i;
      words->push_back(line.substr(begin, i - begin));
    }
  }
  return !words->empty();
}

bool TextCursor::NextWord(std::string_view* word) {
  while (position_ < text_.size()) {
    if (line_is_over_) ++line_;
    line_is_over_ = false;
    const char c = text_[position_];
    if (IsLineEnd(c)) {
      const bool crlf = text_.substr(position_, 2) == "\r\n";
      position_ += crlf ? 2 : 1;
      line_is_over_ = true;
    } else if (IsBlank(c)) {
      ++position_;
    } else {
      const std::size_t begin = position_;
      while (position_ < text_.size() && !IsBlank(text_[position_]) &&
             !IsLineEnd(text_[position_])) {
        ++position_;
      }
      *word = text_.substr(begin, position_ - begin);
      return true;
    }
  }
  return false;
}

std::string_view TextCursor::TakeBytes(std::size_t size) {
  CHECK_LE(size, bytes_left());
  const std::string_view bytes = text_.substr(position_, size);
  position_ += size;
  line_is_over_ = true;
  has_binary_ = true;
  return bytes;
}

std::string TextCursor::Where() const {
  return path_ + (has_binary_ ? ": byte " + std::to_string(position_)
                              : ": line " + std::to_string(line_));
}

double TextCursor::Real(std::string_view word, const char* what) const {
  word = WithoutPlus(word);
  double value = 0;
  const char* const end = word.data() + word.size();
  const auto result = std::from_chars(word.data(), end, value);
  if (result.ptr != end || result.ec == std::errc::invalid_argument) {
    ThrowNotANumber(*this, word, what, "a number");
  }
  return result.ec == std::errc() ? value : BeyondRange(word);
}

std::int64_t TextCursor::Integer(std::string_view word,
                                 const char* what) const {
  word = WithoutPlus(word);
  std::int64_t value = 0;
  const char* const end = word.data() + word.size();
  const auto result = std::from_chars(word.data(), end, value);
  if (result.ptr != end || result.ec != std::errc()) {
    ThrowNotANumber(*this, word, what, "a whole number");
  }
  return value;
}

std::string Quoted(std::string_view text) {
  constexpr std::size_t kLongest = 24;
  std::string quoted = "'";
  for (const char c : text.substr(0, kLongest)) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte >= 0x20 && byte < 0x7f) {
      quoted += c;
    } else {
      constexpr char kDigits[] = "0123456789abcdef";
      quoted += "\\x";
      quoted += kDigits[byte >> 4];
      quoted += kDigits[byte & 15];
    }
  }
  if (text.size() > kLongest) quoted += "...";
  return quoted + "'";
}

bool EndsWith(std::string_view text, std::string_view end) {
  return text.size() >= end.size() &&
         text.substr(text.size() - end.size()) == end;
}

std::string LowerCase(std::string_view text) {
  std::string lower(text);
  for (char& c : lower) {
    if (c >= 'A' && c <= 'Z') c += 'a' - 'A';
  }
  return lower;
}

void AppendReal(double value, std::string* out) {
  char buffer[32];
  const auto result = std::to_chars(
      buffer, buffer + sizeof(buffer), value, std::chars_format::general, 17);
  out->append(buffer, result.ptr - buffer);
}

}  // namespace musclewarp
