// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0

// Prints the lists of settings (src/musclewarp/settings) as JSON. Tables of the
// documentation and signatures of Python are made of it (scripts/generated.py);
// it is not installed.

#include <iostream>
#include <nlohmann/json.hpp>

#include "musclewarp/base/setting_names.h"
#include "musclewarp/settings/articulation_settings.h"
#include "musclewarp/settings/checked_settings.h"
#include "musclewarp/settings/deformer_settings.h"
#include "musclewarp/settings/file_settings.h"
#include "musclewarp/settings/label_settings.h"
#include "musclewarp/settings/scene_settings.h"
#include "musclewarp/settings/separation_settings.h"

namespace musclewarp {
namespace {

using OrderedJson = nlohmann::ordered_json;

template <class Value>
const char* TypeOf() {
  if constexpr (std::is_same_v<Value, bool>) return "bool";
  if constexpr (std::is_floating_point_v<Value>) return "number";
  return std::is_integral_v<Value> ? "whole" : "text";
}

std::string Allowed(const ValueRange& range, const std::string& choices) {
  const bool has_range =
      std::isfinite(range.lowest) || std::isfinite(range.highest);
  return has_range ? range.Text() : choices;
}

template <class Settings>
OrderedJson ListOf() {
  OrderedJson fields = OrderedJson::array();
  VisitFields(Settings(), [&](const auto& field, const auto& value) {
    using Value = std::decay_t<decltype(value)>;
    fields.push_back({{"key", field.key},
                      {"type", field.is_path ? "path" : TypeOf<Value>()},
                      {"default", value},
                      {"unit", field.unit},
                      {"allowed", Allowed(field.range, field.choices)},
                      {"text", WithFlags(field.text)},
                      {"changes_results", field.effect == Effect::kResults}});
  });
  return fields;
}

}  // namespace
}  // namespace musclewarp

int main() {
  using namespace musclewarp;
  const OrderedJson all = {
      {"SceneSettings", ListOf<SceneSettings>()},
      {"DeformerSettings", ListOf<DeformerSettings>()},
      {"FileSettings", ListOf<FileSettings>()},
      {"SeparationSettings", ListOf<SeparationSettings>()},
      {"LabelSettings", ListOf<LabelSettings>()},
      {"ArticulationSettings", ListOf<ArticulationSettings>()}};
  std::cout << all.dump(1) << "\n";
  return 0;
}
