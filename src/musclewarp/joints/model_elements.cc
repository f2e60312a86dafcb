// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/joints/model_elements.h"

#include "musclewarp/base/text.h"

namespace musclewarp {

std::string ExactText(double number) {
  return NumberText(number == 0 ? 0 : number, 17);  // no negative zero
}

std::string VectorText(const Eigen::Vector3d& vector) {
  return ExactText(vector.x()) + " " + ExactText(vector.y()) + " " +
         ExactText(vector.z());
}

void AddText(pugi::xml_node parent, const char* name, const std::string& text) {
  parent.append_child(name).text().set(text.c_str());
}

pugi::xml_node AddNamed(pugi::xml_node parent,
                        const char* kind,
                        const std::string& name) {
  pugi::xml_node node = parent.append_child(kind);
  node.append_attribute("name") = name.c_str();
  return node;
}

void AddComment(pugi::xml_node parent, std::string text) {
  for (size_t at = 0; (at = text.find("--", at)) != std::string::npos;) {
    text.replace(at, 2, "- ");
  }
  parent.append_child(pugi::node_comment).set_value((" " + text + " ").c_str());
}

std::string FramePathOf(const std::string& body) {
  return body == "ground" ? "/ground" : "/bodyset/" + body;
}

}  // namespace musclewarp
