// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/exchange/crossing_files.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "musclewarp/base/input_file.h"
#include "musclewarp/mesh_files/mesh_io.h"
#include "support/meshes.h"
#include "support/temp_dir.h"

namespace musclewarp {
namespace {

namespace fs = std::filesystem;

TEST(CrossingFiles, HoldTrianglesCurvesAndATable) {
  const SearchableMesh a(Icosphere(10, 2));
  const SearchableMesh b(MovedBy(Icosphere(10, 2), {15, 1, 2}));
  const std::vector<NamedMesh> meshes = {{"psoas, upper", &a}, {"femur", &b}};
  const auto places = FindCrossingPlaces(meshes, {});
  ASSERT_EQ(places.size(), 1u);
  const std::string dir = TestTempDir();
  CrossingFiles files(dir, "ply");
  files.Add("frame_0000", meshes, {});
  files.Add("frame_0001", meshes, places);
  files.WriteTable();
  EXPECT_FALSE(fs::exists(dir + "/frame_0000_triangles.ply"));
  const TriangleSoup soup = ReadTriangleSoup(dir + "/frame_0001_triangles.ply");
  EXPECT_EQ(soup.triangles.rows(),
            static_cast<Eigen::Index>(places[0].triangles_of_a.size() +
                                      places[0].triangles_of_b.size()));
  EXPECT_EQ(soup.points.topRows(3),
            Points(a.bvh().corners(places[0].triangles_of_a[0])));
  const std::string table = ReadFile(dir + "/crossings.csv");
  EXPECT_EQ(table.find("frame,a,b,x_mm"), 0u);
  EXPECT_NE(table.find("\nframe_0001,\"psoas, upper\",femur,"),
            std::string::npos);
  EXPECT_EQ(table.find("frame_0000"), std::string::npos);
  EXPECT_NE(ReadFile(dir + "/frame_0001_curves.ply").find("element edge"),
            std::string::npos);
}

}  // namespace
}  // namespace musclewarp
