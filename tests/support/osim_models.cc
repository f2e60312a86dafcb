// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "support/osim_models.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <sstream>

#include "musclewarp/base/output_file.h"
#include "support/temp_dir.h"

namespace musclewarp {

std::string Model4(const std::string& joint,
                   const std::string& constraints,
                   const std::string& forces) {
  return R"(<?xml version="1.0" encoding="UTF-8" ?>
<OpenSimDocument Version="40000">
 <Model name="leg">
  <Ground name="ground"/>
  <BodySet name="bodyset"><objects>
   <Body name="thigh"/>
   <Body name="shank"/>
  </objects></BodySet>
  <JointSet name="jointset"><objects>
   <WeldJoint name="hip">
    <socket_parent_frame>/ground</socket_parent_frame>
    <socket_child_frame>/bodyset/thigh</socket_child_frame>
   </WeldJoint>
   )" + joint +
         R"(
  </objects></JointSet>
  <ConstraintSet name="constraintset"><objects>)" +
         constraints + R"(</objects></ConstraintSet>
  <ForceSet name="forceset"><objects>)" +
         forces + R"(</objects></ForceSet>
 </Model>
</OpenSimDocument>
)";
}

std::string Joint4(const std::string& type,
                   const std::string& coordinates,
                   const std::string& rest) {
  std::string text = "<" + type + " name=\"knee_joint\">" + R"(
    <socket_parent_frame>thigh_offset</socket_parent_frame>
    <socket_child_frame>shank_offset</socket_child_frame>
    <coordinates>)";
  std::istringstream names(coordinates);
  for (std::string name; names >> name;) {
    text += "<Coordinate name=\"" + name + "\"/>";
  }
  return text + R"(</coordinates>
    <frames>
     <PhysicalOffsetFrame name="thigh_offset">
      <socket_parent>/bodyset/thigh</socket_parent>
      <translation>0 -0.4 0</translation><orientation>0 0 0</orientation>
     </PhysicalOffsetFrame>
     <PhysicalOffsetFrame name="shank_offset">
      <socket_parent>/bodyset/shank</socket_parent>
      <translation>0 0 0</translation><orientation>0 0 0</orientation>
     </PhysicalOffsetFrame>
    </frames>
    )" + rest +
         "</" + type + ">";
}

std::string Axis4(const std::string& coordinates,
                  const std::string& axis,
                  const std::string& function) {
  return "<TransformAxis><coordinates>" + coordinates + "</coordinates><axis>" +
         axis + "</axis><function>" + function + "</function></TransformAxis>";
}

std::string SpatialTransform(const std::string& axes) {
  return "<SpatialTransform>" + axes + "</SpatialTransform>";
}

std::string FreeAxes(int from, int to) {
  static const char* const kAxes[] = {"1 0 0", "0 1 0", "0 0 1"};
  std::string text;
  for (int i = from; i < to; ++i) {
    text += Axis4("", kAxes[i % 3], "<Constant><value>0</value></Constant>");
  }
  return text;
}

std::string Model3(const std::string& joint_extra, const std::string& forces) {
  return R"(<?xml version="1.0" encoding="UTF-8" ?>
<OpenSimDocument Version="30000">
 <Model name="leg">
  <BodySet><objects>
   <Body name="ground"><Joint/></Body>
   <Body name="thigh"><Joint><WeldJoint name="hip">
     <parent_body>ground</parent_body>
     <location_in_parent>0 0 0</location_in_parent>
     <orientation_in_parent>0 0 0</orientation_in_parent>
     <location>0 0 0</location><orientation>0 0 0</orientation>
   </WeldJoint></Joint></Body>
   <Body name="shank"><Joint><PinJoint name="knee_joint">
     <parent_body>thigh</parent_body>
     <location_in_parent>0 -0.4 0</location_in_parent>
     <orientation_in_parent>0 0 0</orientation_in_parent>
     <location>0 0 0</location><orientation>0 0 0</orientation>
     <CoordinateSet><objects><Coordinate name="knee">
       <motion_type>rotational</motion_type><default_value>0.25</default_value>
     </Coordinate></objects></CoordinateSet>)" +
         joint_extra + R"(
   </PinJoint></Joint></Body>
  </objects></BodySet>
  <ForceSet><objects>)" +
         forces + R"(</objects></ForceSet>
 </Model>
</OpenSimDocument>
)";
}

std::string Muscle(const std::string& name, const std::string& points) {
  return "<Thelen2003Muscle name=\"" + name +
         "\"><GeometryPath><PathPointSet><objects>" + points +
         "</objects></PathPointSet></GeometryPath></Thelen2003Muscle>";
}

std::string Point4(const std::string& name,
                   const std::string& body,
                   const std::string& location,
                   const std::string& type,
                   const std::string& extra) {
  return "<" + type + " name=\"" + name + "\"><socket_parent_frame>/bodyset/" +
         body + "</socket_parent_frame><location>" + location + "</location>" +
         extra + "</" + type + ">";
}

std::string Written(const std::string& name, const std::string& text) {
  const std::string dir = TestTempPath();
  std::filesystem::create_directories(dir);
  WriteTextAtomically(dir + "/" + name, text);
  return dir + "/" + name;
}

std::string Replaced(std::string text,
                     const std::string& from,
                     const std::string& to) {
  const auto at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return at == std::string::npos ? text : text.replace(at, from.size(), to);
}

}  // namespace musclewarp
