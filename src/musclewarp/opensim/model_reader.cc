// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <map>
#include <utility>

#include "musclewarp/base/input_error.h"
#include "musclewarp/base/input_file.h"
#include "musclewarp/opensim/component_tree.h"
#include "musclewarp/opensim/function_reader.h"
#include "musclewarp/opensim/geometry_reader.h"
#include "musclewarp/opensim/joint_reader.h"
#include "musclewarp/opensim/model.h"
#include "musclewarp/opensim/offset_frames.h"
#include "musclewarp/opensim/osim_xml.h"
#include "musclewarp/opensim/path_reader.h"

namespace musclewarp {
namespace {

constexpr char kGround[] = "ground";
constexpr char kCoupler[] = "CoordinateCouplerConstraint";

// Returns the components of a set of the model, and those of such a kind that
// were added to the model on their own, which OpenSim 4 keeps in <components>.
std::vector<pugi::xml_node> PartsOf(pugi::xml_node model,
                                    const char* set,
                                    bool (*is_kind)(pugi::xml_node)) {
  std::vector<pugi::xml_node> parts = ObjectsOf(model, set);
  for (const pugi::xml_node component : ElementsOf(model.child("components"))) {
    if (is_kind(component)) parts.push_back(component);
  }
  return parts;
}

bool IsBody(pugi::xml_node component) {
  return std::string(component.name()) == "Body";
}

bool IsJoint(pugi::xml_node component) {
  return static_cast<bool>(
      FindSocket(component, {"child_frame", "child_body"}));
}

bool HasPath(pugi::xml_node component) {
  return static_cast<bool>(GeometryPathOf(component));
}

std::vector<pugi::xml_node> BodiesOf(pugi::xml_node model) {
  return PartsOf(model, "BodySet", IsBody);
}

void CheckNumber(const OsimXml& xml, const char* what, size_t count) {
  if (count <= kMostModelParts) return;
  throw InputError(xml.path(),
                   "has " + std::to_string(count) + " " + what +
                       "; allowed: at most " + std::to_string(kMostModelParts),
                   "take out what the motion does not need");
}

// Parts are searched for by their paths, from all that name them.
void CheckNumbers(const OsimXml& xml, pugi::xml_node model) {
  CheckNumber(xml, "bodies", BodiesOf(model).size());
  CheckNumber(xml, "joints", PartsOf(model, "JointSet", IsJoint).size());
  CheckNumber(xml, "muscles", PartsOf(model, "ForceSet", HasPath).size());
}

// Adds the ground. OpenSim 3 has it among the bodies, OpenSim 4 on its own.
void ReadGround(const OsimXml& xml, pugi::xml_node node, Model* model) {
  Body ground;
  ground.name = kGround;
  pugi::xml_node element = node.child("Ground");
  for (const pugi::xml_node body : BodiesOf(node)) {
    if (ComponentName(body) == kGround) element = body;
  }
  ground.geometry = ReadBodyGeometry(xml, element);
  model->bodies.push_back(std::move(ground));
}

void ReadBodies(const OsimXml& xml, pugi::xml_node node, Model* model) {
  ReadGround(xml, node, model);
  for (const pugi::xml_node element : BodiesOf(node)) {
    Body body;
    body.name = ComponentName(element);
    if (body.name == kGround) continue;
    if (model->FindBody(body.name) >= 0) {
      xml.Fail(element,
               "is the second body of that name",
               "give every body a name of its own");
    }
    body.geometry = ReadBodyGeometry(xml, element);
    model->bodies.push_back(std::move(body));
  }
}

void ReadJoints(const OsimXml& xml,
                pugi::xml_node node,
                const OffsetFrames& frames,
                Model* model) {
  for (const pugi::xml_node element : BodiesOf(node)) {
    const std::string body = ComponentName(element);
    const auto joint = ElementsOf(element.child("Joint"));
    if (body == kGround || joint.empty()) continue;
    AddJointOfBody(xml, joint[0], model->FindBody(body), model);
  }
  for (const pugi::xml_node element : PartsOf(node, "JointSet", IsJoint)) {
    AddJointOfSet(xml, frames, element, model);
  }
}

// Gives coordinates of one name in several joints, which OpenSim 4 tells apart
// by their paths, names of their own.
void TellCoordinatesApart(Model* model) {
  std::map<std::string, int> count;
  for (const Coordinate& coordinate : model->coordinates) {
    ++count[coordinate.name];
  }
  for (Coordinate& coordinate : model->coordinates) {
    if (count[coordinate.name] == 1) continue;
    coordinate.name = coordinate.joint + "/" + coordinate.name;
  }
}

// Checks that the way up the joints from every body ends, at the ground or at a
// body without a joint.
void CheckIsTree(const OsimXml& xml, const Model& model) {
  for (const Body& start : model.bodies) {
    const Body* body = &start;
    for (size_t steps = 0; body->joint >= 0; ++steps) {
      if (steps > model.bodies.size()) {
        throw InputError(xml.path() + ": body \"" + body->name + "\"",
                         "is its own parent through the joints above it",
                         "let its joints lead to the ground");
      }
      body = &model.bodies[model.joints[body->joint].parent];
    }
  }
}

std::vector<int> CoordinatesNamed(const OsimXml& xml,
                                  pugi::xml_node element,
                                  const Model& model) {
  std::vector<int> coordinates;
  std::string word;
  for (const char c : xml.Text(element) + " ") {
    if (std::string(" \t\r\n").find(c) == std::string::npos) {
      word += c;
      continue;
    }
    if (word.empty()) continue;
    coordinates.push_back(model.FindCoordinate(word));
    if (coordinates.back() < 0) {
      xml.Fail(element,
               "names \"" + word + "\", which " + WhyNoCoordinate(model, word),
               "check the name");
    }
    word.clear();
  }
  return coordinates;
}

// Marks the joints that use a coordinate whose value is not known.
void MarkUnsupported(int coordinate, const std::string& why, Model* model) {
  for (Joint& joint : model->joints) {
    for (const auto* axes : {&joint.rotations, &joint.translations}) {
      for (const TransformAxis& axis : *axes) {
        if (std::count(
                axis.coordinates.begin(), axis.coordinates.end(), coordinate)) {
          joint.unsupported = why;
        }
      }
    }
  }
}

void ReadCoupler(const OsimXml& xml, pugi::xml_node node, Model* model) {
  CoordinateCoupler coupler;
  coupler.name = ComponentName(node);
  coupler.independents = CoordinatesNamed(
      xml, xml.Child(node, "independent_coordinate_names"), *model);
  const auto dependent_element = xml.Child(node, "dependent_coordinate_name");
  const auto dependent = CoordinatesNamed(xml, dependent_element, *model);
  if (dependent.size() != 1) {
    xml.Fail(dependent_element,
             "names " + std::to_string(dependent.size()) + " coordinates",
             "name exactly one");
  }
  coupler.dependent = dependent[0];
  coupler.scale = xml.Number(node, "scale_factor", 1);
  const auto function = FunctionElement(node, "coupled_coordinates_function");
  if (!function)
    xml.Fail(node, "has no <coupled_coordinates_function>", "give a function");
  std::string unsupported;
  coupler.function = ReadFunction(xml, function, &unsupported);
  if (!coupler.function) {
    MarkUnsupported(
        coupler.dependent,
        "the constraint \"" + coupler.name + "\" with " + unsupported,
        model);
    return;
  }
  if (coupler.function->Arity() > coupler.independents.size()) {
    xml.Fail(node,
             "has a function of more arguments than independent coordinates",
             "name a coordinate for each");
  }
  model->couplers.push_back(std::move(coupler));
}

bool IsEnforced(const OsimXml& xml, pugi::xml_node constraint) {
  return !xml.Bool(constraint, "isDisabled", false) &&
         xml.Bool(constraint, "isEnforced", true);
}

// Reads the couplers, which are not in the set of constraints in every file,
// and names the other constraints.
void ReadConstraints(const OsimXml& xml, pugi::xml_node node, Model* model) {
  for (const pugi::xml_node coupler : ElementsNamed(node, kCoupler)) {
    if (IsEnforced(xml, coupler)) ReadCoupler(xml, coupler, model);
  }
  std::string others;
  for (const pugi::xml_node element : ObjectsOf(node, "ConstraintSet")) {
    if (element.name() == std::string(kCoupler)) continue;
    if (!IsEnforced(xml, element)) continue;
    others += std::string(others.empty() ? "" : ", ") + element.name() + " \"" +
              element.attribute("name").value() + "\"";
  }
  if (!others.empty()) {
    model->warnings.push_back(xml.path() +
                              ": constraints that are not followed: " + others);
  }
}

void ReadMuscles(const OsimXml& xml,
                 pugi::xml_node node,
                 const OffsetFrames& frames,
                 Model* model) {
  std::string wrapped;
  for (const pugi::xml_node force : PartsOf(node, "ForceSet", HasPath)) {
    const pugi::xml_node path = GeometryPathOf(force);
    if (!path) continue;
    ModelMuscle muscle = ReadPath(xml, frames, force, *model);
    if (model->FindMuscle(muscle.name) >= 0) {
      model->warnings.push_back(
          xml.Where(force) + ": is a further one of the name \"" + muscle.name +
          "\", of which only the first is used");
      continue;
    }
    model->muscles.push_back(std::move(muscle));
    if (!ObjectsOf(path, "PathWrapSet").empty()) {
      wrapped += (wrapped.empty() ? "" : ", ") + model->muscles.back().name;
    }
  }
  if (!wrapped.empty()) {
    model->warnings.push_back(xml.path() +
                              ": wrapping is not followed, paths are straight "
                              "between their points: " +
                              wrapped);
  }
}

}  // namespace

Model ReadModel(const std::string& path) {
  return ModelFromText(ReadFile(path), path);
}

Model ModelFromText(std::string text, const std::string& path) {
  const OsimXml xml(text, path);
  Model model;
  model.path = path;
  model.text = std::move(text);
  model.warnings = xml.warnings();
  const pugi::xml_node node = std::string(xml.root().name()) == "Model"
                                  ? xml.root()
                                  : xml.root().child("Model");
  if (!node) {
    throw InputError(
        path, "has no element <Model>", "give an OpenSim model (.osim)");
  }
  model.name = node.attribute("name").value();
  CheckNumbers(xml, node);
  ReadBodies(xml, node, &model);
  const OffsetFrames frames(xml, model);
  ReadJoints(xml, node, frames, &model);
  TellCoordinatesApart(&model);
  CheckIsTree(xml, model);
  AddOffsetGeometry(xml, frames, &model);
  ReadConstraints(xml, node, &model);
  ReadMuscles(xml, node, frames, &model);
  return model;
}

}  // namespace musclewarp
