// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/base/portable_path.h"

#include <cstddef>
#include <cstring>
#include <filesystem>
#include <system_error>

namespace musclewarp {
namespace {

namespace fs = std::filesystem;

bool IsIn(char c, const char* set) { return std::strchr(set, c) != nullptr; }

// Whether a path may begin or end beside a character of a text.
bool IsBefore(char c) { return IsIn(c, " \t\n'\"=(,;:[{"); }
bool IsAfter(char c) { return IsIn(c, " \t\n'\"(),;:[]{}<>"); }

bool BeginsWith(const std::string& text, size_t at, const char* word) {
  return text.compare(at, std::strlen(word), word) == 0;
}

// Whether an absolute path, and no slash between words, begins at a place of a
// text.
bool BeginsAbsolutePath(const std::string& text, size_t at) {
  return text[at] == '/' && (at == 0 || IsBefore(text[at - 1])) &&
         at + 1 < text.size() && !IsAfter(text[at + 1]) && text[at + 1] != '/';
}

// Returns the end of the longest path from `begin` on at which something is, or
// `begin`. Names may have blanks. A single word is no path.
size_t EndOfExistingPath(const std::string& text, size_t begin) {
  const auto exists = [&](size_t end) {
    std::error_code error;
    const std::string path = text.substr(begin, end - begin);
    return path.find('/') != std::string::npos && fs::exists(path, error);
  };
  for (size_t end = text.size(); end > begin + 1; --end) {
    // The path of a part of a file goes on with "#" and its name.
    if (end < text.size() && !IsAfter(text[end]) && text[end] != '#') continue;
    if (exists(end)) return end;
    if (text[end - 1] == '.' && exists(end - 1)) return end - 1;
  }
  return begin;
}

// Returns the end of the word that begins there; in quotation marks it may have
// blanks.
size_t EndOfWord(const std::string& text, size_t begin) {
  const char before = begin > 0 ? text[begin - 1] : ' ';
  if (before == '\'' || before == '"') {
    const size_t end = text.find(before, begin);
    if (end != std::string::npos) return end;
  }
  size_t end = begin;
  while (end < text.size() && !IsAfter(text[end])) ++end;
  return end;
}

// Whether an absolute path or one from the working folder on may begin there.
bool MayBeginPath(const std::string& text, size_t at) {
  if (BeginsAbsolutePath(text, at)) return true;
  if (IsAfter(text[at]) || text[at] == '/') return false;
  if (at > 0 && !IsBefore(text[at - 1])) return false;
  return text.substr(at, EndOfWord(text, at) - at).find('/') !=
         std::string::npos;
}

std::string LastPart(const std::string& path) {
  const size_t last = path.find_last_not_of('/');
  const size_t slash = path.rfind('/', last);
  return path.substr(slash + 1, last - slash);
}

}  // namespace

std::string PathFrom(const std::string& folder, const std::string& path) {
  std::error_code error;
  if (path.empty() || !fs::exists(path, error)) return path;
  const fs::path plain =
      fs::absolute(path, error)
          .lexically_normal()
          .lexically_relative(fs::absolute(folder, error).lexically_normal());
  // With symbolic links on the way, ".." may lead elsewhere.
  if (fs::equivalent(fs::path(folder) / plain, path, error) && !error) {
    return plain.generic_string();
  }
  const fs::path relative = fs::relative(path, folder, error);
  return error || relative.empty() ? path : relative.generic_string();
}

std::string WithPathsFrom(const std::string& folder, const std::string& text) {
  std::string result;
  for (size_t at = 0; at < text.size();) {
    const size_t end =
        MayBeginPath(text, at) ? EndOfExistingPath(text, at) : at;
    if (end == at) {
      result += text[at++];
      continue;
    }
    result += PathFrom(folder, text.substr(at, end - at));
    at = end;
  }
  return result;
}

std::string WithoutFolders(const std::string& text) {
  std::string result;
  for (size_t at = 0; at < text.size();) {
    const bool leaves =
        BeginsWith(text, at, "../") && (at == 0 || IsBefore(text[at - 1]));
    if (!leaves && !BeginsAbsolutePath(text, at)) {
      result += text[at++];
      continue;
    }
    const size_t end = EndOfWord(text, at);
    result += LastPart(text.substr(at, end - at));
    at = end;
  }
  return result;
}

}  // namespace musclewarp
