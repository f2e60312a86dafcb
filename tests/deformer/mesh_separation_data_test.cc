// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

#include "musclewarp/deformer/mesh_separation.h"
#include "musclewarp/mesh_files/mesh_io.h"
#include "musclewarp/proximity/mesh_intersection.h"
#include "support/data_root.h"

namespace musclewarp {
namespace {

namespace fs = std::filesystem;

// Small inputs that once went wrong, each in a folder of its own.
class MeshSeparationData : public ::testing::Test {
 protected:
  void SetUp() override {
    if (DataRoot().empty()) GTEST_SKIP() << kNoDataRoot;
    folder_ = fs::path(DataRoot()) / "cases";
    if (!fs::exists(folder_)) GTEST_SKIP() << folder_ << " does not exist";
  }

  MeshSeparation Separated(const std::string& name,
                           const std::vector<std::string>& muscles,
                           const std::vector<std::string>& bones) const {
    const auto path = [&](const std::string& mesh) {
      return (folder_ / name / (mesh + ".obj")).string();
    };
    Scene scene;
    for (const std::string& mesh : muscles) {
      SceneMuscle& muscle = scene.muscles.emplace_back();
      muscle.name = mesh;
      muscle.mesh_path = path(mesh);
    }
    for (const std::string& mesh : bones) {
      SceneBone& bone = scene.bones.emplace_back();
      bone.name = bone.body = mesh;
      bone.mesh_path = path(mesh);
    }
    return SeparateMeshes(scene, MeshSeparationOptions(), {});
  }

  fs::path folder_;
};

// Each pair of the layers alone moves by 0.5 mm.
TEST_F(MeshSeparationData, ThreeFlatLayersMoveByAboutAMillimetre) {
  const MeshSeparation result =
      Separated("three_flat_layers", {"deep", "middle", "superficial"}, {});
  EXPECT_TRUE(result.frame.IsUsable()) << result.frame.FullReport();
  for (const MuscleFrame& muscle : result.frame.muscles) {
    EXPECT_LT(muscle.max_displacement, 1.5) << muscle.name;
    EXPECT_LT(std::abs(muscle.volume_error), 1e-6) << muscle.name;
  }
}

TEST_F(MeshSeparationData, ABoneInPiecesIsKeptAndNotCrossed) {
  const MeshSeparation result =
      Separated("bone_in_pieces", {"muscle"}, {"ribs"});
  EXPECT_TRUE(result.frame.IsUsable()) << result.frame.FullReport();
  EXPECT_EQ(result.scene.bones[0].mesh.repairs.pieces, 3);
  const TriangleSoup delivered =
      ReadTriangleSoup((folder_ / "bone_in_pieces" / "ribs.obj").string());
  EXPECT_TRUE(IntersectMeshes({result.frame.muscles[0].points,
                               result.scene.muscles[0].model.fine_triangles},
                              delivered)
                  .IsEmpty());
}

}  // namespace
}  // namespace musclewarp
