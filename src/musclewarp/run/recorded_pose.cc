// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/run/recorded_pose.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <filesystem>

#include "musclewarp/base/input_error.h"
#include "musclewarp/mesh/transformed.h"
#include "musclewarp/mesh_files/mesh_io.h"
#include "musclewarp/run/run_files.h"

namespace musclewarp {
namespace {

namespace fs = std::filesystem;

// The largest distance between a bone in a file and its rest mesh moved
// rigidly, mm. Positions in files are rounded, to 1e-5 if another program wrote
// them.
constexpr double kRigidTolerance = 1e-3;

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

bool HaveSameSizes(const std::vector<Points>& a, const std::vector<Points>& b) {
  return std::equal(a.begin(),
                    a.end(),
                    b.begin(),
                    b.end(),
                    [](const Points& one, const Points& other) {
                      return one.rows() == other.rows();
                    });
}

bool HaveSameSizes(const MuscleLines& a, const MuscleLines& b) {
  if (a.lines.size() != b.lines.size()) return false;
  for (std::size_t i = 0; i < a.lines.size(); ++i) {
    if (a.lines[i].name != b.lines[i].name ||
        a.lines[i].points.rows() != b.lines[i].points.rows()) {
      return false;
    }
  }
  return HaveSameSizes(a.fibres, b.fibres) &&
         HaveSameSizes(a.tendons, b.tendons);
}

TriangleSoup ReadMesh(const FrameFiles& files,
                      const std::string& folder,
                      const std::string& name,
                      const TriangleSoup& rest) {
  const std::string file = MeshOf(files.meshes, folder, name);
  TriangleSoup soup = ReadMeshOfFrame(files, name);
  CheckSameTriangles(file, soup, rest.triangles, rest.points.rows());
  return soup;
}

}  // namespace

RecordedPose ReadRestPose(const std::string& folder,
                          const RecordedNames& names) {
  const MeshFiles files = MeshFilesIn(folder);
  RecordedPose pose;
  pose.lines = LinesIn(folder, names.muscles);
  for (const std::string& name : names.muscles) {
    pose.muscles.push_back(ReadTriangleSoup(MeshOf(files, folder, name)));
  }
  for (const std::string& name : names.bones) {
    pose.bone_files.push_back(MeshOf(files, folder, name));
    pose.bones.push_back(ReadTriangleSoup(pose.bone_files.back()));
  }
  return pose;
}

RecordedPose ReadPose(const std::string& folder,
                      const RecordedNames& names,
                      const RecordedPose& rest) {
  const FrameFiles files = FrameFilesIn(folder);
  RecordedPose pose;
  pose.lines = LinesIn(folder, names.muscles);
  for (std::size_t i = 0; i < names.muscles.size(); ++i) {
    const std::string& name = names.muscles[i];
    pose.muscles.push_back(ReadMesh(files, folder, name, rest.muscles[i]));
    if (!HaveSameSizes(rest.lines[i], pose.lines[i])) {
      throw InputError((fs::path(folder) / kLinesFile).string(),
                       "has other lines of \"" + name + "\" than at rest",
                       kRunAgain);
    }
  }
  for (std::size_t i = 0; i < names.bones.size(); ++i) {
    const std::string& name = names.bones[i];
    pose.bones.push_back(ReadMesh(files, folder, name, rest.bones[i]));
    pose.bone_files.push_back(MeshOf(files.meshes, folder, name));
  }
  return pose;
}

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

}  // namespace musclewarp
