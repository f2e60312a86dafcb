// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/page/page_contents.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "page/packed_text.h"
#include "page/read_quietly.h"
#include "run/written_run.h"
#include "support/input_errors.h"
#include "support/temp_dir.h"

namespace musclewarp {
namespace {

using OrderedJson = nlohmann::ordered_json;

// The crossings, frames and meshes of the first run.
OrderedJson FirstRun(const PageContents& contents) {
  return contents.json["runs"][0];
}

TEST(PageContents, PositionsAreWithinTheTolerance) {
  const WrittenRun written = WriteRun(TestTempDir());
  for (const double tolerance : {0.001, 0.1}) {
    PageOptions options;
    options.position_tolerance = tolerance;
    const PageContents contents =
        PageContentsOf({ReadQuietly(written.dir)}, options);
    const OrderedJson run = FirstRun(contents);
    EXPECT_GT(run["position_error_mm"], 0);
    EXPECT_LE(run["position_error_mm"], tolerance);
    const Points last =
        UnpackedPose(contents.numbers, run["muscles"][0]["motion"], 2);
    // Sums of the reader's products are rounded.
    EXPECT_LE((last - written.muscle_frames[1]).cwiseAbs().maxCoeff(),
              run["position_error_mm"].get<double>() + 1e-9);
  }
}

TEST(PageContents, TrianglesAreThoseOfTheFiles) {
  const WrittenRun written = WriteRun(TestTempDir());
  const PageContents contents = PageContentsOf({ReadQuietly(written.dir)}, {});
  const std::vector<int> numbers = UnpackedNumbers(
      contents.numbers, FirstRun(contents)["muscles"][0]["triangles"]);
  EXPECT_EQ(numbers,
            std::vector<int>(written.muscle.triangles.data(),
                             written.muscle.triangles.data() +
                                 written.muscle.triangles.size()));
}

TEST(PageContents, HaveTheAttachmentsOfMuscles) {
  RecordedRun run = ReadQuietly(WriteRun(TestTempDir()).dir);
  run.muscles[0].attached = {{"pelvis", {3, 5, 8}}, {"femur_r", {4}}};
  const PageContents contents = PageContentsOf({run}, {});
  const OrderedJson areas = FirstRun(contents)["muscles"][0]["attached"];
  ASSERT_EQ(areas.size(), 2u);
  EXPECT_EQ(areas[0]["body"], "pelvis");
  EXPECT_EQ(UnpackedNumbers(contents.numbers, areas[0]["vertices"]),
            (std::vector<int>{3, 5, 8}));
}

// What is inside by less than a step is still shown as inside.
TEST(PageContents, GapsAreRoundedAwayFromZero) {
  RecordedRun run = ReadQuietly(WriteRun(TestTempDir()).dir);
  run.muscles[0].gaps[0].setConstant(-1e-6);
  run.muscles[0].gaps[1].setConstant(1e-6);
  run.muscles[0].gaps[2].setConstant(-1000);
  const PageContents contents = PageContentsOf({run}, {});
  const std::vector<int> gaps = UnpackedNumbers(
      contents.numbers, FirstRun(contents)["muscles"][0]["gaps"]);
  const size_t size = run.muscles[0].points[0].rows();
  ASSERT_EQ(gaps.size(), 3 * size);
  EXPECT_EQ(gaps[0], -1);
  EXPECT_EQ(gaps[size], 1);
  EXPECT_EQ(gaps[2 * size], -100);
}

TEST(PageContents, ABoneIsSimplifiedForTheEyeOnly) {
  const WrittenRun written = WriteRun(TestTempDir());
  PageOptions options;
  options.max_bone_triangles = 200;
  const PageContents contents =
      PageContentsOf({ReadQuietly(written.dir)}, options);
  const OrderedJson run = FirstRun(contents);
  const OrderedJson& bone = run["bones"][0];
  EXPECT_EQ(bone["triangles_in_files"], written.bone.triangles.rows());
  EXPECT_LE(bone["triangles"]["count"], 3 * options.max_bone_triangles);
  EXPECT_GT(bone["view_error_mm"], 0);
  EXPECT_EQ(run["crossings"][2][0]["triangle_pairs"], written.pairs);
}

TEST(PageContents, CrossingTrianglesAreListedForMuscles) {
  const RecordedRun run = ReadQuietly(WriteRun(TestTempDir()).dir);
  const PageContents contents = PageContentsOf({run}, {});
  const OrderedJson crossings = FirstRun(contents)["crossings"];
  ASSERT_EQ(crossings.size(), 3u);
  EXPECT_TRUE(crossings[0].empty());
  EXPECT_EQ(UnpackedNumbers(contents.numbers, crossings[2][0]["a_triangles"]),
            run.intersections[2].pairs[0].triangles_of_a);
  // The other mesh is a bone.
  EXPECT_FALSE(crossings[2][0].contains("b_triangles"));
}

TEST(PageContents, MomentArmsNeedOneMovingCoordinate) {
  RecordedRun run = ReadQuietly(WriteRun(TestTempDir()).dir);
  const auto arms = [&] {
    return FirstRun(PageContentsOf({run}, {}))["carried_moment_arms_mm"];
  };
  EXPECT_FALSE(arms().is_null());
  run.report["motion"]["coordinates"][0]["moves"] = false;
  EXPECT_TRUE(arms().is_null());
  run.report.erase("motion");
  EXPECT_TRUE(arms().is_null());
}

TEST(PageContents, NameNoFoldersOfTheMachine) {
  RecordedRun run = ReadQuietly(WriteRun(TestTempDir()).dir);
  run.report["command"] = "musclewarp-deform --scene=/home/anna/leg.json";
  run.report["motion"]["model"] = "../../home/anna/leg.osim";
  run.report["prepare"]["warnings"] = {"/home/anna/psoas.ply: is open"};
  const std::string text = PageContentsOf({run}, {}).json.dump();
  EXPECT_EQ(text.find("anna"), std::string::npos);
  EXPECT_NE(text.find("--scene=leg.json"), std::string::npos);
  EXPECT_EQ(text.find(run.dir), std::string::npos);
}

TEST(PageContents, RunsAreToldApartByAsFewFoldersAsWillDo) {
  RecordedRun run = ReadQuietly(WriteRun(TestTempDir()).dir);
  run.dir = "/home/anna/before/flexion";
  RecordedRun other = run;
  other.dir = "/home/anna/after/flexion/";
  const PageContents contents = PageContentsOf({run, other}, {});
  EXPECT_EQ(contents.json["runs"][0]["folder"], "before/flexion");
  EXPECT_EQ(contents.json["runs"][1]["folder"], "after/flexion");
  EXPECT_EQ(FirstRun(PageContentsOf({run}, {}))["folder"], "flexion");
}

TEST(PageContents, OptionsAreNamedWhenRefused) {
  const RecordedRun run = ReadQuietly(WriteRun(TestTempDir()).dir);
  PageOptions options;
  options.side = "middle";
  ExpectInputError([&] { PageContentsOf({run}, options); }, {"side", "middle"});
}

}  // namespace
}  // namespace musclewarp
