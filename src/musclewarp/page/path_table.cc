// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/page/path_table.h"

#include <filesystem>

#include "musclewarp/scene/json_fields.h"

namespace musclewarp {
namespace {

using OrderedJson = nlohmann::ordered_json;

OrderedJson ErrorOf(const JsonField& held_back, const char* key) {
  if (held_back.IsNull()) return nullptr;
  const JsonField error = held_back.At(key);
  return {error.At("mean").AsNumber(),
          error.At("quantile_95").AsNumber(),
          error.At("largest").AsNumber()};
}

OrderedJson RowOf(const std::string& name, const JsonField& function) {
  const JsonField held_back = function.At("held_back");
  const JsonField survey = function.At("lines_through_range");
  return {{"name", name},
          {"muscle", function.At("muscle").AsString()},
          {"coordinates", function.At("coordinates").AsStrings()},
          {"terms", function.At("terms").AsNumber()},
          {"length_mm", ErrorOf(held_back, "length_error_mm")},
          {"arm_mm", ErrorOf(held_back, "arm_error_mm")},
          {"lines", survey.At("lines").AsNumber()},
          {"jumps", survey.At("jumps").AsNumber()},
          {"with_sign_change", survey.At("with_sign_change").AsNumber()},
          {"within_bounds", function.At("within_bounds").AsBool()}};
}

}  // namespace

OrderedJson PathTableOf(const std::string& file) {
  const JsonField fit = JsonField::ParseFile(file);
  const JsonField functions = fit.At("muscles");
  functions.CheckObject();
  OrderedJson rows = OrderedJson::array();
  for (const std::string& name : functions.Keys()) {
    rows.push_back(RowOf(name, functions.At(name)));
  }
  return {{"file", std::filesystem::path(file).filename().string()},
          {"frames", fit.At("frames").AsNumber()},
          {"frames_doubtful", fit.At("frames_doubtful").ArraySize()},
          {"frames_left_out", fit.At("frames_left_out").ArraySize()},
          {"microseconds", fit.At("microseconds").AsNumber()},
          {"bounds_mm",
           {fit.At("max_length_error_mm").AsNumber(),
            fit.At("max_arm_error_mm").AsNumber(),
            fit.At("largest_arm_error_mm").AsNumber()}},
          {"rows", rows}};
}

}  // namespace musclewarp
