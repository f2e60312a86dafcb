// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <string_view>
#include <type_traits>

#include "musclewarp/base/described.h"

namespace musclewarp {

// The power of a length in a unit: 2 for "mm2", 1 for "mm" and "mm/rad", 0 for
// what has no length in it.
constexpr int LengthPower(std::string_view unit) {
  if (unit == "mm2") return 2;
  if (unit == "mm3") return 3;
  return unit == "mm" || unit == "mm/rad" ? 1 : 0;
}

template <class Struct>
void ScaleFigures(double factor, Struct* object);

// Multiplies what a field of this unit holds.
template <class T>
void ScaleValue(double factor, std::string_view unit, T* value) {
  if constexpr (kIsDescribed<T>) {
    ScaleFigures(factor, value);
  } else if constexpr (kIsVector<T>) {
    for (auto& element : *value) ScaleValue(factor, unit, &element);
  } else if constexpr (kIsMap<T>) {
    for (auto& item : *value) ScaleValue(factor, unit, &item.second);
  } else if constexpr (std::is_same_v<T, double> ||
                       std::is_same_v<T, Eigen::RowVector3d>) {
    *value *= std::pow(factor, LengthPower(unit));
  }
}

// True for a field of a described struct inside of another one, which is scaled
// with that struct.
template <class Struct, class Access>
struct IsScaledInside : std::false_type {};
template <class Struct, class First, class Second>
struct IsScaledInside<Struct, InnerAccess<First, Second>>
    : std::bool_constant<
          kIsDescribed<std::decay_t<std::invoke_result_t<First, Struct&>>>> {};

// Multiplies all lengths of a described struct, and of those in it, by a factor
// above 0, areas by its square and volumes by its cube, as their units say. A
// power of two is exact.
template <class Struct>
void ScaleFigures(double factor, Struct* object) {
  VisitList<Struct>([&](const auto& field) {
    using Access = std::decay_t<decltype(field.access)>;
    if constexpr (!kIsComputed<Access> &&
                  !IsScaledInside<Struct, Access>::value) {
      ScaleValue(factor, field.unit, &std::invoke(field.access, *object));
    }
  });
}

}  // namespace musclewarp
