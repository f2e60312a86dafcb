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
  int body = -1;  // none if the frame is not known
  Eigen::Matrix4d body_from_frame = Eigen::Matrix4d::Identity();

  // Why the frame is not known, for messages: "the frame "x" in line 12, ...".
  // Empty if it is known.
  std::string unknown;
};

// Finds the body that an element of an OpenSim 4 file means. Such an element, a
// socket, names a body, the ground, or a PhysicalOffsetFrame on one of them,
// which may rest on further offset frames and may be kept anywhere in the file.
// A frame that is not known is an error only where it is needed.
class OffsetFrames {
 public:
  // Collects the offset frames of the file. Keeps references to both arguments;
  // the model must have its bodies.
  OffsetFrames(const OsimXml& xml, const Model& model);

  // Returns the frame that a socket names by its path from the model
  // ("/bodyset/femur_r"), by the path from the component that has the socket
  // ("..", "femur_r_offset"), or by a name only, as betas of OpenSim 4 have it.
  // If several offset frames have that name, the one below the component
  // before it in the path is meant, or else the one below the component that
  // has the socket.
  FrameOnBody Resolve(pugi::xml_node socket) const;

  // All elements <PhysicalOffsetFrame> of the file.
  const std::vector<pugi::xml_node>& nodes() const { return nodes_; }

  // Returns where an offset frame, one of nodes(), sits.
  FrameOnBody Place(pugi::xml_node frame) const;

 private:
  // The same with the number of frames passed so far, which ends a circle.
  FrameOnBody Resolve(pugi::xml_node socket, int depth) const;
  FrameOnBody Place(pugi::xml_node frame, int depth) const;

  // Returns the offset frame with the last name of a path that is no path of
  // the model, or an empty node.
  pugi::xml_node FrameNamed(const std::string& path,
                            const std::string& owner) const;

  const OsimXml& xml_;
  const Model& model_;
  std::vector<pugi::xml_node> nodes_;
};

}  // namespace musclewarp
