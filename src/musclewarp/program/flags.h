// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gflags/gflags.h>

#include <map>
#include <set>
#include <string>
#include <tuple>
#include <type_traits>
#include <vector>

#include "musclewarp/base/described.h"
#include "musclewarp/base/setting_names.h"
#include "musclewarp/base/text.h"
#include "musclewarp/settings/checked_settings.h"
#include "musclewarp/settings/setting_headings.h"

namespace musclewarp {

// A flag of this program: a field of a described struct.
struct ProgramFlag {
  std::string name;
  std::string help;
  std::string heading;  // that of the struct, for the list of all flags

  // The kind of its value: TEXT, PATH or NUMBER; empty for a switch.
  std::string value;
  std::string default_value;
  Choices choices;  // the allowed words of a text, if it has a list of them
  const char* allowed = "";  // the kind of its values, for messages
  bool is_path = false;
  Effect effect = Effect::kResults;
};

// Returns the flags of this program in the order of their registration.
std::vector<ProgramFlag>& ProgramFlags();

namespace flags_internal {

template <class Struct, class = void>
struct HasHeading : std::false_type {};
template <class Struct>
struct HasHeading<Struct, std::void_t<decltype(HeadingOf(Described<Struct>()))>>
    : std::true_type {};

// Returns the heading of a struct, or of the one that adds to it, `outer`.
template <class Struct>
std::string HeadingIn(const std::string& outer) {
  if constexpr (HasHeading<Struct>::value) {
    return HeadingOf(Described<Struct>());
  } else {
    return outer;
  }
}

template <class Struct>
void AddHeadings(const std::string& heading,
                 std::map<std::string, std::string>* headings);

template <class Access>
void AddHeading(const Field<Access>& field,
                const std::string& heading,
                std::map<std::string, std::string>* headings) {
  (*headings)[field.key] = heading;
}
template <class Access>
void AddHeading(const NotWritten<Access>& /*field*/,
                const std::string& /*heading*/,
                std::map<std::string, std::string>* /*headings*/) {}
template <class Base>
void AddHeading(const Inherited<Base>& /*entry*/,
                const std::string& heading,
                std::map<std::string, std::string>* headings) {
  AddHeadings<Base>(HeadingIn<Base>(heading), headings);
}

template <class Struct>
void AddHeadings(const std::string& heading,
                 std::map<std::string, std::string>* headings) {
  std::apply(
      [&](const auto&... entry) {
        (AddHeading(entry, heading, headings), ...);
      },
      FieldsOf(Described<Struct>()));
}

// Returns the headings of the fields of a struct by their keys: of each field
// that of the struct in whose list it is, which may be a base.
template <class Struct>
std::map<std::string, std::string> HeadingsOfFields() {
  std::map<std::string, std::string> headings;
  AddHeadings<Struct>(HeadingIn<Struct>("Other flags"), &headings);
  return headings;
}

}  // namespace flags_internal

// Registers the fields of `settings`, except those in `without`, as flags of
// this program. A field is the storage of its flag, and its current value
// becomes the default. Has to be called before RunProgram(), which parses the
// flags. `settings` must outlive the program's use of flags. The fields may be
// of type bool, int, unsigned, double and std::string.
template <class Settings>
void RegisterFlags(Settings* settings,
                   const std::set<std::string>& without = {}) {
  const auto headings = flags_internal::HeadingsOfFields<Settings>();
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
    flag.heading = headings.at(field.key);
    flag.choices = ChoicesOf(field.choices);
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
