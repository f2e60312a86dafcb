// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/exchange/number_reader.h"

#include <algorithm>
#include <cctype>
#include <charconv>

#include "musclewarp/base/input_error.h"

namespace musclewarp {

NumberReader::NumberReader(std::string path, std::string text)
    : path_(std::move(path)), text_(std::move(text)) {}

void NumberReader::Find(const std::string& word) {
  const std::size_t found = text_.find(word, at_);
  if (found == std::string::npos) Fail("has no " + word);
  at_ = found + word.size();
}

void NumberReader::SkipBlanks() {
  while (at_ < text_.size()) {
    if (text_[at_] == '#') {
      at_ = std::min(text_.find('\n', at_), text_.size());
    } else if (std::isspace(static_cast<unsigned char>(text_[at_]))) {
      ++at_;
    } else {
      return;
    }
  }
}

double NumberReader::Real() {
  SkipBlanks();
  double value = 0;
  const char* const begin = text_.data() + at_;
  const auto result =
      std::from_chars(begin, text_.data() + text_.size(), value);
  if (result.ec != std::errc()) Fail("ends early or holds no number");
  at_ += result.ptr - begin;
  return value;
}

int NumberReader::Count(std::int64_t least, std::int64_t most) {
  const double value = Real();
  if (!(value >= static_cast<double>(least) &&
        value <= static_cast<double>(most)) ||
      value != static_cast<int>(value)) {
    Fail("holds a number that is out of range");
  }
  return static_cast<int>(value);
}

void NumberReader::Expect(int value) {
  if (Count(value, value) != value) Fail("is out of order");
}

void NumberReader::Skip(int numbers) {
  for (int i = 0; i < numbers; ++i) Real();
}

void NumberReader::Fail(const std::string& problem) const {
  throw InputError(path_, problem, "try another version of the mesher");
}

}  // namespace musclewarp
