// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <pugixml.hpp>
#include <string>

namespace musclewarp {

// The elements of an .osim file, as pugixml writes them: it escapes what XML
// does not allow in names and texts.

// Returns a number that reads back as the same double, without a negative zero.
std::string ExactText(double number);

// Returns three such numbers with blanks between them.
std::string VectorText(const Eigen::Vector3d& vector);

// Adds <name>text</name>.
void AddText(pugi::xml_node parent, const char* name, const std::string& text);

// Adds <kind name="name"/> and returns it.
pugi::xml_node AddNamed(pugi::xml_node parent,
                        const char* kind,
                        const std::string& name);

// Adds a comment. "--", which would end it, becomes "- ".
void AddComment(pugi::xml_node parent, std::string text);

// Returns the path by which sockets name a body, or "ground".
std::string FramePathOf(const std::string& body);

}  // namespace musclewarp
