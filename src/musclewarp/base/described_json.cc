// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/base/described_json.h"

#include <cmath>
#include <string>
#include <utility>

#include "musclewarp/base/infinity.h"
#include "musclewarp/base/input_error.h"

namespace musclewarp::described_internal {

nlohmann::ordered_json JsonOfNumber(double number) {
  if (std::isnan(number)) return nullptr;
  if (!std::isinf(number)) return number;
  return number > 0 ? kInfinityText : kMinusInfinityText;
}

void AddField(const char* key,
              nlohmann::ordered_json&& value,
              nlohmann::ordered_json* object) {
  object->emplace(key, std::move(value));
}

void Require(bool is_right,
             const nlohmann::json& json,
             const FieldPath& path,
             const char* allowed) {
  if (is_right) return;
  using Handler = nlohmann::json::error_handler_t;
  const std::string seen = json.is_structured()
                               ? json.type_name()
                               : json.dump(-1, ' ', false, Handler::replace);
  throw InputError(path.Text(), "is " + seen, std::string("give ") + allowed);
}

double ReadNumber(const nlohmann::json& json, const FieldPath& path) {
  if (json == kInfinityText) return kInfinity;
  if (json == kMinusInfinityText) return -kInfinity;
  Require(json.is_number(), json, path, "a number");
  const double number = json.get<double>();
  Require(!std::isnan(number), json, path, "a number");
  return number;
}

std::int64_t ReadInteger(const nlohmann::json& json,
                         const FieldPath& path,
                         std::int64_t lowest,
                         std::int64_t highest) {
  Require(json.is_number_integer() && json.get<double>() >= lowest &&
              json.get<double>() <= highest,
          json,
          path,
          "a whole number");
  return json.get<std::int64_t>();
}

const nlohmann::json* FindField(const nlohmann::json& object,
                                const FieldPath& path,
                                Presence presence) {
  const auto found = object.find(path.key);
  if (found != object.end()) return &*found;
  if (presence == Presence::kAlways) {
    throw InputError(path.Text(), "is missing", "compute the results again");
  }
  return nullptr;
}

}  // namespace musclewarp::described_internal
