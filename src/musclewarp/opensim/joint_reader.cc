// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/opensim/joint_reader.h"

#include <algorithm>
#include <map>
#include <utility>

#include "musclewarp/base/near_name.h"
#include "musclewarp/mesh_files/text_cursor.h"
#include "musclewarp/opensim/component_tree.h"
#include "musclewarp/opensim/function_reader.h"

namespace musclewarp {
namespace {

// The axes of the joints that have no SpatialTransform of their own, in the
// order of their coordinates: "rz" turns about z, "tx" moves along x.
const std::map<std::string, std::vector<std::string>>& AxesOfJoints() {
  static const std::map<std::string, std::vector<std::string>> kAxes = {
      {"WeldJoint", {}},
      {"PinJoint", {"rz"}},
      {"SliderJoint", {"tx"}},
      {"UniversalJoint", {"rx", "ry"}},
      {"BallJoint", {"rx", "ry", "rz"}},
      {"GimbalJoint", {"rx", "ry", "rz"}},
      {"PlanarJoint", {"rz", "tx", "ty"}},
      {"FreeJoint", {"rx", "ry", "rz", "tx", "ty", "tz"}}};
  return kAxes;
}

// Returns the coordinate of a joint, both by name, or -1.
int CoordinateOfJoint(const Model& model,
                      const std::string& joint,
                      const std::string& name) {
  for (size_t i = 0; i < model.coordinates.size(); ++i) {
    const Coordinate& coordinate = model.coordinates[i];
    if (coordinate.joint == joint && coordinate.name == name) {
      return static_cast<int>(i);
    }
  }
  return -1;
}

// Adds a coordinate and returns its index.
int AddCoordinate(const OsimXml& xml,
                  pugi::xml_node node,
                  const Joint& joint,
                  std::string name,
                  CoordinateKind kind,
                  Model* model) {
  if (CoordinateOfJoint(*model, joint.name, name) >= 0) {
    xml.Fail(node,
             "is the second coordinate with the name \"" + name +
                 "\" of a joint \"" + joint.name + "\"",
             "give every coordinate a name of its own");
  }
  Coordinate coordinate;
  coordinate.name = std::move(name);
  coordinate.joint = joint.name;
  coordinate.kind = kind;
  coordinate.default_value = xml.Number(node, "default_value", 0);
  coordinate.is_locked = xml.Bool(node, "locked", false);
  const auto range = xml.Numbers(node.child("range"));
  if (range.size() == 2 && range[0] < range[1]) {
    coordinate.range = {range[0], range[1]};
  }
  coordinate.is_clamped = xml.Bool(node, "clamped", false);
  model->coordinates.push_back(std::move(coordinate));
  return static_cast<int>(model->coordinates.size()) - 1;
}

// Returns the name of coordinate `i` of a joint. OpenSim does not write what
// has its default value, which may be the name or the whole element.
std::string CoordinateName(pugi::xml_node element,
                           const Joint& joint,
                           size_t i) {
  const std::string name = element.attribute("name").value();
  return name.empty() ? joint.name + "_coord_" + std::to_string(i) : name;
}

std::vector<pugi::xml_node> CoordinateElements(pugi::xml_node joint) {
  auto elements = ObjectsOf(joint, "CoordinateSet");
  if (elements.empty()) elements = ElementsOf(joint.child("coordinates"));
  return elements;
}

// Adds the coordinates of a joint of whose units nothing is known yet.
void AddCoupledCoordinates(const OsimXml& xml,
                           const std::vector<pugi::xml_node>& elements,
                           const Joint& joint,
                           Model* model) {
  for (size_t i = 0; i < elements.size(); ++i) {
    AddCoordinate(xml,
                  elements[i],
                  joint,
                  CoordinateName(elements[i], joint, i),
                  CoordinateKind::kCoupled,
                  model);
  }
}

// Sets the axes of pins, sliders and the other types of AxesOfJoints.
void SetKnownAxes(const OsimXml& xml,
                  pugi::xml_node node,
                  const std::vector<std::string>& axes,
                  Joint* joint,
                  Model* model) {
  const auto elements = CoordinateElements(node);
  int rotations = 0;
  int translations = 0;
  for (size_t i = 0; i < axes.size(); ++i) {
    const bool turns = axes[i][0] == 'r';
    const pugi::xml_node element =
        i < elements.size() ? elements[i] : pugi::xml_node();
    const std::string name = CoordinateName(element, *joint, i);
    TransformAxis& axis = turns ? joint->rotations[rotations++]
                                : joint->translations[translations++];
    axis.axis = Eigen::Vector3d::Unit(axes[i][1] - 'x');
    axis.coordinates = {AddCoordinate(
        xml,
        element,
        *joint,
        name,
        turns ? CoordinateKind::kRotational : CoordinateKind::kTranslational,
        model)};
    axis.function = MakeLinear({turns ? 1 : kMillimetresPerMetre, 0});
  }
}

// Returns true if a function returns its argument or minus that. The coordinate
// is then the angle about an axis, or the length along it.
bool IsIdentity(const OsimXml& xml, pugi::xml_node function) {
  if (std::string(function.name()) != "LinearFunction") return false;
  const auto coefficients = xml.Numbers(function.child("coefficients"));
  return coefficients.size() == 2 && std::abs(coefficients[0]) == 1 &&
         coefficients[1] == 0;
}

// A function that is not the property "function" would move nothing.
void CheckNoFunctionIsNameless(const OsimXml& xml, pugi::xml_node node) {
  for (const pugi::xml_node child : ElementsOf(node)) {
    const std::string tag = child.name();
    if (tag != "Constant" && !EndsWith(tag, "Function") &&
        !EndsWith(tag, "Spline")) {
      continue;
    }
    xml.Fail(child,
             "is not named as the function of its axis",
             "write <" + tag + " name=\"function\">, or remove it");
  }
}

void SetAxis(const OsimXml& xml,
             pugi::xml_node node,
             bool turns,
             Joint* joint,
             TransformAxis* axis,
             Model* model) {
  axis->axis = xml.Vector(node, "axis", Eigen::Vector3d::Zero());
  const pugi::xml_node function = FunctionElement(node, "function");
  if (!function) {
    CheckNoFunctionIsNameless(xml, node);
    return;
  }
  if (axis->axis.norm() == 0) {
    xml.Fail(node,
             "has a function, but no axis or one of length 0",
             "give the direction of the axis");
  }
  axis->axis.normalize();
  std::string unsupported;
  axis->function = ReadFunction(xml, function, &unsupported);
  if (!axis->function) {
    joint->unsupported = "the function " + unsupported;
    return;
  }
  if (!turns) {
    axis->function =
        MakeMultiplier(kMillimetresPerMetre, std::move(axis->function));
  }
  std::string names = xml.Text(node.child("coordinates"));
  size_t begin = 0;
  while ((begin = names.find_first_not_of(" \t\r\n", begin)) !=
         std::string::npos) {
    const size_t end =
        std::min(names.find_first_of(" \t\r\n", begin), names.size());
    const std::string name = names.substr(begin, end - begin);
    int coordinate = CoordinateOfJoint(*model, joint->name, LastName(name));
    if (coordinate < 0) coordinate = model->FindCoordinate(name);
    if (coordinate < 0) {
      xml.Fail(node.child("coordinates"),
               "names \"" + name + "\", which is not a coordinate of the model",
               "check the name");
    }
    axis->coordinates.push_back(coordinate);
    begin = end;
    if (IsIdentity(xml, function)) {
      model->coordinates[coordinate].kind =
          turns ? CoordinateKind::kRotational : CoordinateKind::kTranslational;
    }
  }
  if (axis->function->Arity() > axis->coordinates.size()) {
    xml.Fail(node,
             "has a function of " + std::to_string(axis->function->Arity()) +
                 " arguments and " + std::to_string(axis->coordinates.size()) +
                 " coordinates",
             "name a coordinate for each");
  }
}

// Files of OpenSim 2 and 3 state the kind of a coordinate. This has precedence
// over what its axes show.
void SetMotionType(const OsimXml& xml,
                   pugi::xml_node element,
                   Coordinate* coordinate) {
  const std::string type = LowerCase(xml.Text(element.child("motion_type")));
  if (type == "rotational") coordinate->kind = CoordinateKind::kRotational;
  if (type == "translational") {
    coordinate->kind = CoordinateKind::kTranslational;
  }
  if (type == "coupled") coordinate->kind = CoordinateKind::kCoupled;
}

void SetSpatialTransform(const OsimXml& xml,
                         pugi::xml_node node,
                         Joint* joint,
                         Model* model) {
  const int first = static_cast<int>(model->coordinates.size());
  const auto elements = CoordinateElements(node);
  AddCoupledCoordinates(xml, elements, *joint, model);
  const pugi::xml_node transform = xml.Child(node, "SpatialTransform");
  std::vector<pugi::xml_node> axes;
  for (const pugi::xml_node axis : transform.children("TransformAxis")) {
    axes.push_back(axis);
  }
  if (axes.size() != 6) {
    xml.Fail(transform,
             "has " + std::to_string(axes.size()) + " <TransformAxis>",
             "give 3 rotations and 3 translations");
  }
  for (int i = 0; i < 3; ++i) {
    SetAxis(xml, axes[i], true, joint, &joint->rotations[i], model);
    SetAxis(xml, axes[i + 3], false, joint, &joint->translations[i], model);
  }
  for (size_t i = 0; i < elements.size(); ++i) {
    SetMotionType(xml, elements[i], &model->coordinates[first + i]);
  }
}

void AddJoint(const OsimXml& xml,
              pugi::xml_node node,
              Joint joint,
              Model* model) {
  joint.type = node.name();
  joint.name = ComponentName(node);
  joint.is_reversed = xml.Bool(node, "reverse", false);
  const auto known = AxesOfJoints().find(joint.type);
  const std::string unknown_frame = std::move(joint.unsupported);
  if (known != AxesOfJoints().end()) {
    SetKnownAxes(xml, node, known->second, &joint, model);
  } else if (joint.type == "CustomJoint") {
    SetSpatialTransform(xml, node, &joint, model);
  } else {
    joint.unsupported =
        "the type of joint in line " + std::to_string(xml.LineOf(node));
    AddCoupledCoordinates(xml, CoordinateElements(node), joint, model);
  }
  if (!unknown_frame.empty()) joint.unsupported = unknown_frame;
  Body& child = model->bodies[joint.child];
  if (child.joint >= 0) {
    // The body is part of a closed loop, and its first joint alone does not
    // determine its motion.
    Joint& first = model->joints[child.joint];
    first.unsupported = "a closed loop: joint \"" + joint.name +
                        "\" has the same child \"" + child.name + "\"";
  } else {
    child.joint = static_cast<int>(model->joints.size());
  }
  model->joints.push_back(std::move(joint));
}

// Returns the place of a joint on a body. The names of the elements that hold
// it end in one of `places`, of which the first that exists is used.
Eigen::Matrix4d JointPlace(const OsimXml& xml,
                           pugi::xml_node node,
                           const std::vector<std::string>& places) {
  for (const std::string& suffix : places) {
    const std::string location = "location" + suffix;
    const std::string orientation = "orientation" + suffix;
    if (!node.child(location.c_str()) && !node.child(orientation.c_str())) {
      continue;
    }
    return OffsetTransform(
        xml.Vector(node, location.c_str(), Eigen::Vector3d::Zero()),
        xml.Vector(node, orientation.c_str(), Eigen::Vector3d::Zero()));
  }
  return Eigen::Matrix4d::Identity();
}

}  // namespace

void AddJointOfBody(const OsimXml& xml,
                    pugi::xml_node node,
                    int child,
                    Model* model) {
  Joint joint;
  joint.child = child;
  const pugi::xml_node parent = xml.Child(node, "parent_body");
  joint.parent = model->FindBody(LastName(xml.Text(parent)));
  if (joint.parent < 0) {
    std::vector<std::string> known;
    for (const Body& body : model->bodies) known.push_back(body.name);
    xml.Fail(
        parent,
        "names \"" + xml.Text(parent) + "\", which is not a body of the model",
        DidYouMean(LastName(xml.Text(parent)), known) + "check the name");
  }
  joint.parent_from_joint = JointPlace(xml, node, {"_in_parent"});
  joint.child_from_joint = JointPlace(xml, node, {"", "_in_child"});
  AddJoint(xml, node, std::move(joint), model);
}

void AddJointOfSet(const OsimXml& xml,
                   const OffsetFrames& frames,
                   pugi::xml_node node,
                   Model* model) {
  const FrameOnBody parent =
      frames.Resolve(SocketOf(xml, node, {"parent_frame", "parent_body"}));
  const FrameOnBody child =
      frames.Resolve(SocketOf(xml, node, {"child_frame", "child_body"}));
  if (child.body < 0) {
    model->warnings.push_back(xml.Where(node) +
                              ": joins no body to others: " + child.unknown);
    return;
  }
  Joint joint;
  joint.parent = std::max(parent.body, 0);
  joint.child = child.body;
  joint.unsupported = parent.unknown;
  joint.parent_from_joint =
      parent.body_from_frame * JointPlace(xml, node, {"_in_parent"});
  joint.child_from_joint =
      child.body_from_frame * JointPlace(xml, node, {"_in_child"});
  AddJoint(xml, node, std::move(joint), model);
}

}  // namespace musclewarp
