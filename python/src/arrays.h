// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <Eigen/Core>
#include <memory>
#include <string>

#include "musclewarp/mesh/triangle_soup.h"

namespace musclewarp::python {

// Convert what Python users give to what the library takes. Anything that numpy
// makes an array of is allowed: lists, arrays of other types of numbers, in any
// order, read-only or with gaps. Throw InputError, whose place is `where`, for
// what is not an array of real numbers, has another shape, is not finite, or is
// out of range.

// Points, (n, 3), mm.
Points PointsFrom(const pybind11::handle& object, const std::string& where);

// Triangles, (m, 3) whole numbers from 0 to num_points - 1.
Triangles TrianglesFrom(const pybind11::handle& object,
                        Eigen::Index num_points,
                        const std::string& where);

// The millimetres in a unit of length, "mm", "cm" or "m".
double MillimetresFrom(const std::string& unit, const std::string& where);

// A rigid motion, (4, 4), translation in mm.
Eigen::Matrix4d RigidMotionFrom(const pybind11::handle& object,
                                const std::string& where);

// Makes an array that shows a matrix or vector without a copy. It is read-only,
// and keeps the owner of the numbers alive.
template <typename Matrix>
pybind11::array ViewOf(const Matrix& numbers,
                       std::shared_ptr<const void> owner) {
  using Number = typename Matrix::Scalar;
  constexpr auto kSize = static_cast<pybind11::ssize_t>(sizeof(Number));
  const pybind11::capsule base(
      new std::shared_ptr<const void>(std::move(owner)), [](void* pointer) {
        delete static_cast<std::shared_ptr<const void>*>(pointer);
      });
  std::vector<pybind11::ssize_t> shape = {numbers.rows()};
  std::vector<pybind11::ssize_t> strides = {numbers.rowStride() * kSize};
  if (Matrix::ColsAtCompileTime != 1) {
    shape.push_back(numbers.cols());
    strides.push_back(numbers.colStride() * kSize);
  }
  pybind11::array view(
      pybind11::dtype::of<Number>(), shape, strides, numbers.data(), base);
  view.attr("setflags")(pybind11::arg("write") = false);
  return view;
}

// Makes an array of its own.
template <typename Matrix>
pybind11::array CopyOf(const Matrix& numbers) {
  const auto copy =
      std::make_shared<const typename Matrix::PlainObject>(numbers);
  return ViewOf(*copy, copy);
}

}  // namespace musclewarp::python
