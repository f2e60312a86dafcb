// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <pybind11/pybind11.h>

#include <nlohmann/json.hpp>

namespace musclewarp::python {

// Returns dicts, lists and numbers as json.loads() makes them of the text.
pybind11::object FromJson(const nlohmann::ordered_json& json);

}  // namespace musclewarp::python
