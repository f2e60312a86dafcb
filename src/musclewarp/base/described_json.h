// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// How described structs (base/described.h) are written as JSON, and read.

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <string>

#include "musclewarp/base/described_checks.h"
#include "musclewarp/base/input_error.h"

namespace musclewarp {

// JSON has no infinite numbers; they are written as these texts. What is no
// number becomes null, and is not read back.
constexpr char kInfinityText[] = "Infinity";
constexpr char kMinusInfinityText[] = "-Infinity";

// Returns a described struct as an object whose keys are in the order of its
// list, a place as [x, y, z], lists and maps of all these as arrays and
// objects. No bit of a number is lost.
template <class T>
nlohmann::ordered_json JsonOf(const T& value) {
  using OrderedJson = nlohmann::ordered_json;
  if constexpr (kIsDescribed<T>) {
    OrderedJson object = OrderedJson::object();
    VisitFields(value, [&](const auto& field, const auto& inner) {
      if constexpr (kCanBeEmpty<std::decay_t<decltype(inner)>>) {
        if (field.presence == Presence::kUnlessEmpty && inner.empty()) return;
        if (field.presence == Presence::kNullIfEmpty && inner.empty()) {
          object.push_back({field.key, nullptr});
          return;
        }
      }
      object.push_back({field.key, JsonOf(inner)});
    });
    return object;
  } else if constexpr (kIsVector<T>) {
    OrderedJson array = OrderedJson::array();
    for (const auto& element : value) array.push_back(JsonOf(element));
    return array;
  } else if constexpr (kIsMap<T>) {
    OrderedJson object = OrderedJson::object();
    for (const auto& [key, element] : value) {
      object.push_back({key, JsonOf(element)});
    }
    return object;
  } else if constexpr (kIsOptional<T>) {
    return value ? JsonOf(*value) : OrderedJson();
  } else if constexpr (std::is_same_v<T, Eigen::RowVector3d>) {
    return OrderedJson::array(
        {JsonOf(value.x()), JsonOf(value.y()), JsonOf(value.z())});
  } else if constexpr (std::is_floating_point_v<T>) {
    if (std::isinf(value)) {
      return value > 0 ? kInfinityText : kMinusInfinityText;
    }
    return std::isnan(value) ? OrderedJson() : OrderedJson(value);
  } else if constexpr (std::is_enum_v<T>) {
    return ToString(value);
  } else {
    return value;
  }
}

namespace described_internal {

// Throws InputError unless a value is as it should be.
template <class Json>
void Require(bool is_right,
             const Json& json,
             const FieldPath& path,
             const char* allowed) {
  if (is_right) return;
  const std::string seen =
      json.is_structured()
          ? json.type_name()
          : json.dump(-1, ' ', false, Json::error_handler_t::replace);
  throw InputError(path.Text(), "is " + seen, std::string("give ") + allowed);
}

template <class Json, class T>
void ReadFields(const Json& json, const FieldPath& path, T* object);

template <class Json, class T>
void ReadNumber(const Json& json, const FieldPath& path, T* number) {
  if constexpr (std::is_floating_point_v<T>) {
    if (json == kInfinityText || json == kMinusInfinityText) {
      *number = json == kInfinityText ? kInfinity : -kInfinity;
      return;
    }
    Require(json.is_number(), json, path, "a number");
  } else {
    using Limits = std::numeric_limits<T>;
    Require(json.is_number_integer() &&
                json.template get<double>() >= Limits::lowest() &&
                json.template get<double>() <= Limits::max(),
            json,
            path,
            "a whole number");
  }
  *number = json.template get<T>();
  Require(*number == *number, json, path, "a number");
}

// The names of an enumeration are those of ToString(), which gives "unknown"
// behind the last one.
template <class Json, class T>
void ReadName(const Json& json, const FieldPath& path, T* value) {
  for (int i = 0; ToString(static_cast<T>(i)) != "unknown"; ++i) {
    if (json != ToString(static_cast<T>(i))) continue;
    *value = static_cast<T>(i);
    return;
  }
  Require(false, json, path, "one of its names");
}

}  // namespace described_internal

// Reads what JsonOf() has written. `path` is the place of the value in its
// file. Throws InputError that names the place if a key is missing or a value
// is of another type. What is computed from other fields has to be there, and
// is passed over.
template <class Json, class T>
void ReadJson(const Json& json, const FieldPath& path, T* value) {
  using described_internal::Require;
  if constexpr (kIsDescribed<T>) {
    described_internal::ReadFields(json, path, value);
  } else if constexpr (kIsVector<T>) {
    Require(json.is_array(), json, path, "a list");
    value->clear();
    value->reserve(json.size());
    for (std::size_t i = 0; i < json.size(); ++i) {
      typename T::value_type element{};
      ReadJson(json[i], {&path, "", static_cast<int>(i)}, &element);
      value->push_back(std::move(element));
    }
  } else if constexpr (kIsMap<T>) {
    Require(json.is_object(), json, path, "an object");
    value->clear();
    for (const auto& item : json.items()) {
      ReadJson(item.value(), {&path, item.key()}, &(*value)[item.key()]);
    }
  } else if constexpr (std::is_same_v<T, Eigen::RowVector3d>) {
    Require(json.is_array() && json.size() == 3, json, path, "three numbers");
    for (int k = 0; k < 3; ++k) ReadJson(json[k], {&path, "", k}, &(*value)[k]);
  } else if constexpr (std::is_same_v<T, bool>) {
    Require(json.is_boolean(), json, path, "true or false");
    *value = json.template get<bool>();
  } else if constexpr (std::is_arithmetic_v<T>) {
    described_internal::ReadNumber(json, path, value);
  } else if constexpr (std::is_enum_v<T>) {
    described_internal::ReadName(json, path, value);
  } else {
    Require(json.is_string(), json, path, "a text");
    *value = json.template get<T>();
  }
}

template <class Json, class T>
void described_internal::ReadFields(const Json& json,
                                    const FieldPath& path,
                                    T* object) {
  Require(json.is_object(), json, path, "an object");
  VisitFields(*object, [&](const auto& field, auto&& value) {
    const auto found = json.find(field.key);
    if (found == json.end()) {
      if (field.presence != Presence::kAlways) return;
      throw InputError(FieldPath{&path, field.key}.Text(),
                       "is missing",
                       "compute the results again");
    }
    if constexpr (!kIsComputed<std::decay_t<decltype(field.access)>>) {
      if (found->is_null() && field.presence == Presence::kNullIfEmpty) {
        value = {};
      } else {
        ReadJson(*found, {&path, field.key}, &value);
      }
    }
  });
}

}  // namespace musclewarp
