// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <utility>

#include "musclewarp/mesh_files/mesh_io.h"
#include "support/data_root.h"

namespace musclewarp {
namespace {

namespace fs = std::filesystem;

class MeshIoData : public ::testing::Test {
 protected:
  void SetUp() override {
    root_ = DataRoot();
    if (root_.empty()) GTEST_SKIP() << kNoDataRoot;
  }

  // Reads every file of the folder that has the extension; returns how many.
  int ReadAll(const std::string& folder, const std::string& extension) const {
    int num_files = 0;
    for (const auto& entry : fs::directory_iterator(root_ / folder)) {
      if (entry.path().extension() != extension) continue;
      EXPECT_NO_THROW(ReadTriangleSoup(entry.path().string())) << entry.path();
      ++num_files;
    }
    return num_files;
  }

  using Sizes = std::pair<int, int>;  // Vertices, triangles.

  void ExpectSizes(const std::string& folder,
                   const std::string& extension,
                   const std::map<std::string, Sizes>& sizes) const {
    for (const auto& [name, expected] : sizes) {
      const TriangleSoup soup =
          ReadTriangleSoup((root_ / folder / (name + extension)).string());
      EXPECT_EQ(Sizes(soup.points.rows(), soup.triangles.rows()), expected)
          << folder << "/" << name;
    }
  }

  fs::path root_;
};

// The figures are those of the READMEs that come with the data.

TEST_F(MeshIoData, LhdlHip) {
  EXPECT_EQ(ReadAll("lhdl_hip", ".ply"), 7);
  ExpectSizes("lhdl_hip",
              ".ply",
              {{"gluteus_maximus_r", {7502, 15000}},
               {"gluteus_medius_r", {4002, 7980}},
               {"iliacus_r", {4002, 7966}},
               {"psoas_major_r", {4001, 7946}},
               {"hip_bone_r", {45000, 89996}},
               {"sacrum", {44964, 89980}},
               {"femur_r", {42502, 84998}}});
}

TEST_F(MeshIoData, LhdlLegacyVtkEqualsThePlyMadeFromIt) {
  for (const std::string name : {"gluteus_medius_r", "psoas_major_r"}) {
    const TriangleSoup vtk = ReadTriangleSoup(
        (root_ / "lhdl_hip/raw_vtk" / (name + ".vtk")).string());
    const TriangleSoup ply =
        ReadTriangleSoup((root_ / "lhdl_hip" / (name + ".ply")).string());
    EXPECT_EQ(vtk.points, ply.points);
    EXPECT_EQ(vtk.triangles, ply.triangles);
  }
}

TEST_F(MeshIoData, BodyParts) {
  EXPECT_EQ(ReadAll("bodyparts3d", ".obj"), 19);
  EXPECT_EQ(ReadAll("bodyparts3d/raw", ".obj"), 19);
  EXPECT_EQ(ReadAll("bodyparts3d/uniform", ".obj"), 17);
  ExpectSizes("bodyparts3d",
              ".obj",
              {{"hip_bone", {975, 1950}},
               {"femur", {1301, 2598}},
               {"gluteus_medius", {5362, 10720}},
               {"adductor_magnus", {8285, 16570}}});
  ExpectSizes("bodyparts3d/raw",
              ".obj",
              {{"hip_bone", {978, 1942}},
               {"gluteus_medius", {5683, 10362}},
               {"psoas_major", {5992, 11269}}});
  ExpectSizes("bodyparts3d/uniform",
              ".obj",
              {{"hip_bone", {4520, 9040}},
               {"gluteus_medius", {4474, 8944}},
               {"gluteus_minimus", {4664, 9324}}});
}

#ifdef MUSCLEWARP_WITH_VTK
TEST_F(MeshIoData, Vtp) {
  EXPECT_EQ(ReadAll("opensim", ".vtp"), 6);
  ExpectSizes("lhdl_hip/geometry", ".vtp", {{"LHDL_femur_r", {42502, 84998}}});
  // Written by the files themselves; sacrum and fibula hold quadrilaterals.
  ExpectSizes(
      "opensim", ".vtp", {{"femur_r", {456, 908}}, {"tibia_r", {145, 286}}});
}
#endif

}  // namespace
}  // namespace musclewarp
