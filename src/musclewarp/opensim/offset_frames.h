// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "musclewarp/opensim/model.h"
#include "musclewarp/opensim/osim_xml.h"

namespace musclewarp {

// Rotations about x, y and z in turn, each about the axes the one before has
// turned, rad; then a translation, m. In mm.
Eigen::Matrix4d OffsetTransform(const Eigen::Vector3d& translation_m,
                                const Eigen::Vector3d& orientation);

// A body and where a frame sits on it.
struct FrameOnBody {
  int body = -1;
  Eigen::Matrix4d body_from_frame = Eigen::Matrix4d::Identity();
};

// The frames of an OpenSim 4 file: bodies, the ground, and the
// PhysicalOffsetFrames on them, wherever they are kept.
class OffsetFrames {
 public:
  OffsetFrames(const OsimXml& xml, const Model& model);

  // What a socket names: the body or offset frame of that name; of several
  // offset frames of one name, the one that `owner` (a joint, say) keeps or the
  // path goes through. Throws InputError at `socket`.
  FrameOnBody Resolve(pugi::xml_node socket, const std::string& owner) const;

  const std::vector<pugi::xml_node>& nodes() const { return nodes_; }
  FrameOnBody Place(pugi::xml_node frame) const;

 private:
  FrameOnBody Resolve(pugi::xml_node socket,
                      const std::string& owner,
                      int depth) const;
  FrameOnBody Place(pugi::xml_node frame, int depth) const;

  const OsimXml& xml_;
  const Model& model_;
  std::vector<pugi::xml_node> nodes_;
};

}  // namespace musclewarp
