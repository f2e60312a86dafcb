// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "python/src/json.h"

namespace musclewarp::python {

namespace py = pybind11;

py::object FromJson(const nlohmann::ordered_json& json) {
  // Names of files that are not UTF-8 may be in it.
  const auto on_error = nlohmann::ordered_json::error_handler_t::replace;
  return py::module_::import("json").attr("loads")(
      json.dump(-1, ' ', false, on_error));
}

}  // namespace musclewarp::python
