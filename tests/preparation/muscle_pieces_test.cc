// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/preparation/muscle_pieces.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "musclewarp/base/output_file.h"
#include "musclewarp/mesh/measures.h"
#include "musclewarp/mesh_files/obj_io.h"
#include "support/meshes.h"
#include "support/temp_dir.h"

namespace musclewarp {
namespace {

using ::testing::ElementsAre;

// Rounding of sums.
constexpr double kRounding = 1e-9;

// The text of an object whose faces count their corners back, so that objects
// may follow each other in any order.
std::string ObjectText(const std::string& name, const TriangleSoup& mesh) {
  std::string text = "o " + name + "\n";
  TriangleSoup points = mesh;
  points.triangles.resize(0, 3);
  text += ObjBytes(points);
  const int count = static_cast<int>(mesh.points.rows());
  for (Eigen::Index f = 0; f < mesh.triangles.rows(); ++f) {
    text += "f";
    for (const int v : mesh.triangles.row(f)) {
      text += " " + std::to_string(v - count);
    }
    text += "\n";
  }
  return text;
}

MusclePieces PiecesOfText(const std::string& text) {
  SceneMuscle muscle;
  muscle.name = "muscles";
  muscle.mesh_path = TestTempDir() + "/muscles.obj";
  WriteTextAtomically(muscle.mesh_path, text);
  return PiecesOfMuscle(muscle, RepairOptions());
}

std::vector<std::string> NamesOf(const MusclePieces& found) {
  std::vector<std::string> names;
  for (const MusclePiece& piece : found.pieces) names.push_back(piece.name);
  return names;
}

const TriangleSoup& Small() {
  static const TriangleSoup kMesh = SphereAt({60, 0, 0}, 15, 2);
  return kMesh;
}

const TriangleSoup& Large() {
  static const TriangleSoup kMesh = SphereAt({0, 0, 0}, 20, 2);
  return kMesh;
}

TEST(MusclePieces, AreCalledByTheirObjectsInAnyOrder) {
  const std::string small = ObjectText("minimus", Small());
  const std::string large = ObjectText("medius", Large());
  for (const std::string& text : {small + large, large + small}) {
    const MusclePieces found = PiecesOfText(text);
    EXPECT_THAT(NamesOf(found), ElementsAre("medius", "minimus"));
    EXPECT_EQ(found.pieces[0].mesh.points, Large().points);
    EXPECT_EQ(found.pieces[1].mesh.points, Small().points);
  }
}

TEST(MusclePieces, AreNumberedWithinANameTheLargestFirst) {
  EXPECT_THAT(NamesOf(PiecesOfText(ObjBytes(Together(Small(), Large())))),
              ElementsAre("muscles_1", "muscles_2"));
  EXPECT_THAT(
      NamesOf(PiecesOfText(ObjectText("a", Together(Small(), Large())) +
                           ObjectText("b", SphereAt({0, 60, 0}, 17, 2)))),
      ElementsAre("a_1", "b", "a_2"));
  EXPECT_THAT(NamesOf(PiecesOfText(ObjectText("a", Small()) +
                                   ObjectText("a", Large()))),
              ElementsAre("a_1", "a_2"));
}

TEST(MusclePieces, MaterialsOfASurfaceDoNotNameIt) {
  const TriangleSoup both = Together(Large(), Small());
  std::string text = ObjBytes(both);
  const size_t face = text.find("f ");
  const size_t next = text.find("f ", face + 1);
  text.insert(next, "o tendon\n");
  text.insert(face, "o belly\n");
  EXPECT_THAT(NamesOf(PiecesOfText(text)),
              ElementsAre("muscles_1", "muscles_2"));
}

TEST(MusclePieces, VolumesAddUpToWhatWasDelivered) {
  // Turned inside out, it encloses its volume all the same.
  TriangleSoup turned = Small();
  turned.triangles.col(0).swap(turned.triangles.col(1));
  const MusclePieces found = PiecesOfText(ObjBytes(Together(turned, Large())));
  ASSERT_EQ(found.pieces.size(), 2u);
  EXPECT_NEAR(found.pieces[0].volume,
              SignedVolume(Large().points, Large().triangles),
              kRounding * found.pieces[0].volume);
  EXPECT_NEAR(found.pieces[1].volume,
              SignedVolume(Small().points, Small().triangles),
              kRounding * found.pieces[1].volume);
}

TEST(MusclePieces, WhatIsNoSurfaceIsLeftOut) {
  const MusclePieces found =
      PiecesOfText(ObjBytes(Together(Large(), SphereAt({0, 0, 0}, 10, 2))));
  EXPECT_THAT(NamesOf(found), ElementsAre("muscles"));
  ASSERT_EQ(found.repairs.dropped_pieces.size(), 1u);
  EXPECT_EQ(found.repairs.dropped_pieces[0].reason, DropReason::kShell);
  EXPECT_EQ(found.repairs.dropped_pieces[0].volume, 0);
  EXPECT_GT(found.repairs.dropped_pieces[0].cavity, 0);
}

}  // namespace
}  // namespace musclewarp
