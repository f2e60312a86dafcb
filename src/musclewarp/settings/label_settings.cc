// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/settings/label_settings.h"

#include <glog/logging.h>

#include <filesystem>
#include <optional>

#include "musclewarp/base/input_error.h"
#include "musclewarp/settings/checked_settings.h"

namespace musclewarp {

double UnitSettings::MmPerUnit() const {
  const std::optional<double> mm = MillimetresPer(units);
  CHECK(mm.has_value()) << units;
  return *mm;
}

LabelMeshOptions OptionsOf(const LabelSettings& settings) {
  CheckSettings(settings);
  if (!settings.labels.empty() && !std::filesystem::exists(settings.labels)) {
    throw InputError("{labels}=" + settings.labels,
                     "does not exist",
                     "check the name and the folder");
  }
  LabelMeshOptions options;
  options.table = settings.labels;
  options.edge_length = settings.edge;
  options.pieces =
      settings.pieces == "all" ? PieceChoice::kAll : PieceChoice::kLargest;
  options.mm_per_unit = settings.MmPerUnit();
  return options;
}

}  // namespace musclewarp
