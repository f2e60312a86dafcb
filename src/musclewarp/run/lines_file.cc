// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/run/lines_file.h"

#include <nlohmann/json.hpp>
#include <utility>

#include "musclewarp/base/output_file.h"
#include "musclewarp/scene/json_fields.h"

namespace musclewarp {
namespace {

nlohmann::ordered_json ToJson(const Points& points) {
  auto json = nlohmann::ordered_json::array();
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    json.push_back({points(i, 0), points(i, 1), points(i, 2)});
  }
  return json;
}

}  // namespace

void WriteLinesFile(const std::string& path,
                    const std::vector<MuscleLines>& muscles) {
  auto all = nlohmann::ordered_json::array();
  for (const MuscleLines& muscle : muscles) {
    auto lines = nlohmann::ordered_json::array();
    for (const NamedLine& line : muscle.lines) {
      lines.push_back({{"name", line.name}, {"points", ToJson(line.points)}});
    }
    auto fibres = nlohmann::ordered_json::array();
    for (const Points& fibre : muscle.fibres) fibres.push_back(ToJson(fibre));
    all.push_back(
        {{"name", muscle.name}, {"lines", lines}, {"fibres", fibres}});
    for (const Points& tendon : muscle.tendons) {
      all.back()["tendons"].push_back(ToJson(tendon));
    }
  }
  const nlohmann::ordered_json file = {{"units", "mm"}, {"muscles", all}};
  // Names of an .osim may not be UTF-8.
  const auto on_error = nlohmann::ordered_json::error_handler_t::replace;
  WriteTextAtomically(path, file.dump(-1, ' ', false, on_error) + "\n");
}

std::vector<MuscleLines> ReadLinesFile(const std::string& path) {
  std::vector<MuscleLines> muscles;
  const JsonField all = JsonField::ParseFile(path).At("muscles");
  for (size_t i = 0; i < all.ArraySize(); ++i) {
    const JsonField field = all.At(i);
    MuscleLines muscle;
    muscle.name = field.At("name").AsString();
    const JsonField lines = field.At("lines");
    for (size_t k = 0; k < lines.ArraySize(); ++k) {
      const JsonField line = lines.At(k);
      muscle.lines.push_back(
          {line.At("name").AsString(), line.At("points").AsPoints()});
    }
    const JsonField fibres = field.At("fibres");
    for (size_t k = 0; k < fibres.ArraySize(); ++k) {
      muscle.fibres.push_back(fibres.At(k).AsPoints());
    }
    if (field.Has("tendons")) {
      const JsonField tendons = field.At("tendons");
      for (size_t k = 0; k < tendons.ArraySize(); ++k) {
        muscle.tendons.push_back(tendons.At(k).AsPoints());
      }
    }
    muscles.push_back(std::move(muscle));
  }
  return muscles;
}

}  // namespace musclewarp
