// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>

namespace musclewarp {

// More elements than any mesher makes in the memory there is.
constexpr std::int64_t kMostElements = 500000000;

// Reads the numbers of a text file in turn, as other programs write their
// meshes: separated by blanks, with comments from '#' to the end of a line.
// What is not as asked for throws InputError that names the file.
class NumberReader {
 public:
  // `path` is used in messages only; `text` is the whole file.
  NumberReader(std::string path, std::string text);

  // Goes on behind the next place where `word` stands.
  void Find(const std::string& word);

  double Real();

  // Reads an integer from `least` to `most`.
  int Count(std::int64_t least, std::int64_t most);

  // Reads an integer that has to be this one.
  void Expect(int value);

  // Passes over numbers.
  void Skip(int numbers);

 private:
  [[noreturn]] void Fail(const std::string& problem) const;
  void SkipBlanks();

  std::string path_;
  std::string text_;
  std::size_t at_ = 0;
};

}  // namespace musclewarp
