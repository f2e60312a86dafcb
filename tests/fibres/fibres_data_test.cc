// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <memory>
#include <set>
#include <string>

#include "musclewarp/fibres/fibres.h"
#include "musclewarp/mesh_files/mesh_io.h"
#include "musclewarp/proximity/inside_test.h"
#include "musclewarp/skeleton/polyline.h"
#include "support/data_root.h"

namespace musclewarp {
namespace {

// Where anatomy has the ends of the muscles of bodyparts3d, by the bones that
// are there: the vertebrae, the sacrum and the tract of the tensor are not.
const struct {
  const char* muscle;
  const char* origin;
  const char* insertion;
} kMuscles[] = {{"adductor_brevis", "pelvis", "femur"},
                {"adductor_magnus", "pelvis", "femur"},
                {"biceps_femoris_long", "pelvis", "shank"},
                {"biceps_femoris_short", "femur", "shank"},
                {"gluteus_maximus", "pelvis", "femur"},
                {"gluteus_medius", "pelvis", "femur"},
                {"gluteus_minimus", "pelvis", "femur"},
                {"gracilis", "pelvis", "shank"},
                {"iliacus", "pelvis", "femur"},
                {"pectineus", "pelvis", "femur"},
                {"piriformis", "pelvis", "femur"},
                {"psoas_major", "pelvis", "femur"},
                {"semimembranosus", "pelvis", "shank"},
                {"semitendinosus", "pelvis", "shank"},
                {"tensor_fasciae_latae", "pelvis", "femur"}};

TEST(FibresData, EveryMuscleHasLinesAndFibresBetweenItsBones) {
  const std::string root = DataRoot();
  if (root.empty()) GTEST_SKIP() << kNoDataRoot;
  const std::string folder = root + "/bodyparts3d/";
  std::vector<std::unique_ptr<TriangleBvh>> trees;
  const auto bone = [&](const std::string& file) {
    const TriangleSoup soup = ReadTriangleSoup(folder + file);
    trees.push_back(std::make_unique<TriangleBvh>(soup.points, soup.triangles));
    return trees.back().get();
  };
  const std::vector<BodySurface> bodies = {
      {"pelvis", {bone("uniform/hip_bone.obj")}},
      {"femur", {bone("uniform/femur.obj")}},
      {"shank", {bone("tibia.obj"), bone("fibula.obj")}}};
  for (const auto& expected : kMuscles) {
    const std::string name = expected.muscle;
    const TriangleSoup muscle =
        ReadTriangleSoup(folder + "uniform/" + name + ".obj");
    const auto lines =
        MakeLines(name, muscle, bodies, {}, 3, LinePoints::kNine);
    ASSERT_EQ(lines.size(), 3u) << name;
    for (const ActionLine& line : lines) {
      EXPECT_EQ(line.bodies.front(), expected.origin) << name;
      EXPECT_EQ(line.bodies.back(), expected.insertion) << name;
    }
    const auto fibres = MakeFibres(muscle, bodies, {}, FibreOptions());
    EXPECT_EQ(fibres.size(), 100u) << name;
    const InsideTest inside(muscle.points, muscle.triangles, 3);
    const double size = (muscle.points.colwise().maxCoeff() -
                         muscle.points.colwise().minCoeff())
                            .maxCoeff();
    double longest = 0;
    for (const Points& fibre : fibres) {
      for (Eigen::Index i = 0; i < fibre.rows(); ++i) {
        EXPECT_TRUE(inside.Contains(fibre.row(i))) << name;
      }
      longest = std::max(longest, PolylineLength(fibre));
      EXPECT_LT(PolylineLength(fibre), 1.3 * size) << name;
    }
    // Along the muscle, not across it.
    EXPECT_GT(longest, 0.7 * size) << name;
  }
}

}  // namespace
}  // namespace musclewarp
