// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "musclewarp/anatomy/muscle_facts.h"
#include "musclewarp/mesh_files/mesh_io.h"
#include "support/data_root.h"

namespace musclewarp {
namespace {

// Muscles that end on a tendon or a tract that is not part of their mesh, or
// whose tendon is not all there.
bool EndsBeforeItsBone(const std::string& muscle, const std::string& landmark) {
  static const auto* missing =
      new std::set<std::pair<std::string, std::string>>{
          {"gastrocnemius_lateral", "calcaneal_tuberosity"},
          {"gastrocnemius_medial", "calcaneal_tuberosity"},
          {"soleus", "calcaneal_tuberosity"},
          {"tensor_fasciae_latae", "iliotibial_tubercle"},
          {"extensor_hallucis_longus", "top_of_toe_1"}};
  return missing->count({muscle, landmark}) > 0;
}

// The points of a right side in the frame of BonePlace. BodyParts3D has x to
// the left, y backward and z up.
Points ReadPoints(const std::string& path) {
  const TriangleSoup mesh = ReadTriangleSoup(path);
  Points points(mesh.points.rows(), 3);
  points.col(0) = -mesh.points.col(1);
  points.col(1) = mesh.points.col(2);
  points.col(2) = -mesh.points.col(0);
  return points;
}

std::map<std::string, Points> ReadSets(const std::string& root) {
  std::map<std::string, Points> meshes;
  for (const char* set :
       {"bodyparts3d", "bodyparts3d_shank", "bodyparts3d_shoulder"}) {
    const std::string folder = root + "/" + set + "/uniform";
    if (!std::filesystem::exists(folder)) continue;
    for (const auto& file : std::filesystem::directory_iterator(folder)) {
      if (file.path().extension() != ".obj") continue;
      meshes[file.path().stem().string()] = ReadPoints(file.path().string());
    }
  }
  return meshes;
}

// The direction in which the bone is longest, from its beginning to its end.
Eigen::Vector3d AxisOfShape(const Points& bone, const std::string& name) {
  const Points centered = bone.rowwise() - bone.colwise().mean();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(
      centered.transpose() * centered);
  const Eigen::Vector3d axis = solver.eigenvectors().col(2);
  return axis.dot(LongAxisOf(name)) < 0 ? Eigen::Vector3d(-axis) : axis;
}

// The distance (mm) from a bone of those points of a muscle that lie beside
// the part of the bone's length that a place names.
double GapAt(const BonePlace& place, const Points& muscle, const Points& bone) {
  const Eigen::Vector3d axis = AxisOfShape(bone, place.bone);
  const Eigen::VectorXd along_bone = bone * axis;
  const double begin = along_bone.minCoeff();
  const double length = along_bone.maxCoeff() - begin;
  double gap = INFINITY;
  for (int i = 0; i < muscle.rows(); ++i) {
    const double part = (muscle.row(i).dot(axis) - begin) / length;
    if (part < place.begin || part > place.end) continue;
    gap = std::min(gap,
                   std::sqrt((bone.rowwise() - muscle.row(i))
                                 .rowwise()
                                 .squaredNorm()
                                 .minCoeff()));
  }
  return gap;
}

TEST(BonePlacesData, AreWhereTheMusclesOfBodyParts3DTouchTheirBones) {
  // The meshes were made one by one and have vertices every 2 to 3 mm.
  const double touching = 5;
  const int least_ends = 50;  // the three sets have some 65
  if (DataRoot().empty()) GTEST_SKIP() << kNoDataRoot;
  const std::map<std::string, Points> meshes = ReadSets(DataRoot());
  int count = 0;
  for (const auto& [name, muscle] : meshes) {
    const MuscleFacts* facts = FindMuscleFacts(name);
    if (facts == nullptr) continue;
    std::vector<AnatomicalEnd> ends = facts->origin_ends;
    ends.insert(
        ends.end(), facts->insertion_ends.begin(), facts->insertion_ends.end());
    for (const AnatomicalEnd& end : ends) {
      if (EndsBeforeItsBone(name, end.landmark)) continue;
      const BonePlace& place = end.places.front();
      const auto bone = meshes.find(place.bone);
      if (bone == meshes.end()) continue;
      EXPECT_LT(GapAt(place, muscle, bone->second), touching)
          << name << " on " << end.landmark;
      ++count;
    }
  }
  EXPECT_GT(count, least_ends);
}

}  // namespace
}  // namespace musclewarp
