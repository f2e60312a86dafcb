// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Settings are what users choose: described structs (base/described.h) whose
// fields are flags of the programs and keywords of Python with the same names.
// Their texts, units and ranges come from one list, and OptionsOf() of each
// struct returns the options of the library that its values mean.

#include <glog/logging.h>

#include <cmath>
#include <functional>
#include <initializer_list>
#include <limits>
#include <set>
#include <sstream>
#include <string>
#include <type_traits>
#include <vector>

#include "musclewarp/base/described.h"
#include "musclewarp/base/input_error.h"

namespace musclewarp {

// The words that a text may be.
struct Choices {
  std::vector<std::string> words;

  // True if the text may also be several of them, with commas between them.
  bool takes_several = false;
};

// Reads choices as fields list them: "auto, never", or "ply, obj; commas" if
// several may be given.
Choices ChoicesOf(const std::string& listed);

// Throws InputError, naming the setting, unless `value` is among `choices`, as
// fields list them. Without choices every value is allowed.
void CheckChoice(const char* name,
                 const std::string& value,
                 const std::string& choices);

// Throws InputError, naming the setting, unless `value` is finite and in its
// range. `unit` may be empty.
void CheckNumber(const char* name,
                 double value,
                 const ValueRange& range,
                 const std::string& unit = "");

// Throws InputError for the first setting whose value is not in the range or
// among the choices of its field.
template <class Settings>
void CheckSettings(const Settings& settings) {
  VisitFields(settings, [](const auto& field, const auto& value) {
    using Value = std::decay_t<decltype(value)>;
    if constexpr (std::is_same_v<Value, std::string>) {
      CheckChoice(field.key, value, field.choices);
    } else if constexpr (!std::is_same_v<Value, bool>) {
      CheckNumber(field.key, value, field.range, field.unit);
    }
  });
}

// Returns the values that a type of setting has, for messages.
template <class Value>
constexpr const char* KindOfValue() {
  if constexpr (std::is_same_v<Value, bool>) {
    return "true or false";
  } else if constexpr (std::is_same_v<Value, unsigned>) {
    return "a whole number that is not negative";
  } else if constexpr (std::is_integral_v<Value>) {
    return "a whole number";
  } else if constexpr (std::is_floating_point_v<Value>) {
    return "a number";
  } else {
    return "a text";
  }
}

// Returns the help on a setting: its text, unit and range.
template <class Access>
std::string HelpOf(const Field<Access>& field) {
  const bool has_range =
      std::isfinite(field.range.lowest) || std::isfinite(field.range.highest);
  const std::string unit = field.unit;
  const std::string range = has_range ? field.range.Text() : "";
  const std::string limits =
      unit + (unit.empty() || range.empty() ? "" : "; ") + range;
  return field.text + (limits.empty() ? "" : " (" + limits + ")");
}

// Returns the names of lengths and areas that are in mm of the scene rather
// than in units of the size of the body: those in `given`, which the user set,
// and those that differ from their default.
template <class Settings>
std::set<std::string> LengthsInMillimetres(const Settings& settings) {
  const Settings defaults;
  std::set<std::string> names;
  VisitFields(settings, [&](const auto& field, const auto& value) {
    const std::string unit = field.unit;
    const bool is_length = unit == "mm" || unit == "mm2";
    if (is_length && (settings.given.count(field.key) > 0 ||
                      value != std::invoke(field.access, defaults))) {
      names.insert(field.key);
    }
  });
  return names;
}

// Returns a text that is equal for two structs of settings only if they lead to
// equal results.
template <class Settings>
std::string KeyOf(const Settings& settings) {
  std::ostringstream key;
  key.precision(std::numeric_limits<double>::max_digits10);
  VisitFields(settings, [&](const auto& field, const auto& value) {
    if (field.effect != Effect::kResults) return;
    key << field.key << "=" << value << "\n";
  });
  for (const std::string& name : LengthsInMillimetres(settings)) {
    key << name << " in mm\n";
  }
  return key.str();
}

// Returns the one of `values` with a name. Precondition (CHECKed): there is
// one.
template <class Enum>
Enum Named(const std::string& name, std::initializer_list<Enum> values) {
  for (const Enum value : values) {
    if (ToString(value) == name) return value;
  }
  LOG(FATAL) << "no value \"" << name << "\"";
  return *values.begin();
}

// Returns a base of a struct that is composed of several structs of settings:
//
//   OptionsOf(PartOf<FileSettings>(settings))
template <class Part>
const Part& PartOf(const Part& settings) {
  return settings;
}

}  // namespace musclewarp
