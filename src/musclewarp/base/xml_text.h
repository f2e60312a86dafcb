// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace musclewarp {

// The text of an XML file, whatever encoding it was in.
struct XmlText {
  std::string utf8;  // valid UTF-8, without a byte order mark

  // True if the bytes are not in the encoding that the file names, nor in
  // UTF-8, or if it names one that is not known: the text is then that of
  // Latin-1.
  bool is_guessed = false;
};

// Decodes the bytes of an XML file: UTF-8 and UTF-16 with a byte order mark or
// without, Latin-1 (ISO-8859-1) and windows-1252 as the declaration names them.
// Bytes that are valid UTF-8 are taken as such, whatever the file names, as
// programs write UTF-8 under the declarations of the files that they read. What
// UTF-16 does not define becomes U+FFFD.
XmlText DecodeXml(const std::string& bytes);

// Returns the text with a declaration, if it has one that names an encoding,
// that names UTF-8. A text without one is UTF-8 by the rules of XML, and stays.
std::string WithUtf8Declaration(std::string utf8);

// Returns the text with entities for what ends a text between tags or an
// attribute in double quotes.
std::string XmlEscaped(const std::string& text);

}  // namespace musclewarp
