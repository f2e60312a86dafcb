// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <pugixml.hpp>
#include <string>
#include <vector>

namespace musclewarp {

// Changes of the text of an OpenSim model that leave all other bytes as they
// are. The text is UTF-8, parsed by ParseOsim(); nodes know where they are in
// it (offset_debug()).

constexpr char kGeometryPath[] = "GeometryPath";

// A piece of a text and what stands there instead.
struct TextEdit {
  size_t begin = 0, end = 0;
  std::string text;
};

// Returns the text with pieces replaced. They may not overlap.
std::string WithEdits(std::string text, std::vector<TextEdit> edits);

// Parses a text. Throws InputError, naming `where`, if it is not XML.
void ParseOsim(const std::string& text,
               const std::string& where,
               pugi::xml_document* document);

// Returns the <GeometryPath> of a muscle. Throws InputError if there is none,
// or more than one.
pugi::xml_node PathOfMuscle(const pugi::xml_document& document,
                            const std::string& where,
                            const std::string& muscle);

// Returns the element that has a path as its own: the muscle.
pugi::xml_node OwnerOfPath(pugi::xml_node path);

// Returns the position of the start tag of an element, and those after its
// start tag and after its end tag.
size_t BeginOf(pugi::xml_node element);
size_t EndOfStartTag(const std::string& text, pugi::xml_node element);
size_t EndOf(const std::string& text, pugi::xml_node element);

// Returns the white space before a position in its line.
std::string IndentAt(const std::string& text, size_t position);

}  // namespace musclewarp
