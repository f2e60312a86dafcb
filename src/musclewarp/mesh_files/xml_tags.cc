// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/mesh_files/xml_tags.h"

namespace musclewarp {
namespace {

constexpr std::size_t kNone = std::string_view::npos;

// Returns the position of the '>' that ends the tag that begins at `begin`; one
// in quotes does not end it.
std::size_t FindTagEnd(std::string_view text, std::size_t begin) {
  std::size_t at = text.find_first_of("\"'>", begin);
  while (at != kNone && text[at] != '>') {
    at = text.find(text[at], at + 1);
    if (at != kNone) at = text.find_first_of("\"'>", at + 1);
  }
  return at;
}

}  // namespace

std::string_view XmlTag::name() const {
  const std::string_view rest = text.substr(is_closing() ? 1 : 0);
  return rest.substr(0, rest.find_first_of(" \t\r\n/"));
}

bool XmlTag::is_empty_element() const {
  return !text.empty() && text.back() == '/';
}

std::string_view XmlTag::Attribute(std::string_view attribute) const {
  std::size_t at = text.find_first_of(kXmlBlanks);
  while (at != kNone) {
    const std::size_t begin = text.find_first_not_of(kXmlBlanks, at);
    const std::size_t equals = text.find('=', at);
    if (begin == kNone || equals == kNone) return "";
    const std::size_t open = text.find_first_of("\"'", equals);
    if (open == kNone) return "";
    const std::size_t close = text.find(text[open], open + 1);
    if (close == kNone) return "";
    const std::string_view found = text.substr(begin, equals - begin);
    if (found.substr(0, found.find_first_of(kXmlBlanks)) == attribute) {
      return text.substr(open + 1, close - open - 1);
    }
    at = close + 1;
  }
  return "";
}

bool NextXmlTag(std::string_view text, std::size_t at, XmlTag* tag) {
  constexpr std::string_view kComment = "<!--";
  while (true) {
    const std::size_t begin = text.find('<', at);
    if (begin == kNone) return false;
    if (text.substr(begin, kComment.size()) == kComment) {
      at = text.find("-->", begin + kComment.size());
      if (at == kNone) return false;
      continue;
    }
    const std::size_t end = FindTagEnd(text, begin);
    if (end == kNone) return false;
    *tag = {text.substr(begin + 1, end - begin - 1), end + 1};
    if (tag->text.empty() || (tag->text[0] != '?' && tag->text[0] != '!')) {
      return true;
    }
    at = end + 1;
  }
}

}  // namespace musclewarp
