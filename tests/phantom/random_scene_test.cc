// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/phantom/random_scene.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "musclewarp/base/angles.h"
#include "musclewarp/mesh/defects.h"
#include "musclewarp/proximity/mesh_intersection.h"

namespace musclewarp {
namespace {

const TriangleSoup& SurfaceOf(const PhantomScene& made,
                              const std::string& name) {
  return std::find_if(
             made.meshes.begin(),
             made.meshes.end(),
             [&](const PhantomMesh& mesh) { return mesh.name == name; })
      ->surface;
}

// The share of the volume of a muscle that is outside all bones, by points on a
// grid of 6 mm.
double ShareOutside(const TriangleSoup& muscle,
                    const std::vector<const TriangleSoup*>& bones) {
  constexpr double kStep = 6;  // mm
  const SearchableMesh mesh(muscle);
  std::vector<std::unique_ptr<SearchableMesh>> trees;
  for (const TriangleSoup* bone : bones) {
    trees.push_back(std::make_unique<SearchableMesh>(*bone));
  }
  const Eigen::RowVector3d low = muscle.points.colwise().minCoeff();
  const Eigen::RowVector3d high = muscle.points.colwise().maxCoeff();
  int inside = 0, outside_bones = 0;
  Eigen::RowVector3d p;
  for (p.x() = low.x(); p.x() < high.x(); p.x() += kStep) {
    for (p.y() = low.y(); p.y() < high.y(); p.y() += kStep) {
      for (p.z() = low.z(); p.z() < high.z(); p.z() += kStep) {
        if (!mesh.winding().IsInside(p)) continue;
        ++inside;
        outside_bones +=
            std::none_of(trees.begin(), trees.end(), [&](const auto& bone) {
              return bone->winding().IsInside(p);
            });
      }
    }
  }
  return inside == 0 ? 0 : outside_bones / static_cast<double>(inside);
}

// The bones of a scene in a pose, by the order of the scene.
std::vector<TriangleSoup> BonesIn(const PhantomScene& made,
                                  const ScenePose& pose) {
  std::vector<TriangleSoup> bones;
  for (const SceneBone& bone : made.scene.bones) {
    TriangleSoup moved = SurfaceOf(made, bone.name);
    const Eigen::Matrix4d& transform = pose.bodies.at(bone.body);
    moved.points = ((moved.points * transform.topLeftCorner<3, 3>().transpose())
                        .rowwise() +
                    transform.topRightCorner<3, 1>().transpose())
                       .eval();
    bones.push_back(moved);
  }
  return bones;
}

void ExpectSoundMeshesMostlyOutsideBones(const PhantomScene& made) {
  std::vector<const TriangleSoup*> bones;
  for (const SceneBone& bone : made.scene.bones) {
    bones.push_back(&SurfaceOf(made, bone.name));
  }
  for (const PhantomMesh& mesh : made.meshes) {
    EXPECT_TRUE(CountDefects(mesh.surface).IsClean()) << mesh.name;
    EXPECT_TRUE(SelfIntersections(mesh.surface).empty()) << mesh.name;
  }
  for (const SceneMuscle& muscle : made.scene.muscles) {
    EXPECT_GE(ShareOutside(SurfaceOf(made, muscle.name), bones), 0.5)
        << muscle.name;
  }
}

void ExpectNamesThatDifferAndLinesInside(const PhantomScene& made) {
  const Scene& scene = made.scene;
  std::set<std::string> bodies, names, lines;
  for (const SceneBone& bone : scene.bones) {
    EXPECT_TRUE(bodies.insert(bone.body).second) << bone.body;
    EXPECT_TRUE(names.insert(bone.name).second) << bone.name;
  }
  for (const SceneMuscle& muscle : scene.muscles) {
    EXPECT_TRUE(names.insert(muscle.name).second) << muscle.name;
    EXPECT_EQ(muscle.attachments.size(), 2 * muscle.lines.size());
    const SearchableMesh mesh(SurfaceOf(made, muscle.name));
    ASSERT_FALSE(muscle.lines.empty());
    for (const ActionLine& line : muscle.lines) {
      EXPECT_TRUE(lines.insert(line.name).second) << line.name;
      for (Eigen::Index i = 0; i < line.rest.rows(); ++i) {
        EXPECT_TRUE(bodies.count(line.bodies[i])) << line.name;
        EXPECT_TRUE(mesh.winding().IsInside(line.rest.row(i))) << line.name;
      }
    }
  }
}

void ExpectBonesApartInAllPoses(const PhantomScene& made) {
  ASSERT_GE(made.scene.poses.size(), 3u);
  for (const ScenePose& pose : made.scene.poses) {
    const std::vector<TriangleSoup> bones = BonesIn(made, pose);
    for (size_t i = 0; i < bones.size(); ++i) {
      for (size_t j = 0; j < i; ++j) {
        EXPECT_TRUE(IntersectMeshes(bones[i], bones[j]).IsEmpty())
            << pose.name << ": bones " << i << " and " << j;
      }
    }
  }
}

class RandomSceneOfSeed : public ::testing::TestWithParam<int> {};

TEST_P(RandomSceneOfSeed, IsSane) {
  const int count = 2 + GetParam() % 2;  // few, to be quick
  const PhantomScene made = MakeRandomScene(GetParam(), count);
  EXPECT_EQ(static_cast<int>(made.scene.muscles.size()), count);
  ExpectSoundMeshesMostlyOutsideBones(made);
  ExpectNamesThatDifferAndLinesInside(made);
  ExpectBonesApartInAllPoses(made);
}

INSTANTIATE_TEST_SUITE_P(Seeds, RandomSceneOfSeed, ::testing::Range(1, 21));

TEST(RandomScene, ASecondSeedGivesAnotherScene) {
  const PhantomScene one = MakeRandomScene(9, 2),
                     other = MakeRandomScene(19, 2);
  EXPECT_NE(one.meshes[0].surface.points.rows(),
            other.meshes[0].surface.points.rows());
  EXPECT_FALSE(one.scene.muscles[0].lines[0].rest.row(0) ==
               other.scene.muscles[0].lines[0].rest.row(0));
}

TEST(RandomScene, MoreMusclesAreAddedToTheSameOnes) {
  const PhantomScene two = MakeRandomScene(9, 2), three = MakeRandomScene(9, 3);
  ASSERT_EQ(three.scene.bones.size(), two.scene.bones.size());
  for (const PhantomMesh& mesh : two.meshes) {
    EXPECT_EQ(SurfaceOf(three, mesh.name).points, mesh.surface.points);
  }
}

TEST(RandomScene, WithoutANumberItIsDrawn) {
  for (const uint32_t seed : {9, 19}) {
    const size_t count = MakeRandomScene(seed, 0).scene.muscles.size();
    EXPECT_GE(count, 2u);
    EXPECT_LE(count, 20u);
  }
}

// The turn of a body, degrees.
double TurnOf(const Eigen::Matrix4d& pose) {
  const Eigen::Matrix3d turn = pose.topLeftCorner<3, 3>();
  return DegreesOf(Eigen::AngleAxisd(turn).angle());
}

TEST(RandomScene, ASinglePoseIsTheLastOfTheSameMotion) {
  const PhantomScene drawn = MakeRandomScene(9, 2),
                     one = MakeRandomScene(9, 2, 1),
                     six = MakeRandomScene(9, 2, 6);
  ASSERT_EQ(one.scene.poses.size(), 1u);
  ASSERT_EQ(six.scene.poses.size(), 6u);
  double largest = 0;
  for (const auto& [body, last] : drawn.scene.poses.back().bodies) {
    EXPECT_EQ(one.scene.poses[0].bodies.at(body), last);
    EXPECT_EQ(six.scene.poses[5].bodies.at(body), last);
    EXPECT_EQ(TurnOf(six.scene.poses[0].bodies.at(body)), 0);
    largest = std::max(largest, TurnOf(last));
  }
  EXPECT_GE(largest, 8);  // the least turn of a drawn motion
}

}  // namespace
}  // namespace musclewarp
