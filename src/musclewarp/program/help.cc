// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/program/help.h"

#include <glog/logging.h>

#include <algorithm>
#include <initializer_list>
#include <string>

#include "musclewarp/base/setting_names.h"

namespace musclewarp {
namespace {

// Returns true if one of the arguments before "--" is one of `flags`.
bool HasArgument(int argc,
                 char** argv,
                 std::initializer_list<const char*> flags) {
  for (int i = 1; i < argc && std::string(argv[i]) != "--"; ++i) {
    for (const char* flag : flags) {
      if (std::string(argv[i]) == flag) return true;
    }
  }
  return false;
}

// Returns "=PATH", or "=auto|never" for a flag with a known list of words, or
// "=ply|obj,..." if it takes several of them. Empty for a switch.
std::string ValueIn(const ProgramFlag& flag) {
  if (flag.value.empty()) return "";
  if (flag.choices.words.empty()) return "=" + flag.value;
  std::string words;
  for (const std::string& word : flag.choices.words) {
    words += (words.empty() ? "" : "|") + word;
  }
  return "=" + words + (flag.choices.takes_several ? ",..." : "");
}

void PrintFlag(const ProgramFlag& flag, std::ostream& out) {
  out << "  --" << flag.name << ValueIn(flag) << "\n      " << flag.help;
  if (!flag.default_value.empty()) out << " [" << flag.default_value << "]";
  out << "\n";
}

bool IsMain(const ProgramText& text, const ProgramFlag& flag) {
  return std::count(text.main_flags.begin(), text.main_flags.end(), flag.name) >
         0;
}

void PrintMainFlags(const ProgramText& text,
                    const std::vector<ProgramFlag>& flags,
                    std::ostream& out) {
  for (const std::string& name : text.main_flags) {
    const auto flag =
        std::find_if(flags.begin(), flags.end(), [&](const ProgramFlag& other) {
          return other.name == name;
        });
    CHECK(flag != flags.end()) << "no flag --" << name;
    PrintFlag(*flag, out);
  }
}

// Returns the headings of the flags that are not main flags, each once.
std::vector<std::string> HeadingsOf(const ProgramText& text,
                                    const std::vector<ProgramFlag>& flags) {
  std::vector<std::string> headings;
  for (const ProgramFlag& flag : flags) {
    const bool is_there =
        std::count(headings.begin(), headings.end(), flag.heading) > 0;
    if (!is_there && !IsMain(text, flag)) headings.push_back(flag.heading);
  }
  return headings;
}

void PrintUsage(const ProgramText& text, std::ostream& out) {
  out << "usage: " << text.usage << "\n\nExamples:\n";
  for (const CommandExample& example : text.examples) {
    out << "  " << example.command << "\n      " << example.what << "\n";
  }
}

}  // namespace

bool AsksForShortHelp(int argc, char** argv) {
  return HasArgument(argc, argv, {"-h", "-helpshort", "--helpshort"});
}

bool AsksForHelp(int argc, char** argv) {
  return HasArgument(argc, argv, {"-help", "--help"});
}

void PrintShortHelp(const ProgramText& text,
                    const std::vector<ProgramFlag>& flags,
                    std::ostream& out) {
  PrintUsage(text, out);
  out << "\nMost used flags (--help lists all " << flags.size() << "):\n";
  PrintMainFlags(text, flags, out);
}

void PrintHelp(const ProgramText& text,
               const std::vector<ProgramFlag>& flags,
               std::ostream& out) {
  PrintUsage(text, out);
  out << WithFlags("\nFlags ({flagfile}=F reads them from a file):\n")
      << "\nMost used:\n";
  PrintMainFlags(text, flags, out);
  for (const std::string& heading : HeadingsOf(text, flags)) {
    out << "\n" << heading << ":\n";
    for (const ProgramFlag& flag : flags) {
      if (flag.heading == heading && !IsMain(text, flag)) PrintFlag(flag, out);
    }
  }
}

}  // namespace musclewarp
