// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "musclewarp/label_images/label_meshes.h"
#include "musclewarp/mesh/defects.h"
#include "musclewarp/proximity/mesh_intersection.h"
#include "support/data_root.h"

namespace musclewarp {
namespace {

namespace fs = std::filesystem;

// What a label of a few hundred voxels may lose where it is thin.
constexpr double kLostWhereThin = 0.01;

class LabelMeshesData : public ::testing::Test {
 protected:
  void SetUp() override {
    if (DataRoot().empty()) GTEST_SKIP() << kNoDataRoot;
    folder_ = fs::path(DataRoot()) / "label_images";
    if (!fs::exists(folder_)) GTEST_SKIP() << folder_ << " does not exist";
  }

  // Every mesh is closed and holds the voxels of its piece; together they hold
  // those of the labels.
  LabelMeshes ExpectAllVoxelsAreHeld(const std::string& name) const {
    LabelMeshOptions options;
    options.pieces = PieceChoice::kAll;
    LabelMeshes labels = ReadLabelMeshes((folder_ / name).string(), options);
    double delivered = 0, held = 0;
    for (const LabelMesh& label : labels.meshes) {
      EXPECT_TRUE(CountDefects(label.mesh).IsClean()) << label.name;
      EXPECT_NEAR(label.volume / label.voxel_volume, 1, kLostWhereThin)
          << label.name;
      delivered += label.delivered_volume;
      held += label.volume;
    }
    EXPECT_NEAR(held / delivered, 1, kLostWhereThin);
    return labels;
  }

  fs::path folder_;
};

// The largest piece hangs together at one corner of a voxel.
TEST_F(LabelMeshesData, EveryVertebraIsWhole) {
  const LabelMeshes labels =
      ExpectAllVoxelsAreHeld("totalseg_vertebrae_body.nii.gz");
  EXPECT_EQ(labels.meshes.size(), 12u);
}

TEST_F(LabelMeshesData, AThinRingKeepsItsVolume) {
  const LabelMeshes labels =
      ExpectAllVoxelsAreHeld("sinotubular_junction.nii.gz");
  EXPECT_EQ(labels.meshes.size(), 1u);
}

// The tendon of the psoas is two voxels thick at 1.5 mm, and ends at the lesser
// trochanter, at z = -480 on the mesh of which the image was made.
TEST_F(LabelMeshesData, TheTendonOfThePsoasIsKept) {
  LabelMeshOptions options;
  options.table = (folder_ / "lhdl_hip_labels.csv").string();
  const LabelMeshes labels =
      ReadLabelMeshes((folder_ / "lhdl_hip_1.5mm.nii.gz").string(), options);
  EXPECT_EQ(labels.meshes.size(), 7u);
  for (const LabelMesh& label : labels.meshes) {
    EXPECT_TRUE(SelfIntersections(label.mesh).empty()) << label.name;
    if (label.name.find("psoas") == std::string::npos) continue;
    EXPECT_NEAR(label.mesh.points.col(2).minCoeff(), -480, 3);
  }
}

}  // namespace
}  // namespace musclewarp
