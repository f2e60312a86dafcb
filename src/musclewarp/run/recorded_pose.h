// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "musclewarp/mesh/triangle_soup.h"
#include "musclewarp/run/lines_file.h"

namespace musclewarp {

// What messages about damaged files of a run advise.
constexpr char kRunAgain[] = "run musclewarp-deform again";

// The names of the meshes of a run, in the order of its report.
struct RecordedNames {
  std::vector<std::string> muscles;
  std::vector<std::string> bones;
};

// The meshes and lines of a run in one pose, in the order of the names.
struct RecordedPose {
  std::vector<TriangleSoup> muscles;
  std::vector<TriangleSoup> bones;
  std::vector<std::string> bone_files;  // where the bones were read from
  std::vector<MuscleLines> lines;       // those that the muscles carry
};

// Reads the rest pose of a run from its folder. Throws InputError that names
// the file if a mesh or the lines are missing or damaged.
RecordedPose ReadRestPose(const std::string& folder,
                          const RecordedNames& names);

// Reads another pose of the same run, whether its bones are written in every
// frame or once: to the last bit the same. Throws InputError as ReadRestPose
// does, and if a mesh has other triangles than at rest, or a muscle other
// lines.
RecordedPose ReadPose(const std::string& folder,
                      const RecordedNames& names,
                      const RecordedPose& rest);

// Returns the rigid motion (4 x 4, translation in mm) that takes the points
// `from` of a bone to the points `to` (#V x 3 each, mm). Throws InputError that
// names `file` if there is none.
Eigen::Matrix4d RigidMotion(const std::string& file,
                            const Points& from,
                            const Points& to);

}  // namespace musclewarp
