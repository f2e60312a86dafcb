// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "musclewarp/opensim/function.h"
#include "musclewarp/opensim/osim_xml.h"

namespace musclewarp {

// The function element that `node` keeps as its property `property`: OpenSim 3
// wraps it (<function><Constant/></function>), OpenSim 4 names it (<Constant
// name="function"/>). Empty if there is none.
pugi::xml_node FunctionElement(pugi::xml_node node, const char* property);

// Null, with the reason in `unsupported`, if this project does not know the
// kind of function. Throws InputError for one it knows that is not sound.
FunctionPtr ReadFunction(const OsimXml& xml,
                         pugi::xml_node element,
                         std::string* unsupported);

}  // namespace musclewarp
