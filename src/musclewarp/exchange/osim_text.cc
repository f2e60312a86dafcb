// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/exchange/osim_text.h"

#include <algorithm>

#include "musclewarp/base/input_error.h"

namespace musclewarp {

std::string WithEdits(std::string text, std::vector<TextEdit> edits) {
  std::sort(edits.begin(), edits.end(), [](const auto& a, const auto& b) {
    return a.begin > b.begin;
  });
  for (const TextEdit& edit : edits) {
    text.replace(edit.begin, edit.end - edit.begin, edit.text);
  }
  return text;
}

void ParseOsim(const std::string& text,
               const std::string& where,
               pugi::xml_document* document) {
  const auto result = document->load_buffer(
      text.data(), text.size(), pugi::parse_default, pugi::encoding_utf8);
  if (result) return;
  throw InputError(where,
                   std::string("is not XML: ") + result.description(),
                   "save the model with OpenSim again");
}

pugi::xml_node OwnerOfPath(pugi::xml_node path) {
  const pugi::xml_node parent = path.parent();
  return std::string(parent.name()) == "path" ? parent.parent() : parent;
}

pugi::xml_node PathOfMuscle(const pugi::xml_document& document,
                            const std::string& where,
                            const std::string& muscle) {
  pugi::xml_node path;
  int count = 0;
  document.find_node([&](pugi::xml_node node) {
    if (std::string(node.name()) == kGeometryPath &&
        OwnerOfPath(node).attribute("name").value() == muscle && ++count == 1) {
      path = node;
    }
    return false;
  });
  if (count > 1) {
    throw InputError(where,
                     "has " + std::to_string(count) + " muscles named \"" +
                         muscle + "\", and one path is for one of them",
                     "give every muscle of the model a name of its own");
  }
  if (path) return path;
  throw InputError(where,
                   "has no muscle \"" + muscle + "\" with a <GeometryPath>",
                   "give the model that the run was made with");
}

size_t BeginOf(pugi::xml_node element) {
  return static_cast<size_t>(element.offset_debug()) - 1;
}

size_t EndOfStartTag(const std::string& text, pugi::xml_node element) {
  char quote = 0;
  for (size_t i = BeginOf(element); i < text.size(); ++i) {
    const char c = text[i];
    if (quote == 0 && c == '>') return i + 1;
    if (quote == 0 && (c == '"' || c == '\'')) {
      quote = c;
    } else if (c == quote) {
      quote = 0;
    }
  }
  return text.size();
}

size_t EndOf(const std::string& text, pugi::xml_node element) {
  const size_t after_start = EndOfStartTag(text, element);
  if (text.compare(after_start - 2, 2, "/>") == 0) return after_start;
  // The end tags of elements in it come first, and comments may hold anything.
  size_t i = after_start;
  for (const pugi::xml_node child : element.children()) {
    if (child.type() == pugi::node_element) i = EndOf(text, child);
  }
  while (i < text.size()) {
    if (text.compare(i, 4, "<!--") == 0) {
      i = std::min(text.find("-->", i), text.size());
    } else if (text.compare(i, 2, "</") == 0) {
      return text.find('>', i) + 1;
    } else {
      ++i;
    }
  }
  return i;
}

std::string IndentAt(const std::string& text, size_t position) {
  const size_t start = text.find_last_of('\n', position) + 1;
  const size_t end = text.find_first_not_of(" \t", start);
  return text.substr(start, std::min(end, position) - start);
}

}  // namespace musclewarp
