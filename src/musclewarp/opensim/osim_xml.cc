// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/opensim/osim_xml.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstring>
#include <utility>

#include "musclewarp/base/input_error.h"
#include "musclewarp/base/nesting.h"
#include "musclewarp/base/xml_text.h"
#include "musclewarp/mesh_files/text_cursor.h"

namespace musclewarp {
namespace {

int LineAt(const std::string& text, std::ptrdiff_t offset) {
  const auto end = std::min<std::ptrdiff_t>(offset, text.size());
  return 1 + static_cast<int>(
                 std::count(text.begin(),
                            text.begin() + std::max<std::ptrdiff_t>(0, end),
                            '\n'));
}

// Goes through the elements without entering itself again.
class NestingCheck : public pugi::xml_tree_walker {
 public:
  explicit NestingCheck(const std::string& path) : path_(path) {}
  bool for_each(pugi::xml_node& /*node*/) override {
    CheckNesting(path_, depth());
    return true;
  }

 private:
  const std::string& path_;
};

bool IsBlank(char c) { return std::strchr(" \t\r\n,", c) != nullptr; }

}  // namespace

OsimXml::OsimXml(const std::string& bytes, const std::string& path)
    : path_(path) {
  XmlText text = DecodeXml(bytes);
  text_ = std::move(text.utf8);
  if (text.is_guessed) {
    warnings_.push_back(path + ": is not UTF-8, read as Latin-1");
  }
  const pugi::xml_parse_result result = document_.load_buffer(
      text_.data(), text_.size(), pugi::parse_default, pugi::encoding_utf8);
  if (!result || !document_.document_element()) {
    throw InputError(
        path + ": line " + std::to_string(LineAt(text_, result.offset)),
        std::string("is not well-formed XML (") +
            (result ? "there is no element" : result.description()) + ")",
        "copy or export the file again");
  }
  NestingCheck nesting(path_);
  document_.traverse(nesting);
}

int OsimXml::LineOf(pugi::xml_node node) const {
  return LineAt(text_, node.offset_debug());
}

std::string OsimXml::Where(pugi::xml_node node) const {
  std::string where =
      path_ + ": line " + std::to_string(LineOf(node)) + ", <" + node.name();
  if (const auto name = node.attribute("name")) {
    where += std::string(" name=\"") + name.value() + "\"";
  }
  return where + ">";
}

void OsimXml::Fail(pugi::xml_node node,
                   const std::string& problem,
                   const std::string& advice) const {
  throw InputError(Where(node), problem, advice);
}

pugi::xml_node OsimXml::Child(pugi::xml_node node, const char* name) const {
  const pugi::xml_node child = node.child(name);
  if (!child) {
    Fail(node,
         std::string("has no <") + name + ">",
         "save the model with OpenSim again");
  }
  return child;
}

std::string OsimXml::Text(pugi::xml_node node) const {
  const std::string text = node.text().get();
  const auto begin = text.find_first_not_of(" \t\r\n");
  if (begin == std::string::npos) return "";
  return text.substr(begin, text.find_last_not_of(" \t\r\n") + 1 - begin);
}

std::vector<double> OsimXml::Numbers(pugi::xml_node node) const {
  std::vector<double> numbers;
  const std::string text = Text(node);
  for (size_t i = 0; i < text.size();) {
    if (IsBlank(text[i])) {
      ++i;
      continue;
    }
    size_t end = i;
    while (end < text.size() && !IsBlank(text[end])) ++end;
    double value = 0;
    const char* const begin = text.data() + i + (text[i] == '+');
    const auto result = std::from_chars(begin, text.data() + end, value);
    if (result.ptr != text.data() + end || result.ec != std::errc() ||
        !std::isfinite(value)) {
      Fail(node,
           "has " + Quoted(text.substr(i, end - i)) + " in place of a number",
           "give finite numbers");
    }
    numbers.push_back(value);
    i = end;
  }
  return numbers;
}

std::vector<double> OsimXml::Numbers(
    pugi::xml_node node,
    const char* child,
    size_t count,
    const std::vector<double>& otherwise) const {
  const pugi::xml_node element = node.child(child);
  if (!element) return otherwise;
  const std::vector<double> numbers = Numbers(element);
  if (numbers.size() != count) {
    Fail(element,
         "has " + std::to_string(numbers.size()) + " numbers",
         "give " + std::to_string(count));
  }
  return numbers;
}

Eigen::Vector3d OsimXml::Vector(pugi::xml_node node,
                                const char* child,
                                const Eigen::Vector3d& otherwise) const {
  const auto numbers =
      Numbers(node, child, 3, {otherwise[0], otherwise[1], otherwise[2]});
  return {numbers[0], numbers[1], numbers[2]};
}

double OsimXml::Number(pugi::xml_node node,
                       const char* child,
                       double otherwise) const {
  return Numbers(node, child, 1, {otherwise})[0];
}

bool OsimXml::Bool(pugi::xml_node node,
                   const char* child,
                   bool otherwise) const {
  const pugi::xml_node element = node.child(child);
  if (!element) return otherwise;
  const std::string text = LowerCase(Text(element));
  if (text == "true" || text == "1") return true;
  if (text == "false" || text == "0") return false;
  Fail(element, "is " + Quoted(text), "allowed: true, false");
}

std::vector<pugi::xml_node> ElementsOf(pugi::xml_node node) {
  std::vector<pugi::xml_node> elements;
  for (const pugi::xml_node child : node.children()) {
    if (child.type() == pugi::node_element) elements.push_back(child);
  }
  return elements;
}

std::vector<pugi::xml_node> ObjectsOf(pugi::xml_node node, const char* set) {
  return ElementsOf(node.child(set).child("objects"));
}

std::string LastName(const std::string& path) {
  const auto slash = path.find_last_of('/');
  return slash == std::string::npos ? path : path.substr(slash + 1);
}

}  // namespace musclewarp
