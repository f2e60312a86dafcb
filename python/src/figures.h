// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Figures as properties of Python, made of their lists (base/described.h).

#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <functional>
#include <set>
#include <string>
#include <vector>

#include "musclewarp/base/described_json.h"
#include "musclewarp/frames/frame.h"
#include "python/src/json.h"

namespace musclewarp::python {

// Returns a text of a list without the marks of Markdown.
std::string PlainText(const std::string& text);

// Returns "name: text, unit", indented and wrapped as in docstrings.
std::string AttributeText(const std::string& name,
                          const std::string& text,
                          const std::string& unit,
                          int indent = 4);

// Returns numbers as such, and all else as json.loads() makes it of what a
// report says.
template <class T>
pybind11::object ToPython(const T& value) {
  if constexpr (std::is_arithmetic_v<T>) {
    return pybind11::cast(value);
  } else if constexpr (std::is_same_v<T, std::vector<MuscleFrame>>) {
    return pybind11::none();  // frames bind them by hand
  } else {
    return FromJson(JsonOf(value));
  }
}

// Returns the docstrings of the fields of a struct that Python shows, but for
// those of `by_hand`.
template <class Figures>
std::string AttributeTexts(const std::set<std::string>& by_hand) {
  std::string texts;
  VisitList<Figures>([&](const auto& field) {
    if constexpr (std::decay_t<decltype(field)>::kIsWritten) {
      if (by_hand.count(NameOf(field)) > 0) return;
      texts += "\n" + AttributeText(NameOf(field), field.text, field.unit);
    }
  });
  return texts;
}

// Adds a property for each field of figures, which `figures_of` finds in an
// object of Python, but for those of `by_hand`.
template <class Figures, class Object, class Class>
void BindFigures(const Figures& (*figures_of)(const Object&),
                 const std::set<std::string>& by_hand,
                 Class* type) {
  VisitList<Figures>([&](const auto& field) {
    if constexpr (std::decay_t<decltype(field)>::kIsWritten) {
      const std::string name = NameOf(field);
      if (by_hand.count(name) > 0) return;
      const std::string doc = PlainText(field.text);
      type->def_property_readonly(
          name.c_str(),
          [figures_of, access = field.access](const Object& object) {
            return ToPython(std::invoke(access, figures_of(object)));
          },
          doc.c_str());
    }
  });
}

}  // namespace musclewarp::python
