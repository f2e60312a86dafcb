// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/label_images/label_meshes.h"

#include <gtest/gtest.h>

#include <cmath>

#include "musclewarp/base/output_file.h"
#include "musclewarp/mesh/defects.h"
#include "musclewarp/mesh/measures.h"
#include "support/input_errors.h"
#include "support/made_images.h"
#include "support/temp_dir.h"

namespace musclewarp {
namespace {

using ::testing::HasSubstr;

// The volume is restored to 1e-4 of that of the voxels.
constexpr double kOfVoxels = 2e-4;

// Two half balls that touch each other (1 and 2), a bar (5) and a crumb (5).
MadeImage TouchingLabels() {
  return MakeImage({30, 24, 24},
                   TurnedSteps({1, 1, 1.5}, {3, -7, 40}),
                   [](const Eigen::Vector3d&) { return 0; });
}

MadeImage WithShapes() {
  MadeImage image = TouchingLabels();
  int at = 0;
  for (int k = 0; k < 24; ++k) {
    for (int j = 0; j < 24; ++j) {
      for (int i = 0; i < 30; ++i, ++at) {
        const double radius =
            std::hypot(std::hypot(i - 9.5, j - 11.5), 1.5 * (k - 11.5));
        if (radius < 9) image.labels[at] = i < 10 ? 1 : 2;
        const bool is_bar = i > 21 && i < 28 && j > 5 && j < 12;
        if (is_bar && (k < 17 || k == 20)) image.labels[at] = 5;
      }
    }
  }
  return image;
}

// Writes the image and returns its path.
std::string WriteImage(const std::string& dir, const MadeImage& image) {
  WriteTextAtomically(dir + "/image.nrrd", NrrdBytes(image));
  return dir + "/image.nrrd";
}

LabelMeshes MeshesBy(const std::string& table) {
  const std::string dir = TestTempDir();
  LabelMeshOptions options;
  if (!table.empty()) {
    options.table = dir + "/table.csv";
    WriteTextAtomically(options.table, table);
  }
  return ReadLabelMeshes(WriteImage(dir, WithShapes()), options);
}

}  // namespace

TEST(LabelMeshes, EveryLabelGivesAClosedMeshWithTheVolumeOfItsVoxels) {
  const LabelMeshes meshes = MeshesBy("");
  const MadeImage image = WithShapes();
  ASSERT_EQ(meshes.meshes.size(), 3u);
  EXPECT_EQ(meshes.frame, "LPS");
  for (const LabelMesh& mesh : meshes.meshes) {
    EXPECT_EQ(mesh.name, "label_" + std::to_string(mesh.label));
    EXPECT_FALSE(mesh.is_bone);
    EXPECT_TRUE(CountDefects(mesh.mesh).IsClean());
    EXPECT_NEAR(
        SignedVolume(mesh.mesh.points, mesh.mesh.triangles) / mesh.voxel_volume,
        1,
        kOfVoxels);
    if (mesh.label == 5) continue;  // its crumb is left out
    EXPECT_NEAR(mesh.voxel_volume / VoxelVolumeOf(image, mesh.label), 1, 1e-12);
  }
  ASSERT_EQ(meshes.notes.size(), 1u);
  EXPECT_THAT(meshes.notes[0],
              HasSubstr("label_5 (label 5) has 2 pieces, which do not hang "
                        "together by faces of voxels: the largest, of 0.918 "
                        "cm3, is kept; 0.054 cm3 in 1 other is left out"));
}

// Two balls of one label that touch at no more than a corner of voxels: one of
// them is lost, and said to be, or each becomes a mesh.
TEST(LabelMeshes, PiecesOfALabelAreLostOrMeshesOfTheirOwn) {
  const Eigen::Vector3d one(8, 8, 8), other(20, 20, 20);
  const MadeImage image = MakeImage({29, 29, 29},
                                    TurnedSteps({1, 1, 1}, {0, 0, 0}),
                                    [](const Eigen::Vector3d&) { return 0; });
  MadeImage made = image;
  int at = 0;
  for (int k = 0; k < 29; ++k) {
    for (int j = 0; j < 29; ++j) {
      for (int i = 0; i < 29; ++i, ++at) {
        const Eigen::Vector3d p(i, j, k);
        const bool is_inside = (p - one).norm() < 7.5 || (p - other).norm() < 7;
        made.labels[at] = is_inside && (i < 14) == ((p - one).norm() < 9);
      }
    }
  }
  const std::string path = WriteImage(TestTempDir(), made);
  LabelMeshOptions options;
  const LabelMeshes largest = ReadLabelMeshes(path, options);
  ASSERT_EQ(largest.meshes.size(), 1u);
  const LabelMesh& kept = largest.meshes[0];
  EXPECT_LT(kept.voxel_volume, 0.6 * kept.delivered_volume);
  options.pieces = PieceChoice::kAll;
  const LabelMeshes all = ReadLabelMeshes(path, options);
  ASSERT_EQ(all.meshes.size(), 2u);
  EXPECT_EQ(all.meshes[0].name, "label_1_1");
  EXPECT_EQ(all.meshes[1].name, "label_1_2");
  EXPECT_EQ(all.meshes[0].delivered_volume + all.meshes[1].delivered_volume,
            kept.delivered_volume);
  for (const LabelMesh& mesh : all.meshes) {
    EXPECT_TRUE(CountDefects(mesh.mesh).IsClean());
    EXPECT_NEAR(mesh.volume / mesh.delivered_volume, 1, kOfVoxels);
  }
}

// A label that lost a fiftieth of its volume is not what was delivered any
// more.
TEST(LabelMeshes, ALossIsNotedFromTwoPerCentOn) {
  EXPECT_FALSE(IsLossWorthANote(1.9, 100));
  EXPECT_TRUE(IsLossWorthANote(2.1, 100));
  EXPECT_FALSE(IsLossWorthANote(0, 0));
}

// MetaImage and NRRD without "space units" have the unit that is stated.
TEST(LabelMeshes, TheUnitOfAnImageThatHasNoneIsStated) {
  const std::string path = WriteImage(TestTempDir(), WithShapes());
  LabelMeshOptions options;
  const double millimetres =
      ReadLabelMeshes(path, options).meshes[0].voxel_volume;
  options.mm_per_unit = 10;
  EXPECT_NEAR(ReadLabelMeshes(path, options).meshes[0].voxel_volume,
              1000 * millimetres,
              1e-9 * millimetres);
}

TEST(LabelMeshes, TheTableNamesAndSelects) {
  const LabelMeshes meshes =
      MeshesBy("label,name,kind\n5,femur,bone\n1,psoas,muscle\n9,tibia,bone\n");
  ASSERT_EQ(meshes.meshes.size(), 2u);
  EXPECT_EQ(meshes.meshes[0].name, "psoas");
  EXPECT_FALSE(meshes.meshes[0].is_bone);
  EXPECT_EQ(meshes.meshes[1].name, "femur");
  EXPECT_TRUE(meshes.meshes[1].is_bone);
  ASSERT_EQ(meshes.notes.size(), 3u);
  EXPECT_THAT(meshes.notes[0], HasSubstr("label 9 (tibia)"));
  EXPECT_THAT(meshes.notes[0], HasSubstr("not in the image"));
  EXPECT_THAT(meshes.notes[1], HasSubstr("are left out: 2"));
}

TEST(LabelMeshes, SegmentsOfSlicerBringTheirNames) {
  const std::string dir = TestTempDir();
  std::string bytes = NrrdBytes(WithShapes());
  bytes.insert(bytes.find("kinds:"),
               "Segment0_LabelValue:=2\nSegment0_Name:=iliacus\n"
               "Segment1_LabelValue:=8\nSegment1_Name:=psoas\n");
  WriteTextAtomically(dir + "/a.seg.nrrd", bytes);
  const LabelMeshes meshes = ReadLabelMeshes(dir + "/a.seg.nrrd", {});
  ASSERT_EQ(meshes.meshes.size(), 3u);
  EXPECT_EQ(meshes.meshes[0].name, "label_1");
  EXPECT_EQ(meshes.meshes[1].name, "iliacus");
  EXPECT_THAT(meshes.notes[0], HasSubstr("without voxels: segment 8 (psoas)"));
}

TEST(LabelMeshes, TheEdgeLengthSetsTheNumberOfTriangles) {
  const std::string path = WriteImage(TestTempDir(), WithShapes());
  LabelMeshOptions options;
  options.edge_length = 1.5;
  const auto fine = ReadLabelMeshes(path, options).meshes[0].mesh;
  options.edge_length = 3;
  const auto coarse = ReadLabelMeshes(path, options).meshes[0].mesh;
  EXPECT_GT(fine.triangles.rows(), 2 * coarse.triangles.rows());
}

TEST(LabelMeshes, RefusesImagesAndTablesThatDoNotFit) {
  const std::string dir = TestTempDir();
  ExpectInputError([] { MeshesBy("7,a\n8,b\n"); },
                   {"table.csv: has none of the labels of", "(1, 2, 5)"});
  ExpectInputError(
      [&] { ReadLabelMeshes(WriteImage(dir, TouchingLabels()), {}); },
      {"image.nrrd: has no label above 0"});
  MadeImage crumb = TouchingLabels();
  crumb.labels[5000] = 4;
  ExpectInputError([&] { ReadLabelMeshes(WriteImage(dir, crumb), {}); },
                   {"image.nrrd: label 4 (label_4) has 1 voxels",
                    "allowed: at least 64",
                    "labels=TABLE"});
}

TEST(LabelMeshes, AllTinyLabelsAreNamedAtOnce) {
  const std::string dir = TestTempDir();
  MadeImage crumbs = WithShapes();
  for (int label = 11; label < 14; ++label) {
    for (int i = 0; i < label; ++i) crumbs.labels[30 * label + i] = label;
  }
  const std::string path = WriteImage(dir, crumbs);
  ExpectInputError([&] { ReadLabelMeshes(path, {}); },
                   {"image.nrrd: 3 labels: 11 (label_11), 12 (label_12), 13 "
                    "(label_13)",
                    "none has more than 13 voxels",
                    "labels=TABLE"});
  // What it says to do.
  LabelMeshOptions options;
  options.table = dir + "/table.csv";
  WriteTextAtomically(options.table, "1,a\n2,b\n5,c\n");
  EXPECT_EQ(ReadLabelMeshes(path, options).meshes.size(), 3u);
}

TEST(LabelMeshes, NamesThatAreNotInTheImageAreOneLine) {
  std::string table = "1,psoas\n2,iliacus\n5,femur\n";
  for (int label = 100; label < 400; ++label) {
    table += std::to_string(label) + ",muscle_" + std::to_string(label) + "\n";
  }
  const LabelMeshes meshes = MeshesBy(table);
  ASSERT_EQ(meshes.notes.size(), 2u);  // the other is of the crumb
  EXPECT_THAT(meshes.notes[0], HasSubstr("300 labels: 100 (muscle_100), 101"));
  EXPECT_THAT(meshes.notes[0], HasSubstr("(muscle_109) and 290 more"));
}

TEST(LabelMeshes, AnImageWithAThousandValuesIsNoLabelMap) {
  const std::string dir = TestTempDir();
  std::string data;
  for (int i = 0; i < 2048; ++i) {
    data += static_cast<char>(i % 256);
    data += static_cast<char>(i / 256);
  }
  WriteTextAtomically(dir + "/ct.nrrd",
                      "NRRD0004\ntype: uint16\ndimension: 3\nendian: little\n"
                      "sizes: 16 16 8\nspacings: 1 1 1\nencoding: raw\n\n" +
                          data);
  ExpectInputError([&] { ReadLabelMeshes(dir + "/ct.nrrd", {}); },
                   {"ct.nrrd: has 2047 different values", "at most 1000"});
}

}  // namespace musclewarp
