// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/phantom/hip_model.h"

#include <cmath>
#include <sstream>

#include "musclewarp/base/text.h"

namespace musclewarp::phantom {
namespace {

constexpr double kMetres = 1e-3;  // per mm
constexpr char kFlexion[] = "hip_flexion_r";

std::string Text(const Eigen::Vector3d& point_mm) {
  return NumberText(kMetres * point_mm[0], 12) + " " +
         NumberText(kMetres * point_mm[1], 12) + " " +
         NumberText(kMetres * point_mm[2], 12);
}

std::string OffsetFrame(const std::string& body, const Eigen::Vector3d& at) {
  return "          <PhysicalOffsetFrame name=\"" + body +
         "_offset\">\n            <socket_parent>/bodyset/" + body +
         "</socket_parent>\n            <translation>" + Text(at) +
         "</translation>\n            <orientation>0 0 0</orientation>\n"
         "          </PhysicalOffsetFrame>\n";
}

std::string CoordinateText(const std::string& name) {
  return "          <Coordinate name=\"" + name +
         "\">\n            <default_value>0</default_value>\n"
         "          </Coordinate>\n";
}

std::string Axis(const std::string& name,
                 const std::string& coordinate,
                 const std::string& axis) {
  const bool moves = !coordinate.empty();
  return "          <TransformAxis name=\"" + name +
         "\">\n            <coordinates>" + coordinate +
         "</coordinates>\n            <axis>" + axis + "</axis>\n" +
         (moves ? "            <LinearFunction name=\"function\">\n"
                  "              <coefficients>1 0</coefficients>\n"
                  "            </LinearFunction>\n"
                : "            <Constant name=\"function\">\n"
                  "              <value>0</value>\n"
                  "            </Constant>\n") +
         "          </TransformAxis>\n";
}

std::string FixedPoint(const std::string& name,
                       const std::string& body,
                       const Eigen::Vector3d& location) {
  return "              <PathPoint name=\"" + name +
         "\">\n                <socket_parent_frame>/bodyset/" + body +
         "</socket_parent_frame>\n                <location>" + Text(location) +
         "</location>\n              </PathPoint>\n";
}

// The point moves straight from its rest place, at flexion 0, to its place at
// 60 degrees, and beyond.
std::string MovingPoint(const std::string& name,
                        const std::string& body,
                        const Eigen::Vector3d& rest,
                        const Eigen::Vector3d& flexed) {
  std::ostringstream text;
  text.precision(12);
  text << "              <MovingPathPoint name=\"" << name
       << "\">\n                <socket_parent_frame>/bodyset/" << body
       << "</socket_parent_frame>\n";
  for (int k = 0; k < 3; ++k) {
    const char letter = static_cast<char>('x' + k);
    text << "                <socket_" << letter
         << "_coordinate>/jointset/hip_r/" << kFlexion << "</socket_" << letter
         << "_coordinate>\n"
         << "                <" << letter
         << "_location>\n                  <PiecewiseLinearFunction>\n"
            "                    <x>0 "
         << M_PI / 3 << "</x>\n                    <y>" << kMetres * rest[k]
         << " " << kMetres * flexed[k]
         << "</y>\n                  </PiecewiseLinearFunction>\n"
            "                </"
         << letter << "_location>\n";
  }
  text << "              </MovingPathPoint>\n";
  return text.str();
}

std::string MuscleText(const ActionLine& line, const WrappedPoint& wrapped) {
  std::string text = "      <PathActuator name=\"" + line.name +
                     "\">\n        <GeometryPath name=\"geometrypath\">\n"
                     "          <PathPointSet>\n            <objects>\n";
  for (Eigen::Index i = 0; i < line.rest.rows(); ++i) {
    const std::string name = line.name + "-P" + std::to_string(i + 1);
    const Eigen::Vector3d location = line.rest.row(i).transpose();
    text += line.name == wrapped.line && i == wrapped.point
                ? MovingPoint(name, line.bodies[i], location, wrapped.flexed)
                : FixedPoint(name, line.bodies[i], location);
  }
  return text +
         "            </objects>\n          </PathPointSet>\n"
         "        </GeometryPath>\n      </PathActuator>\n";
}

}  // namespace

std::string HipModelText(const Scene& scene,
                         const Eigen::Vector3d& hip_centre,
                         const WrappedPoint& wrapped) {
  std::string text =
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
      "<OpenSimDocument Version=\"40000\">\n  <Model name=\"hip\">\n"
      "    <Ground name=\"ground\"/>\n"
      "    <length_units>meters</length_units>\n"
      "    <BodySet name=\"bodyset\">\n      <objects>\n"
      "        <Body name=\"pelvis\"/>\n        <Body name=\"femur_r\"/>\n"
      "      </objects>\n    </BodySet>\n"
      "    <JointSet name=\"jointset\">\n      <objects>\n"
      "      <WeldJoint name=\"ground_pelvis\">\n"
      "        <socket_parent_frame>/ground</socket_parent_frame>\n"
      "        <socket_child_frame>/bodyset/pelvis</socket_child_frame>\n"
      "      </WeldJoint>\n"
      "      <CustomJoint name=\"hip_r\">\n"
      "        <socket_parent_frame>pelvis_offset</socket_parent_frame>\n"
      "        <socket_child_frame>femur_r_offset</socket_child_frame>\n"
      "        <coordinates>\n";
  text += CoordinateText(kFlexion) + CoordinateText("hip_adduction_r") +
          CoordinateText("hip_rotation_r") +
          "        </coordinates>\n        <frames>\n";
  text += OffsetFrame("pelvis", hip_centre) +
          OffsetFrame("femur_r", hip_centre) +
          "        </frames>\n        <SpatialTransform>\n";
  text += Axis("rotation1", kFlexion, "1 0 0") +
          Axis("rotation2", "hip_adduction_r", "0 1 0") +
          Axis("rotation3", "hip_rotation_r", "0 0 1") +
          Axis("translation1", "", "1 0 0") +
          Axis("translation2", "", "0 1 0") + Axis("translation3", "", "0 0 1");
  text +=
      "        </SpatialTransform>\n      </CustomJoint>\n"
      "      </objects>\n    </JointSet>\n"
      "    <ForceSet name=\"forceset\">\n      <objects>\n";
  for (const SceneMuscle& muscle : scene.muscles) {
    for (const ActionLine& line : muscle.lines) {
      text += MuscleText(line, wrapped);
    }
  }
  return text +
         "      </objects>\n    </ForceSet>\n  </Model>\n"
         "</OpenSimDocument>\n";
}

std::string HipMotionText() {
  constexpr int kRows = 15;
  std::ostringstream text;
  text << "hip_flexion\nversion=1\nnRows=" << kRows
       << "\nnColumns=2\ninDegrees=yes\nendheader\ntime\t" << kFlexion << "\n";
  for (int i = 0; i < kRows; ++i) {
    text << 0.05 * i << "\t" << -10 + 5 * i << "\n";
  }
  return text.str();
}

}  // namespace musclewarp::phantom
