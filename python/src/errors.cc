// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/base/input_error.h"
#include "musclewarp/base/setting_names.h"

#include "python/src/bindings.h"

namespace musclewarp::python {
namespace {

namespace py = pybind11;

void RaiseInputError(const InputError& error) {
  const py::object type =
      py::module_::import("musclewarp._errors").attr("InputError");
  const py::object raised = type(WithFieldNames(error.where()),
                                 WithFieldNames(error.problem()),
                                 WithFieldNames(error.advice()));
  PyErr_SetObject(type.ptr(), raised.ptr());
}

}  // namespace

void BindErrors(py::module_* /*module*/) {
  // pybind11 wants a function that takes the pointer by value.
  // NOLINTNEXTLINE(performance-unnecessary-value-param)
  py::register_exception_translator([](std::exception_ptr thrown) {
    try {
      if (thrown) std::rethrow_exception(thrown);
    } catch (const InputError& error) {
      RaiseInputError(error);
    }
  });
}

}  // namespace musclewarp::python
