// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/opensim/offset_frames.h"

#include <Eigen/Geometry>
#include <algorithm>

#include "musclewarp/opensim/component_tree.h"

namespace musclewarp {
namespace {

constexpr int kDeepest = 100;  // more frames on each other are a cycle

constexpr char kOffsetFrame[] = "PhysicalOffsetFrame";

// Returns the component before the last name of a path, such as "knee_r" of
// "/jointset/knee_r/femur_r_offset".
std::string OwnerInPath(const std::string& path) {
  const auto slash = path.find_last_of('/');
  return slash == std::string::npos ? "" : LastName(path.substr(0, slash));
}

}  // namespace

Eigen::Matrix4d OffsetTransform(const Eigen::Vector3d& translation_m,
                                const Eigen::Vector3d& orientation) {
  using Eigen::AngleAxisd;
  using Eigen::Vector3d;
  Eigen::Matrix4d transform = Eigen::Matrix4d::Identity();
  transform.topLeftCorner<3, 3>() =
      (AngleAxisd(orientation[0], Vector3d::UnitX()) *
       AngleAxisd(orientation[1], Vector3d::UnitY()) *
       AngleAxisd(orientation[2], Vector3d::UnitZ()))
          .toRotationMatrix();
  transform.topRightCorner<3, 1>() = kMillimetresPerMetre * translation_m;
  return transform;
}

OffsetFrames::OffsetFrames(const OsimXml& xml, const Model& model)
    : xml_(xml),
      model_(model),
      nodes_(ElementsNamed(xml.root(), kOffsetFrame)) {}

FrameOnBody OffsetFrames::Resolve(pugi::xml_node socket) const {
  return Resolve(socket, 0);
}

FrameOnBody OffsetFrames::Place(pugi::xml_node frame) const {
  return Place(frame, 0);
}

pugi::xml_node OffsetFrames::FrameNamed(const std::string& path,
                                        const std::string& owner) const {
  const std::string name = LastName(path);
  const std::string path_owner = OwnerInPath(path);
  pugi::xml_node best;
  int best_rank = 0;
  for (const pugi::xml_node frame : nodes_) {
    if (ComponentName(frame) != name) continue;
    const std::string keeper = ComponentName(OwnerOf(frame));
    const int rank = keeper == path_owner ? 3 : keeper == owner ? 2 : 1;
    if (rank > best_rank) best = frame;
    best_rank = std::max(rank, best_rank);
  }
  return best;
}

FrameOnBody OffsetFrames::Resolve(pugi::xml_node socket, int depth) const {
  const std::string path = xml_.Text(socket);
  const pugi::xml_node owner = OwnerOf(socket);
  pugi::xml_node component =
      path.empty() ? pugi::xml_node() : FindComponent(owner, path);
  const std::string type = component.name();
  const bool is_body = type == "Body" || type == "Ground";
  if (!is_body && type != kOffsetFrame) {
    component = FrameNamed(path, ComponentName(owner));
  }
  if (component && !is_body) return Place(component, depth);
  FrameOnBody frame;
  frame.body =
      model_.FindBody(is_body ? ComponentName(component) : LastName(path));
  if (frame.body < 0) {
    frame.unknown = "the frame \"" + path + "\" in line " +
                    std::to_string(xml_.LineOf(socket)) +
                    ", which is not a body or frame of the model";
  }
  return frame;
}

FrameOnBody OffsetFrames::Place(pugi::xml_node frame, int depth) const {
  if (depth > kDeepest) {
    FrameOnBody unknown;
    unknown.unknown = "the frame \"" + ComponentName(frame) + "\" in line " +
                      std::to_string(xml_.LineOf(frame)) +
                      ", which rests on itself through other frames";
    return unknown;
  }
  FrameOnBody placed =
      Resolve(SocketOf(xml_, frame, {"parent", "parent_frame"}), depth + 1);
  placed.body_from_frame =
      placed.body_from_frame *
      OffsetTransform(
          xml_.Vector(frame, "translation", Eigen::Vector3d::Zero()),
          xml_.Vector(frame, "orientation", Eigen::Vector3d::Zero()));
  return placed;
}

}  // namespace musclewarp
