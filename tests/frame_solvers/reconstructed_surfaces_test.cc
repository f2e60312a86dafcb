// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/frame_solvers/reconstructed_surfaces.h"

#include <gtest/gtest.h>

#include "musclewarp/mesh/defects.h"
#include "musclewarp/mesh/measures.h"
#include "support/meshes.h"

namespace musclewarp {
namespace {

double VolumeOf(const TriangleSoup& soup) {
  return SignedVolume(soup.points, soup.triangles);
}

// One muscle and one bone; nothing else of a scene matters.
struct MuscleAndBone {
  PreparedScene scene;

  MuscleAndBone(const TriangleSoup& muscle, const TriangleSoup& bone) {
    MuscleModel& model = scene.muscles.emplace_back().model;
    model.name = "psoas";
    model.fine_rest = muscle.points;
    model.fine_triangles = muscle.triangles;
    model.rest_volume = VolumeOf(muscle);
    PreparedBone& prepared = scene.bones.emplace_back();
    prepared.mesh.name = "femur";
    prepared.rest = bone;
  }

  TriangleSoup Reconstructed(const ReconstructionOptions& options) const {
    return ReconstructedSurfaces(
        options, MedialCellOptions(), {0}, /*attempt=*/0, scene)[0];
  }
};

// Samples that are as fine as half an edge, for quick tests.
ReconstructionOptions Coarse() {
  ReconstructionOptions options;
  options.samples_across = 1;
  return options;
}

// A block of 8 x 8 x 16 mm with edges of 2 mm, whose lower quarter is in a
// bone that is wider by 2 mm on all sides.
constexpr double kBoneTop = 4;
MuscleAndBone BlockInABone() {
  TriangleSoup muscle = LatticeBox(4, 4, 8);
  muscle.points *= 2;
  return {muscle, MovedBy(Box(12, 12, 8), {4, 4, kBoneTop - 4})};
}

// A surface that was made anew before is grown to the volume before that, to
// half a per cent (EvenAndGrown), and nearly as much again where the triangles
// are made even.
TEST(ReconstructedSurfaces, HaveTheVolumeOfTheMuscleBesideTheBone) {
  for (const bool is_again : {false, true}) {
    MuscleAndBone made = BlockInABone();
    SurfaceReconstruction& known = made.scene.muscles[0].mesh.reconstruction;
    double volume = made.scene.muscles[0].model.rest_volume;
    known.volume_before = 1.06 * volume;
    known.is_done = is_again;
    if (is_again) volume = known.volume_before;
    const TriangleSoup surface = made.Reconstructed(Coarse());
    EXPECT_TRUE(CountDefects(surface).IsClean());
    EXPECT_NEAR(VolumeOf(surface), volume, 0.006 * volume);
    // Triangles may cut the corners of the bone.
    EXPECT_GT(surface.points.col(2).minCoeff(), kBoneTop - 1);
  }
}

// Less than a quarter of the muscle is left: too little to grow from.
TEST(ReconstructedSurfaces, DoNotGrowFromTooLittle) {
  const MuscleAndBone made = {LatticeBox(8, 8, 32),
                              MovedBy(Box(20, 20, 54), {4, 4, 26 - 27})};
  const double volume = made.scene.muscles[0].model.rest_volume;
  EXPECT_LT(VolumeOf(made.Reconstructed(Coarse())), 0.2 * volume);
  ReconstructionOptions options = Coarse();
  options.least_volume_fraction = 0.1;
  EXPECT_GT(VolumeOf(made.Reconstructed(options)), 0.25 * volume);
}

// A belly with a tendon of 1.2 mm, which samples at 1.5 mm do not see: of its
// 226 mm2 no more may be lost than 30.
TEST(ReconstructedSurfaces, KeepATendonThatSamplesWouldMiss) {
  TriangleSoup muscle = Spindle(12, 40, 4);
  for (auto p : muscle.points.rowwise()) {
    if (p[2] > 10) p.head<2>() *= 0.6 / std::max(0.6, p.head<2>().norm());
  }
  const MuscleAndBone made = {muscle, SphereAt({100, 0, 0}, 5, 2)};
  ReconstructionOptions options = Coarse();
  options.spacing_fraction = 10;
  EXPECT_GT(made.Reconstructed(options).points.col(2).maxCoeff(), 36);
}

}  // namespace
}  // namespace musclewarp
