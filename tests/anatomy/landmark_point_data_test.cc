// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <filesystem>
#include <string>
#include <vector>

#include "musclewarp/anatomy/bone_names.h"
#include "musclewarp/anatomy/image_directions.h"
#include "musclewarp/anatomy/landmark_point.h"
#include "musclewarp/anatomy/muscle_facts.h"
#include "musclewarp/mesh_files/mesh_io.h"
#include "support/data_root.h"

namespace musclewarp {
namespace {

// The bones of the leg of BodyParts3D, turned.
std::vector<MeasuredBone> BonesOfLeg(const Eigen::Matrix3d& turn) {
  std::vector<MeasuredBone> bones;
  const std::string folder = DataRoot() + "/bodyparts3d_shank/uniform";
  for (const auto& file : std::filesystem::directory_iterator(folder)) {
    const std::string name = file.path().stem().string();
    if (file.path().extension() != ".obj" || !ParseBoneName(name).is_known) {
      continue;
    }
    TriangleSoup mesh = ReadTriangleSoup(file.path().string());
    mesh.points = mesh.points * turn.transpose();
    bones.push_back(Measured(BoneOfName(name, mesh)));
  }
  return bones;
}

// The landmark at which the insertion of a muscle lies.
LandmarkPoint InsertionOf(const std::string& muscle,
                          const std::vector<MeasuredBone>& bones) {
  const auto found =
      FindLandmark(FindMuscleFacts(muscle)->insertion_ends.front().places,
                   bones,
                   Side::kRight,
                   DirectionsOfAxes("LPS"));
  EXPECT_TRUE(found) << muscle;
  return found.value_or(LandmarkPoint());
}

TEST(LandmarkPointData, IsWhereTheTendonsOfBodyParts3DEnd) {
  if (DataRoot().empty()) GTEST_SKIP() << kNoDataRoot;
  const std::vector<MeasuredBone> bones =
      BonesOfLeg(Eigen::Matrix3d::Identity());
  // An attachment of the foot is some 10 mm wide, and the place of a landmark
  // is as good as that.
  const double near = 12;
  for (const char* muscle : {"tibialis_anterior",
                             "tibialis_posterior",
                             "fibularis_tertius",
                             "flexor_hallucis_longus",
                             "extensor_digitorum_longus"}) {
    const LandmarkPoint place = InsertionOf(muscle, bones);
    EXPECT_EQ(place.evidence, LandmarkEvidence::kFound) << muscle;
    const TriangleSoup mesh = ReadTriangleSoup(
        DataRoot() + "/bodyparts3d_shank/uniform/" + muscle + ".obj");
    const double gap =
        (mesh.points.rowwise() - place.point).rowwise().norm().minCoeff();
    EXPECT_LT(gap, near) << muscle << " on " << bones[place.bone].bone.name;
  }
}

TEST(LandmarkPointData, TurnsWithTheBones) {
  if (DataRoot().empty()) GTEST_SKIP() << kNoDataRoot;
  const Eigen::Matrix3d turn =
      Eigen::AngleAxisd(1.3, Eigen::Vector3d(2, 1, -1).normalized())
          .toRotationMatrix();
  const LandmarkPoint before =
      InsertionOf("soleus", BonesOfLeg(Eigen::Matrix3d::Identity()));
  const LandmarkPoint after = InsertionOf("soleus", BonesOfLeg(turn));
  // The place is the centre of a triangle, the same one.
  EXPECT_LT((after.point - before.point * turn.transpose()).norm(), 1e-6);
}

}  // namespace
}  // namespace musclewarp
