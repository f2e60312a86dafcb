// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/run/run_writer.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "musclewarp/base/described_checks.h"
#include "musclewarp/base/input_file.h"
#include "musclewarp/figures/figures_json.h"
#include "musclewarp/run/attachments_file.h"
#include "support/meshes.h"
#include "support/temp_dir.h"

namespace musclewarp {
namespace {

namespace fs = std::filesystem;

// A muscle and two poses of it.
class RunWriterTest : public ::testing::Test {
 protected:
  RunWriterTest() {
    const TriangleSoup ball = Icosphere(10, 1);
    scene_.scene.name = "a \"quoted\"\nname";
    scene_.scene.muscles.resize(1);
    scene_.muscles.resize(1);
    scene_.muscles[0].model.name = "muscle";
    scene_.muscles[0].model.fine_rest = ball.points;
    scene_.muscles[0].model.fine_triangles = ball.triangles;
    rest_.muscles.resize(1);
    rest_.muscles[0].points = ball.points;
    for (int i = 0; i < 2; ++i) {
      Frame& frame = frames_.emplace_back();
      frame.index = i;
      frame.muscles.resize(1);
      frame.muscles[0].points = ball.points / (i + 3);
      frame.muscles[0].volume_error = 1.0 / (i + 3);
      frame.muscles[0].solver.stop_reason = StopReason::kConverged;
    }
  }

  nlohmann::ordered_json Report() const {
    return nlohmann::ordered_json::parse(ReadFile(dir_ + "/report.json"));
  }

  const std::string dir_ = TestTempDir();
  PreparedScene scene_;
  Frame rest_;
  std::vector<Frame> frames_;
};

TEST_F(RunWriterTest, WritesWhatIsReadBackEqual) {
  RunWriter writer(scene_, {}, dir_);
  writer.WriteRest(rest_);
  RunRecord run;
  run.dir = dir_;
  run.scene = &scene_;
  run.frames_planned = 2;
  run.finished = true;
  for (const Frame& frame : frames_) {
    run.frames.push_back(writer.WriteFrame(frame));
    EXPECT_TRUE(AreEqual(run.frames.back(), FiguresOf(frame)));
  }
  writer.WriteReport(run);
  for (const char* file : {"rest/muscle.ply",
                           "frame_0000/muscle.ply",
                           "frame_0001/muscle.ply",
                           kAttachmentsFile}) {
    EXPECT_TRUE(fs::exists(fs::path(dir_) / file)) << file;
  }
  const auto report = Report();
  EXPECT_EQ(report.at("scene"), scene_.scene.name);
  std::vector<FrameFigures> frames;
  ReadJson(report.at("frames"), {nullptr, "frames"}, &frames);
  EXPECT_TRUE(AreEqual(frames, run.frames));
  RunFigures summary;
  ReadJson(report.at("summary"), {nullptr, "summary"}, &summary);
  EXPECT_TRUE(AreEqual(summary, TotalsOf(run)));
}

TEST_F(RunWriterTest, AFigureThatMakesNoSenseIsAShortcoming) {
  frames_[0].muscles[0].volume_error = std::nan("");
  const FrameFigures figures =
      RunWriter(scene_, {}, dir_).WriteFrame(frames_[0]);
  EXPECT_FALSE(figures.IsUsable());
  ASSERT_EQ(figures.shortcomings.size(), 1u);
  EXPECT_EQ(figures.shortcomings[0],
            "a figure makes no sense: muscles[0].volume_error is nan, "
            "allowed: numbers");
}

// The report is there from the first frame on, and not written for every one of
// many.
TEST_F(RunWriterTest, KeepsTheReportUpToDate) {
  RunWriter writer(scene_, {}, dir_);
  RunRecord run;
  run.scene = &scene_;
  run.frames.push_back(writer.WriteFrame(frames_[0]));
  writer.KeepReportUpToDate(run);
  EXPECT_EQ(Report().at("frames").size(), 1u);
  EXPECT_EQ(Report().at("summary").at("finished"), false);
  run.frames.push_back(writer.WriteFrame(frames_[1]));
  writer.WriteReport(run);
  EXPECT_EQ(Report().at("frames").size(), 2u);
}

}  // namespace
}  // namespace musclewarp
