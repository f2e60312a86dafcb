// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/page/recorded_run.h"

#include <filesystem>
#include <memory>
#include <utility>

#include "musclewarp/base/input_error.h"
#include "musclewarp/base/input_file.h"
#include "musclewarp/geometry/view.h"
#include "musclewarp/proximity/mesh_intersection.h"
#include "musclewarp/run/frame_files.h"
#include "musclewarp/run/recorded_pose.h"
#include "musclewarp/run/run_reader.h"
#include "musclewarp/scene/json_fields.h"

namespace musclewarp {
namespace {

namespace fs = std::filesystem;

// Checks what the page needs beside the outline. Throws InputError.
void CheckReport(const JsonField& report) {
  report.At("solver").AsString();
  report.At("command").AsString();
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
  if (report.Has("motion") && !report.At("motion").IsNull()) {
    const JsonField coordinates = report.At("motion").At("coordinates");
    for (std::size_t i = 0; i < coordinates.ArraySize(); ++i) {
      coordinates.At(i).At("name").AsString();
      coordinates.At(i).At("moves").AsBool();
      const JsonField unit = coordinates.At(i).At("unit");
      if (!unit.IsString()) unit.Fail("is no text", kRunAgain);
    }
  }
  report.At("rest").At("intersections").At("triangle_pairs").AsNumber();
}

// The meshes of a run, pose after pose.
class PoseReader {
 public:
  // Reads rest.
  PoseReader(const std::string& folder,
             const RecordedNames& names,
             RecordedRun* run)
      : names_(names), rest_(ReadRestPose(folder, names)), run_(run) {
    for (std::size_t i = 0; i < names.muscles.size(); ++i) {
      const std::string& name = names.muscles[i];
      const TriangleSoup& soup = rest_.muscles[i];
      run->muscles.push_back(
          {name, soup.triangles, {soup.points}, {rest_.lines[i]}, {}, {}});
      muscles_.push_back(Add(name, soup));
    }
    for (std::size_t i = 0; i < names.bones.size(); ++i) {
      const std::string& name = names.bones[i];
      run->bones.push_back(
          {name, rest_.bones[i], {Eigen::Matrix4d::Identity()}});
      bones_.push_back(Add(name, rest_.bones[i]));
    }
    Measure();
  }

  // Reads a frame.
  void ReadFrame(const std::string& folder) {
    RecordedPose pose = ReadPose(folder, names_, rest_);
    for (std::size_t i = 0; i < run_->muscles.size(); ++i) {
      RecordedMuscle& muscle = run_->muscles[i];
      Move(pose.muscles[i].points, meshes_[i].get());
      muscle.points.push_back(std::move(pose.muscles[i].points));
      muscle.lines.push_back(std::move(pose.lines[i]));
    }
    for (std::size_t i = 0; i < run_->bones.size(); ++i) {
      RecordedBone& bone = run_->bones[i];
      const Points& points = pose.bones[i].points;
      bone.from_rest.push_back(
          RigidMotion(pose.bone_files[i], bone.rest.points, points));
      Move(points, meshes_[muscles_.size() + i].get());
    }
    Measure();
  }

 private:
  NamedMesh Add(const std::string& name, TriangleSoup soup) {
    meshes_.push_back(std::make_unique<SearchableMesh>(std::move(soup)));
    return {name, meshes_.back().get()};
  }

  static void Move(const Points& points, SearchableMesh* mesh) {
    if (points != mesh->points()) mesh->Refit(points);
  }

  void Measure() {
    SceneIntersections found = IntersectScene(muscles_, bones_);
    for (std::size_t i = 0; i < muscles_.size(); ++i) {
      run_->muscles[i].gaps.push_back(VertexGaps(i,
                                                 muscles_,
                                                 bones_,
                                                 found.inside_of_muscles[i],
                                                 kGapLimit * run_->body_size));
    }
    run_->intersections.push_back(std::move(found));
  }

  RecordedNames names_;
  RecordedPose rest_;
  std::vector<std::unique_ptr<SearchableMesh>> meshes_;  // muscles, then bones
  std::vector<NamedMesh> muscles_, bones_;
  RecordedRun* run_;
};

// Older runs have no file of attachments.
void AddAttachments(const std::string& path, RecordedRun* run) {
  if (!fs::exists(path)) return;
  RecordedAttachments recorded = ReadAttachments(path);
  for (RecordedMuscle& muscle : run->muscles) {
    muscle.attached = std::move(recorded.muscles[muscle.name]);
    for (const AttachedArea& area : muscle.attached) {
      for (const int v : area.vertices) {
        if (v < muscle.points[0].rows()) continue;
        throw InputError(path,
                         "has the vertex " + std::to_string(v) + " of " +
                             muscle.name + ", which has " +
                             std::to_string(muscle.points[0].rows()),
                         kRunAgain);
      }
    }
  }
}

}  // namespace

RecordedRun ReadRecordedRun(const std::string& dir, std::ostream& log) {
  const JsonField report = ReadReport(dir);
  CheckReport(report);
  RunOutline outline = OutlineOf(dir, report);
  DropMissingFrames(&outline);
  RecordedRun run;
  run.dir = dir;
  run.report = nlohmann::ordered_json::parse(ReadFile(report.file()));
  run.body_size = outline.body_size;
  run.warnings = outline.warnings;
  PoseReader reader(outline.rest, outline.names, &run);
  AddAttachments((fs::path(dir) / kAttachmentsFile).string(), &run);
  for (RecordedFrame& frame : outline.frames) {
    reader.ReadFrame(frame.folder);
    run.frames.push_back(std::move(frame.figures));
    const int pairs = run.intersections.back().triangle_pairs;
    const int reported = run.frames.back().intersections.triangle_pairs;
    if (pairs != reported) {
      run.warnings.push_back(FrameFolder(run.frames.back().index) + " has " +
                             std::to_string(pairs) +
                             " crossing pairs, report.json says " +
                             std::to_string(reported));
    }
  }
  log << "read " << run.frames.size() << " frames of " << dir << "\n";
  return run;
}

}  // namespace musclewarp
