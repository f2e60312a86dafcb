// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "run/written_run.h"

#include <Eigen/Geometry>
#include <filesystem>

#include "figures/some_figures.h"
#include "musclewarp/base/output_file.h"
#include "musclewarp/figures/figures_json.h"
#include "musclewarp/mesh/transformed.h"
#include "musclewarp/mesh_files/mesh_io.h"
#include "musclewarp/proximity/mesh_intersection.h"
#include "musclewarp/run/bones_file.h"
#include "musclewarp/run/frame_files.h"
#include "musclewarp/run/lines_file.h"
#include "support/meshes.h"

namespace musclewarp {
namespace {

namespace fs = std::filesystem;

Points Shifted(Points points, double x) {
  points.col(0).array() += x;
  return points;
}

void WritePose(const WrittenRun& run,
               const std::string& folder,
               const std::string& muscle_name,
               const Points& muscle,
               const Points& bone) {
  const fs::path dir = fs::path(run.dir) / folder;
  fs::create_directories(dir);
  WriteTriangleSoup((dir / "muscle.ply").string(),
                    {muscle, run.muscle.triangles});
  // The name may hold what a shell would not like, but no slash.
  fs::rename(dir / "muscle.ply", dir / (muscle_name + ".ply"));
  WriteTriangleSoup((dir / "bone.ply").string(), {bone, run.bone.triangles});
  WriteLinesFile((dir / kLinesFile).string(),
                 {{muscle_name,
                   {{"line", muscle.topRows(3)}},
                   {muscle.middleRows(3, 2), muscle.middleRows(5, 4)}}});
}

nlohmann::ordered_json MeshReport(const std::string& name) {
  return {{"name", name},
          {"defects", nlohmann::ordered_json::object()},
          {"repairs", nlohmann::ordered_json::object()}};
}

}  // namespace

void WrittenRun::WriteReport() const {
  WriteTextAtomically(dir + "/report.json", report.dump(2));
}

void WrittenRun::KeepBonesOnce() const {
  for (size_t i = 0; i < bone_motions.size(); ++i) {
    const fs::path folder = fs::path(dir) / FrameFolder(static_cast<int>(i));
    fs::remove(folder / "bone.ply");
    WriteBonesFile((folder / kBonesFile).string(), {{"bone", bone_motions[i]}});
  }
}

WrittenRun WriteRun(const std::string& dir, const std::string& muscle_name) {
  WrittenRun run;
  run.dir = dir;
  run.muscle = Icosphere(10, 2);
  run.bone = Icosphere(10, 3);
  run.bone.points = Shifted(run.bone.points, 23);
  const Eigen::Affine3d motion =
      Eigen::Translation3d(-8, 1, 2) *
      Eigen::AngleAxisd(0.3, Eigen::Vector3d(1, 2, 3).normalized());
  run.muscle_frames = {Shifted(run.muscle.points, -5), run.muscle.points};
  run.bone_motions = {Eigen::Matrix4d::Identity(), motion.matrix()};
  for (const Eigen::Matrix4d& from_rest : run.bone_motions) {
    run.bone_frames.push_back(Transformed(run.bone.points, from_rest));
  }
  WritePose(run, "rest", muscle_name, run.muscle.points, run.bone.points);

  auto frames = nlohmann::ordered_json::array();
  for (int i = 0; i < 2; ++i) {
    const Points& muscle = run.muscle_frames[i];
    const Points& bone = run.bone_frames[i];
    WritePose(run, FrameFolder(i), muscle_name, muscle, bone);
    FrameFigures record = SomeFigures(i);
    record.muscles[0].name = muscle_name;
    record.coordinates = {{"hip", 10.0 * i}};
    const MeshIntersection found =
        IntersectMeshes(TriangleSoup{muscle, run.muscle.triangles},
                        TriangleSoup{bone, run.bone.triangles});
    run.pairs = static_cast<int>(found.triangle_pairs.size());
    record.intersections = {};
    record.intersections.triangle_pairs = run.pairs;
    frames.push_back(JsonOf(record));
  }
  run.report = {{"scene", "by hand"},
                {"axes", "ASR"},
                {"side", "left"},
                {"solver", "ceres"},
                {"contact", "none"},
                {"version", "0"},
                {"command", "musclewarp-deform"},
                {"inputs_hash", "0123"},
                {"motion",
                 {{"coordinates",
                   {{{"name", "hip"}, {"unit", "degrees"}, {"moves", true}}}}}},
                {"machine", {{"processor", "p"}, {"cores", 2}}},
                {"prepare",
                 {{"wall_ms", 1.0},
                  {"warnings", nlohmann::ordered_json::array()},
                  {"muscles", {MeshReport(muscle_name)}},
                  {"bones", {MeshReport("bone")}}}},
                {"rest", {{"intersections", JsonOf(SceneIntersections())}}},
                {"frames", frames},
                {"summary", {{"finished", true}, {"usable", true}}}};
  run.WriteReport();
  return run;
}

}  // namespace musclewarp
