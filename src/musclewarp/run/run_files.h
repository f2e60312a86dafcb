// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>
#include <vector>

#include "musclewarp/mesh/triangle_soup.h"
#include "musclewarp/run/bones_file.h"

namespace musclewarp {

// Finds the files of a run of musclewarp-deform, or of any folder of meshes,
// without reading the meshes, and reads single ones. Runs whose bones are
// written once (BoneFiles::kOnce) are read as all others.

// The paths of mesh files by the names of the muscles and bones they show.
using MeshFiles = std::map<std::string, std::string>;

// The files of a frame.
struct FrameFiles {
  // What the pose is called for readers (run/pose_name.h), by report.json; ""
  // without a report.
  std::string name;

  // Of bones that are written once, the files are those of the rest folder, and
  // `bones_from_rest` moves them to their places in the frame.
  MeshFiles meshes;
  BoneMotions bones_from_rest;
};

// The files of a run, and what report.json says of how to show them.
struct RunFiles {
  std::vector<FrameFiles> frames;
  // False if the folder has no report.json; `muscles` is then empty.
  bool has_report = false;
  // The names of the muscles, in the order of the report; other meshes are
  // bones.
  std::vector<std::string> muscles;
  // How the axes of the meshes lie in the body, and the side of the body (see
  // ParseView in geometry/view.h).
  std::string axes = "LPS";
  std::string side = "right";
};

// Returns the mesh files of a folder by their names without extension. If a
// mesh is there in several formats, the most exact one is taken, .ply before
// all others. Throws InputError if the folder does not exist or holds no mesh.
MeshFiles MeshFilesIn(const std::string& dir);

// Returns the files of a frame, without its name, from its folder, such as
// RUN/frame_0000; any other folder of meshes is one, too. Throws InputError as
// MeshFilesIn does, and if bones.json in the folder is damaged or names a bone
// that RUN/rest does not hold.
FrameFiles FrameFilesIn(const std::string& folder);

// Reads a mesh of a frame, where it is in the frame: to the last bit the same
// whether its bones are written in every frame or once. Throws InputError if
// the file is damaged. Remarks of the reader are appended to `notes`, unless it
// is null. Precondition: `frame.meshes` has the name.
TriangleSoup ReadMeshOfFrame(const FrameFiles& frame,
                             const std::string& name,
                             std::vector<std::string>* notes = nullptr);

// Finds the frames of a run. `frames` selects them, in its order: numbers or
// "last", separated by commas. A folder without frame folders is taken as a
// single frame. Throws InputError that names what is missing: the folder, its
// meshes, or a frame that --frames asks for.
RunFiles FindRunFiles(const std::string& dir, const std::string& frames);

}  // namespace musclewarp
