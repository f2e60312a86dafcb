// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/opensim/offset_frames.h"

#include <Eigen/Geometry>

namespace musclewarp {
namespace {

constexpr int kDeepest = 100;  // more frames on each other are a cycle

// Returns the name of the component to which a frame belongs, that of the
// nearest element above it that has a name.
std::string OwnerOf(pugi::xml_node frame) {
  for (auto node = frame.parent(); node; node = node.parent()) {
    if (node.attribute("name")) return node.attribute("name").value();
  }
  return "";
}

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
    : xml_(xml), model_(model) {
  struct Walker : pugi::xml_tree_walker {
    std::vector<pugi::xml_node>* nodes;
    bool for_each(pugi::xml_node& node) override {
      if (std::string(node.name()) == "PhysicalOffsetFrame") {
        nodes->push_back(node);
      }
      return true;
    }
  } walker;
  walker.nodes = &nodes_;
  xml.root().traverse(walker);
}

FrameOnBody OffsetFrames::Resolve(pugi::xml_node socket,
                                  const std::string& owner) const {
  return Resolve(socket, owner, 0);
}

FrameOnBody OffsetFrames::Place(pugi::xml_node frame) const {
  return Place(frame, 0);
}

FrameOnBody OffsetFrames::Resolve(pugi::xml_node socket,
                                  const std::string& owner,
                                  int depth) const {
  const std::string path = xml_.Text(socket);
  const std::string name = LastName(path);
  const std::string path_owner = OwnerInPath(path);
  pugi::xml_node best;
  int best_rank = 0;
  for (const pugi::xml_node frame : nodes_) {
    if (frame.attribute("name").value() != name) continue;
    const std::string keeper = OwnerOf(frame);
    const int rank = keeper == path_owner ? 3 : keeper == owner ? 2 : 1;
    if (rank > best_rank) best = frame;
    best_rank = std::max(rank, best_rank);
  }
  if (best) return Place(best, depth);
  FrameOnBody frame;
  frame.body = model_.FindBody(name);
  if (frame.body < 0) {
    xml_.Fail(
        socket,
        "names \"" + path + "\", which is not a body or frame of the model",
        "check the name");
  }
  return frame;
}

FrameOnBody OffsetFrames::Place(pugi::xml_node frame, int depth) const {
  if (depth > kDeepest) {
    xml_.Fail(frame,
              "rests on itself through other frames",
              "set its socket_parent to a body");
  }
  FrameOnBody placed =
      Resolve(xml_.Child(frame, "socket_parent"), OwnerOf(frame), depth + 1);
  placed.body_from_frame =
      placed.body_from_frame *
      OffsetTransform(
          xml_.Vector(frame, "translation", Eigen::Vector3d::Zero()),
          xml_.Vector(frame, "orientation", Eigen::Vector3d::Zero()));
  return placed;
}

}  // namespace musclewarp
