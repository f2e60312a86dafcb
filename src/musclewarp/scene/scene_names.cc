// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/scene/scene_names.h"

#include <algorithm>

#include "musclewarp/base/input_error.h"
#include "musclewarp/scene/json_fields.h"

namespace musclewarp {
namespace {

constexpr char kDelete = 0x7f;

bool IsControl(char c) {
  return static_cast<unsigned char>(c) < ' ' || c == kDelete;
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

void CheckPrintable(const std::string& where,
                    const std::string& what,
                    const std::string& name) {
  if (std::none_of(name.begin(), name.end(), IsControl)) return;
  throw InputError(where,
                   "the name " + QuotedName(name) + " of a " + what +
                       " has a control character",
                   "allowed: names without line breaks, tabs and the like");
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
