// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/opensim/component_tree.h"

#include <cctype>
#include <sstream>

#include "musclewarp/mesh_files/text_cursor.h"

namespace musclewarp {
namespace {

bool IsComponent(pugi::xml_node element) {
  // <PathPointSet> is none in OpenSim, in spite of its capital letter.
  return std::isupper(static_cast<unsigned char>(element.name()[0])) != 0 &&
         std::string(element.name()) != "PathPointSet";
}

pugi::xml_node ModelAbove(pugi::xml_node element) {
  for (auto node = element; node; node = node.parent()) {
    if (std::string(node.name()) == "Model") return node;
  }
  const pugi::xml_node root = ElementsOf(element.root()).front();
  const pugi::xml_node model = root.child("Model");
  return model ? model : root;
}

// Returns the component of that name that `owner` owns itself.
pugi::xml_node ChildComponent(pugi::xml_node owner, const std::string& name) {
  for (const pugi::xml_node child : ElementsOf(owner)) {
    if (IsComponent(child)) {
      if (ComponentName(child) == name) return child;
      continue;
    }
    if (const auto inside = ChildComponent(child, name)) return inside;
  }
  return {};
}

bool StartsWith(const std::string& text, const std::string& start) {
  return text.compare(0, start.size(), start) == 0;
}

pugi::xml_node SocketNamed(pugi::xml_node component, const std::string& name) {
  for (const std::string& property :
       {"socket_" + name,
        "socket_" + name + "_connectee_name",
        "connector_" + name + "_connectee_name"}) {
    if (const auto socket = component.child(property.c_str())) return socket;
  }
  for (const auto connector : ElementsOf(component.child("connectors"))) {
    if (StartsWith(connector.name(), "Connector_") &&
        connector.attribute("name").value() == name) {
      return connector.child("connectee_name");
    }
  }
  return {};
}

}  // namespace

std::string ComponentName(pugi::xml_node component) {
  const std::string name = component.attribute("name").value();
  return name.empty() ? LowerCase(component.name()) : name;
}

pugi::xml_node OwnerOf(pugi::xml_node element) {
  const pugi::xml_node model = ModelAbove(element);
  if (element == model) return {};
  for (auto node = element.parent(); node; node = node.parent()) {
    if (node == model || IsComponent(node)) return node;
  }
  return {};
}

pugi::xml_node FindComponent(pugi::xml_node from, const std::string& path) {
  pugi::xml_node component =
      !path.empty() && path[0] == '/' ? ModelAbove(from) : from;
  std::istringstream names(path);
  for (std::string name; component && std::getline(names, name, '/');) {
    if (name.empty() || name == ".") continue;
    component =
        name == ".." ? OwnerOf(component) : ChildComponent(component, name);
  }
  return component;
}

pugi::xml_node FindSocket(pugi::xml_node component,
                          std::initializer_list<const char*> names) {
  for (const char* name : names) {
    if (const auto socket = SocketNamed(component, name)) return socket;
  }
  return {};
}

pugi::xml_node SocketOf(const OsimXml& xml,
                        pugi::xml_node component,
                        std::initializer_list<const char*> names) {
  const pugi::xml_node socket = FindSocket(component, names);
  // What is missing is named as current files have it.
  return socket ? socket
                : xml.Child(component,
                            ("socket_" + std::string(*names.begin())).c_str());
}

std::vector<pugi::xml_node> ElementsNamed(pugi::xml_node model,
                                          const std::string& name) {
  struct Walker : pugi::xml_tree_walker {
    const std::string* name = nullptr;
    std::vector<pugi::xml_node> found;
    bool for_each(pugi::xml_node& node) override {
      if (node.name() == *name && !IsDefault(node)) found.push_back(node);
      return true;
    }
    static bool IsDefault(pugi::xml_node node) {
      for (; node; node = node.parent()) {
        if (std::string(node.name()) == "defaults") return true;
      }
      return false;
    }
  } walker;
  walker.name = &name;
  model.traverse(walker);
  return walker.found;
}

}  // namespace musclewarp
