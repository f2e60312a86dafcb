// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/exchange/mesher.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "musclewarp/base/child_process.h"
#include "musclewarp/base/output_file.h"
#include "musclewarp/mesh/measures.h"
#include "support/input_errors.h"
#include "support/meshes.h"
#include "support/temp_dir.h"

namespace musclewarp {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

// Relative, of sums of some thousand volumes.
constexpr double kRounding = 1e-12;

// A program of this name that does as the script says.
MesherOptions FakeMesher(const std::string& script) {
  const std::string path = TestTempDir() + "/tetgen";
  WriteTextAtomically(path, "#!/bin/sh\n" + script + "\n");
  fs::permissions(path, fs::perms::owner_all);
  return FindMesher(path);
}

class Mesher : public ::testing::TestWithParam<const char*> {};

TEST_P(Mesher, FillsMusclesAndKeepsTheirSurfaces) {
  if (FindProgram(GetParam()).empty()) GTEST_SKIP() << "no " << GetParam();
  // A third of a millimetre has no end in binary or decimal digits.
  const TriangleSoup surface =
      Together(MovedBy(Spindle(10, 40, 3), {1.0 / 3, 0, 0}),
               MovedBy(Spindle(10, 40, 3), {20.5, 0, 0}));
  const MesherResult result =
      FillWithTetrahedra(surface, FindMesher(GetParam()));
  ASSERT_TRUE(result.mesh) << result.failure;
  const TetrahedralMesh& mesh = *result.mesh;
  EXPECT_EQ(mesh.points.topRows(surface.points.rows()), surface.points);
  EXPECT_EQ(BorderFaces(mesh.tetrahedra, surface.triangles).size(),
            static_cast<size_t>(surface.triangles.rows()));
  EXPECT_GT(Volumes(mesh).minCoeff(), 0);
  const double volume = SignedVolume(surface.points, surface.triangles);
  EXPECT_NEAR(Volumes(mesh).sum() / volume, 1, kRounding);
  EXPECT_EQ(QualityOf(mesh).inverted, 0);
}

INSTANTIATE_TEST_SUITE_P(Programs, Mesher, ::testing::Values("tetgen", "gmsh"));

TEST(FillWithTetrahedra, TetgenDoesNotFillSurfacesThatCross) {
  if (FindProgram("tetgen").empty()) GTEST_SKIP() << "no tetgen";
  const TriangleSoup surface =
      Together(Icosphere(10, 2), MovedBy(Icosphere(10, 2), {7, 1, 2}));
  const MesherResult result = FillWithTetrahedra(surface, FindMesher("tetgen"));
  EXPECT_FALSE(result.mesh);
  EXPECT_THAT(result.failure, HasSubstr("the mesher"));
}

TEST(FindMesher, WhatIsMissingIsNamed) {
  ExpectInputError([] { FindMesher("/no/such/tetgen"); },
                   {"mesher=/no/such/tetgen", "apt-get install tetgen"});
  ExpectInputError([] { FindMesher("netgen"); },
                   {"mesher=netgen", "neither TetGen nor Gmsh"});
}

TEST(FillWithTetrahedra, SaysHowTheMesherFailed) {
  const TriangleSoup ball = Icosphere(10, 1);
  const auto failure = [&](const std::string& script, double timeout_s = 60) {
    MesherOptions options = FakeMesher(script);
    options.timeout_s = timeout_s;
    const MesherResult result = FillWithTetrahedra(ball, options);
    EXPECT_FALSE(result.mesh);
    return result.failure;
  };
  EXPECT_THAT(failure("echo out of memory; exit 3"),
              HasSubstr("ended with exit code 3, having said \"out of memory"));
  EXPECT_THAT(failure("kill -ABRT $$"), HasSubstr("killed by signal 6"));
  EXPECT_THAT(failure("exec sleep 300", 0.05), HasSubstr("ran out of time"));
  EXPECT_THAT(failure("exit 0"), HasSubstr("surface.1.node"));
  EXPECT_THAT(failure("echo '4 3 0 0 0 1 2' > surface.1.node"),
              HasSubstr("ends early"));
}

TEST(FillWithTetrahedra, LeavesNoFilesBehind) {
  const std::string dir = TestTempDir();
  const MesherOptions options = FakeMesher("pwd > " + dir + "/where; exit 1");
  FillWithTetrahedra(Icosphere(10, 1), options);
  std::ifstream in(dir + "/where");
  std::string where;
  std::getline(in, where);
  EXPECT_NE(where, "");
  EXPECT_FALSE(fs::exists(where));
}

}  // namespace
}  // namespace musclewarp
