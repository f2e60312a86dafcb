// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string_view>

namespace musclewarp {

// A tag of an XML text: <Piece NumberOfPoints="3">, </Piece>, <Verts/>.
struct XmlTag {
  std::string_view text;  // What stands between the angle brackets.
  std::size_t end = 0;    // In the XML text, behind the closing bracket.

  // Without the slash of a closing tag.
  std::string_view name() const;
  bool is_closing() const { return text.substr(0, 1) == "/"; }
  bool is_empty_element() const;  // <Verts/>

  // The value as it stands, "" if there is no such attribute.
  std::string_view Attribute(std::string_view attribute) const;
};

// The next tag of the text from `at` on, without comments, declarations and
// processing instructions. False if there is none.
bool NextXmlTag(std::string_view text, std::size_t at, XmlTag* tag);

}  // namespace musclewarp
