// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/run/run_files.h"

#include <algorithm>
#include <filesystem>
#include <sstream>

#include "musclewarp/base/input_error.h"
#include "musclewarp/mesh/transformed.h"
#include "musclewarp/mesh_files/mesh_io.h"
#include "musclewarp/run/frame_files.h"
#include "musclewarp/run/pose_name.h"
#include "musclewarp/run/run_reader.h"

namespace musclewarp {
namespace {

namespace fs = std::filesystem;

// Returns a rank, of which the lowest is best: double precision comes before
// text, and text before float.
int Rank(const fs::path& path) {
  static const std::vector<std::string> kOrder = {
      ".ply", ".vtp", ".vtk", ".obj", ".off", ".stl"};
  return static_cast<int>(
      std::find(kOrder.begin(), kOrder.end(), path.extension()) -
      kOrder.begin());
}

std::vector<int> ParseFrames(const std::string& text,
                             const std::string& dir,
                             const std::map<int, std::string>& folders) {
  const int last = folders.rbegin()->first;
  std::vector<int> numbers;
  std::istringstream in(text);
  for (std::string word; std::getline(in, word, ',');) {
    const int number = word == "last" ? last : FrameNumber("frame_" + word);
    if (folders.count(number) == 0) {
      throw InputError("{frames}",
                       "'" + word + "' is not a frame of " + dir,
                       "use 'last' or numbers from " +
                           std::to_string(folders.begin()->first) + " to " +
                           std::to_string(last) + ", separated by commas");
    }
    numbers.push_back(number);
  }
  if (numbers.empty()) {
    throw InputError("{frames}", "names no frame", "use for example 0,last");
  }
  return numbers;
}

}  // namespace

MeshFiles MeshFilesIn(const std::string& dir) {
  if (!fs::is_directory(dir)) {
    throw InputError(
        dir, "there is no such folder", "run musclewarp-deform again");
  }
  MeshFiles files;
  for (const fs::directory_entry& entry : fs::directory_iterator(dir)) {
    const fs::path& path = entry.path();
    if (!entry.is_regular_file() || path.extension().empty() ||
        !IsMeshExtension(path.extension().string())) {
      continue;
    }
    std::string& file = files[path.stem().string()];
    if (file.empty() || Rank(path) < Rank(file)) file = path.string();
  }
  if (files.empty()) {
    throw InputError(dir,
                     "the folder holds no mesh",
                     "name the folder of a run or a folder of meshes");
  }
  return files;
}

FrameFiles FrameFilesIn(const std::string& folder) {
  FrameFiles frame;
  frame.meshes = MeshFilesIn(folder);
  const fs::path bones = fs::path(folder) / kBonesFile;
  if (!fs::exists(bones)) return frame;
  frame.bones_from_rest = ReadBonesFile(bones.string());
  if (frame.bones_from_rest.empty()) return frame;
  // The folder may be named without its parent, as in a glob.
  const fs::path run = fs::absolute(bones).parent_path().parent_path();
  const MeshFiles rest = MeshFilesIn((run / kRestFolder).string());
  for (const auto& item : frame.bones_from_rest) {
    const auto file = rest.find(item.first);
    if (file == rest.end()) {
      throw InputError(bones.string(),
                       "names the bone \"" + item.first +
                           "\", which the rest folder of the run lacks",
                       "run musclewarp-deform again");
    }
    frame.meshes[item.first] = file->second;
  }
  return frame;
}

TriangleSoup ReadMeshOfFrame(const FrameFiles& frame,
                             const std::string& name,
                             std::vector<std::string>* notes) {
  TriangleSoup soup = ReadTriangleSoup(frame.meshes.at(name), notes);
  const auto motion = frame.bones_from_rest.find(name);
  if (motion != frame.bones_from_rest.end()) {
    soup.points = Transformed(soup.points, motion->second);
  }
  return soup;
}

RunFiles FindRunFiles(const std::string& dir, const std::string& frames) {
  if (!fs::is_directory(dir)) {
    throw InputError(dir, "there is no such folder", "check {in}");
  }
  RunFiles run;
  std::map<int, std::string> names;
  if (fs::exists(fs::path(dir) / "report.json")) {
    const JsonField report = ReadReport(dir);
    const RunOutline outline = OutlineOf(dir, report);
    const auto moving = MovingCoordinatesIn(report);
    for (const RecordedFrame& frame : outline.frames) {
      const FrameFigures& figures = frame.figures;
      names[figures.index] =
          PoseName(figures.name, figures.coordinates, moving);
    }
    run.has_report = true;
    run.muscles = outline.names.muscles;
    run.axes = outline.axes;
    if (!outline.side.empty()) run.side = outline.side;
  }
  const std::map<int, std::string> folders = FrameFoldersIn(dir);
  if (folders.empty()) {
    run.frames.push_back(FrameFilesIn(dir));
    return run;
  }
  for (const int number : ParseFrames(frames, dir, folders)) {
    run.frames.push_back(FrameFilesIn(folders.at(number)));
    run.frames.back().name = names[number];
  }
  return run;
}

}  // namespace musclewarp
