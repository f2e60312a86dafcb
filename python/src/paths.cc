// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include <pybind11/eigen.h>
#include <pybind11/stl.h>

#include <memory>
#include <sstream>
#include <utility>

#include "musclewarp/base/input_error.h"
#include "musclewarp/exchange/fitted_paths.h"
#include "musclewarp/run/frame_files.h"
#include "musclewarp/scene/scene_names.h"
#include "python/src/arrays.h"
#include "python/src/bindings.h"
#include "python/src/call.h"
#include "python/src/json.h"
#include "python/src/run_of_deformer.h"

namespace musclewarp::python {
namespace {

namespace py = pybind11;
using Rows =
    Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

constexpr char kPathsDoc[] =
    R"(Lengths and moment arms of paths as functions of joint coordinates.

    paths = run.fit_paths()
    arms = paths.moment_arms(q)         # (n, paths, coordinates), mm per rad or m
    paths["psoas_r"].coefficients

Each length is one polynomial, of which the moment arms are derivatives
(docs/export.md). Outside the range of the run functions go on linearly.

Attributes:
    names: of the paths.
    coordinates: names of the columns of `q`.)";

constexpr char kPathDoc[] =
    R"(The length of a path: sum_i coefficients[i] * prod_k q[k]**exponents[i, k].

Attributes:
    name, muscle: of the path, and of the muscle that carries it.
    coordinates: the names of those on which it depends.
    exponents: (terms, coordinates).
    coefficients: (terms,), mm, for coordinates in rad or m.
    low, high: (coordinates,), the range in which it holds.
    figures: errors on held-back postures and more, as in fit.json.)";

constexpr char kLengthsDoc[] =
    R"(Returns the lengths of all paths, (n, paths), mm.

Args:
    q: (n, coordinates) or (coordinates,), rad or m.)";

constexpr char kArmsDoc[] =
    R"(Returns the moment arms -dl/dq, (n, paths, coordinates), mm per rad or m.

Args:
    q: (n, coordinates) or (coordinates,), rad or m.)";

constexpr char kInsideDoc[] =
    R"(Returns where the functions hold: (n, paths), False beyond their range.

Args:
    q: (n, coordinates) or (coordinates,), rad or m.)";

// The paths refer to what was measured.
struct PathsOfRun {
  RunPaths measured;
  PathBounds bounds;
  FittedPaths fitted;
  nlohmann::ordered_json record;
};
using SharedPaths = std::shared_ptr<const PathsOfRun>;

struct PathOfRun {
  SharedPaths paths;
  size_t index = 0;

  const FittedPath& path() const { return paths->fitted.paths[index]; }
  const PathFunction& function() const { return path().fit.path; }
};

SharedPaths Fitted(RunPaths measured) {
  const auto paths = std::make_shared<PathsOfRun>();
  paths->measured = std::move(measured);
  paths->fitted = FitPaths(paths->measured, paths->bounds);
  paths->record = FitJson(paths->measured, paths->fitted, paths->bounds);
  return paths;
}

void CheckPathsPerMuscle(int paths_per_muscle) {
  if (paths_per_muscle >= 0) return;
  throw InputError("paths_per_muscle",
                   "is " + std::to_string(paths_per_muscle),
                   "allowed: 0 (lines) and above (bands of fibres)");
}

SharedPaths FitRun(const RunOfDeformer& run, int paths_per_muscle) {
  CheckPathsPerMuscle(paths_per_muscle);
  const Scene& scene = run.basis->scene->scene;
  if (!scene.model) {
    throw InputError("run",
                     "has no model",
                     "deform a scene with a model; others have no moment arms");
  }
  MeasuredRun measured;
  measured.name = "run";
  measured.contact = run.basis->contact.name;
  measured.is_of_design = !scene.design.empty();
  for (const SharedFrame& frame : run.frames) {
    measured.frames.push_back(FiguresOf(frame->frame));
  }
  measured.at_rest = LinesOf(*run.basis->scene, run.basis->rest);
  return ComputeFree([model = scene.model, measured, paths_per_muscle] {
    return Fitted(PathsOf(model->model, {measured}, paths_per_muscle));
  });
}

SharedPaths FitFolders(const std::vector<std::string>& folders,
                       const std::string& model,
                       int paths_per_muscle) {
  CheckPathsPerMuscle(paths_per_muscle);
  return ComputeFree(
      [=] { return Fitted(ReadRunPaths(folders, model, paths_per_muscle)); });
}

// Returns q as rows. Throws InputError if it has another shape.
Rows PosturesFrom(const PathsOfRun& paths, const py::handle& q) {
  const auto count =
      static_cast<py::ssize_t>(paths.measured.coordinates.size());
  const auto array =
      py::array_t<double, py::array::c_style | py::array::forcecast>::ensure(q);
  const bool is_row = array && array.ndim() == 1 && array.shape(0) == count;
  if (!array) PyErr_Clear();
  if (!is_row && (!array || array.ndim() != 2 || array.shape(1) != count)) {
    throw InputError("q",
                     "is no array of postures",
                     "give (n, " + std::to_string(count) +
                         ") numbers, a column for each of `coordinates`");
  }
  const py::ssize_t rows = is_row ? 1 : array.shape(0);
  return Eigen::Map<const Rows>(array.data(), rows, count);
}

// Calls `use` with the value of every path in every posture.
template <typename Use>
void EvaluateAll(const PathsOfRun& paths, const Rows& q, const Use& use) {
  PathValue value;
  for (Eigen::Index i = 0; i < q.rows(); ++i) {
    const Eigen::VectorXd at = q.row(i);
    for (size_t p = 0; p < paths.fitted.paths.size(); ++p) {
      const PathFunction& path = paths.fitted.paths[p].fit.path;
      Evaluate(path, at(path.coordinates), &value);
      use(i, p, path, value);
    }
  }
}

// Returns one number of every path in every posture, (n, paths).
template <typename Number, typename NumberOf>
py::array TableOf(const PathsOfRun& paths,
                  const py::handle& q,
                  const NumberOf& number_of) {
  const Rows postures = PosturesFrom(paths, q);
  py::array_t<Number> table(std::vector<size_t>{
      static_cast<size_t>(postures.rows()), paths.fitted.paths.size()});
  auto out = table.template mutable_unchecked<2>();
  EvaluateAll(paths,
              postures,
              [&](auto i, auto p, const auto& /*path*/, const auto& v) {
                out(i, p) = number_of(v);
              });
  return std::move(table);
}

py::array Lengths(const PathsOfRun& paths, const py::handle& q) {
  return TableOf<double>(
      paths, q, [](const PathValue& value) { return value.length; });
}

py::array Inside(const PathsOfRun& paths, const py::handle& q) {
  return TableOf<bool>(
      paths, q, [](const PathValue& value) { return value.is_inside_range; });
}

py::array MomentArms(const PathsOfRun& paths, const py::handle& q) {
  const Rows postures = PosturesFrom(paths, q);
  py::array_t<double> arms(
      std::vector<size_t>{static_cast<size_t>(postures.rows()),
                          paths.fitted.paths.size(),
                          paths.measured.coordinates.size()});
  std::fill_n(arms.mutable_data(), arms.size(), 0.0);
  auto out = arms.mutable_unchecked<3>();
  EvaluateAll(
      paths, postures, [&](auto i, auto p, const auto& path, const auto& v) {
        for (size_t k = 0; k < path.coordinates.size(); ++k) {
          out(i, p, path.coordinates[k]) = v.arms[static_cast<int>(k)];
        }
      });
  return std::move(arms);
}

PathOfRun PathNamed(const SharedPaths& paths, const std::string& name) {
  for (size_t p = 0; p < paths->fitted.paths.size(); ++p) {
    if (paths->fitted.paths[p].path->name == name) return {paths, p};
  }
  throw py::key_error(name);
}

std::vector<std::string> CoordinatesOf(const PathOfRun& path) {
  std::vector<std::string> names;
  for (const int k : path.function().coordinates) {
    names.push_back(path.paths->measured.coordinates[k]);
  }
  return names;
}

void BindPath(py::module_* module) {
  py::class_<PathOfRun>(*module, "PathFunction", kPathDoc)
      .def_property_readonly(
          "name", [](const PathOfRun& self) { return self.path().path->name; })
      .def_property_readonly(
          "muscle",
          [](const PathOfRun& self) { return self.path().path->muscle; })
      .def_property_readonly("coordinates", &CoordinatesOf)
      .def_property_readonly("exponents",
                             [](const PathOfRun& self) {
                               return ViewOf(self.function().exponents,
                                             self.paths);
                             })
      .def_property_readonly("coefficients",
                             [](const PathOfRun& self) {
                               return ViewOf(self.function().coefficients,
                                             self.paths);
                             })
      .def_property_readonly("low",
                             [](const PathOfRun& self) {
                               return ViewOf(self.function().low, self.paths);
                             })
      .def_property_readonly("high",
                             [](const PathOfRun& self) {
                               return ViewOf(self.function().high, self.paths);
                             })
      .def_property_readonly(
          "figures",
          [](const PathOfRun& self) {
            return FromJson(
                self.paths->record["muscles"][self.path().path->name]);
          })
      .def("__repr__", [](const PathOfRun& self) {
        return "<musclewarp.PathFunction " +
               QuotedName(self.path().path->name) + ">";
      });
}

}  // namespace

void BindPaths(py::module_* module) {
  BindPath(module);
  py::class_<PathsOfRun, std::shared_ptr<PathsOfRun>>(
      *module, "PathFunctions", kPathsDoc)
      .def_property_readonly(
          "names",
          [](const PathsOfRun& paths) {
            std::vector<std::string> names;
            for (const FittedPath& path : paths.fitted.paths) {
              names.push_back(path.path->name);
            }
            return names;
          })
      .def_property_readonly(
          "coordinates",
          [](const PathsOfRun& paths) { return paths.measured.coordinates; })
      .def("lengths", &Lengths, py::arg("q"), kLengthsDoc)
      .def("moment_arms", &MomentArms, py::arg("q"), kArmsDoc)
      .def("inside", &Inside, py::arg("q"), kInsideDoc)
      .def(
          "record",
          [](const PathsOfRun& paths) { return FromJson(paths.record); },
          "Returns fit.json as a dict (docs/export.md).")
      .def("__getitem__",
           [](const std::shared_ptr<PathsOfRun>& paths,
              const std::string& name) { return PathNamed(paths, name); })
      .def("__len__",
           [](const PathsOfRun& paths) { return paths.fitted.paths.size(); })
      .def("__str__", [](const PathsOfRun& paths) {
        std::ostringstream text;
        PrintFits(paths.measured, paths.fitted, text);
        return text.str();
      });
  module->def("fit_run", &FitRun, py::arg("run"), py::arg("paths_per_muscle"));
  module->def("fit_folders",
              &FitFolders,
              py::arg("folders"),
              py::arg("model"),
              py::arg("paths_per_muscle"));
}

}  // namespace musclewarp::python
