// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/settings/label_settings.h"

#include <glog/logging.h>

#include <optional>

#include "musclewarp/settings/checked_settings.h"

namespace musclewarp {

double UnitSettings::MmPerUnit() const {
  const std::optional<double> mm = MillimetresPer(units);
  CHECK(mm.has_value()) << units;
  return *mm;
}

LabelMeshOptions OptionsOf(const LabelSettings& settings) {
  CheckSettings(settings);
  LabelMeshOptions options;
  options.table = settings.labels;
  options.edge_length = settings.edge;
  options.pieces =
      settings.pieces == "all" ? PieceChoice::kAll : PieceChoice::kLargest;
  options.mm_per_unit = settings.MmPerUnit();
  return options;
}

}  // namespace musclewarp
