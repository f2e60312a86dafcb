// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <initializer_list>
#include <pugixml.hpp>
#include <string>
#include <vector>

#include "musclewarp/opensim/osim_xml.h"

namespace musclewarp {

// The components of an OpenSim 4 model form a tree, in which a path such as
// "/bodyset/femur_r" or "../femur_r_offset" leads from one component to
// another. In the file a component is an element whose name begins with a
// capital letter; elements in lower case are its properties and do not count.

// Returns the name of a component: its attribute "name" or, without one, the
// name of its element in lower case, as OpenSim gives it.
std::string ComponentName(pugi::xml_node component);

// Returns the component that owns an element, such as the joint in whose
// <frames> it is. The result is empty for the model.
pugi::xml_node OwnerOf(pugi::xml_node element);

// Returns the component to which a path leads from `from`, or from the model if
// the path begins with a slash; ".." leads to the owner. The result is empty if
// there is no such component.
pugi::xml_node FindComponent(pugi::xml_node from, const std::string& path);

// Returns the element whose text is the path that satisfies a socket of a
// component, under the first of the socket's names that the component has. The
// forms of all versions of OpenSim 4 and its betas are known:
// <socket_parent_frame>, <connector_parent_frame_connectee_name>, and
// <connectors> with a <connectee_name> each. Empty if there is none.
pugi::xml_node FindSocket(pugi::xml_node component,
                          std::initializer_list<const char*> names);

// The same for a socket that must exist; throws InputError at the component.
pugi::xml_node SocketOf(const OsimXml& xml,
                        pugi::xml_node component,
                        std::initializer_list<const char*> names);

// Returns the elements with a name, wherever they are in the model but for its
// <defaults>.
std::vector<pugi::xml_node> ElementsNamed(pugi::xml_node model,
                                          const std::string& name);

}  // namespace musclewarp
