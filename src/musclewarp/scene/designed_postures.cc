// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/scene/designed_postures.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include "musclewarp/base/angles.h"
#include "musclewarp/base/text.h"
#include "musclewarp/opensim/storage_table.h"
#include "musclewarp/scene/coordinate_fields.h"
#include "musclewarp/scene/posture_samples.h"
#include "musclewarp/scene/posture_tree.h"

namespace musclewarp {
namespace {

constexpr int kMostPostures = 20000;
constexpr char kLatinHypercube[] = "latin_hypercube";
constexpr char kGrid[] = "grid";
constexpr char kOfModel[] = "model";  // the range of a coordinate

// A coordinate and its range in the units of tables: degrees or m.
struct RangedCoordinate {
  int index = -1;
  double low = 0, high = 0;
};

// Degrees per unit, for comparing moves of different coordinates, in tables.
double DegreesPerTableUnit(const Coordinate& coordinate) {
  constexpr double kDegreesPerMetre = 20 / 0.08;
  return coordinate.kind == CoordinateKind::kTranslational ? kDegreesPerMetre
                                                           : 1;
}

RangedCoordinate WithRangeOfModel(const JsonField& field,
                                  const Model& model,
                                  int index) {
  const Coordinate& coordinate = model.coordinates[index];
  if (!coordinate.range || !((*coordinate.range)[0] < (*coordinate.range)[1])) {
    field.Fail("has no range for " + coordinate.name +
                   ", and neither has the model " + model.path,
               "give one, such as \"" + coordinate.name + "\": [-10, 60]");
  }
  const double unit =
      coordinate.kind == CoordinateKind::kRotational ? kDegreesPerRadian : 1;
  return {index, (*coordinate.range)[0] * unit, (*coordinate.range)[1] * unit};
}

RangedCoordinate ReadRange(const JsonField& field,
                           const Model& model,
                           int index) {
  if (field.IsString()) {
    if (field.AsString() != kOfModel) {
      field.Fail("is " + field.AsText(),
                 "give a range such as [-10, 60], or \"model\" for that of the "
                 "model");
    }
    return WithRangeOfModel(field, model, index);
  }
  const std::vector<double> ends = ReadCoordinateValues(field);
  if (ends.size() != 2 || !(ends[0] < ends[1])) {
    field.Fail("is no range",
               "give its lower and its upper end, such as [-10, 60]");
  }
  const double unit = ScenePerTableUnit(model.coordinates[index]);
  return {index, ends[0] / unit, ends[1] / unit};
}

// Returns true if the coordinate moves some bodies relative to others.
bool MovesSomeOf(const Model& model,
                 int coordinate,
                 const std::vector<std::string>& bodies) {
  size_t moved = 0;
  for (const std::string& name : bodies) {
    const int body = model.FindBody(name);
    moved += body >= 0 && MovesBody(model, coordinate, body) ? 1 : 0;
  }
  return moved > 0 && moved < bodies.size();
}

std::vector<RangedCoordinate> AllThatMove(
    const JsonField& field,
    const Model& model,
    const std::vector<std::string>& bodies) {
  std::vector<RangedCoordinate> ranged;
  for (const int index : FreeCoordinates(model)) {
    if (!MovesSomeOf(model, index, bodies)) continue;
    ranged.push_back(WithRangeOfModel(field, model, index));
  }
  if (ranged.empty()) {
    field.Fail("has no \"coordinates\", and no free coordinate of " +
                   model.path + " moves the bones",
               "name coordinates of the model");
  }
  return ranged;
}

std::vector<RangedCoordinate> ReadRanges(
    const JsonField& field,
    const Model& model,
    const std::vector<std::string>& bodies) {
  if (!field.Has("coordinates")) return AllThatMove(field, model, bodies);
  const JsonField coordinates = field.At("coordinates");
  const std::vector<std::string> names =
      coordinates.IsArray() ? coordinates.AsStrings() : coordinates.Keys();
  if (!coordinates.IsArray()) coordinates.CheckObject();
  CheckCoordinateNames(coordinates, names, model);
  if (names.empty()) {
    coordinates.Fail("is empty", "name at least one coordinate of the model");
  }
  std::vector<int> free = FreeCoordinates(model);
  std::vector<RangedCoordinate> ranged;
  for (const std::string& name : names) {
    const int index = model.FindCoordinate(name);
    if (std::count(free.begin(), free.end(), index) == 0) {
      coordinates.Fail(
          "names " + name + ", which the model " +
              (model.coordinates[index].is_locked ? "locks"
                                                  : "couples to others"),
          "leave it out; in all postures it is as the model has it");
    }
    ranged.push_back(coordinates.IsArray()
                         ? WithRangeOfModel(coordinates, model, index)
                         : ReadRange(coordinates.At(name), model, index));
  }
  std::sort(ranged.begin(), ranged.end(), [](const auto& a, const auto& b) {
    return a.index < b.index;
  });
  for (size_t i = 1; i < ranged.size(); ++i) {
    if (ranged[i].index != ranged[i - 1].index) continue;
    coordinates.Fail(
        "names " + model.coordinates[ranged[i].index].name + " more than once",
        "name each coordinate once");
  }
  return ranged;
}

// Returns an integer within the limits.
double ReadInteger(const JsonField& field, double lowest, double highest) {
  const double value = field.AsNumber();
  if (value != std::floor(value) || value < lowest || value > highest) {
    constexpr int kDigits = 10;
    field.Fail("is " + field.AsText(),
               "allowed: whole numbers from " + NumberText(lowest, kDigits) +
                   " to " + NumberText(highest, kDigits));
  }
  return value;
}

Eigen::MatrixXd ReadGrid(const JsonField& field,
                         const Model& model,
                         const std::vector<RangedCoordinate>& ranged,
                         int most) {
  if (field.Has("seed")) {
    field.At("seed").Fail("is given for a grid, in which nothing is random",
                          "leave it out");
  }
  std::vector<double> widths;
  for (const RangedCoordinate& one : ranged) {
    widths.push_back((one.high - one.low) *
                     DegreesPerTableUnit(model.coordinates[one.index]));
  }
  const std::vector<int> counts = GridCounts(widths, most);
  if (counts.empty()) {
    field.At("postures")
        .Fail("is " + std::to_string(most) + ", too few for a grid of " +
                  std::to_string(ranged.size()) + " coordinates",
              "a grid has at least two values of each; give more postures, or "
              "\"design\": \"latin_hypercube\"");
  }
  return GridSamples(counts);
}

Eigen::MatrixXd ReadSamples(const JsonField& field,
                            const Model& model,
                            const std::vector<RangedCoordinate>& ranged,
                            const std::string& design) {
  const int count =
      static_cast<int>(ReadInteger(field.At("postures"), 1, kMostPostures));
  if (design == kGrid) return ReadGrid(field, model, ranged, count);
  constexpr double kLargestSeed = 4294967295;
  const double seed =
      field.Has("seed") ? ReadInteger(field.At("seed"), 0, kLargestSeed) : 1;
  return LatinHypercube(
      count, static_cast<int>(ranged.size()), static_cast<std::uint32_t>(seed));
}

StorageTable TableOf(const Model& model,
                     const std::vector<RangedCoordinate>& ranged,
                     const Eigen::MatrixXd& samples) {
  StorageTable table;
  table.in_degrees = true;
  table.times.assign(samples.rows(), 0);
  table.values.resize(samples.rows(), samples.cols());
  for (size_t k = 0; k < ranged.size(); ++k) {
    table.labels.push_back(model.coordinates[ranged[k].index].name);
    // The ends of the range are met exactly.
    table.values.col(k) = (1 - samples.col(k).array()) * ranged[k].low +
                          samples.col(k).array() * ranged[k].high;
  }
  return table;
}

std::string NoteOn(const Model& model,
                   const std::vector<RangedCoordinate>& ranged,
                   const std::string& design,
                   const Eigen::MatrixXd& samples) {
  std::string note = std::to_string(samples.rows()) + " postures of a " +
                     (design == kGrid ? "grid" : "Latin hypercube") + ": ";
  for (size_t k = 0; k < ranged.size(); ++k) {
    const Coordinate& coordinate = model.coordinates[ranged[k].index];
    const bool is_length = coordinate.kind == CoordinateKind::kTranslational;
    const double unit = ScenePerTableUnit(coordinate);
    note += (k == 0 ? "" : ", ") + coordinate.name + " from " +
            MeasureText(ranged[k].low * unit) + " to " +
            MeasureText(ranged[k].high * unit) +
            (is_length                                        ? " mm"
             : coordinate.kind == CoordinateKind::kRotational ? " degrees"
                                                              : "");
  }
  return note;
}

}  // namespace

bool IsDesign(const JsonField& field) {
  return field.IsObject() && field.Has("design");
}

DesignedPostures ReadDesignedPostures(const JsonField& field,
                                      const Model& model,
                                      const std::vector<std::string>& bodies) {
  field.CheckKeys({"design", "postures", "coordinates", "seed"});
  DesignedPostures postures;
  postures.design = field.At("design").AsString();
  if (postures.design != kLatinHypercube && postures.design != kGrid) {
    field.At("design").Fail("is " + field.At("design").AsText(),
                            "allowed: \"latin_hypercube\", \"grid\"");
  }
  const std::vector<RangedCoordinate> ranged = ReadRanges(field, model, bodies);
  const Eigen::MatrixXd samples =
      ReadSamples(field, model, ranged, postures.design);
  postures.motion =
      MotionOf(model, TableOf(model, ranged, samples), field.where());
  postures.motion.moving = postures.motion.given;
  postures.note = NoteOn(model, ranged, postures.design, samples);
  return postures;
}

std::vector<int> VisitAsTree(const Model& model,
                             const CoordinateValues& rest,
                             CoordinateMotion* postures) {
  const auto count = static_cast<Eigen::Index>(postures->values.size());
  const auto dimensions = static_cast<Eigen::Index>(postures->given.size());
  Eigen::RowVectorXd start(dimensions);
  Eigen::MatrixXd places(count, dimensions);
  for (Eigen::Index k = 0; k < dimensions; ++k) {
    const int index = postures->given[k];
    const Coordinate& coordinate = model.coordinates[index];
    const double unit = coordinate.kind == CoordinateKind::kTranslational
                            ? RadiansOf(DegreesPerTableUnit(coordinate))
                            : 1;
    start[k] = unit * rest[index];
    for (Eigen::Index i = 0; i < count; ++i) {
      places(i, k) = unit * postures->values[i][index];
    }
  }
  PostureTree tree = TreeFrom(start, places);
  std::vector<CoordinateValues> ordered;
  for (const int posture : tree.order) {
    ordered.push_back(std::move(postures->values[posture]));
  }
  postures->values = std::move(ordered);
  return std::move(tree.reached_from);
}

}  // namespace musclewarp
