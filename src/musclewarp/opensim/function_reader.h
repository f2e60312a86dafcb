// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "musclewarp/opensim/function.h"
#include "musclewarp/opensim/osim_xml.h"

namespace musclewarp {

// Returns the element of the function that is the property `property` of
// `node`. OpenSim 3 wraps it (<function><Constant/></function>), while OpenSim
// 4 names it (<Constant name="function"/>). Returns an empty node if there is
// none.
pugi::xml_node FunctionElement(pugi::xml_node node, const char* property);

// Reads a function from its element. The known kinds are Constant,
// LinearFunction, PolynomialFunction, SimmSpline (with its older names),
// PiecewiseLinearFunction and MultiplierFunction.
//
// Returns null for other kinds and sets *unsupported to a text that names the
// kind and its line; such a function is an error only where a scene needs it.
// Throws InputError if a function of a known kind is not valid: it lacks
// coefficients, has a different number of x and y, fewer than two points, or x
// that do not ascend.
FunctionPtr ReadFunction(const OsimXml& xml,
                         pugi::xml_node element,
                         std::string* unsupported);

}  // namespace musclewarp
