// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/joints/articulated_model.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <pugixml.hpp>
#include <sstream>

#include "musclewarp/base/angles.h"
#include "musclewarp/base/input_error.h"
#include "musclewarp/base/output_file.h"
#include "musclewarp/joints/joint_building.h"
#include "musclewarp/joints/model_elements.h"
#include "musclewarp/joints/muscle_elements.h"
#include "musclewarp/mesh/measures.h"
#include "musclewarp/mesh_files/mesh_io.h"
#include "musclewarp/opensim/model.h"

namespace musclewarp {
namespace {

// Density of a whole bone, kg/mm^3: 1.5 g/cm^3.
constexpr double kBoneDensity = 1.5e-6;
constexpr double kLeastMass = 1e-3;  // kg

void AddMesh(const Bone& bone, pugi::xml_node geometry) {
  pugi::xml_node mesh = AddNamed(geometry, "Mesh", bone.name);
  AddText(mesh, "socket_frame", "..");
  AddText(mesh,
          "scale_factors",
          VectorText(Eigen::Vector3d::Constant(1 / kMillimetresPerMetre)));
  AddText(mesh, "mesh_file", bone.name + ".obj");
}

// The mass of the bones of a body and a ball of that mass in their middle.
void AddMass(const std::vector<const Bone*>& bones, pugi::xml_node node) {
  constexpr double kBall = 0.4;  // inertia of a ball by m r^2
  double volume = 0;
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  double points = 0;
  for (const Bone* bone : bones) {
    volume += std::abs(SignedVolume(bone->mesh.points, bone->mesh.triangles));
    middle += bone->mesh.points.colwise().sum().transpose();
    points += bone->mesh.points.rows();
  }
  middle /= std::max(points, 1.0) * kMillimetresPerMetre;
  const double mass = std::max(kLeastMass, volume * kBoneDensity);
  const double radius =
      std::cbrt(3 * mass / (kBoneDensity * 4 * M_PI)) / kMillimetresPerMetre;
  const std::string inertia = ExactText(kBall * mass * radius * radius);
  AddText(node, "mass", ExactText(mass));
  AddText(node, "mass_center", VectorText(middle));
  AddText(node, "inertia", inertia + " " + inertia + " " + inertia + " 0 0 0");
}

void AddBodies(const Articulation& articulation, pugi::xml_node model) {
  pugi::xml_node set = AddNamed(model, "BodySet", "bodyset");
  AddComment(set,
             "Masses are those of the volumes of the bones at 1.5 g/cm3. They "
             "are no data for dynamics.");
  pugi::xml_node objects = set.append_child("objects");
  for (const std::string& name : articulation.bodies) {
    pugi::xml_node body = AddNamed(objects, "Body", name);
    pugi::xml_node geometry = body.append_child("attached_geometry");
    std::vector<const Bone*> bones;
    for (const Bone& bone : articulation.bones) {
      if (bone.body != name) continue;
      AddMesh(bone, geometry);
      bones.push_back(&bone);
    }
    AddMass(bones, body);
  }
}

std::string FrameName(const std::string& body) { return body + "_offset"; }

void AddFrame(const std::string& body,
              const Eigen::Vector3d& center,
              const Eigen::Matrix3d& axes,
              pugi::xml_node frames) {
  pugi::xml_node frame =
      AddNamed(frames, "PhysicalOffsetFrame", FrameName(body));
  AddText(frame, "socket_parent", FramePathOf(body));
  AddText(frame, "translation", VectorText(center / kMillimetresPerMetre));
  AddText(frame, "orientation", VectorText(BodyFixedAngles(axes)));
}

void AddSockets(const std::string& parent,
                const std::string& child,
                pugi::xml_node joint) {
  AddText(joint, "socket_parent_frame", FrameName(parent));
  AddText(joint, "socket_child_frame", FrameName(child));
}

void AddCoordinates(const FoundJoint& joint, pugi::xml_node node) {
  pugi::xml_node coordinates = node.append_child("coordinates");
  const std::vector<JointCoordinate> entries =
      CoordinatesOf(joint.kind, joint.side);
  const std::vector<double> values = ScanCoordinates(joint);
  for (size_t i = 0; i < entries.size(); ++i) {
    pugi::xml_node entry = AddNamed(coordinates, "Coordinate", entries[i].name);
    AddText(entry, "default_value", ExactText(values[i]));
    AddText(entry, "default_speed_value", "0");
    // The pose of the scan is within the range.
    const double low =
        std::min(entries[i].lowest * kRadiansPerDegree, values[i]);
    const double high =
        std::max(entries[i].highest * kRadiansPerDegree, values[i]);
    AddText(entry, "range", ExactText(low) + " " + ExactText(high));
    AddText(entry, "clamped", "false");
    AddText(entry, "locked", "false");
  }
}

// Axes of which the first are those of the coordinates and the others stand
// still: OpenSim wants three that are independent.
void AddTransform(const FoundJoint& joint, pugi::xml_node node) {
  const std::vector<JointCoordinate> coordinates =
      CoordinatesOf(joint.kind, joint.side);
  std::vector<Eigen::Vector3d> axes;
  for (const JointCoordinate& entry : coordinates) axes.push_back(entry.axis);
  for (int axis = 0; axis < 3; ++axis) {
    const Eigen::Vector3d unit = Eigen::Vector3d::Unit(axis);
    const bool is_used = std::any_of(axes.begin(), axes.end(), [&](auto& used) {
      return std::abs(used.dot(unit)) > 0.5;
    });
    if (!is_used) axes.push_back(unit);
  }
  pugi::xml_node transform = node.append_child("SpatialTransform");
  for (int i = 0; i < 6; ++i) {
    const bool is_rotation = i < 3;
    pugi::xml_node axis = AddNamed(
        transform,
        "TransformAxis",
        (is_rotation ? "rotation" : "translation") + std::to_string(i % 3 + 1));
    const bool moves = is_rotation && i < static_cast<int>(coordinates.size());
    AddText(axis, "coordinates", moves ? coordinates[i].name : "");
    AddText(axis,
            "axis",
            VectorText(is_rotation
                           ? axes[i]
                           : Eigen::Vector3d(Eigen::Vector3d::Unit(i % 3))));
    if (moves) {
      AddText(
          AddNamed(axis, "LinearFunction", "function"), "coefficients", "1 0");
    } else {
      AddText(AddNamed(axis, "Constant", "function"), "value", "0");
    }
  }
}

std::string VerdictText(const FoundJoint& joint) {
  std::string text = joint.name() + ": ";
  text += joint.is_given ? "given" : ToString(joint.verdict.quality);
  for (const std::string& reason : joint.verdict.reasons) {
    text += "; " + reason;
  }
  return text;
}

void AddJoints(const Articulation& articulation, pugi::xml_node model) {
  pugi::xml_node objects =
      AddNamed(model, "JointSet", "jointset").append_child("objects");
  for (const Weld& weld : articulation.welds) {
    pugi::xml_node node =
        AddNamed(objects, "WeldJoint", weld.parent + "_" + weld.child);
    AddSockets(weld.parent, weld.child, node);
    pugi::xml_node frames = node.append_child("frames");
    for (const std::string& body : {weld.parent, weld.child}) {
      AddFrame(
          body, Eigen::Vector3d::Zero(), Eigen::Matrix3d::Identity(), frames);
    }
  }
  for (const FoundJoint& joint : articulation.joints) {
    AddComment(objects, VerdictText(joint));
    if (!joint.IsFound()) continue;
    pugi::xml_node node = AddNamed(objects, "CustomJoint", joint.name());
    AddSockets(joint.parent, joint.child, node);
    AddCoordinates(joint, node);
    pugi::xml_node frames = node.append_child("frames");
    AddFrame(joint.parent, joint.center, joint.parent_axes, frames);
    AddFrame(joint.child, joint.center, joint.child_axes, frames);
    AddTransform(joint, node);
  }
}

std::string NumbersText(const std::vector<double>& numbers) {
  std::string text;
  for (const double number : numbers) {
    text += (text.empty() ? "" : " ") + ExactText(number);
  }
  return text;
}

// Coordinates that follow others. The function is constant beyond its ends, by
// one more point on either side.
void AddCouplers(const Articulation& articulation, pugi::xml_node model) {
  constexpr double kBeyond = 4 * M_PI;
  pugi::xml_node objects;
  for (const FoundJoint& joint : articulation.joints) {
    const JointCoupling& coupling = joint.coupling;
    if (!joint.IsFound() || coupling.coordinate.empty()) continue;
    if (!objects) {
      objects = AddNamed(model, "ConstraintSet", "constraintset")
                    .append_child("objects");
    }
    const std::string dependent = CoordinatesOf(joint.kind, joint.side)[0].name;
    std::vector<double> x = coupling.at, y = coupling.values;
    x.insert(x.begin(), x.front() - kBeyond);
    y.insert(y.begin(), y.front());
    x.push_back(x.back() + kBeyond);
    y.push_back(y.back());
    pugi::xml_node node = AddNamed(
        objects, "CoordinateCouplerConstraint", dependent + "_coupler");
    pugi::xml_node function =
        AddNamed(node.append_child("coupled_coordinates_function"),
                 "PiecewiseLinearFunction",
                 "function");
    AddText(function, "x", NumbersText(x));
    AddText(function, "y", NumbersText(y));
    AddText(node, "independent_coordinate_names", coupling.coordinate);
    AddText(node, "dependent_coordinate_name", dependent);
    AddText(node, "scale_factor", "1");
  }
}

}  // namespace

Eigen::Vector3d BodyFixedAngles(const Eigen::Matrix3d& rotation) {
  const Eigen::Matrix3d& r = rotation;
  const double sine = std::min(1.0, std::max(-1.0, r(0, 2)));
  constexpr double kNearlyOne = 1 - 1e-14;
  if (std::abs(sine) > kNearlyOne) {
    // Turns about x and z are one and the same.
    return {std::atan2(r(2, 1), r(1, 1)), std::asin(sine), 0};
  }
  return {std::atan2(-r(1, 2), r(2, 2)),
          std::asin(sine),
          std::atan2(-r(0, 1), r(0, 0))};
}

std::string ArticulatedModelText(const Articulation& articulation,
                                 const std::string& name,
                                 const std::vector<LineMuscle>& muscles) {
  pugi::xml_document document;
  pugi::xml_node declaration = document.append_child(pugi::node_declaration);
  declaration.append_attribute("version") = "1.0";
  declaration.append_attribute("encoding") = "UTF-8";
  pugi::xml_node root = document.append_child("OpenSimDocument");
  root.append_attribute("Version") = "40000";
  pugi::xml_node model = AddNamed(root, "Model", name);
  AddText(
      model, "credits", "Joints found on the shapes of bones by musclewarp");
  AddText(model, "length_units", "meters");
  AddText(model, "force_units", "N");
  AddText(model, "gravity", "0 0 0");
  AddNamed(model, "Ground", "ground");
  AddBodies(articulation, model);
  AddJoints(articulation, model);
  AddCouplers(articulation, model);
  if (!muscles.empty()) AddMuscles(articulation.bodies, muscles, model);
  std::ostringstream text;
  document.save(text, "  ");
  return text.str();
}

void WriteArticulatedModel(const Articulation& articulation,
                           const std::string& name,
                           const std::string& path,
                           const std::vector<LineMuscle>& muscles) {
  const std::filesystem::path folder =
      std::filesystem::path(path).parent_path() / "Geometry";
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) {
    throw InputError(folder.string(),
                     "cannot be made (" + error.message() + ")",
                     "choose another folder");
  }
  for (const Bone& bone : articulation.bones) {
    WriteTriangleSoup((folder / (bone.name + ".obj")).string(), bone.mesh);
  }
  WriteTextAtomically(path, ArticulatedModelText(articulation, name, muscles));
}

}  // namespace musclewarp
