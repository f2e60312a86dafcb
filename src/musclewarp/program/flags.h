// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gflags/gflags.h>

#include <map>
#include <set>
#include <string>
#include <type_traits>
#include <vector>

#include "musclewarp/base/described.h"
#include "musclewarp/base/setting_names.h"
#include "musclewarp/base/text.h"
#include "musclewarp/settings/checked_settings.h"

namespace musclewarp {

// A flag of this program: a field of a described struct.
struct ProgramFlag {
  std::string name;
  std::string help;

  // The kind of its value: TEXT, PATH or NUMBER; empty for a switch.
  std::string value;
  std::string default_value;
  const char* allowed = "";  // the kind of its values, for messages
  bool is_path = false;
  Effect effect = Effect::kResults;
};

// Returns the flags of this program in the order of their registration.
std::vector<ProgramFlag>& ProgramFlags();

// Registers the fields of `settings`, except those in `without`, as flags of
// this program. A field is the storage of its flag, and its current value
// becomes the default. Has to be called before RunProgram(), which parses the
// flags. `settings` must outlive the program's use of flags. The fields may be
// of type bool, int, unsigned, double and std::string.
template <class Settings>
void RegisterFlags(Settings* settings,
                   const std::set<std::string>& without = {}) {
  VisitFields(*settings, [&](const auto& field, auto& value) {
    using Value = std::decay_t<decltype(value)>;
    if (without.count(field.key) > 0) return;
    // Never deleted, as gflags keeps pointers to all of these.
    auto* default_value = new Value(value);
    auto* help = new std::string(WithFlags(HelpOf(field)));
    gflags::FlagRegisterer(field.key, help->c_str(), "", &value, default_value);
    ProgramFlag flag;
    flag.name = field.key;
    flag.help = *help;
    flag.allowed = KindOfValue<Value>();
    flag.is_path = field.is_path;
    flag.effect = field.effect;
    if constexpr (std::is_same_v<Value, std::string>) {
      flag.value = field.is_path ? "PATH" : "TEXT";
      flag.default_value = value;
    } else if constexpr (std::is_same_v<Value, bool>) {
      flag.default_value = value ? "true" : "false";
    } else {
      flag.value = "NUMBER";
      flag.default_value = NumberText(value);
    }
    ProgramFlags().push_back(flag);
  });
}

// Throws InputError for an argument "--flag=value" whose value is of another
// type than the flag. gflags refuses it, too, but does not say what is allowed.
void CheckTypesOfFlags(int argc, char** argv);

// Returns true if this program has a flag and it was given.
bool IsGiven(const std::string& flag);

// Returns the names of the flags that were given.
std::set<std::string> GivenFlags();

// Returns the name of the program with the given flags, except those in
// `without`: "musclewarp-deform --gap=0.2". Its paths do not depend on the
// working folder, so that a report can make them relative to its own folder
// (run/paths_in_json.h).
std::string CommandLine(const std::set<std::string>& without);

// Returns the given flags that change the results or the files of a run, in the
// same form. Two runs of equal input with equal texts have equal files.
std::string ResultFlagsText();

// Returns the values of all flags by name, as reports have them.
std::map<std::string, std::string> AllFlagValues();

// Returns the given flags of a struct, except those in `without`, one per line,
// for --flagfile. Their paths do not depend on the working folder.
template <class Settings>
std::string FlagFileOf(const Settings& settings,
                       const std::set<std::string>& without) {
  std::string lines;
  VisitFields(settings, [&](const auto& field, const auto& /*value*/) {
    if (without.count(field.key) > 0 || !IsGiven(field.key)) return;
    lines += "--" + std::string(field.key) + "=" +
             AllFlagValues().at(field.key) + "\n";
  });
  return lines;
}

}  // namespace musclewarp
