// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/program/flags.h"

#include <algorithm>
#include <cctype>
#include <cstring>
#include <filesystem>
#include <functional>

#include "musclewarp/base/portable_path.h"

namespace musclewarp {
namespace {

// Returns a text quoted as one word of a shell, if necessary.
std::string ShellQuoted(const std::string& text) {
  const auto is_plain = [](unsigned char c) {
    return std::isalnum(c) || std::strchr("_-+=./:,@%", c) != nullptr;
  };
  if (!text.empty() && std::all_of(text.begin(), text.end(), is_plain)) {
    return text;
  }
  std::string quoted = "'";
  for (const char c : text)
    quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return quoted + "'";
}

std::string ValueOf(const std::string& flag) {
  return gflags::GetCommandLineFlagInfoOrDie(flag.c_str()).current_value;
}

std::string AbsolutePath(const std::string& path) {
  auto absolute = std::filesystem::absolute(path).lexically_normal();
  if (!absolute.has_filename()) absolute = absolute.parent_path();
  return absolute.string();
}

// Returns the path of a motion relative to the folder of the data.
std::string MotionPath(const std::string& motion) {
  if (std::filesystem::path(motion).is_relative()) return motion;
  const std::string root = ValueOf("data_root");
  return PathFrom(
      root.empty()
          ? std::filesystem::absolute(ValueOf("scene")).parent_path().string()
          : root,
      motion);
}

// Returns the value of a flag as reports have it.
std::string RecordedValue(const ProgramFlag& flag) {
  const std::string value = ValueOf(flag.name);
  if (!flag.is_path || value.empty() || value == flag.default_value) {
    return value;
  }
  if (flag.name == "motion") return MotionPath(value);
  if (flag.name != "geometry") return AbsolutePath(value);
  std::string paths;
  for (const std::string& path : Split(value, ',')) {
    paths += (paths.empty() ? "" : ",") + AbsolutePath(path);
  }
  return paths;
}

// Returns the given flags that `includes` chooses, with their values.
std::string FlagsText(
    const std::function<bool(const ProgramFlag&)>& includes,
    const std::function<std::string(const ProgramFlag&)>& value_of) {
  std::string text;
  for (const ProgramFlag& flag : ProgramFlags()) {
    if (!IsGiven(flag.name) || !includes(flag)) continue;
    text += " --" + flag.name + "=" + ShellQuoted(value_of(flag));
  }
  return text;
}

}  // namespace

std::vector<ProgramFlag>& ProgramFlags() {
  static std::vector<ProgramFlag>& flags = *new std::vector<ProgramFlag>;
  return flags;
}

void CheckTypesOfFlags(int argc, char** argv) {
  for (int i = 1; i < argc && std::string(argv[i]) != "--"; ++i) {
    const std::string argument = argv[i];
    const size_t name = argument.find_first_not_of('-');
    const size_t equals = argument.find('=');
    if (name == 0 || name == std::string::npos || equals == std::string::npos) {
      continue;
    }
    const std::string value = argument.substr(equals + 1);
    for (const ProgramFlag& flag : ProgramFlags()) {
      if (argument.compare(name, equals - name, flag.name) != 0) continue;
      if (!gflags::SetCommandLineOption(flag.name.c_str(), value.c_str())
               .empty()) {
        continue;
      }
      throw InputError("{" + flag.name + "}",
                       "is " + value,
                       std::string("allowed: ") + flag.allowed);
    }
  }
}

bool IsGiven(const std::string& flag) {
  gflags::CommandLineFlagInfo info;
  return gflags::GetCommandLineFlagInfo(flag.c_str(), &info) &&
         !info.is_default;
}

std::set<std::string> GivenFlags() {
  std::set<std::string> given;
  for (const ProgramFlag& flag : ProgramFlags()) {
    if (IsGiven(flag.name)) given.insert(flag.name);
  }
  return given;
}

std::string CommandLine(const std::set<std::string>& without) {
  return std::string(gflags::ProgramInvocationShortName()) +
         FlagsText(
             [&](const ProgramFlag& flag) {
               return without.count(flag.name) == 0;
             },
             RecordedValue);
}

std::string ResultFlagsText() {
  return FlagsText(
      [](const ProgramFlag& flag) { return flag.effect != Effect::kNothing; },
      [](const ProgramFlag& flag) { return ValueOf(flag.name); });
}

std::map<std::string, std::string> AllFlagValues() {
  std::map<std::string, std::string> values;
  for (const ProgramFlag& flag : ProgramFlags()) {
    values[flag.name] = RecordedValue(flag);
  }
  return values;
}

}  // namespace musclewarp
