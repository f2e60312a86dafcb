// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/joints/articulated_model.h"

#include <gtest/gtest.h>

#include <map>
#include <pugixml.hpp>
#include <set>
#include <string>

#include "joints/made_leg.h"
#include "musclewarp/joints/articulation.h"

namespace musclewarp {
namespace {

// The children that elements have in OpenSim 4's own models, as far as they are
// written here: Rajagopal2016.osim of opensim-models (version 40000).
const std::map<std::string, std::set<std::string>>& ChildrenInOpenSim() {
  static const auto* children = new std::map<std::string,
                                             std::set<std::string>>{
      {"OpenSimDocument", {"Model"}},
      {"Model",
       {"Ground",
        "gravity",
        "credits",
        "length_units",
        "force_units",
        "BodySet",
        "JointSet",
        "ConstraintSet"}},
      {"Ground", {}},
      {"BodySet", {"objects"}},
      {"JointSet", {"objects"}},
      {"ConstraintSet", {"objects"}},
      {"objects",
       {"Body", "WeldJoint", "CustomJoint", "CoordinateCouplerConstraint"}},
      {"Body", {"attached_geometry", "mass", "mass_center", "inertia"}},
      {"attached_geometry", {"Mesh"}},
      {"Mesh", {"socket_frame", "scale_factors", "mesh_file"}},
      {"WeldJoint", {"socket_parent_frame", "socket_child_frame", "frames"}},
      {"CustomJoint",
       {"socket_parent_frame",
        "socket_child_frame",
        "coordinates",
        "frames",
        "SpatialTransform"}},
      {"frames", {"PhysicalOffsetFrame"}},
      {"PhysicalOffsetFrame", {"socket_parent", "translation", "orientation"}},
      {"Coordinate",
       {"default_value", "default_speed_value", "range", "clamped", "locked"}},
      {"SpatialTransform", {"TransformAxis"}},
      {"TransformAxis", {"coordinates", "axis", "LinearFunction", "Constant"}},
      {"LinearFunction", {"coefficients"}},
      {"Constant", {"value"}},
      {"CoordinateCouplerConstraint",
       {"coupled_coordinates_function",
        "independent_coordinate_names",
        "dependent_coordinate_name",
        "scale_factor"}},
      {"coupled_coordinates_function", {"PiecewiseLinearFunction"}},
      {"PiecewiseLinearFunction", {"x", "y"}},
  };
  return *children;
}

void ExpectKnownChildren(pugi::xml_node node) {
  const std::string name = node.name();
  const auto known = ChildrenInOpenSim().find(name);
  for (const pugi::xml_node child : node.children()) {
    if (child.type() != pugi::node_element) continue;
    // The coordinates of a joint are elements, those of an axis names.
    if (name == "coordinates") {
      EXPECT_STREQ(child.name(), "Coordinate");
    } else if (known == ChildrenInOpenSim().end()) {
      ADD_FAILURE() << "<" << name << "> has <" << child.name() << ">";
    } else {
      EXPECT_EQ(known->second.count(child.name()), 1u)
          << "<" << name << "> has <" << child.name() << ">";
    }
    ExpectKnownChildren(child);
  }
}

TEST(ArticulatedModelText, HasTheElementsOfOpenSimFour) {
  const std::string text =
      ArticulatedModelText(Articulate(LegWithPatella(Side::kRight), {}), "leg");
  pugi::xml_document document;
  ASSERT_TRUE(document.load_string(text.c_str()));
  const pugi::xml_node root = document.document_element();
  EXPECT_STREQ(root.attribute("Version").value(), "40000");
  ExpectKnownChildren(root);
  // All kinds of joints are there.
  for (const char* kind :
       {"WeldJoint", "CustomJoint", "CoordinateCouplerConstraint"}) {
    EXPECT_NE(text.find(std::string("<") + kind), std::string::npos) << kind;
  }
}

// OpenSim finds a frame of a joint among those that the joint has.
TEST(ArticulatedModelText, HasTheFramesThatItsJointsName) {
  const std::string text =
      ArticulatedModelText(Articulate(LegOf(Side::kLeft).bones, {}), "leg");
  pugi::xml_document document;
  ASSERT_TRUE(document.load_string(text.c_str()));
  int joints = 0;
  for (const pugi::xml_node joint : document.document_element()
                                        .child("Model")
                                        .child("JointSet")
                                        .child("objects")
                                        .children()) {
    if (joint.type() != pugi::node_element) continue;
    ++joints;
    for (const char* socket : {"socket_parent_frame", "socket_child_frame"}) {
      const pugi::xml_node frame =
          joint.child("frames").find_child_by_attribute(
              "PhysicalOffsetFrame", "name", joint.child_value(socket));
      ASSERT_TRUE(frame) << joint.attribute("name").value();
      const std::string body = frame.child_value("socket_parent");
      EXPECT_TRUE(body == "/ground" || body.rfind("/bodyset/", 0) == 0) << body;
    }
  }
  EXPECT_EQ(joints, 3);  // the pelvis is fixed to the ground; hip and knee
}

}  // namespace
}  // namespace musclewarp
