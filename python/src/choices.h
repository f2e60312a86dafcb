// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <pybind11/pybind11.h>

#include <functional>

#include "musclewarp/base/input_error.h"
#include "musclewarp/deformer/deformer.h"

namespace musclewarp::python {

// Returns the options that keywords mean, which are the flags of
// musclewarp-deform by name (tools/deformer_settings.h). Throws InputError that
// names the keyword.
DeformerOptions OptionsFrom(const pybind11::dict& keywords);

// The defaults, as keywords.
pybind11::dict DefaultChoices();

// Calls a function of the programs. Where an error names a flag, "--gap", that
// of Python names the keyword, "gap".
void CallWithKeywords(const std::function<void()>& function);

}  // namespace musclewarp::python
