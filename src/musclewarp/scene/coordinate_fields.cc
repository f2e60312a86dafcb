// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/scene/coordinate_fields.h"

#include <cmath>

#include "musclewarp/base/near_name.h"
#include "musclewarp/base/short_list.h"
#include "musclewarp/opensim/motion_columns.h"
#include "musclewarp/scene/coordinate_limits.h"
#include "musclewarp/scene/scene_names.h"

namespace musclewarp {

void CheckCoordinateNames(const JsonField& field,
                          const std::vector<std::string>& names,
                          const Model& model) {
  std::vector<std::string> known;
  for (const Coordinate& coordinate : model.coordinates) {
    known.push_back(coordinate.name);
  }
  for (const std::string& name : names) {
    if (model.FindCoordinate(name) >= 0) continue;
    const std::string problem = "names " + QuotedName(name) + ", which " +
                                WhyNoCoordinate(model, name) + ", " +
                                model.path;
    field.Fail(
        problem,
        DidYouMean(name, known) + "allowed: " + ShortList(known, known.size()));
  }
}

std::vector<double> ReadCoordinateValues(const JsonField& field) {
  if (!field.IsArray() || field.ArraySize() == 0) {
    field.Fail("is " + field.AsText(),
               "give a list of numbers such as [30] or [0, 90, 0]");
  }
  std::vector<double> values(field.ArraySize());
  for (size_t i = 0; i < values.size(); ++i) {
    values[i] = field.At(i).AsNumber();
    if (std::abs(values[i]) > kLargestCoordinate) {
      field.At(i).Fail("is " + field.At(i).AsText(), "allowed: -1e7 to 1e7");
    }
  }
  return values;
}

double ScenePerTableUnit(const Coordinate& coordinate) {
  return coordinate.kind == CoordinateKind::kTranslational
             ? kMillimetresPerMetre
             : 1;
}

}  // namespace musclewarp
