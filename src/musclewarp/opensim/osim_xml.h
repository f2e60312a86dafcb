// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <pugixml.hpp>
#include <string>
#include <vector>

namespace musclewarp {

// The XML document of an OpenSim file. It gives the readers of elements checked
// values, and error messages that name the file, the line and the element.
class OsimXml {
 public:
  // Reads the bytes of a file in the encodings of DecodeXml. Throws InputError,
  // which names the line, if it is not well-formed XML. A file that is neither
  // UTF-8 nor in the encoding that it names is read as Latin-1, with a warning.
  OsimXml(const std::string& bytes, const std::string& path);

  pugi::xml_node root() const { return document_.document_element(); }
  const std::string& path() const { return path_; }
  const std::vector<std::string>& warnings() const { return warnings_; }

  // Returns the place of an element for messages, such as
  // "model.osim: line 12, <Body name="femur_r">".
  std::string Where(pugi::xml_node node) const;

  // Returns the line in which an element begins, counted from 1.
  int LineOf(pugi::xml_node node) const;

  // Throws InputError at an element.
  [[noreturn]] void Fail(pugi::xml_node node,
                         const std::string& problem,
                         const std::string& advice) const;

  // The functions below throw InputError at the element if what they return is
  // missing or not valid.

  // Returns a child element that must exist.
  pugi::xml_node Child(pugi::xml_node node, const char* name) const;

  // Returns the text of an element without white space at its ends.
  std::string Text(pugi::xml_node node) const;

  // Returns all numbers of the text of an element, which must be finite. They
  // may be separated by white space or commas.
  std::vector<double> Numbers(pugi::xml_node node) const;

  // Returns the numbers of a child element, of which there must be `count`, or
  // `otherwise` if there is no such child.
  std::vector<double> Numbers(pugi::xml_node node,
                              const char* child,
                              size_t count,
                              const std::vector<double>& otherwise) const;

  // The same for a vector of three numbers, a single number, and a bool, which
  // is written as true, false, 1 or 0.
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

// Returns the elements in a set that is a child of `node`, such as
// <CoordinateSet><objects>...</objects></CoordinateSet>. The list is empty if
// there is no such set.
std::vector<pugi::xml_node> ObjectsOf(pugi::xml_node node, const char* set);

// Returns all children of a node that are elements, not text or comments.
std::vector<pugi::xml_node> ElementsOf(pugi::xml_node node);

// Returns the last name of a path: "femur_r" of "/bodyset/femur_r".
std::string LastName(const std::string& path);

}  // namespace musclewarp
