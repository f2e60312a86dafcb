// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <pybind11/pybind11.h>

namespace musclewarp::python {

// Each adds one concept to the module.
void BindErrors(pybind11::module_* module);
void BindSettings(pybind11::module_* module);
void BindLog(pybind11::module_* module);
void BindMeshes(pybind11::module_* module);
void BindSceneParts(pybind11::module_* module);
void BindScene(pybind11::module_* module);
void BindFrames(pybind11::module_* module);
void BindDeformer(pybind11::module_* module);
void BindRun(pybind11::module_* module);
void BindPaths(pybind11::module_* module);
void BindChecks(pybind11::module_* module);
void BindLabels(pybind11::module_* module);
void BindJoints(pybind11::module_* module);
void BindOpenSim(pybind11::module_* module);

// Hands what the library has logged since then to Python's logging, as the
// logger "musclewarp". Precondition: the interpreter is held.
void ForwardLog();

}  // namespace musclewarp::python
