// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Settings as keywords of Python: their names, defaults and texts are those of
// the lists (musclewarp/settings).

#include <pybind11/pybind11.h>

#include <string>
#include <type_traits>

#include "musclewarp/base/described.h"
#include "musclewarp/base/input_error.h"
#include "musclewarp/settings/checked_settings.h"
#include "python/src/figures.h"

namespace musclewarp::python {

// Returns the text that a value stands for: a str, a path, or a sequence of
// str, which are joined with commas. Throws pybind11::cast_error for others.
std::string TextFrom(const pybind11::object& value);

// Returns settings with the values of keywords, of which others are passed
// over. Throws InputError, naming the keyword, for a value of another type.
template <class Settings>
Settings SettingsFrom(const pybind11::dict& keywords) {
  Settings settings;
  VisitFields(settings, [&](const auto& field, auto& value) {
    using Value = std::decay_t<decltype(value)>;
    if (!keywords.contains(field.key)) return;
    const pybind11::object given = keywords[field.key];
    try {
      if constexpr (std::is_same_v<Value, std::string>) {
        value = TextFrom(given);
      } else {
        value = given.cast<Value>();
      }
    } catch (const pybind11::cast_error&) {
      throw InputError(field.key,
                       "is " + pybind11::repr(given).cast<std::string>(),
                       std::string("allowed: ") + KindOfValue<Value>());
    }
  });
  return settings;
}

// Returns the keywords with their defaults, and the text of each for a
// docstring.
template <class Settings>
pybind11::dict DefaultsOf() {
  pybind11::dict keywords;
  VisitFields(Settings(), [&](const auto& field, const auto& value) {
    keywords[field.key] = value;
  });
  return keywords;
}

template <class Settings>
std::string ArgumentTexts() {
  std::string texts;
  VisitFields(Settings(), [&](const auto& field, const auto& /*value*/) {
    texts += (texts.empty() ? "" : "\n") +
             AttributeText(field.key, HelpOf(field), "", 8);
  });
  return texts;
}

}  // namespace musclewarp::python
