// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <nlohmann/json.hpp>
#include <ostream>
#include <string>
#include <vector>

#include "musclewarp/certificate/scene_intersections.h"
#include "musclewarp/figures/frame_figures.h"
#include "musclewarp/frames/frame.h"
#include "musclewarp/mesh/triangle_soup.h"
#include "musclewarp/run/attachments_file.h"
#include "musclewarp/run/lines_file.h"

namespace musclewarp {

// A muscle in all poses of a run. The vectors below are by pose: entry 0 is the
// rest pose, entry i + 1 is frame i.
struct RecordedMuscle {
  std::string name;
  // The triangles (#F x 3), which are the same in all poses.
  Triangles triangles;
  // The vertices, #V x 3, mm.
  std::vector<Points> points;
  // The lines and fibres that the muscle carries.
  std::vector<MuscleLines> lines;
  // The distance of each vertex to the nearest other mesh, #V, mm: negative
  // inside it, and at most kGapLimit in a human.
  std::vector<Eigen::VectorXd> gaps;
  // The same in all poses.
  std::vector<AttachedArea> attached;
};

// A bone, which moves rigidly.
struct RecordedBone {
  std::string name;
  TriangleSoup rest;
  // target_from_rest by pose; the first is the identity.
  std::vector<Eigen::Matrix4d> from_rest;
};

// A run of musclewarp-deform as its files tell it.
struct RecordedRun {
  std::string dir;
  // The contents of report.json, and of it Scene::body_size, which older runs
  // do not have.
  nlohmann::ordered_json report;
  double body_size = 1;
  // The frames whose files exist; an interrupted run has fewer than planned.
  std::vector<FrameFigures> frames;
  std::vector<RecordedMuscle> muscles;
  std::vector<RecordedBone> bones;
  // What crosses, counted anew on the meshes of the files, by pose.
  std::vector<SceneIntersections> intersections;
  // Sentences that say where the files and the report disagree.
  std::vector<std::string> warnings;
};

// Reads the report and all meshes of a run, finished or not, and counts anew
// what crosses, so that the page does not depend on the word of the program
// that is judged. Progress is written to `log`. Throws InputError that names
// the file and the field if the folder or report.json is missing or damaged, if
// a mesh is missing, damaged or differs in its triangles from the same mesh in
// other frames, or if a bone does not move rigidly.
RecordedRun ReadRecordedRun(const std::string& dir, std::ostream& log);

}  // namespace musclewarp
