// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "python/src/arrays.h"

#include <vector>

#include "musclewarp/base/input_error.h"
#include "musclewarp/scene/coordinate_limits.h"
#include "musclewarp/scene/length_unit.h"
#include "musclewarp/scene/rigid_motion.h"

namespace musclewarp::python {
namespace {

namespace py = pybind11;

std::string ShapeText(const py::array& array) {
  std::string text;
  for (py::ssize_t i = 0; i < array.ndim(); ++i) {
    text += (i > 0 ? ", " : "") + std::to_string(array.shape(i));
  }
  return "(" + text + (array.ndim() == 1 ? ",)" : ")");
}

// An array of numbers of the kinds in `kinds` (as numpy has them) with a shape,
// where -1 stands for any number of rows.
py::array ArrayFrom(const py::handle& object,
                    const std::string& kinds,
                    int rows,
                    int cols,
                    const std::string& allowed,
                    const std::string& where) {
  const py::array array = py::array::ensure(object);
  if (!array) {
    throw InputError(
        where,
        "is no array of numbers, but " +
            py::str(py::type::of(object).attr("__name__")).cast<std::string>(),
        "allowed: " + allowed);
  }
  if (kinds.find(array.dtype().kind()) == std::string::npos) {
    throw InputError(
        where,
        "has the type " + py::str(array.dtype()).cast<std::string>(),
        "allowed: " + allowed);
  }
  if (array.ndim() != 2 || array.shape(1) != cols ||
      (rows >= 0 && array.shape(0) != rows)) {
    throw InputError(
        where, "has the shape " + ShapeText(array), "allowed: " + allowed);
  }
  return array;
}

template <typename Number>
using RowMajorArray =
    py::array_t<Number, py::array::c_style | py::array::forcecast>;

template <typename Number>
RowMajorArray<Number> ConvertedTo(const py::array& array,
                                  const std::string& where) {
  auto converted = RowMajorArray<Number>::ensure(array);
  if (!converted) {
    throw InputError(where, "cannot be converted", "give an array of numbers");
  }
  return converted;
}

}  // namespace

Points PointsFrom(const py::handle& object, const std::string& where) {
  const auto numbers = ConvertedTo<double>(
      ArrayFrom(object, "fiu", -1, 3, "(n, 3) real numbers, mm", where), where);
  const Points points =
      Eigen::Map<const Points>(numbers.data(), numbers.shape(0), 3);
  CheckCoordinates(where, points);
  return points;
}

Triangles TrianglesFrom(const py::handle& object,
                        Eigen::Index num_points,
                        const std::string& where) {
  const auto numbers = ConvertedTo<int64_t>(
      ArrayFrom(object, "iu", -1, 3, "(m, 3) whole numbers", where), where);
  const auto indices = numbers.unchecked<2>();
  Triangles triangles(indices.shape(0), 3);
  for (py::ssize_t f = 0; f < indices.shape(0); ++f) {
    for (int k = 0; k < 3; ++k) {
      const int64_t v = indices(f, k);
      if (v < 0 || v >= num_points) {
        throw InputError(where + ": triangle " + std::to_string(f),
                         "names point " + std::to_string(v) +
                             ", the mesh has " + std::to_string(num_points),
                         num_points > 0
                             ? "allowed: 0 to " + std::to_string(num_points - 1)
                             : "give points, too");
      }
      triangles(f, k) = static_cast<int>(v);
    }
  }
  return triangles;
}

double MillimetresFrom(const std::string& unit, const std::string& where) {
  const std::optional<double> mm_per_unit = MillimetresPer(unit);
  if (mm_per_unit) return *mm_per_unit;
  throw InputError(
      where, "has the units " + unit, std::string("allowed: ") + kLengthUnits);
}

Eigen::Matrix4d RigidMotionFrom(const py::handle& object,
                                const std::string& where) {
  const std::string allowed =
      "(4, 4) real numbers, a rotation and a translation in mm";
  const auto numbers = ConvertedTo<double>(
      ArrayFrom(object, "fiu", 4, 4, allowed, where), where);
  using RowMajor = Eigen::Matrix<double, 4, 4, Eigen::RowMajor>;
  const Eigen::Matrix4d motion = Eigen::Map<const RowMajor>(numbers.data());
  CheckCoordinates(where, motion);
  const std::string fault = RigidMotionFault(motion);
  if (!fault.empty()) throw InputError(where, fault, "allowed: " + allowed);
  return motion;
}

}  // namespace musclewarp::python
