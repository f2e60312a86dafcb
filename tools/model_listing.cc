// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "tools/model_listing.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "musclewarp/base/angles.h"
#include "musclewarp/base/input_error.h"
#include "musclewarp/base/text.h"
#include "musclewarp/opensim/coordinate_motion.h"
#include "musclewarp/opensim/geometry_files.h"
#include "musclewarp/opensim/kinematics.h"
#include "musclewarp/opensim/storage_table.h"

namespace musclewarp {
namespace {

// Prints rows in columns that are as wide as their longest entry.
void PrintColumns(const std::vector<std::vector<std::string>>& rows,
                  std::ostream& screen) {
  std::vector<size_t> widths;
  for (const auto& row : rows) {
    widths.resize(std::max(widths.size(), row.size()), 0);
    for (size_t i = 0; i < row.size(); ++i) {
      widths[i] = std::max(widths[i], row[i].size());
    }
  }
  for (const auto& row : rows) {
    std::string line = " ";
    for (size_t i = 0; i < row.size(); ++i) {
      line += " " + row[i] + std::string(widths[i] - row[i].size() + 1, ' ');
    }
    screen << line.substr(0, line.find_last_not_of(' ') + 1) << "\n";
  }
}

// Returns the reason for which `check` throws, or an empty text if it does not.
template <typename Check>
std::string ReasonAgainst(const Check& check) {
  try {
    check();
    return "";
  } catch (const InputError& error) {
    return std::string("NOT usable: ") + error.what();
  }
}

std::string JointOf(const Model& model, const Body& body) {
  if (body.joint < 0) return "";
  const Joint& joint = model.joints[body.joint];
  return joint.type + " \"" + joint.name + "\" on " +
         model.bodies[joint.parent].name;
}

void PrintBodies(const Model& model,
                 const std::vector<std::string>& folders,
                 std::ostream& screen) {
  std::vector<std::vector<std::string>> rows;
  for (size_t i = 0; i < model.bodies.size(); ++i) {
    const Body& body = model.bodies[i];
    rows.push_back({body.name, JointOf(model, body), ReasonAgainst([&] {
                      CheckBodyIsSupported(
                          model, static_cast<int>(i), "the scene");
                    })});
  }
  screen << "bodies:\n";
  PrintColumns(rows, screen);
  rows.clear();
  for (const Body& body : model.bodies) {
    for (const ModelGeometry& mesh : body.geometry) {
      const std::string path = FindGeometry(mesh, folders);
      rows.push_back({body.name, mesh.file, path.empty() ? "not there" : path});
    }
  }
  screen << "meshes (" << rows.size() << "), looked for in\n";
  for (const std::string& folder : folders) screen << "  " << folder << "\n";
  screen << (rows.empty() ? "none\n" : "by body:\n");
  PrintColumns(rows, screen);
}

// Returns the bodies on which a path lies, in the order of its points.
std::string BodiesOf(const Model& model, const ModelMuscle& muscle) {
  std::vector<int> bodies;
  std::string names;
  for (const PathPoint& point : muscle.path) {
    if (std::count(bodies.begin(), bodies.end(), point.body)) continue;
    bodies.push_back(point.body);
    names += (names.empty() ? "" : ", ") + model.bodies[point.body].name;
  }
  return names;
}

void PrintMuscles(const Model& model, std::ostream& screen) {
  std::vector<std::vector<std::string>> rows;
  for (size_t i = 0; i < model.muscles.size(); ++i) {
    const std::string reason = ReasonAgainst(
        [&] { CheckMuscleIsSupported(model, static_cast<int>(i)); });
    rows.push_back(
        {model.muscles[i].name,
         reason.empty() ? BodiesOf(model, model.muscles[i]) : reason});
  }
  screen << "muscles (" << rows.size()
         << "), and the bodies of their points:\n";
  PrintColumns(rows, screen);
}

std::string InUnits(double value, const Coordinate& coordinate) {
  const bool is_angle = coordinate.kind == CoordinateKind::kRotational;
  return NumberText(value * (is_angle ? kDegreesPerRadian : 1));
}

std::string UnitOfCoordinate(const Coordinate& coordinate) {
  switch (coordinate.kind) {
    case CoordinateKind::kRotational:
      return "degrees";
    case CoordinateKind::kTranslational:
      return "m";
    case CoordinateKind::kCoupled:
      break;
  }
  return "as it is";
}

std::string RangeIn(const CoordinateMotion& motion,
                    int index,
                    const Coordinate& coordinate) {
  if (!std::count(motion.given.begin(), motion.given.end(), index)) return "";
  double least = motion.values[0][index];
  double most = least;
  for (const CoordinateValues& values : motion.values) {
    least = std::min(least, values[index]);
    most = std::max(most, values[index]);
  }
  return InUnits(least, coordinate) + " to " + InUnits(most, coordinate);
}

void PrintCoordinates(const Model& model,
                      const std::optional<CoordinateMotion>& motion,
                      std::ostream& screen) {
  std::vector<std::vector<std::string>> rows = {
      {"name", "unit", "default", motion ? "in the motion" : "", ""}};
  for (size_t i = 0; i < model.coordinates.size(); ++i) {
    const Coordinate& coordinate = model.coordinates[i];
    const int index = static_cast<int>(i);
    const bool is_dependent =
        std::any_of(model.couplers.begin(),
                    model.couplers.end(),
                    [&](const CoordinateCoupler& coupler) {
                      return coupler.dependent == index;
                    });
    rows.push_back({coordinate.name,
                    UnitOfCoordinate(coordinate),
                    InUnits(coordinate.default_value, coordinate),
                    motion ? RangeIn(*motion, index, coordinate) : "",
                    is_dependent           ? "follows others"
                    : coordinate.is_locked ? "locked"
                                           : ""});
  }
  screen << "coordinates (" << model.coordinates.size() << "):\n";
  PrintColumns(rows, screen);
}

}  // namespace

void PrintModel(const std::string& path,
                const ModelSources& sources,
                std::ostream& screen) {
  const Model model = ReadModel(path);
  std::optional<CoordinateMotion> motion;
  if (!sources.motion.empty()) {
    motion = MotionOf(model,
                      ReadStorageTable(sources.motion),
                      sources.motion,
                      sources.motion_in_degrees);
  }
  screen << "model " << model.name << " (" << path << ")\n";
  PrintBodies(model, GeometryFolders(model, sources.geometry), screen);
  PrintMuscles(model, screen);
  PrintCoordinates(model, motion, screen);
  if (motion) {
    screen << "motion " << sources.motion << ": " << motion->times.size()
           << " rows, " << motion->times.front() << " to "
           << motion->times.back() << " s\n";
  }
  std::vector<std::string> warnings = model.warnings;
  if (motion) {
    warnings.insert(
        warnings.end(), motion->warnings.begin(), motion->warnings.end());
  }
  for (const std::string& warning : warnings) {
    screen << "warning: " << warning << "\n";
  }
}

}  // namespace musclewarp
