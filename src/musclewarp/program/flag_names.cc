// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/program/flag_names.h"

#include <gflags/gflags.h>

#include <algorithm>
#include <fstream>
#include <optional>

#include "musclewarp/base/input_error.h"
#include "musclewarp/base/near_name.h"
#include "musclewarp/base/text.h"
#include "musclewarp/program/flags.h"

namespace musclewarp {
namespace {

// A flag as it was written: "--name=value" or "-name".
struct WrittenFlag {
  std::string name;  // with "_" for "-", as gflags reads it
  std::optional<std::string> value;
};

std::optional<WrittenFlag> ParseFlag(const std::string& text) {
  const size_t begin = text.compare(0, 2, "--") == 0 ? 2 : 1;
  if (text.size() <= begin || text[0] != '-') return std::nullopt;
  const size_t equals = text.find('=');
  WrittenFlag flag;
  flag.name = text.substr(begin, equals - begin);
  std::replace(flag.name.begin(), flag.name.end(), '-', '_');
  if (equals != std::string::npos) flag.value = text.substr(equals + 1);
  return flag;
}

// Returns what gflags knows of a flag, also of one that is turned off.
std::optional<gflags::CommandLineFlagInfo> InfoOf(const std::string& name) {
  gflags::CommandLineFlagInfo info;
  if (gflags::GetCommandLineFlagInfo(name.c_str(), &info)) return info;
  if (name.compare(0, 2, "no") == 0 &&
      gflags::GetCommandLineFlagInfo(name.c_str() + 2, &info) &&
      info.type == "bool") {
    return info;
  }
  return std::nullopt;
}

// Returns all names under which flags of the program can be given.
std::vector<std::string> KnownFlags() {
  std::vector<std::string> known;
  for (const ProgramFlag& flag : ProgramFlags()) {
    known.push_back(flag.name);
    if (flag.value.empty()) known.push_back("no" + flag.name);
  }
  known.insert(known.end(), {"flagfile", "help", "version"});
  return known;
}

[[noreturn]] void Refuse(const std::string& where, const std::string& name) {
  throw InputError(
      where,
      "is not a flag of this program",
      DidYouMean(name, KnownFlags(), "--") + "{help} lists all flags");
}

}  // namespace

void CheckNamesOfFlags(const std::vector<std::string>& arguments) {
  for (size_t i = 0; i < arguments.size() && arguments[i] != "--"; ++i) {
    const std::optional<WrittenFlag> flag = ParseFlag(arguments[i]);
    if (!flag) continue;
    if (flag->name == "undefok") return;  // names flags that may be unknown
    const auto info = InfoOf(flag->name);
    if (!info) {
      Refuse(arguments[i].substr(0, arguments[i].find('=')), flag->name);
    }
    // The value of a flag that is no switch may be the next argument.
    const bool has_next = !flag->value && info->type != "bool";
    if (has_next) ++i;
    if (flag->name != "flagfile") continue;
    if (flag->value) {
      CheckFlagsInFiles(*flag->value);
    } else if (i < arguments.size()) {
      CheckFlagsInFiles(arguments[i]);
    }
  }
}

void CheckFlagsInFiles(const std::string& path) {
  for (const std::string& name : Split(path, ',')) {
    std::ifstream file(name);
    std::string line;
    for (int number = 1; std::getline(file, line); ++number) {
      const size_t begin = line.find_first_not_of(" \t\r");
      if (begin == std::string::npos || line[begin] == '#') continue;
      line = line.substr(begin);
      // Names of programs, for which alone the lines below are.
      if (line[0] != '-') break;
      const std::optional<WrittenFlag> flag = ParseFlag(line);
      if (!flag || InfoOf(flag->name)) continue;
      Refuse(name + ", line " + std::to_string(number) + ": " +
                 line.substr(0, line.find('=')),
             flag->name);
    }
  }
}

}  // namespace musclewarp
