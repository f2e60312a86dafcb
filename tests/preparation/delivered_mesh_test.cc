// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/preparation/delivered_mesh.h"

#include <gtest/gtest.h>

#include "musclewarp/mesh_files/mesh_io.h"
#include "musclewarp/mesh_files/stated_space.h"
#include "support/meshes.h"
#include "support/temp_dir.h"

namespace musclewarp {
namespace {

// A mesh in another space, which is turned, is the same as one in the space of
// the scene, whatever its unit and place.
TEST(DeliveredMesh, TurnsBeforeItScalesAndPlaces) {
  const TriangleSoup soup = Icosphere(10, 1);
  TriangleSoup other = soup;
  TurnToOtherSpace(&other.points);
  const std::string dir = TestTempDir();
  WriteTriangleSoup(dir + "/soup.ply", soup);
  WriteTriangleSoup(dir + "/other.ply", other);
  std::vector<std::string> notes;
  SceneMuscle muscle;
  muscle.mesh_path = dir + "/soup.ply";
  muscle.mm_per_unit = 10;
  SceneMuscle turned_muscle = muscle;
  turned_muscle.mesh_path = dir + "/other.ply";
  turned_muscle.is_turned = true;
  EXPECT_EQ(DeliveredMesh(turned_muscle, &notes).points,
            DeliveredMesh(muscle, &notes).points);
  SceneBone bone;
  bone.mesh_path = dir + "/soup.ply";
  bone.rest_from_file.col(3).head<3>() << 1, 2, 3;
  SceneBone turned_bone = bone;
  turned_bone.mesh_path = dir + "/other.ply";
  turned_bone.is_turned = true;
  EXPECT_EQ(DeliveredMesh(turned_bone, &notes).points,
            DeliveredMesh(bone, &notes).points);
}

}  // namespace
}  // namespace musclewarp
