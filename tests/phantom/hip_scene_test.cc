// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "musclewarp/mesh/defects.h"
#include "musclewarp/mesh/measures.h"
#include "musclewarp/mesh_repair/repair.h"
#include "musclewarp/phantom/phantom_scene.h"
#include "musclewarp/proximity/mesh_intersection.h"

namespace musclewarp {
namespace {

// Built once for all tests of a program.
const PhantomScene& Hip() {
  static const PhantomScene hip = MakePhantomScene("hip", 1);
  return hip;
}

const PhantomMesh& MeshNamed(const std::string& name) {
  for (const PhantomMesh& mesh : Hip().meshes) {
    if (mesh.name == name) return mesh;
  }
  ADD_FAILURE() << "no mesh " << name;
  return Hip().meshes.front();
}

TEST(HipScene, MeshesAreInTheOrderOfTheScene) {
  std::vector<std::string> names;
  for (const auto& muscle : Hip().scene.muscles) names.push_back(muscle.name);
  for (const auto& bone : Hip().scene.bones) names.push_back(bone.name);
  ASSERT_EQ(names.size(), Hip().meshes.size());
  for (size_t i = 0; i < names.size(); ++i) {
    EXPECT_EQ(names[i], Hip().meshes[i].name);
  }
}

TEST(HipScene, SurfacesAreClosedManifoldsFacingOutward) {
  for (const PhantomMesh& mesh : Hip().meshes) {
    EXPECT_TRUE(CountDefects(mesh.surface).IsClean()) << mesh.name;
    EXPECT_TRUE(SelfIntersections(mesh.surface).empty()) << mesh.name;
  }
}

TEST(HipScene, DeliveredMeshesHaveTheDefectsPlanted) {
  int sum = 0;
  for (const PhantomMesh& mesh : Hip().meshes) {
    const MeshDefects found = CountDefects(mesh.delivered);
    const PlantedDefects& planted = mesh.defects;
    EXPECT_EQ(found.duplicate_points, planted.duplicate_points) << mesh.name;
    EXPECT_EQ(found.degenerate_triangles, planted.degenerate_triangles)
        << mesh.name;
    EXPECT_EQ(found.non_manifold_edges, planted.flaps) << mesh.name;
    // A degenerate triangle has no edge that could connect it.
    EXPECT_EQ(found.components,
              1 + planted.stray_pieces + planted.degenerate_triangles)
        << mesh.name;
    EXPECT_EQ(found.border_edges,
              4 * planted.duplicate_points + 2 * planted.flaps +
                  3 * planted.missing_triangles)
        << mesh.name;
    sum += planted.duplicate_points + planted.degenerate_triangles +
           planted.flaps + planted.stray_pieces + planted.missing_triangles;
  }
  EXPECT_GT(sum, 10);
}

TEST(HipScene, RepairGivesTheSurfacesBack) {
  for (const PhantomMesh& mesh : Hip().meshes) {
    const TriangleSoup repaired =
        RepairMesh(mesh.delivered, mesh.name, {}, nullptr);
    EXPECT_TRUE(CountDefects(repaired).IsClean()) << mesh.name;
    EXPECT_EQ(repaired.points.rows(), mesh.surface.points.rows()) << mesh.name;
  }
}

TEST(HipScene, MusclesAreOfTheSizeOfRealOnes) {
  for (const SceneMuscle& muscle : Hip().scene.muscles) {
    const TriangleSoup& surface = MeshNamed(muscle.name).surface;
    EXPECT_GE(surface.points.rows(), 2000) << muscle.name;
    EXPECT_LE(surface.points.rows(), 5000) << muscle.name;
    // Adult hip muscles: 80 to 300 cm^3.
    const double volume = SignedVolume(surface.points, surface.triangles);
    EXPECT_GT(volume, 80e3) << muscle.name;
    EXPECT_LT(volume, 300e3) << muscle.name;
  }
  for (const SceneBone& bone : Hip().scene.bones) {
    const TriangleSoup& surface = MeshNamed(bone.name).surface;
    EXPECT_GE(surface.points.rows(), 3000) << bone.name;
    EXPECT_LE(surface.points.rows(), 6000) << bone.name;
  }
}

TEST(HipScene, LinesRunInsideTheirMuscles) {
  for (const SceneMuscle& muscle : Hip().scene.muscles) {
    const SearchableMesh mesh(MeshNamed(muscle.name).surface);
    ASSERT_FALSE(muscle.lines.empty());
    for (const ActionLine& line : muscle.lines) {
      EXPECT_EQ(line.bodies.front(), "pelvis") << line.name;
      EXPECT_EQ(line.bodies.back(), "femur_r") << line.name;
      for (Eigen::Index i = 0; i + 1 < line.rest.rows(); ++i) {
        for (double t = 0; t <= 1; t += 0.125) {
          const Eigen::RowVector3d p =
              (1 - t) * line.rest.row(i) + t * line.rest.row(i + 1);
          EXPECT_TRUE(mesh.winding().IsInside(p))
              << line.name << " segment " << i << " at " << t;
        }
      }
    }
  }
}

TEST(HipScene, AttachmentsLieOnTheirMuscles) {
  for (const SceneMuscle& muscle : Hip().scene.muscles) {
    const Points& points = MeshNamed(muscle.name).surface.points;
    ASSERT_EQ(muscle.attachments.size(), 2u);
    for (const Attachment& attachment : muscle.attachments) {
      EXPECT_GT(attachment.radius, 0);
      for (Eigen::Index i = 0; i < attachment.points.rows(); ++i) {
        EXPECT_EQ((points.rowwise() - attachment.points.row(i))
                      .rowwise()
                      .squaredNorm()
                      .minCoeff(),
                  0)
            << muscle.name << " on " << attachment.body;
      }
    }
  }
}

// Two surfaces cut along each other by 1.5 (muscles) or 2.5 mm (bones), bumps
// of 0.25 mm on each, facets of 4 mm in corners: a few millimetres, as in
// segmented data, where up to 9 mm occur.
TEST(HipScene, NeighboursOverlapALittle) {
  constexpr double kDeepest = 4;  // mm
  const std::vector<std::pair<std::string, std::string>> pairs = {
      {"gluteus_medius_r", "gluteus_minimus_r"},
      {"gluteus_medius_r", "pelvis"},
      {"gluteus_medius_r", "femur_r"},
      {"gluteus_minimus_r", "pelvis"},
      {"gluteus_minimus_r", "femur_r"},
      {"psoas_major_r", "pelvis"},
      {"psoas_major_r", "femur_r"}};
  for (const auto& [a, b] : pairs) {
    const MeshIntersection found =
        IntersectMeshes(MeshNamed(a).surface, MeshNamed(b).surface);
    EXPECT_FALSE(found.triangle_pairs.empty()) << a << " x " << b;
    EXPECT_GT(found.max_depth_mm, 1) << a << " x " << b;
    EXPECT_LT(found.max_depth_mm, kDeepest) << a << " x " << b;
  }
}

TEST(HipScene, TheFemurTurnsFreelyInItsSocket) {
  const SearchableMesh pelvis(MeshNamed("pelvis").surface);
  for (const ScenePose& pose : Hip().scene.poses) {
    TriangleSoup femur = MeshNamed("femur_r").surface;
    const Eigen::Matrix4d& turn = pose.bodies.at("femur_r");
    femur.points =
        ((femur.points * turn.topLeftCorner<3, 3>().transpose()).rowwise() +
         turn.topRightCorner<3, 1>().transpose())
            .eval();
    EXPECT_TRUE(IntersectMeshes(pelvis, SearchableMesh(femur)).IsEmpty())
        << pose.name;
  }
}

TEST(HipScene, PosesGoTheWayTheirNamesSay) {
  // x lateral, y anterior, z up; the femur hangs down from the hip centre.
  const Eigen::Vector4d knee(85, 0, -400, 1);
  for (const ScenePose& pose : Hip().scene.poses) {
    const Eigen::Vector4d moved = pose.bodies.at("femur_r") * knee;
    const double forward = std::asin(moved.y() / 400) * 57.295779513;
    const double aside = std::asin((moved.x() - 85) / 400) * 57.295779513;
    // Matrices have twelve decimals.
    constexpr double kTolerance = 1e-6;  // degrees
    EXPECT_NEAR(forward,
                pose.name == "flexion_30"     ? 30
                : pose.name == "flexion_60"   ? 60
                : pose.name == "extension_10" ? -10
                                              : 0,
                kTolerance)
        << pose.name;
    EXPECT_NEAR(aside, pose.name == "abduction_20" ? 20 : 0, kTolerance)
        << pose.name;
  }
  EXPECT_EQ(Hip().scene.poses.size(), 5u);
}

TEST(HipScene, OnePoseGivesTheTargetOfALine) {
  int targets = 0;
  for (const ScenePose& pose : Hip().scene.poses) targets += pose.lines.size();
  EXPECT_EQ(targets, 1);
  const ActionLine& psoas = Hip().scene.muscles[2].lines[0];
  const Points& target = Hip().scene.poses[2].lines.at(psoas.name);
  const Eigen::Matrix4d& turn = Hip().scene.poses[2].bodies.at("femur_r");
  ASSERT_EQ(target.rows(), psoas.rest.rows());
  for (Eigen::Index i = 0; i < target.rows(); ++i) {
    Eigen::Vector4d moved(0, 0, 0, 1);
    moved.head<3>() = psoas.rest.row(i).transpose();
    if (psoas.bodies[i] == "femur_r") moved = turn * moved;
    const double distance =
        (target.row(i).transpose() - moved.head<3>()).norm();
    // All but the wrapping point move with their bodies, rounded to 2^-10 mm.
    if (i == 5) {
      EXPECT_GT(distance, 10);
    } else {
      EXPECT_LT(distance, 1e-3);
    }
  }
}

// That the same seed gives the same bytes is seen by comparing with
// data/phantom in phantom_scene_test.cc.
TEST(HipScene, ASecondSeedGivesAnotherSoundScene) {
  const PhantomScene other = MakePhantomScene("hip", 2);
  for (size_t i = 0; i < Hip().meshes.size(); ++i) {
    const TriangleSoup& mesh = Hip().meshes[i].delivered;
    const TriangleSoup& other_mesh = other.meshes[i].delivered;
    EXPECT_FALSE(mesh.points.rows() == other_mesh.points.rows() &&
                 mesh.points == other_mesh.points);
    EXPECT_TRUE(CountDefects(other.meshes[i].surface).IsClean());
  }
}

}  // namespace
}  // namespace musclewarp
