// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/scene/scene_names.h"

#include <cstdio>
#include <optional>
#include <utility>

#include "musclewarp/base/input_error.h"
#include "musclewarp/scene/json_fields.h"

namespace musclewarp {
namespace {

struct CharacterRange {
  char32_t first, last;
  const char* what;
};
constexpr CharacterRange kRefused[] = {
    {0x0000, 0x001f, "control character"},
    {0x007f, 0x009f, "control character"},
    {0x061c, 0x061c, "mark of direction"},
    {0x200b, 0x200b, "character without width"},
    {0x200e, 0x200f, "mark of direction"},
    {0x2028, 0x2029, "separator of lines"},
    {0x202a, 0x202e, "mark of direction"},
    {0x2060, 0x2064, "character without width"},
    {0x2066, 0x2069, "mark of direction"},
    {0xfeff, 0xfeff, "character without width"}};

// Returns the character of a text in UTF-8 that begins at `*at`, and moves on
// to the next one. Bytes that begin none stand for themselves.
char32_t NextCharacter(const std::string& text, size_t* at) {
  const auto byte = [&](size_t i) -> unsigned char {
    return i < text.size() ? static_cast<unsigned char>(text[i]) : 0;
  };
  const unsigned char first = byte((*at)++);
  const int more = first >= 0xf0   ? 3
                   : first >= 0xe0 ? 2
                   : first >= 0xc0 ? 1
                                   : 0;
  char32_t character = more == 0 ? first : first & (0x3f >> more);
  for (int k = 0; k < more && (byte(*at) & 0xc0) == 0x80; ++k) {
    character = character << 6 | (byte((*at)++) & 0x3f);
  }
  return character;
}

// Returns the first character of a name that is refused, and what it is.
std::optional<std::pair<char32_t, const char*>> RefusedCharacter(
    const std::string& name) {
  for (size_t at = 0; at < name.size();) {
    const char32_t character = NextCharacter(name, &at);
    for (const CharacterRange& range : kRefused) {
      if (character < range.first || character > range.last) continue;
      return std::make_pair(character, range.what);
    }
  }
  return std::nullopt;
}

// Returns why a name cannot be a file name, or an empty text if it can.
std::string FileNameProblem(const std::string& name) {
  if (name.find('/') != std::string::npos) return "has a \"/\"";
  if (name[0] == '.') return "begins with a dot";
  if (name.front() == ' ') return "begins with a blank";
  if (name.back() == ' ') return "ends with a blank";
  return "";
}

}  // namespace

std::string QuotedName(const std::string& name) { return ShortenedText(name); }

std::string ColumnName(std::string name) {
  for (char& c : name) {
    if (c == ' ' || c == '\t' || c == '\n' || c == '\r') c = '_';
  }
  return name;
}

void CheckPrintable(const std::string& where,
                    const std::string& what,
                    const std::string& name) {
  const auto refused = RefusedCharacter(name);
  if (!refused) return;
  char code[16];
  std::snprintf(
      code, sizeof(code), "U+%04X", static_cast<unsigned>(refused->first));
  throw InputError(where,
                   "the name " + QuotedName(name) + " of a " + what +
                       " has a " + refused->second + " (" + code + ")",
                   "allowed: names without line breaks, tabs and characters "
                   "that nobody sees");
}

void CheckColumnName(const std::string& where,
                     const std::string& what,
                     const std::string& name) {
  CheckPrintable(where, what, name);
  if (name.size() <= kLongestName) return;
  throw InputError(where,
                   "the name " + QuotedName(name) + " of a " + what + " has " +
                       std::to_string(name.size()) + " bytes",
                   "allowed: at most " + std::to_string(kLongestName));
}

void CheckFileName(const std::string& where,
                   const std::string& what,
                   const std::string& name) {
  CheckColumnName(where, what, name);
  if (name.empty()) {
    throw InputError(where, "a " + what + " has no name", "give it one");
  }
  const std::string problem = FileNameProblem(name);
  if (problem.empty()) return;
  throw InputError(where,
                   "the name " + QuotedName(name) + " of a " + what +
                       " cannot be a file name: it " + problem,
                   "choose a name without \"/\", without a dot in front and "
                   "without blanks at its ends");
}

}  // namespace musclewarp
