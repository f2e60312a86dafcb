// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <nlohmann/json.hpp>
#include <ostream>
#include <string>
#include <vector>

#include "musclewarp/certificate/scene_intersections.h"
#include "musclewarp/mesh/triangle_soup.h"
#include "musclewarp/motion/lines_file.h"
#include "musclewarp/report/frame_record.h"

namespace musclewarp {

// Gaps are looked for up to this distance for the page, mm.
constexpr double kPageGapLimit = 5;

// A muscle at rest and in the frames: its surface, the lines and fibres it
// carries, and the gap of each vertex to the nearest other mesh (#V, mm,
// negative inside, at most kPageGapLimit).
struct RecordedMuscle {
  std::string name;
  Triangles triangles;
  std::vector<Points> points;  // #V x 3, mm
  std::vector<MuscleLines> lines;
  std::vector<Eigen::VectorXd> gaps;
};

struct RecordedBone {
  std::string name;
  TriangleSoup rest;
  std::vector<Eigen::Matrix4d> from_rest;  // to rest and the frames
};

// A run as musclewarp-deform left it on disk. "Poses" are rest, then the
// frames: entry 0 of the lists by pose is rest, entry i + 1 frames[i].
struct RecordedRun {
  std::string dir;
  nlohmann::ordered_json report;    // report.json as it is
  std::vector<FrameRecord> frames;  // those of which the files are there
  std::vector<RecordedMuscle> muscles;
  std::vector<RecordedBone> bones;
  // Counted on the files, by pose.
  std::vector<SceneIntersections> intersections;
  // Where the files and the report disagree.
  std::vector<std::string> warnings;
};

// Reads the report and all meshes of a run, finished or not, and counts anew
// what crosses. Says on `log` how far it is. Throws InputError that names the
// file and the field: no folder, no or a damaged report.json, a mesh that is
// missing, damaged or not the one of the other frames, a bone that does not
// move rigidly.
RecordedRun ReadRecordedRun(const std::string& dir, std::ostream& log);

}  // namespace musclewarp
