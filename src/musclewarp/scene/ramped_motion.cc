// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/scene/ramped_motion.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "musclewarp/opensim/storage_table.h"
#include "musclewarp/scene/coordinate_fields.h"

namespace musclewarp {
namespace {

constexpr int kMostFrames = 100000;

// A coordinate and its values at equally spaced times.
struct Ramp {
  std::string name;
  std::vector<double> values;
  double per_table_unit = 1;  // 1000 for mm, since tables are in metres
};

std::vector<Ramp> ReadRamps(const JsonField& coordinates, const Model& model) {
  coordinates.CheckObject();
  CheckCoordinateNames(coordinates, coordinates.Keys(), model);
  std::vector<Ramp> ramps;
  for (const Coordinate& coordinate : model.coordinates) {
    if (!coordinates.Has(coordinate.name)) continue;
    ramps.push_back({coordinate.name,
                     ReadCoordinateValues(coordinates.At(coordinate.name)),
                     ScenePerTableUnit(coordinate)});
  }
  if (ramps.empty()) {
    coordinates.Fail("is empty", "name at least one coordinate of the model");
  }
  return ramps;
}

int ReadFrames(const JsonField& field, const std::vector<Ramp>& ramps) {
  const bool stands_still =
      std::all_of(ramps.begin(), ramps.end(), [](const Ramp& ramp) {
        return ramp.values.size() == 1;
      });
  const double frames = field.AsNumber();
  if (frames != std::floor(frames) || frames < (stands_still ? 1 : 2) ||
      frames > kMostFrames) {
    field.Fail("is " + field.AsText(),
               "allowed: whole numbers from 2 to " +
                   std::to_string(kMostFrames) +
                   ", and 1 if every coordinate has a single value");
  }
  return static_cast<int>(frames);
}

// Returns the value at frame `frame` of 0 to `last`. The interval is found with
// integers, so that a frame at one of the values has it exactly.
double ValueAt(const std::vector<double>& values, int frame, int last) {
  if (values.size() == 1) return values[0];
  const auto pieces = static_cast<std::int64_t>(values.size()) - 1;
  const std::int64_t piece = frame * pieces / last;
  const std::int64_t rest = frame * pieces % last;
  if (rest == 0) return values[piece];
  return values[piece] +
         (values[piece + 1] - values[piece]) * static_cast<double>(rest) / last;
}

StorageTable TableOf(const std::vector<Ramp>& ramps, int frames) {
  StorageTable table;
  table.in_degrees = true;
  table.values.resize(frames, static_cast<Eigen::Index>(ramps.size()));
  const int last = frames - 1;
  for (int i = 0; i < frames; ++i) {
    table.times.push_back(last > 0 ? static_cast<double>(i) / last : 0);
    for (size_t k = 0; k < ramps.size(); ++k) {
      table.values(i, k) =
          ValueAt(ramps[k].values, i, last) / ramps[k].per_table_unit;
    }
  }
  for (const Ramp& ramp : ramps) table.labels.push_back(ramp.name);
  return table;
}

}  // namespace

CoordinateMotion RampedMotion(const JsonField& field, const Model& model) {
  field.CheckKeys({"frames", "coordinates"});
  const std::vector<Ramp> ramps = ReadRamps(field.At("coordinates"), model);
  const int frames = ReadFrames(field.At("frames"), ramps);
  StorageTable table = TableOf(ramps, frames);
  for (const Ramp& ramp : ramps) {
    const size_t values = ramp.values.size();
    if (values <= static_cast<size_t>(frames)) continue;
    table.warnings.push_back(field.where() + ": " + std::to_string(frames) +
                             " frames pass over some of the " +
                             std::to_string(values) + " values of " +
                             ramp.name);
  }
  return MotionOf(model, table, field.where());
}

}  // namespace musclewarp
