// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "musclewarp/mesh/triangle_soup.h"

namespace musclewarp {

// A run of two frames as musclewarp-deform leaves it, made by hand: a ball of
// muscle beside a ball of bone; in the first frame the muscle moves away, in
// the second the bone turns and moves into it.
struct WrittenRun {
  std::string dir;
  nlohmann::ordered_json report;  // what report.json holds
  TriangleSoup muscle, bone;      // at rest
  std::vector<Points> muscle_frames, bone_frames;
  std::vector<Eigen::Matrix4d> bone_motions;  // from rest, by frame
  int pairs = 0;  // of triangles that cross in the second frame

  // Writes `report` anew.
  void WriteReport() const;

  // Leaves the run as BoneFiles::kOnce does: frames have the motions of the
  // bone in place of its mesh.
  void KeepBonesOnce() const;
};

WrittenRun WriteRun(const std::string& dir,
                    const std::string& muscle_name = "muscle");

}  // namespace musclewarp
