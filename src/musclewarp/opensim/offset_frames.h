// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "musclewarp/opensim/model.h"
#include "musclewarp/opensim/osim_xml.h"

namespace musclewarp {

// Returns the transform (mm) of OpenSim's elements "translation" (m) and
// "orientation" (rad): rotations about x, y and z in turn, each about the axes
// that the ones before have turned, and the translation after them.
Eigen::Matrix4d OffsetTransform(const Eigen::Vector3d& translation_m,
                                const Eigen::Vector3d& orientation);

// A frame that is fixed to a body: the index of the body, and the place of the
// frame on it (mm).
struct FrameOnBody {
  int body = -1;
  Eigen::Matrix4d body_from_frame = Eigen::Matrix4d::Identity();
};

// Finds the body that an element of an OpenSim 4 file means. Such an element, a
// socket, names a body, the ground, or a PhysicalOffsetFrame on one of them,
// which may rest on further offset frames and may be kept anywhere in the file.
class OffsetFrames {
 public:
  // Collects the offset frames of the file. Keeps references to both arguments;
  // the model must have its bodies.
  OffsetFrames(const OsimXml& xml, const Model& model);

  // Returns the frame that a socket names, such as "/bodyset/femur_r" or
  // "femur_r_offset". If several offset frames have that name, the one below
  // the component before it in the path is meant, or else the one below the
  // component `owner`, such as the joint that has the socket. Throws InputError
  // at `socket` if there is no such frame or body.
  FrameOnBody Resolve(pugi::xml_node socket, const std::string& owner) const;

  // All elements <PhysicalOffsetFrame> of the file.
  const std::vector<pugi::xml_node>& nodes() const { return nodes_; }

  // Returns where an offset frame, one of nodes(), sits. Throws InputError at
  // the frame if it does not rest on a body, because it rests on itself.
  FrameOnBody Place(pugi::xml_node frame) const;

 private:
  // The same with the number of frames passed so far, which ends a circle.
  FrameOnBody Resolve(pugi::xml_node socket,
                      const std::string& owner,
                      int depth) const;
  FrameOnBody Place(pugi::xml_node frame, int depth) const;

  const OsimXml& xml_;
  const Model& model_;
  std::vector<pugi::xml_node> nodes_;
};

}  // namespace musclewarp
