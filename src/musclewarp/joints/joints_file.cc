// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/joints/joints_file.h"

#include <Eigen/Geometry>
#include <optional>
#include <set>
#include <string>

#include "musclewarp/base/angles.h"
#include "musclewarp/joints/joint_building.h"
#include "musclewarp/scene/json_fields.h"
#include "musclewarp/scene/scene_names.h"

namespace musclewarp {
namespace {

using OrderedJson = nlohmann::ordered_json;

OrderedJson VectorJson(const Eigen::Vector3d& vector) {
  return {vector.x(), vector.y(), vector.z()};
}

OrderedJson RowsJson(const Eigen::Matrix3d& matrix) {
  OrderedJson rows = OrderedJson::array();
  for (int row = 0; row < 3; ++row) {
    rows.push_back(VectorJson(matrix.row(row).transpose()));
  }
  return rows;
}

OrderedJson ShapeJson(const FittedShape& shape, const FoundJoint& joint) {
  OrderedJson json = {{"what", shape.what}};
  json["body"] = shape.is_on_parent ? joint.parent : joint.child;
  json["shape"] = shape.kind == FittedShape::Kind::kSphere     ? "sphere"
                  : shape.kind == FittedShape::Kind::kCylinder ? "cylinder"
                                                               : "axis";
  json["center_mm"] = VectorJson(shape.center);
  if (shape.direction.norm() > 0) json["axis"] = VectorJson(shape.direction);
  json["radius_mm"] = shape.radius;
  json["spread_mm"] = shape.spread;
  if (shape.kind == FittedShape::Kind::kSphere) {
    json["coverage"] = shape.coverage;
  } else {
    json["angle_deg"] = shape.angle / kRadiansPerDegree;
  }
  return json;
}

OrderedJson CouplingJson(const JointCoupling& coupling) {
  OrderedJson json = {{"coordinate", coupling.coordinate},
                      {"at_deg", OrderedJson::array()},
                      {"values_deg", OrderedJson::array()}};
  for (size_t i = 0; i < coupling.at.size(); ++i) {
    json["at_deg"].push_back(coupling.at[i] / kRadiansPerDegree);
    json["values_deg"].push_back(coupling.values[i] / kRadiansPerDegree);
  }
  return json;
}

OrderedJson JointJson(const FoundJoint& joint) {
  OrderedJson json = {{"name", joint.name()},
                      {"parent", joint.parent},
                      {"child", joint.child},
                      {"quality", ToString(joint.verdict.quality)},
                      {"given", joint.is_given},
                      {"reasons", joint.verdict.reasons}};
  if (joint.IsFound()) {
    json["center_mm"] = VectorJson(joint.center);
    json["parent_axes"] = RowsJson(joint.parent_axes);
    json["child_axes"] = RowsJson(joint.child_axes);
    OrderedJson coordinates = OrderedJson::array();
    const std::vector<double> values = ScanCoordinates(joint);
    const std::vector<JointCoordinate> entries =
        CoordinatesOf(joint.kind, joint.side);
    for (size_t i = 0; i < entries.size(); ++i) {
      coordinates.push_back(
          {{"name", entries[i].name},
           {"axis", VectorJson(joint.parent_axes * entries[i].axis)},
           {"axis_in_joint", VectorJson(entries[i].axis)},
           {"scan_deg", values[i] / kRadiansPerDegree},
           {"range_deg", {entries[i].lowest, entries[i].highest}}});
      if (joint.coupling.coordinate.empty()) continue;
      coordinates.back()["follows"] = CouplingJson(joint.coupling);
    }
    json["coordinates"] = coordinates;
  }
  OrderedJson shapes = OrderedJson::array();
  for (const FittedShape& shape : joint.shapes) {
    shapes.push_back(ShapeJson(shape, joint));
  }
  json["shapes"] = shapes;
  return json;
}

// The kind and the side that the name of a joint has.
struct JointId {
  JointKind kind;
  Side side;
};
JointId IdOf(const JsonField& name) {
  std::string known;
  for (const Side side : {Side::kRight, Side::kLeft}) {
    for (const JointKind kind : AllJointKinds()) {
      if (JointName(kind, side) == name.AsString()) return {kind, side};
      known += (known.empty() ? "" : ", ") + JointName(kind, side);
    }
  }
  name.Fail("is " + QuotedName(name.AsString()) + ", which is no joint",
            "allowed: " + known);
}

Eigen::Vector3d ReadVector(const JsonField& field, bool is_length) {
  if (field.ArraySize() != 3)
    field.Fail("has not three numbers", "give [x, y, z]");
  Eigen::Vector3d vector;
  for (int i = 0; i < 3; ++i) {
    const JsonField number = field.At(static_cast<size_t>(i));
    vector[i] = is_length ? number.AsCoordinate() : number.AsNumber();
  }
  return vector;
}

Eigen::Matrix3d ReadAxes(const JsonField& field) {
  // Files have axes rounded to some digits.
  constexpr double kTolerance = 1e-3;
  if (field.ArraySize() != 3)
    field.Fail("has not three rows", "give 3 x 3 numbers");
  Eigen::Matrix3d axes;
  for (int row = 0; row < 3; ++row) {
    axes.row(row) = ReadVector(field.At(static_cast<size_t>(row)), false);
  }
  if ((axes * axes.transpose() - Eigen::Matrix3d::Identity()).norm() >
          kTolerance ||
      axes.determinant() < 0) {
    field.Fail("is no rotation",
               "give right-handed axes of unit length at right angles, as "
               "columns: forward, up, right");
  }
  return Eigen::Quaterniond(axes).normalized().toRotationMatrix();
}

// Axes in which the first coordinate of a joint turns about a direction.
Eigen::Matrix3d AxesAbout(const JsonField& field, const JointId& id) {
  const Eigen::Vector3d direction = ReadVector(field, false);
  if (!(direction.norm() > 0)) field.Fail("is zero", "give a direction");
  const Eigen::Vector3d own = CoordinatesOf(id.kind, id.side)[0].axis;
  return Eigen::Quaterniond::FromTwoVectors(own, direction).toRotationMatrix();
}

JointCoupling ReadCoupling(const JsonField& field) {
  JointCoupling coupling;
  coupling.coordinate = field.At("coordinate").AsString();
  const JsonField at = field.At("at_deg"), values = field.At("values_deg");
  if (at.ArraySize() == 0 || at.ArraySize() != values.ArraySize()) {
    values.Fail("has " + std::to_string(values.ArraySize()) + " numbers",
                "give as many as at_deg, at least one");
  }
  for (size_t i = 0; i < at.ArraySize(); ++i) {
    coupling.at.push_back(at.At(i).AsNumber() * kRadiansPerDegree);
    coupling.values.push_back(values.At(i).AsNumber() * kRadiansPerDegree);
    if (i > 0 && coupling.at[i] <= coupling.at[i - 1]) {
      at.At(i).Fail("is not above the number before it", "sort the points");
    }
  }
  return coupling;
}

FoundJoint ReadJoint(const JsonField& field, const JointId& id) {
  FoundJoint joint;
  joint.kind = id.kind;
  joint.side = id.side;
  joint.is_given = true;
  joint.center = ReadVector(field.At("center_mm"), true);
  joint.parent_axes = field.Has("parent_axes")
                          ? ReadAxes(field.At("parent_axes"))
                          : AxesAbout(field.At("axis"), id);
  joint.child_axes = field.Has("child_axes") ? ReadAxes(field.At("child_axes"))
                                             : joint.parent_axes;
  if (field.Has("coordinates") && field.At("coordinates").ArraySize() == 1 &&
      field.At("coordinates").At(0).Has("follows")) {
    joint.coupling = ReadCoupling(field.At("coordinates").At(0).At("follows"));
  }
  return joint;
}

}  // namespace

OrderedJson JointsJson(const Articulation& articulation,
                       const std::string& axes) {
  OrderedJson bones = OrderedJson::array(), joints = OrderedJson::array();
  OrderedJson welds = OrderedJson::array();
  for (const Bone& bone : articulation.bones) {
    bones.push_back(
        {{"name", bone.name},
         {"body", bone.body},
         {"side",
          bone.side ? OrderedJson(ToString(*bone.side)) : OrderedJson()}});
  }
  for (const FoundJoint& joint : articulation.joints) {
    joints.push_back(JointJson(joint));
  }
  for (const Weld& weld : articulation.welds) {
    welds.push_back({{"parent", weld.parent}, {"child", weld.child}});
  }
  return {{"units", "mm"},
          {"axes", axes},
          {"joints", joints},
          {"bones", bones},
          {"bodies", articulation.bodies},
          {"welds", welds},
          {"notes", articulation.notes}};
}

std::vector<FoundJoint> ReadJoints(const std::string& path) {
  return ReadJoints(JsonField::ParseFile(path));
}

std::vector<FoundJoint> ReadJoints(const JsonField& file) {
  const JsonField root = file.Has("units") ? file.InItsUnits() : file;
  const JsonField list = root.At("joints");
  std::vector<FoundJoint> joints;
  std::set<std::string> names;
  for (size_t i = 0; i < list.ArraySize(); ++i) {
    const JsonField field = list.At(i);
    const JsonField name = field.At("name");
    const JointId id = IdOf(name);
    if (!names.insert(name.AsString()).second) {
      name.Fail("is " + QuotedName(name.AsString()) + ", which is given twice",
                "remove one");
    }
    if (field.Has("quality") && field.At("quality").AsString() == "failed" &&
        !field.Has("center_mm")) {
      continue;
    }
    joints.push_back(ReadJoint(field, id));
  }
  return joints;
}

}  // namespace musclewarp
