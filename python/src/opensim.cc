// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <cmath>
#include <filesystem>

#include "musclewarp/base/input_error.h"
#include "musclewarp/base/output_file.h"
#include "musclewarp/opensim/coordinate_motion.h"
#include "musclewarp/opensim/kinematics.h"
#include "musclewarp/opensim/storage_table.h"
#include "musclewarp/scene/scene_names.h"
#include "python/src/arrays.h"
#include "python/src/bindings.h"
#include "python/src/call.h"

namespace musclewarp::python {
namespace {

namespace py = pybind11;
using SharedModel = std::shared_ptr<Model>;
using SharedTable = std::shared_ptr<StorageTable>;
using Coordinates = std::map<std::string, double>;

template <typename Part>
std::vector<std::string> NamesOf(const std::vector<Part>& parts) {
  std::vector<std::string> names;
  for (const Part& part : parts) names.push_back(part.name);
  return names;
}

int Found(int idx, const std::string& what, const std::string& name) {
  if (idx >= 0) return idx;
  throw InputError(what + " " + QuotedName(name),
                   "is not in the model",
                   "the model lists its parts by name");
}

// The values of all coordinates: the defaults but for those given.
CoordinateValues ValuesOf(const Model& model, const Coordinates& given) {
  CoordinateValues values = DefaultValues(model);
  for (const auto& [name, value] : given) {
    const int c = Found(model.FindCoordinate(name), "coordinate", name);
    if (!std::isfinite(value)) {
      throw InputError("coordinate " + QuotedName(name),
                       "is " + std::to_string(value),
                       "allowed: finite numbers, rad or m");
    }
    values[c] = value;
  }
  ApplyCouplers(model, &values);
  return values;
}

Coordinates ByName(const Model& model, const CoordinateValues& values) {
  Coordinates named;
  for (size_t c = 0; c < values.size(); ++c) {
    named[model.coordinates[c].name] = values[c];
  }
  return named;
}

std::map<std::string, py::array> FramesOfBodies(const Model& model,
                                                const Coordinates& given) {
  const auto frames = BodyFrames(model, ValuesOf(model, given));
  std::map<std::string, py::array> named;
  for (size_t b = 0; b < frames.size(); ++b) {
    named.emplace(model.bodies[b].name, CopyOf(frames[b]));
  }
  return named;
}

const ModelMuscle& SupportedMuscle(const Model& model,
                                   const std::string& name) {
  const int m = Found(model.FindMuscle(name), "muscle", name);
  CheckMuscleIsSupported(model, m);
  return model.muscles[m];
}

py::array PointsOfPath(const Model& model,
                       const std::string& muscle,
                       const Coordinates& given) {
  const ModelMuscle& path = SupportedMuscle(model, muscle);
  const CoordinateValues values = ValuesOf(model, given);
  return CopyOf(PathPoints(path, BodyFrames(model, values), values));
}

double LengthOfPath(const Model& model,
                    const std::string& muscle,
                    const Coordinates& given) {
  const ModelMuscle& path = SupportedMuscle(model, muscle);
  const CoordinateValues values = ValuesOf(model, given);
  return PathLength(path, BodyFrames(model, values), values);
}

double MomentArm(const Model& model,
                 const std::string& muscle,
                 const std::string& coordinate,
                 const Coordinates& given) {
  const ModelMuscle& path = SupportedMuscle(model, muscle);
  const int c =
      Found(model.FindCoordinate(coordinate), "coordinate", coordinate);
  return PathMomentArm(model, path, c, ValuesOf(model, given));
}

std::vector<std::pair<double, Coordinates>> ReadMotion(
    const SharedModel& model,
    const std::filesystem::path& path,
    const std::optional<bool>& in_degrees) {
  const std::string file = path.string();
  const CoordinateMotion motion = ComputeFree([=] {
    return MotionOf(*model, ReadStorageTable(file), file, in_degrees);
  });
  std::vector<std::pair<double, Coordinates>> rows;
  for (size_t i = 0; i < motion.times.size(); ++i) {
    rows.emplace_back(motion.times[i], ByName(*model, motion.values[i]));
  }
  return rows;
}

py::array ColumnOf(const SharedTable& table, const std::string& label) {
  for (size_t k = 0; k < table->labels.size(); ++k) {
    if (table->labels[k] != label) continue;
    return ViewOf(table->values.col(static_cast<Eigen::Index>(k)), table);
  }
  throw py::key_error(QuotedName(label) + " is no column of the table");
}

void BindTables(py::module_* module) {
  py::class_<StorageTable, SharedTable>(
      *module,
      "Table",
      R"(A table over time, as OpenSim has it in .sto and .mot files; in their units.

table["hip_flexion_r"] is a column.

Attributes:
    name: of the table.
    labels: of the columns, without "time".
    times: (t,), s.
    values: (t, number of labels).
    in_degrees: whether angles are; None if the file does not say.
    warnings: where header and rows of the file disagree.)")
      .def_readonly("name", &StorageTable::name)
      .def_readonly("labels", &StorageTable::labels)
      .def_readonly("in_degrees", &StorageTable::in_degrees)
      .def_readonly("warnings", &StorageTable::warnings)
      .def_property_readonly(
          "times",
          [](const SharedTable& table) {
            return ViewOf(Eigen::Map<const Eigen::VectorXd>(
                              table->times.data(),
                              static_cast<Eigen::Index>(table->times.size())),
                          table);
          })
      .def_property_readonly(
          "values",
          [](const SharedTable& table) { return ViewOf(table->values, table); })
      .def("__getitem__", &ColumnOf, py::arg("label"))
      .def("__contains__",
           [](const StorageTable& table, const std::string& label) {
             return std::count(
                        table.labels.begin(), table.labels.end(), label) > 0;
           })
      .def("__len__",
           [](const StorageTable& table) { return table.times.size(); })
      .def(
          "write",
          [](const SharedTable& table, const std::filesystem::path& path) {
            RunFree([=] {
              WriteTextAtomically(path.string(), StorageText(*table));
            });
          },
          py::arg("path"),
          "Writes the table as an OpenSim file.");
  module->def(
      "read_table",
      [](const std::filesystem::path& path) {
        return ComputeFree([path] {
          return std::make_shared<StorageTable>(
              ReadStorageTable(path.string()));
        });
      },
      py::arg("path"),
      "Reads a table of OpenSim or SIMM (.sto, .mot). Raises InputError that "
      "names the line.");
}

void BindModelClass(py::module_* module) {
  py::class_<Model, SharedModel>(
      *module,
      "Model",
      R"(An OpenSim model: bodies, joints and paths of muscles (docs/motion.md).

Coordinates are given as a dict by name, in rad, or m of translations; others
have their defaults, coupled ones follow.

Attributes:
    name, path: of the model and its file.
    bodies, muscles: their names.
    coordinates: their default values by name.
    warnings: what of the file is ignored.)")
      .def_readonly("name", &Model::name)
      .def_readonly("path", &Model::path)
      .def_readonly("warnings", &Model::warnings)
      .def_property_readonly(
          "bodies", [](const Model& model) { return NamesOf(model.bodies); })
      .def_property_readonly(
          "muscles", [](const Model& model) { return NamesOf(model.muscles); })
      .def_property_readonly("coordinates",
                             [](const Model& model) {
                               return ByName(model, DefaultValues(model));
                             })
      .def("body_frames",
           &FramesOfBodies,
           py::arg("coordinates"),
           "Returns ground_from_body (4, 4), mm, of every body by name.")
      .def("path_points",
           &PointsOfPath,
           py::arg("muscle"),
           py::arg("coordinates"),
           "Returns the active points of a path in the ground frame (p, 3), "
           "mm.")
      .def("path_length",
           &LengthOfPath,
           py::arg("muscle"),
           py::arg("coordinates"),
           "Returns the length through the active points of a path, mm. "
           "Wrapping is ignored.")
      .def("moment_arm",
           &MomentArm,
           py::arg("muscle"),
           py::arg("coordinate"),
           py::arg("coordinates"),
           "Returns -dl/dq of a path, mm per rad (or per m), by central "
           "differences.")
      .def("read_motion",
           &ReadMotion,
           py::arg("path"),
           py::arg("in_degrees") = py::none(),
           "Returns the time (s) and all coordinates (rad or m, by name) of "
           "every row of an OpenSim motion. in_degrees: whether angles are in "
           "degrees, whatever the header says.");
}

}  // namespace

void BindOpenSim(py::module_* module) {
  BindTables(module);
  BindModelClass(module);
  module->def(
      "read_model",
      [](const std::filesystem::path& path) {
        return ComputeFree([path] {
          return std::make_shared<Model>(ReadModel(path.string()));
        });
      },
      py::arg("path"),
      "Reads an OpenSim model (.osim, versions 2 to 4). Raises InputError that "
      "names the line and the element.");
}

}  // namespace musclewarp::python
