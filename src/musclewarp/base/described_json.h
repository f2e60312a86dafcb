// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// How described structs (base/described.h) are written as JSON, and read.

#include <cstdint>
#include <limits>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>

#include "musclewarp/base/described_checks.h"

namespace musclewarp {

// JSON has no infinite numbers; they are written as these texts. What is no
// number becomes null, and is not read back.
constexpr char kInfinityText[] = "Infinity";
constexpr char kMinusInfinityText[] = "-Infinity";

// The steps that all structs share are no templates: what is instantiated for
// each field of each struct takes most of the time to compile.
namespace described_internal {

nlohmann::ordered_json JsonOfNumber(double number);

void AddField(const char* key,
              nlohmann::ordered_json&& value,
              nlohmann::ordered_json* object);

// Throws InputError unless a value is as it should be.
void Require(bool is_right,
             const nlohmann::json& json,
             const FieldPath& path,
             const char* allowed);

double ReadNumber(const nlohmann::json& json, const FieldPath& path);

// Returns a whole number between two others.
std::int64_t ReadInteger(const nlohmann::json& json,
                         const FieldPath& path,
                         std::int64_t lowest,
                         std::int64_t highest);

// Returns the field of an object, or null if it may be missing there; throws
// InputError if it may not.
const nlohmann::json* FindField(const nlohmann::json& object,
                                const FieldPath& path,
                                Presence presence);

}  // namespace described_internal

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
          described_internal::AddField(field.key, nullptr, &object);
          return;
        }
      }
      described_internal::AddField(field.key, JsonOf(inner), &object);
    });
    return object;
  } else if constexpr (kIsVector<T>) {
    OrderedJson array = OrderedJson::array();
    for (const auto& element : value) array.push_back(JsonOf(element));
    return array;
  } else if constexpr (kIsMap<T>) {
    OrderedJson object = OrderedJson::object();
    for (const auto& [key, element] : value) {
      described_internal::AddField(key.c_str(), JsonOf(element), &object);
    }
    return object;
  } else if constexpr (kIsOptional<T>) {
    return value ? JsonOf(*value) : OrderedJson();
  } else if constexpr (std::is_same_v<T, Eigen::RowVector3d>) {
    OrderedJson array = OrderedJson::array();
    for (int k = 0; k < 3; ++k) array.push_back(JsonOf(value[k]));
    return array;
  } else if constexpr (std::is_floating_point_v<T>) {
    return described_internal::JsonOfNumber(value);
  } else if constexpr (std::is_enum_v<T>) {
    return ToString(value);
  } else {
    return value;
  }
}

// Reads what JsonOf() has written. `path` is the place of the value in its
// file. Throws InputError that names the place if a key is missing or a value
// is of another type. What is computed from other fields has to be there, and
// is passed over.
template <class T>
void ReadJson(const nlohmann::json& json, const FieldPath& path, T* value);

namespace described_internal {

// The names of an enumeration are those of ToString(), which gives "unknown"
// behind the last one.
template <class T>
void ReadName(const nlohmann::json& json, const FieldPath& path, T* value) {
  for (int i = 0; ToString(static_cast<T>(i)) != "unknown"; ++i) {
    if (json != ToString(static_cast<T>(i))) continue;
    *value = static_cast<T>(i);
    return;
  }
  Require(false, json, path, "one of its names");
}

template <class T>
void ReadFields(const nlohmann::json& json, const FieldPath& path, T* object) {
  Require(json.is_object(), json, path, "an object");
  VisitFields(*object, [&](const auto& field, auto&& value) {
    const FieldPath place = {&path, field.key};
    const nlohmann::json* found = FindField(json, place, field.presence);
    if (!found) return;
    if constexpr (!kIsComputed<std::decay_t<decltype(field.access)>>) {
      if (found->is_null() && field.presence == Presence::kNullIfEmpty) {
        value = {};
      } else {
        ReadJson(*found, place, &value);
      }
    }
  });
}

}  // namespace described_internal

template <class T>
void ReadJson(const nlohmann::json& json, const FieldPath& path, T* value) {
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
  } else if constexpr (kIsOptional<T>) {
    value->reset();
    if (!json.is_null()) ReadJson(json, path, &value->emplace());
  } else if constexpr (std::is_same_v<T, Eigen::RowVector3d>) {
    Require(json.is_array() && json.size() == 3, json, path, "three numbers");
    for (int k = 0; k < 3; ++k) ReadJson(json[k], {&path, "", k}, &(*value)[k]);
  } else if constexpr (std::is_same_v<T, bool>) {
    Require(json.is_boolean(), json, path, "true or false");
    *value = json.get<bool>();
  } else if constexpr (std::is_floating_point_v<T>) {
    *value = static_cast<T>(described_internal::ReadNumber(json, path));
  } else if constexpr (std::is_integral_v<T>) {
    static_assert(std::is_signed_v<T>);
    using Limits = std::numeric_limits<T>;
    *value = static_cast<T>(described_internal::ReadInteger(
        json, path, Limits::lowest(), Limits::max()));
  } else if constexpr (std::is_enum_v<T>) {
    described_internal::ReadName(json, path, value);
  } else {
    Require(json.is_string(), json, path, "a text");
    *value = json.get<T>();
  }
}

}  // namespace musclewarp
