// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace musclewarp {

// Walks through the text of a mesh file by lines or by words and knows the line
// number for messages. Lines end with LF, CR LF or CR; numbers are read with
// the decimal point whatever the locale.
class TextCursor {
 public:
  // `text` must outlive the cursor. `comment`: a character that starts a
  // comment up to the end of the line, 0 for none.
  TextCursor(std::string path, std::string_view text, char comment = 0);

  // The next line as it stands. False at the end of the text.
  bool NextLine(std::string_view* line);

  // The words of the next line that has any; comments are left out.
  bool NextWords(std::vector<std::string_view>* words);

  // The next word, on this line or a later one.
  bool NextWord(std::string_view* word);

  // The next `size` bytes, which may be anything. Precondition (CHECKed): they
  // are there.
  std::string_view TakeBytes(std::size_t size);

  std::size_t bytes_left() const { return text_.size() - position_; }

  // Line of what was returned last, from 1.
  std::size_t line() const { return line_; }

  // "muscle.obj: line 12"; behind binary data "muscle.vtk: byte 48120".
  std::string Where() const;

  // The number `word` spells, rounded to the nearest double; "nan" and "inf"
  // are numbers here. Throws InputError, naming `what`, if it is none.
  double Real(std::string_view word, const char* what) const;
  std::int64_t Integer(std::string_view word, const char* what) const;

 private:
  std::string path_;
  std::string_view text_;
  char comment_;
  std::size_t position_ = 0;
  std::size_t line_ = 0;
  bool line_is_over_ = true;  // What comes next starts a new line.
  bool has_binary_ = false;   // Lines cannot be counted any more.
};

// `text` between quotes for a message: cut when long, control bytes escaped.
std::string Quoted(std::string_view text);

// Lower case of ASCII letters.
std::string LowerCase(std::string_view text);

// Appends the 17 digits that give the same double again.
void AppendReal(double value, std::string* out);

}  // namespace musclewarp
