// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Comparison of described structs (base/described.h), and checks of their
// values.

#include <sstream>
#include <string>
#include <string_view>

#include "musclewarp/base/described.h"

namespace musclewarp {

// Returns true if two structs are equal in everything that is written of them.
template <class T>
bool AreEqual(const T& a, const T& b) {
  if constexpr (kIsDescribed<T>) {
    bool are_equal = true;
    VisitFields(a, [&](const auto& field, const auto& value) {
      are_equal = are_equal && AreEqual(value, std::invoke(field.access, b));
    });
    return are_equal;
  } else if constexpr (kIsVector<T>) {
    if (a.size() != b.size()) return false;
    for (std::size_t i = 0; i < a.size(); ++i) {
      if (!AreEqual(a[i], b[i])) return false;
    }
    return true;
  } else {
    return a == b;
  }
}

// A place in a struct, for messages. It points to the place around it, so that
// nothing is written until a message is needed.
struct FieldPath {
  const FieldPath* outer = nullptr;
  std::string_view key;
  int index = -1;  // of an element, or -1

  // "muscles[0].volume_error"
  std::string Text() const {
    std::string text = outer ? outer->Text() : "";
    if (index >= 0) return text + "[" + std::to_string(index) + "]";
    if (!text.empty() && !key.empty()) text += ".";
    return text.append(key);
  }
};

// Returns true if every number of a value is one, and is within the range of
// its field; else writes to `error` which is not: "muscles[0].gap is -1,
// allowed: 0 or above".
template <class T>
bool IsValidAt(const FieldPath& path,
               const T& value,
               const ValueRange& range,
               std::string* error) {
  bool is_valid = true;
  const auto check = [&](const FieldPath& inner, const auto& element) {
    is_valid = is_valid && IsValidAt(inner, element, range, error);
  };
  if constexpr (kIsDescribed<T>) {
    VisitFields(value, [&](const auto& field, const auto& inner) {
      is_valid =
          is_valid && IsValidAt({&path, field.key}, inner, field.range, error);
    });
  } else if constexpr (kIsVector<T>) {
    for (std::size_t i = 0; i < value.size(); ++i) {
      check({&path, "", static_cast<int>(i)}, value[i]);
    }
  } else if constexpr (kIsMap<T>) {
    for (const auto& [key, element] : value) check({&path, key}, element);
  } else if constexpr (kIsOptional<T>) {
    if (value) check(path, *value);
  } else if constexpr (std::is_same_v<T, Eigen::RowVector3d>) {
    for (int k = 0; k < 3; ++k) check({&path, "", k}, value[k]);
  } else if constexpr (std::is_arithmetic_v<T> && !std::is_same_v<T, bool>) {
    if (range.Contains(static_cast<double>(value))) return true;
    std::ostringstream message;
    message << path.Text() << " is " << value << ", allowed: " << range.Text();
    *error = message.str();
    return false;
  }
  return is_valid;
}

// The same of a described struct, or of a list of them, whose place is `path`.
template <class T>
bool IsValid(const T& value, std::string* error, const FieldPath& path = {}) {
  return IsValidAt(path, value, {}, error);
}

}  // namespace musclewarp
