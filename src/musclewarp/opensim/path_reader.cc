// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/opensim/path_reader.h"

#include <Eigen/Geometry>
#include <sstream>
#include <utility>

#include "musclewarp/opensim/component_tree.h"
#include "musclewarp/opensim/function_reader.h"

namespace musclewarp {
namespace {

constexpr char kFunctionBasedPath[] = "FunctionBasedPath";

// Returns the child with the name of OpenSim 3 if there is one, else the socket
// of OpenSim 4.
pugi::xml_node ChildOrSocket(const OsimXml& xml,
                             pugi::xml_node node,
                             const char* opensim3,
                             const char* socket) {
  if (const auto child = node.child(opensim3)) return child;
  return SocketOf(xml, node, {socket});
}

int CoordinateOf(const OsimXml& xml,
                 pugi::xml_node element,
                 const Model& model) {
  const std::string name = xml.Text(element);
  const int coordinate = model.FindCoordinate(name);
  if (coordinate < 0) {
    xml.Fail(element,
             "names \"" + name + "\", which " + WhyNoCoordinate(model, name),
             "check the name");
  }
  return coordinate;
}

void ReadCondition(const OsimXml& xml,
                   pugi::xml_node node,
                   const Model& model,
                   PathPoint* point) {
  point->condition = CoordinateOf(
      xml, ChildOrSocket(xml, node, "coordinate", "coordinate"), model);
  xml.Child(node, "range");
  const auto range = xml.Numbers(node, "range", 2, {});
  point->range[0] = range[0];
  point->range[1] = range[1];
}

// Reads the functions x_location, y_location and z_location. Returns false and
// sets the reason if one of them is not supported.
bool ReadMovement(const OsimXml& xml,
                  pugi::xml_node node,
                  const Model& model,
                  PathPoint* point,
                  std::string* unsupported) {
  point->is_moving = true;
  for (int i = 0; i < 3; ++i) {
    const std::string letter(1, static_cast<char>('x' + i));
    const std::string location = letter + "_location";
    const std::string coordinate = letter + "_coordinate";
    const auto element = FunctionElement(node, location.c_str());
    if (!element) {
      xml.Fail(node, "has no <" + location + ">", "give a function");
    }
    FunctionPtr function = ReadFunction(xml, element, unsupported);
    if (!function) return false;
    if (function->Arity() > 1) {
      xml.Fail(element,
               "is a function of " + std::to_string(function->Arity()) +
                   " arguments",
               "give a function of one");
    }
    const bool needs_coordinate = function->Arity() > 0;
    point->moving_functions[i] =
        MakeMultiplier(kMillimetresPerMetre, std::move(function));
    if (!needs_coordinate) continue;
    point->moving_coordinates[i] = CoordinateOf(
        xml,
        ChildOrSocket(xml, node, coordinate.c_str(), coordinate.c_str()),
        model);
  }
  return true;
}

PathPoint ReadPoint(const OsimXml& xml,
                    const OffsetFrames& frames,
                    pugi::xml_node node,
                    const Model& model,
                    std::string* unsupported) {
  PathPoint point;
  point.name = node.attribute("name").value();
  const FrameOnBody frame =
      frames.Resolve(ChildOrSocket(xml, node, "body", "parent_frame"));
  if (frame.body < 0) {
    *unsupported = frame.unknown;
    point.body = 0;
    return point;
  }
  point.body = frame.body;
  point.body_from_frame = frame.body_from_frame;
  const std::string type = node.name();
  if (type == "MovingPathPoint" || type == "MovingMusclePoint") {
    ReadMovement(xml, node, model, &point, unsupported);
    return point;
  }
  if (type == "ConditionalPathPoint" || type == "MuscleViaPoint") {
    ReadCondition(xml, node, model, &point);
  } else if (type != "PathPoint" && type != "MusclePoint") {
    *unsupported = "the path point <" + type + "> in line " +
                   std::to_string(xml.LineOf(node));
    return point;
  }
  xml.Child(node, "location");
  const Eigen::Vector3d location =
      kMillimetresPerMetre *
      xml.Vector(node, "location", Eigen::Vector3d::Zero());
  point.location = (frame.body_from_frame * location.homogeneous()).head<3>();
  return point;
}

void ReadLengthFunction(const OsimXml& xml,
                        pugi::xml_node path,
                        const Model& model,
                        ModelMuscle* muscle) {
  std::istringstream names(xml.Text(xml.Child(path, "coordinate_paths")));
  for (std::string name; names >> name;) {
    const int coordinate = model.FindCoordinate(name);
    if (coordinate < 0) {
      xml.Fail(path,
               "names \"" + name + "\", which " + WhyNoCoordinate(model, name),
               "check the name");
    }
    muscle->length_coordinates.push_back(coordinate);
  }
  const pugi::xml_node element = FunctionElement(path, "length_function");
  if (!element) xml.Fail(path, "has no <length_function>", "give a function");
  std::string unknown;
  muscle->length_function = ReadFunction(xml, element, &unknown);
  if (muscle->length_function &&
      muscle->length_function->Arity() > muscle->length_coordinates.size()) {
    xml.Fail(path,
             "has a length function of " +
                 std::to_string(muscle->length_function->Arity()) +
                 " arguments and " +
                 std::to_string(muscle->length_coordinates.size()) +
                 " coordinates",
             "name a coordinate for each");
  }
  muscle->unsupported =
      "the path <FunctionBasedPath>, which has no points, in "
      "line " +
      std::to_string(xml.LineOf(path));
}

}  // namespace

pugi::xml_node GeometryPathOf(pugi::xml_node force) {
  const pugi::xml_node property = force.child("path");
  for (const pugi::xml_node parent : {force, property}) {
    for (const char* type : {"GeometryPath", kFunctionBasedPath}) {
      if (const auto path = parent.child(type)) return path;
    }
  }
  return {};
}

ModelMuscle ReadPath(const OsimXml& xml,
                     const OffsetFrames& frames,
                     pugi::xml_node force,
                     const Model& model) {
  ModelMuscle muscle;
  muscle.name = ComponentName(force);
  const pugi::xml_node path = GeometryPathOf(force);
  if (std::string(path.name()) == kFunctionBasedPath) {
    ReadLengthFunction(xml, path, model, &muscle);
    return muscle;
  }
  for (const pugi::xml_node node : ObjectsOf(path, "PathPointSet")) {
    muscle.path.push_back(
        ReadPoint(xml, frames, node, model, &muscle.unsupported));
  }
  if (muscle.path.size() < 2) {
    xml.Fail(path,
             "has " + std::to_string(muscle.path.size()) + " path points",
             "give at least 2");
  }
  return muscle;
}

}  // namespace musclewarp
