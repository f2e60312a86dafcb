// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <pugixml.hpp>
#include <string>
#include <vector>

namespace musclewarp {

// The XML of an OpenSim file, and what every reader of its elements needs:
// values with their checks, and places for messages.
class OsimXml {
 public:
  // Throws InputError with the line if the file is not well-formed. Files that
  // say UTF-8 and are not are read as Latin-1, with a warning.
  explicit OsimXml(const std::string& path);

  pugi::xml_node root() const { return document_.document_element(); }
  const std::string& path() const { return path_; }
  const std::vector<std::string>& warnings() const { return warnings_; }

  // "model.osim: line 12, <Body name="femur_r">"
  std::string Where(pugi::xml_node node) const;
  int LineOf(pugi::xml_node node) const;
  [[noreturn]] void Fail(pugi::xml_node node,
                         const std::string& problem,
                         const std::string& advice) const;

  // The name attribute; fails if it is missing.
  std::string NameOf(pugi::xml_node node) const;
  // A child that must be there.
  pugi::xml_node Child(pugi::xml_node node, const char* name) const;
  // Text without blanks at its ends.
  std::string Text(pugi::xml_node node) const;
  // All numbers of the text, finite.
  std::vector<double> Numbers(pugi::xml_node node) const;
  // The numbers of a child, exactly `count`; `otherwise` if it is missing.
  std::vector<double> Numbers(pugi::xml_node node,
                              const char* child,
                              size_t count,
                              const std::vector<double>& otherwise) const;
  Eigen::Vector3d Vector(pugi::xml_node node,
                         const char* child,
                         const Eigen::Vector3d& otherwise) const;
  double Number(pugi::xml_node node, const char* child, double otherwise) const;
  bool Bool(pugi::xml_node node, const char* child, bool otherwise) const;

 private:
  std::string path_;
  std::string text_;  // UTF-8
  pugi::xml_document document_;
  std::vector<std::string> warnings_;
};

// The elements of a child of type Set: <CoordinateSet><objects>...; empty if
// there is none.
std::vector<pugi::xml_node> ObjectsOf(pugi::xml_node node, const char* set);

// All element children.
std::vector<pugi::xml_node> ElementsOf(pugi::xml_node node);

// The last name of a path: "/bodyset/femur_r" -> "femur_r".
std::string LastName(const std::string& path);

}  // namespace musclewarp
