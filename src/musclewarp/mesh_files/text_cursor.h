// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace musclewarp {

// The words of a line, views into the text.
using Words = std::vector<std::string_view>;

// Walks through the text of a mesh file by lines or by words, and knows the
// line for messages. Lines may end with LF, CR LF or CR. Numbers are read with
// a decimal point whatever the locale.
//
//   TextCursor cursor(path, bytes, '#');
//   Words words;
//   while (cursor.NextWords(&words)) {
//     const double x = cursor.Real(words[0], "a coordinate");
//     ...
//   }
class TextCursor {
 public:
  // `text` must outlive the cursor. `comment` is the character that starts a
  // comment, which ends with the line; 0 if the format has none.
  TextCursor(std::string path, std::string_view text, char comment = 0);

  // Sets `line` to the next line, without its end. Returns false at the end of
  // the text.
  bool NextLine(std::string_view* line);

  // Sets `words` to the words of the next line that has any outside of
  // comments. Returns false, and no words, at the end of the text.
  bool NextWords(Words* words);

  // Sets `word` to the next word on this line or a later one; comments are not
  // known here. Returns false at the end of the text.
  bool NextWord(std::string_view* word);

  // Returns the next `size` bytes, whatever they are: binary data within a
  // text. Precondition (CHECKed): size <= bytes_left().
  std::string_view TakeBytes(std::size_t size);

  std::size_t bytes_left() const { return text_.size() - position_; }

  // The number of the line that was returned last, or that has the word that
  // was returned last; the first line is 1.
  std::size_t line() const { return line_; }

  // Returns the place for messages: "muscle.obj: line 12", or behind binary
  // data, where lines cannot be counted, "muscle.vtk: byte 48120".
  std::string Where() const;

  // Returns the number that `word` spells, rounded to the nearest double. Words
  // such as "nan" and "inf" are numbers; one beyond the range of double is
  // infinite, or zero if it is tiny. Throws InputError, which says that `what`
  // was expected, if the word is not a number.
  double Real(std::string_view word, const char* what) const;

  // Returns the whole number that `word` spells. Throws InputError in the same
  // way, also if the number does not fit 64 bits.
  std::int64_t Integer(std::string_view word, const char* what) const;

 private:
  std::string path_;
  std::string_view text_;
  char comment_;
  std::size_t position_ = 0;
  std::size_t line_ = 0;
  bool line_is_over_ = true;  // what comes next starts a new line
  bool has_binary_ = false;   // lines cannot be counted any more
};

// Returns `text` in quotes for a message: cut off when it is long, and with
// bytes other than printable ASCII escaped as \x0a.
std::string Quoted(std::string_view text);

// Returns the text with the ASCII letters in lower case, whatever the locale.
std::string LowerCase(std::string_view text);

// Returns true if a text ends with another one.
bool EndsWith(std::string_view text, std::string_view end);

// Appends a number with 17 significant digits, from which the same double is
// read again, whatever the locale.
void AppendReal(double value, std::string* out);

}  // namespace musclewarp
