// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/page/recorded_run.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include "musclewarp/base/output_file.h"
#include "musclewarp/mesh/transformed.h"
#include "musclewarp/mesh_files/mesh_io.h"
#include "page/read_quietly.h"
#include "run/written_run.h"
#include "support/input_errors.h"
#include "support/temp_dir.h"

namespace musclewarp {
namespace {

namespace fs = std::filesystem;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

TEST(RecordedRun, IsWhatWasWritten) {
  const WrittenRun written = WriteRun(TestTempDir());
  const RecordedRun run = ReadQuietly(written.dir);
  EXPECT_THAT(run.warnings, IsEmpty());
  ASSERT_EQ(run.frames.size(), 2u);
  ASSERT_EQ(run.muscles.size(), 1u);
  const RecordedMuscle& muscle = run.muscles[0];
  EXPECT_EQ(muscle.triangles, written.muscle.triangles);
  ASSERT_EQ(muscle.points.size(), 3u);
  EXPECT_EQ(muscle.points[0], written.muscle.points);
  EXPECT_EQ(muscle.points[2], written.muscle_frames[1]);
  EXPECT_EQ(muscle.lines[1].lines[0].points,
            written.muscle_frames[0].topRows(3));
  EXPECT_EQ(muscle.lines[2].fibres.size(), 2u);
  ASSERT_EQ(run.bones.size(), 1u);
  const RecordedBone& bone = run.bones[0];
  EXPECT_EQ(bone.from_rest[1], Eigen::Matrix4d::Identity());
  // The rotation is found by a singular value decomposition.
  EXPECT_LT((Transformed(bone.rest.points, bone.from_rest[2]) -
             written.bone_frames[1])
                .cwiseAbs()
                .maxCoeff(),
            1e-9);
}

TEST(RecordedRun, KnowsWhatIsAttachedToWhat) {
  const WrittenRun written = WriteRun(TestTempDir());
  const std::string path = (fs::path(written.dir) / kAttachmentsFile).string();
  WriteAttachments(path, {{{"muscle", {{"femur_r", {0, 7}}}}}, {}});
  const RecordedRun run = ReadQuietly(written.dir);
  ASSERT_EQ(run.muscles[0].attached.size(), 1u);
  EXPECT_EQ(run.muscles[0].attached[0].body, "femur_r");
  EXPECT_THAT(run.muscles[0].attached[0].vertices, ElementsAre(0, 7));

  const int count = static_cast<int>(written.muscle.points.rows());
  WriteAttachments(path, {{{"muscle", {{"femur_r", {0, count}}}}}, {}});
  ExpectInputError([&] { ReadQuietly(written.dir); },
                   {kAttachmentsFile, std::to_string(count), "muscle"});
}

TEST(RecordedRun, MeasuresGapsAndCrossings) {
  const WrittenRun written = WriteRun(TestTempDir());
  const RecordedRun run = ReadQuietly(written.dir);
  ASSERT_EQ(run.intersections.size(), 3u);
  EXPECT_TRUE(run.intersections[0].IsClean());
  EXPECT_GT(written.pairs, 0);
  EXPECT_EQ(run.intersections[2].triangle_pairs, written.pairs);
  EXPECT_FALSE(run.intersections[2].pairs[0].triangles_of_a.empty());
  // Vertices of balls of 10 mm, 23 mm apart, look at each other along x.
  EXPECT_NEAR(run.muscles[0].gaps[0].minCoeff(), 3, 0.05);
  EXPECT_EQ(run.muscles[0].gaps[0].maxCoeff(), kGapLimit);
  EXPECT_LT(run.muscles[0].gaps[2].minCoeff(), -1);
}

TEST(RecordedRun, IsTheSameIfBonesAreWrittenOnce) {
  const WrittenRun written = WriteRun(TestTempDir());
  const RecordedRun every = ReadQuietly(written.dir);
  written.KeepBonesOnce();
  const RecordedRun once = ReadQuietly(written.dir);
  EXPECT_EQ(once.bones[0].from_rest, every.bones[0].from_rest);
  EXPECT_EQ(once.muscles[0].gaps, every.muscles[0].gaps);
  EXPECT_EQ(once.intersections[2].triangle_pairs, written.pairs);
  EXPECT_THAT(once.warnings, IsEmpty());
}

TEST(RecordedRun, SaysWhereTheReportIsAnother) {
  WrittenRun written = WriteRun(TestTempDir());
  written.report["frames"][1]["intersections"]["triangle_pairs"] = 3;
  written.WriteReport();
  EXPECT_THAT(ReadQuietly(written.dir).warnings,
              ElementsAre(HasSubstr("frame_0001")));
}

TEST(RecordedRun, IsReadAsFarAsItCame) {
  const WrittenRun written = WriteRun(TestTempDir());
  fs::remove_all(written.dir + "/frame_0001");
  const RecordedRun run = ReadQuietly(written.dir);
  EXPECT_EQ(run.frames.size(), 1u);
  EXPECT_THAT(run.warnings, ElementsAre(HasSubstr("frame_0001")));
  EXPECT_EQ(run.muscles[0].points.size(), 2u);
}

TEST(RecordedRun, MayHaveNoFrameYet) {
  WrittenRun written = WriteRun(TestTempDir());
  written.report["frames"] = nlohmann::ordered_json::array();
  written.WriteReport();
  const RecordedRun run = ReadQuietly(written.dir);
  EXPECT_TRUE(run.frames.empty());
  EXPECT_EQ(run.muscles[0].points.size(), 1u);
}

TEST(RecordedRun, DamagedReportsAreNamed) {
  const std::string dir = TestTempDir();
  const WrittenRun good = WriteRun(dir);
  const auto refused = [&](const std::vector<std::string>& words) {
    ExpectInputError([&] { ReadQuietly(dir); }, words);
  };
  WriteTextAtomically(dir + "/report.json", good.report.dump().substr(0, 900));
  refused({"report.json", "is not JSON", "line 1"});
  for (const auto& key : good.report.items()) {
    if (key.key() == "motion") continue;  // not every run is one
    WrittenRun bad = good;
    bad.report.erase(key.key());
    bad.WriteReport();
    refused({"report.json: " + key.key(), "is missing"});
  }
  for (const std::string key : {"usable", "muscles", "intersections"}) {
    WrittenRun bad = good;
    bad.report["frames"][1].erase(key);
    bad.WriteReport();
    refused({"report.json: frames[1]." + key + ": is missing"});
  }
  WrittenRun bad = good;
  bad.report["frames"][0]["muscles"][0]["iterations"] = "many";
  bad.WriteReport();
  refused({"report.json: frames[0].muscles[0].iterations: is \"many\""});
  bad = good;
  bad.report["motion"]["coordinates"][0]["unit"] = 3;
  bad.WriteReport();
  refused({"report.json: motion.coordinates[0].unit"});
  bad = good;
  bad.report["prepare"]["muscles"][0]["name"] = 3;
  bad.WriteReport();
  refused({"report.json: prepare.muscles[0].name", "3"});
  fs::remove(dir + "/report.json");
  refused({"report.json"});
}

TEST(RecordedRun, DamagedMeshesAreNamed) {
  const std::string dir = TestTempDir();
  const auto refused = [&](const std::vector<std::string>& words) {
    ExpectInputError([&] { ReadQuietly(dir); }, words);
    WriteRun(dir);
  };
  const WrittenRun good = WriteRun(dir);
  fs::remove(dir + "/frame_0001/bone.ply");
  refused({"frame_0001", "\"bone\""});
  WriteTextAtomically(dir + "/frame_0000/muscle.ply", "ply\n");
  refused({"frame_0000/muscle.ply"});
  WriteTriangleSoup(dir + "/frame_0000/muscle.ply", good.bone);
  refused({"frame_0000/muscle.ply", "triangles"});
  Points bent = good.bone_frames[1];
  bent(0, 0) += 0.1;
  WriteTriangleSoup(dir + "/frame_0001/bone.ply", {bent, good.bone.triangles});
  refused({"frame_0001/bone.ply", "moved and turned"});
  WriteLinesFile(dir + "/frame_0001/lines.json", {{"other", {}, {}}});
  refused({"frame_0001/lines.json", "other muscles"});
  WriteLinesFile(dir + "/frame_0001/lines.json", {{"muscle", {}, {}}});
  refused({"frame_0001/lines.json", "\"muscle\""});
  fs::remove_all(dir + "/rest");
  refused({"rest"});
}

}  // namespace
}  // namespace musclewarp
