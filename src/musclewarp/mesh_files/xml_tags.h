// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string_view>

namespace musclewarp {

// Finds the tags of a .vtp file. That is not quite XML: behind <AppendedData>
// follow raw bytes, at which an XML parser gives up. All texts below are views
// into the file.

// What stands between attributes, and around numbers and data.
constexpr std::string_view kXmlBlanks = " \t\r\n";

// A tag: <Piece NumberOfPoints="3">, </Piece>, or <Verts/>.
struct XmlTag {
  // What stands between the angle brackets.
  std::string_view text;
  // The position behind the closing bracket in the XML text: where to look for
  // the next tag.
  std::size_t end = 0;

  // Returns the name of the element, without the slash of a closing tag.
  std::string_view name() const;
  // True for </Piece>.
  bool is_closing() const { return text.substr(0, 1) == "/"; }
  // True for <Verts/>, which has no closing tag.
  bool is_empty_element() const;

  // Returns the value of an attribute between its quotes, entities such as &lt;
  // left as they are; "" if the tag has no such attribute.
  std::string_view Attribute(std::string_view attribute) const;
};

// Sets `tag` to the next tag at or behind position `at`; comments, declarations
// and processing instructions are passed over. Returns false if there is none.
bool NextXmlTag(std::string_view text, std::size_t at, XmlTag* tag);

}  // namespace musclewarp
