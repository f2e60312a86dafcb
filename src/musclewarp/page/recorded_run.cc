// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/page/recorded_run.h"

#include <Eigen/Geometry>
#include <filesystem>
#include <map>
#include <memory>
#include <utility>

#include "musclewarp/base/input_error.h"
#include "musclewarp/base/input_file.h"
#include "musclewarp/geometry/mesh_intersection.h"
#include "musclewarp/geometry/view.h"
#include "musclewarp/mesh/transformed.h"
#include "musclewarp/mesh_files/mesh_io.h"
#include "musclewarp/motion/frame_files.h"
#include "musclewarp/page/run_files.h"
#include "musclewarp/scene/json_fields.h"

namespace musclewarp {
namespace {

namespace fs = std::filesystem;

constexpr char kRunAgain[] = "run musclewarp-deform again";

// The largest distance between a bone in a file and its rest mesh moved
// rigidly, mm. Positions in files are rounded, to 1e-5 if another program wrote
// them.
constexpr double kRigidTolerance = 1e-3;

std::vector<std::string> NamesIn(const JsonField& list) {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < list.ArraySize(); ++i) {
    names.push_back(list.At(i).At("name").AsString());
  }
  return names;
}

// Checks the keys that the page needs. Throws InputError.
void CheckReport(const JsonField& report) {
  for (const char* key : {"scene",
                          "axes",
                          "side",
                          "solver",
                          "contact",
                          "version",
                          "command",
                          "inputs_hash"}) {
    report.At(key).AsString();
  }
  // Throws if the axes or the side are not valid.
  ParseView(
      "anterior", report.At("axes").AsString(), report.At("side").AsString());
  report.At("machine").At("processor").AsString();
  report.At("machine").At("cores").AsNumber();
  const JsonField prepare = report.At("prepare");
  prepare.At("wall_ms").AsNumber();
  prepare.At("warnings").ArraySize();
  for (const char* kind : {"muscles", "bones"}) {
    const JsonField meshes = prepare.At(kind);
    for (std::size_t i = 0; i < meshes.ArraySize(); ++i) {
      meshes.At(i).At("defects").CheckObject();
      meshes.At(i).At("repairs").CheckObject();
    }
  }
  if (report.Has("motion") && !report.At("motion").value().is_null()) {
    const JsonField coordinates = report.At("motion").At("coordinates");
    for (std::size_t i = 0; i < coordinates.ArraySize(); ++i) {
      coordinates.At(i).At("name").AsString();
      coordinates.At(i).At("moves").AsBool();
      const JsonField unit = coordinates.At(i).At("unit");
      if (!unit.value().is_string()) unit.Fail("is no text", kRunAgain);
    }
  }
  report.At("rest").At("intersections").At("triangle_pairs").AsNumber();
  report.At("summary").At("finished").AsBool();
  report.At("summary").At("usable").AsBool();
}

std::vector<FrameRecord> FrameRecordsIn(const JsonField& frames) {
  std::vector<FrameRecord> records;
  for (std::size_t i = 0; i < frames.ArraySize(); ++i) {
    const JsonField frame = frames.At(i);
    try {
      records.push_back(FrameRecordFromJson(frame.value()));
    } catch (const nlohmann::json::exception& error) {
      frame.Fail("is not as musclewarp-deform writes it (" +
                     std::string(error.what()) + ")",
                 kRunAgain);
    }
  }
  return records;
}

// Throws InputError.
std::string MeshOf(const MeshFiles& files,
                   const std::string& folder,
                   const std::string& name) {
  const auto found = files.find(name);
  if (found == files.end()) {
    throw InputError(folder, "has no mesh \"" + name + "\"", kRunAgain);
  }
  return found->second;
}

void CheckSameTriangles(const std::string& file,
                        const TriangleSoup& soup,
                        const Triangles& triangles,
                        Eigen::Index vertices) {
  if (soup.points.rows() == vertices &&
      soup.triangles.rows() == triangles.rows() &&
      soup.triangles == triangles) {
    return;
  }
  throw InputError(file, "has other triangles than at rest", kRunAgain);
}

// Throws InputError, naming `file`, if that is no rigid motion.
Eigen::Matrix4d RigidMotion(const std::string& file,
                            const Points& from,
                            const Points& to) {
  if (from == to) return Eigen::Matrix4d::Identity();
  const Eigen::Matrix4d motion =
      Eigen::umeyama(from.transpose(), to.transpose(), /*with_scaling=*/false);
  const double error =
      (Transformed(from, motion) - to).rowwise().norm().maxCoeff();
  if (error <= kRigidTolerance) return motion;
  throw InputError(
      file, "is not the bone at rest, moved and turned", kRunAgain);
}

// Reads the lines and fibres of a pose, by muscle. Throws InputError.
std::vector<MuscleLines> LinesIn(const std::string& folder,
                                 const std::vector<std::string>& muscles) {
  const std::string file = (fs::path(folder) / kLinesFile).string();
  std::vector<MuscleLines> lines = ReadLinesFile(file);
  bool fits = lines.size() == muscles.size();
  for (std::size_t i = 0; fits && i < lines.size(); ++i) {
    fits = lines[i].name == muscles[i];
  }
  if (fits) return lines;
  throw InputError(file, "names other muscles than report.json", kRunAgain);
}

bool HaveSameSizes(const MuscleLines& a, const MuscleLines& b) {
  if (a.lines.size() != b.lines.size() || a.fibres.size() != b.fibres.size()) {
    return false;
  }
  for (std::size_t i = 0; i < a.lines.size(); ++i) {
    if (a.lines[i].name != b.lines[i].name ||
        a.lines[i].points.rows() != b.lines[i].points.rows()) {
      return false;
    }
  }
  for (std::size_t i = 0; i < a.fibres.size(); ++i) {
    if (a.fibres[i].rows() != b.fibres[i].rows()) return false;
  }
  return true;
}

// The meshes of a run, pose after pose.
class PoseReader {
 public:
  // Reads rest.
  PoseReader(const std::string& rest,
             const std::vector<std::string>& muscles,
             const std::vector<std::string>& bones,
             RecordedRun* run)
      : muscle_names_(muscles), run_(run) {
    const MeshFiles files = MeshFilesIn(rest);
    std::vector<MuscleLines> lines = LinesIn(rest, muscles);
    for (std::size_t i = 0; i < muscles.size(); ++i) {
      const std::string& name = muscles[i];
      TriangleSoup soup = ReadTriangleSoup(MeshOf(files, rest, name));
      run->muscles.push_back(
          {name, soup.triangles, {soup.points}, {std::move(lines[i])}, {}});
      muscles_.push_back(Add(name, std::move(soup)));
    }
    for (const std::string& name : bones) {
      TriangleSoup soup = ReadTriangleSoup(MeshOf(files, rest, name));
      run->bones.push_back({name, soup, {Eigen::Matrix4d::Identity()}});
      bones_.push_back(Add(name, std::move(soup)));
    }
    Measure();
  }

  // Reads a frame.
  void ReadPose(const std::string& folder) {
    const MeshFiles files = MeshFilesIn(folder);
    std::vector<MuscleLines> lines = LinesIn(folder, muscle_names_);
    for (std::size_t i = 0; i < run_->muscles.size(); ++i) {
      RecordedMuscle& muscle = run_->muscles[i];
      const std::string file = MeshOf(files, folder, muscle.name);
      muscle.points.push_back(Moved(file, meshes_[i].get()));
      if (!HaveSameSizes(muscle.lines[0], lines[i])) {
        throw InputError(
            (fs::path(folder) / kLinesFile).string(),
            "has other lines of \"" + muscle.name + "\" than at rest",
            kRunAgain);
      }
      muscle.lines.push_back(std::move(lines[i]));
    }
    for (std::size_t i = 0; i < run_->bones.size(); ++i) {
      RecordedBone& bone = run_->bones[i];
      const std::string file = MeshOf(files, folder, bone.name);
      bone.from_rest.push_back(
          RigidMotion(file,
                      bone.rest.points,
                      Moved(file, meshes_[muscles_.size() + i].get())));
    }
    Measure();
  }

 private:
  NamedMesh Add(const std::string& name, TriangleSoup soup) {
    meshes_.push_back(std::make_unique<SearchableMesh>(std::move(soup)));
    return {name, meshes_.back().get()};
  }

  // Moves the mesh to the points of the file.
  Points Moved(const std::string& file, SearchableMesh* mesh) {
    const TriangleSoup soup = ReadTriangleSoup(file);
    CheckSameTriangles(file, soup, mesh->triangles(), mesh->points().rows());
    if (soup.points != mesh->points()) mesh->Refit(soup.points);
    return soup.points;
  }

  void Measure() {
    SceneIntersections found = IntersectScene(muscles_, bones_);
    for (std::size_t i = 0; i < muscles_.size(); ++i) {
      run_->muscles[i].gaps.push_back(VertexGaps(
          i, muscles_, bones_, found.inside_of_muscles[i], kGapLimit));
    }
    run_->intersections.push_back(std::move(found));
  }

  std::vector<std::string> muscle_names_;
  std::vector<std::unique_ptr<SearchableMesh>> meshes_;  // muscles, then bones
  std::vector<NamedMesh> muscles_, bones_;
  RecordedRun* run_;
};

}  // namespace

RecordedRun ReadRecordedRun(const std::string& dir, std::ostream& log) {
  if (!fs::is_directory(dir)) {
    throw InputError(dir, "there is no such folder", "check the name");
  }
  const std::string path = (fs::path(dir) / "report.json").string();
  const JsonField report = JsonField::ParseFile(path);
  CheckReport(report);
  RecordedRun run;
  run.dir = dir;
  run.report = nlohmann::ordered_json::parse(ReadFile(path));
  const JsonField prepare = report.At("prepare");
  PoseReader reader((fs::path(dir) / kRestFolder).string(),
                    NamesIn(prepare.At("muscles")),
                    NamesIn(prepare.At("bones")),
                    &run);
  const std::map<int, std::string> folders = FrameFoldersIn(dir);
  std::vector<FrameRecord> records = FrameRecordsIn(report.At("frames"));
  for (FrameRecord& record : records) {
    const auto folder = folders.find(record.index);
    if (folder == folders.end()) {
      run.warnings.push_back(FrameFolder(record.index) +
                             " is in report.json, its folder is missing");
      continue;
    }
    reader.ReadPose(folder->second);
    run.frames.push_back(std::move(record));
    if (run.intersections.back().triangle_pairs !=
        run.frames.back().intersections.triangle_pairs) {
      run.warnings.push_back(
          FrameFolder(run.frames.back().index) + " has " +
          std::to_string(run.intersections.back().triangle_pairs) +
          " crossing pairs, report.json says " +
          std::to_string(run.frames.back().intersections.triangle_pairs));
    }
  }
  log << "read " << run.frames.size() << " frames of " << dir << "\n";
  return run;
}

}  // namespace musclewarp
