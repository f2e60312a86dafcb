// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "tools/export_command.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <sstream>

#include "musclewarp/base/child_process.h"
#include "musclewarp/base/output_file.h"
#include "musclewarp/mesh/measures.h"
#include "musclewarp/mesh_files/mesh_io.h"
#include "musclewarp/program/program.h"
#include "musclewarp/run/attachments_file.h"
#include "run/written_run.h"
#include "support/input_errors.h"
#include "support/meshes.h"
#include "support/temp_dir.h"
#include "tools/run_program.h"

namespace musclewarp {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;
using ::testing::AllOf;
using ::testing::ContainsRegex;
using ::testing::HasSubstr;
using ::testing::Not;

// A run of two frames: in the first one nothing crosses, in the second the bone
// is in the muscle.
class Export : public ::testing::Test {
 protected:
  void SetUp() override {
    run_ = WriteRun(TestTempDir());
    request_.in = run_.dir;
    request_.out = run_.dir + "/out";
  }

  int Run(const std::string& format) {
    request_.format = format;
    screen_.str("");
    return ExportCommand(request_, screen_);
  }

  void ExpectRefused(const std::string& format,
                     const std::vector<std::string>& words) {
    ExpectInputError([&] { Run(format); }, words);
    EXPECT_FALSE(fs::exists(request_.out));
  }

  // A mesher that does as the script says.
  void UseFakeMesher(const std::string& script) {
    request_.elements.mesher = run_.dir + "/tetgen";
    WriteTextAtomically(request_.elements.mesher,
                        "#!/bin/sh\n" + script + "\n");
    fs::permissions(request_.elements.mesher, fs::perms::owner_all);
  }

  Json Record() const {
    return Json::parse(FileText(request_.out + "/export.json"));
  }

  WrittenRun run_;
  ExportRequest request_;
  std::ostringstream screen_;
};

TEST_F(Export, IsTheSameIfBonesAreWrittenOnce) {
  const auto crossings = [&] {
    EXPECT_EQ(Run("crossings"), kExitUsable);
    return FileText(request_.out + "/crossings.csv") +
           FileText(request_.out + "/frame_0001_triangles.ply") +
           FileText(request_.out + "/frame_0001_curves.ply");
  };
  const std::string every = crossings();
  run_.KeepBonesOnce();
  EXPECT_TRUE(crossings() == every);
}

TEST_F(Export, CrossingsOfARun) {
  EXPECT_EQ(Run("crossings"), kExitUsable);
  EXPECT_THAT(screen_.str(),
              AllOf(HasSubstr("frame_0000  0 places"),
                    HasSubstr("frame_0001  1 places")));
  EXPECT_FALSE(fs::exists(request_.out + "/frame_0000_triangles.ply"));
  EXPECT_TRUE(fs::exists(request_.out + "/frame_0001_triangles.ply"));
  EXPECT_TRUE(fs::exists(request_.out + "/frame_0001_curves.ply"));
  EXPECT_THAT(FileText(request_.out + "/crossings.csv"),
              HasSubstr("\nframe_0001,muscle,bone,"));
}

TEST_F(Export, FramesKeepTheNumbersOfTheirFolders) {
  // The run has the frames 7 and 9, as of --frames=7:9:2.
  fs::rename(run_.dir + "/frame_0000", run_.dir + "/frame_0007");
  fs::rename(run_.dir + "/frame_0001", run_.dir + "/frame_0009");
  run_.report["frames"][0]["index"] = 7;
  run_.report["frames"][1]["index"] = 9;
  run_.WriteReport();
  request_.frames = "0";
  ExpectRefused("crossings", {"--frames=0", "frames 7 to 9 (2 of them)"});
  request_.frames = "9";
  EXPECT_EQ(Run("crossings"), kExitUsable);
  EXPECT_THAT(screen_.str(), HasSubstr("frame_0009  1 places, at 1.1 s\n"));
  EXPECT_TRUE(fs::exists(request_.out + "/frame_0009_curves.ply"));
  request_.frames = "all";
  request_.out = run_.dir + "/caches";
  EXPECT_EQ(Run("pc2"), kExitUsable);
  EXPECT_THAT(screen_.str(),
              AllOf(HasSubstr("frame_0007  1 of 2, at 0.1 s\n"),
                    HasSubstr("frame_0009  2 of 2, at 1.1 s\n")));
  if (FindProgram("tetgen").empty()) GTEST_SKIP() << "no tetgen";
  request_.out = run_.dir + "/out";
  request_.frames = "7:9";
  EXPECT_EQ(Run("inp,msh,feb"), kExitNotUsable);
  EXPECT_THAT(screen_.str(),
              AllOf(ContainsRegex("frame_0007 .*, at 0.1 s\n"),
                    ContainsRegex("frame_0009  failed: .*, at 1.1 s\n")));
  EXPECT_EQ(Record()["frames"][0]["frame"], "frame_0007");
  EXPECT_EQ(Record()["frames"][0]["time"], 0.1);
  const auto text = [&](const std::string& format) {
    return FileText(request_.out + "/frame_0007." + format);
  };
  EXPECT_THAT(text("inp"), HasSubstr("*HEADING\nby hand, frame_0007, "));
  EXPECT_THAT(text("feb"), HasSubstr("<!-- musclewarp-export, frame_0007."));
  EXPECT_THAT(text("msh"),
              AllOf(HasSubstr("$Comments\nby hand, frame_0007, "),
                    ContainsRegex("\"fibre\"\n1\n0\\.10*1?\n3\n0\n3\n")));
}

TEST_F(Export, CrossingsOfFiles) {
  request_.in = "";
  request_.files = {run_.dir + "/frame_0001/muscle.ply",
                    run_.dir + "/frame_0001/bone.ply"};
  request_.mesh_format = "obj";
  EXPECT_EQ(Run("crossings"), kExitUsable);
  EXPECT_TRUE(fs::exists(request_.out + "/meshes_curves.obj"));
  EXPECT_THAT(FileText(request_.out + "/crossings.csv"),
              HasSubstr("\nmeshes,muscle,bone,"));
  // What the reader of a mesh has to say comes along.
  const std::string file = run_.dir + "/noted.obj";
  WriteTextAtomically(file, "v 0 0 0\nv 9 0 0\nv 0 9 0\nf 1 2 3\nxyz\n");
  request_.files = {file};
  request_.out = run_.dir + "/of_one";
  EXPECT_EQ(Run("crossings"), kExitUsable);
  EXPECT_THAT(screen_.str(), HasSubstr("'xyz'"));
}

TEST_F(Export, ATableHasARowForEachFrame) {
  request_.out = run_.dir + "/out.csv";
  EXPECT_EQ(Run("csv"), kExitUsable);
  EXPECT_THAT(screen_.str(), HasSubstr("1 muscles in 2 frames"));
  const std::string both = FileText(request_.out);
  EXPECT_EQ(std::count(both.begin(), both.end(), '\n'), 3);
  request_.frames = "1";
  EXPECT_EQ(Run("csv"), kExitUsable);
  const std::string one = FileText(request_.out);
  EXPECT_THAT(both, HasSubstr(one.substr(one.find('\n'))));
  EXPECT_THAT(one, HasSubstr("\n1,"));
}

TEST_F(Export, AnimationsSayTheirAxes) {
  request_.out = run_.dir + "/out.glb";
  EXPECT_EQ(Run("glb"), kExitUsable);
  EXPECT_TRUE(fs::exists(request_.out));
  EXPECT_THAT(screen_.str(),
              AllOf(HasSubstr("1 muscles, 1 bones, 2 frames"),
                    HasSubstr("+y up"),
                    HasSubstr("the axes of the run are ASR"),
                    HasSubstr("warning: the run is of version 0")));
  request_.out = run_.dir + "/out";
  request_.frames = "1";
  EXPECT_EQ(Run("pc2"), kExitUsable);
  EXPECT_THAT(screen_.str(), HasSubstr("frame_0001  1 of 1, at 1.1 s\n"));
  EXPECT_TRUE(fs::exists(request_.out + "/muscle.pc2"));
}

TEST_F(Export, WhatCannotBeDoneIsNamedAndNothingIsWritten) {
  ExpectRefused("",
                {"--format=",
                 "crossings, csv, fit, glb, mjcf, osim, pc2, feb, inp, msh"});
  ExpectRefused("fbx", {"--format=fbx", "allowed: "});
  ExpectRefused("inp,glb", {"--format=inp,glb"});
  ExpectRefused("glb", {"--out", ".glb"});
  ExpectRefused("csv", {"--out", ".csv"});
  request_.frames = "0:7";
  ExpectRefused("pc2", {"--frames=0:7", "frames 0 to 1"});
  request_.frames = "all";
  request_.mesh_format = "stl";
  ExpectRefused("crossings", {"--mesh_format=stl", "ply, obj"});
  request_.mesh_format = "ply";
  request_.files = {"a.ply"};
  ExpectRefused("crossings", {"--in", "together with mesh files"});
  ExpectRefused("inp", {"a.ply", "--format=crossings only"});
  request_.files.clear();
  request_.in = "";
  ExpectRefused("inp", {"--in", "is missing"});
  request_.in = run_.dir + "/none";
  ExpectRefused("inp", {run_.dir + "/none"});
  request_.in = run_.dir;
  request_.elements.mesher = "/no/such/tetgen";
  ExpectRefused("inp", {"--mesher=/no/such/tetgen", "apt-get install"});
  UseFakeMesher("exit 0");
  request_.elements.mesher_timeout_s = 0;
  ExpectRefused("inp", {"--mesher_timeout_s", "above 0"});
  request_.elements.mesher_timeout_s = 1;
  request_.elements.min_dihedral_deg = 71;
  ExpectRefused("inp", {"--min_dihedral_deg", "0 to 70"});
  WriteTextAtomically(run_.dir + "/" + kAttachmentsFile, "{}");
  request_.elements.min_dihedral_deg = 0;
  ExpectRefused("inp", {kAttachmentsFile, "is missing"});
  request_.out = "";
  ExpectRefused("inp", {"--out", "is missing"});
}

TEST_F(Export, FramesThatCrossFailAndTheOthersAreWritten) {
  if (FindProgram("tetgen").empty()) GTEST_SKIP() << "no tetgen";
  EXPECT_EQ(Run("inp,msh,feb"), kExitNotUsable);
  for (const char* format : {".inp", ".msh", ".feb"}) {
    EXPECT_TRUE(fs::exists(request_.out + "/frame_0000" + format));
    EXPECT_FALSE(fs::exists(request_.out + "/frame_0001" + format));
  }
  EXPECT_THAT(screen_.str(),
              AllOf(HasSubstr("frame_0001  failed: " +
                              std::to_string(run_.pairs) + " pairs"),
                    HasSubstr("1 of 2 frames written")));
  const Json record = Record();
  EXPECT_FALSE(record["usable"]);
  EXPECT_EQ(record["frames"][0]["inverted"], 0);
  EXPECT_TRUE(record["frames"][0]["failure"].is_null());
  EXPECT_NEAR(record["frames"][0]["volume_mm3"].get<double>() /
                  SignedVolume(run_.muscle.points, run_.muscle.triangles),
              1,
              1e-12);
  EXPECT_FALSE(record["frames"][1]["failure"].is_null());
  // Without the bone nothing crosses.
  request_.elements.bones = false;
  EXPECT_EQ(Run("inp"), kExitUsable);
  EXPECT_THAT(FileText(request_.out + "/frame_0001.inp"),
              Not(HasSubstr("RIGID BODY")));
}

TEST_F(Export, OneMeshFollowsTheMuscle) {
  if (FindProgram("tetgen").empty()) GTEST_SKIP() << "no tetgen";
  request_.elements.bones = false;
  request_.elements.one_mesh = true;
  EXPECT_EQ(Run("inp"), kExitUsable);
  const std::string first = FileText(request_.out + "/frame_0000.inp");
  const std::string second = FileText(request_.out + "/frame_0001.inp");
  const auto elements = [](const std::string& text) {
    const size_t at = text.find("*ELEMENT");
    return text.substr(at, text.find("*SURFACE") - at);
  };
  EXPECT_EQ(elements(first), elements(second));
  EXPECT_NE(first, second);
  EXPECT_EQ(Record()["frames"][1]["inverted"], 0);
}

TEST_F(Export, AttachmentsBecomeNodeSets) {
  if (FindProgram("tetgen").empty()) GTEST_SKIP() << "no tetgen";
  request_.frames = "0";
  RecordedAttachments attachments;
  attachments.muscles["muscle"] = {{"pelvis", {3, 5}}};
  attachments.bones["bone"] = "pelvis";
  WriteAttachments(run_.dir + "/" + kAttachmentsFile, attachments);
  EXPECT_EQ(Run("inp"), kExitUsable);
  EXPECT_THAT(FileText(request_.out + "/frame_0000.inp"),
              HasSubstr("*NSET, NSET=muscle_on_pelvis\n4, 6\n"));
}

TEST_F(Export, PoorElementsFailAFrame) {
  if (FindProgram("tetgen").empty()) GTEST_SKIP() << "no tetgen";
  request_.frames = "0";
  request_.elements.min_dihedral_deg = 60;
  EXPECT_EQ(Run("inp"), kExitNotUsable);
  EXPECT_THAT(Record()["frames"][0]["failure"].get<std::string>(),
              HasSubstr("--min_dihedral_deg is 60"));
  EXPECT_FALSE(fs::exists(request_.out + "/frame_0000.inp"));
}

TEST_F(Export, AMesherThatDiesFailsTheFrameAndLeavesNoFile) {
  request_.frames = "0";
  UseFakeMesher("kill -ABRT $$");
  EXPECT_EQ(Run("inp"), kExitNotUsable);
  EXPECT_THAT(screen_.str(), HasSubstr("killed by signal 6"));
  UseFakeMesher("exec sleep 300");
  request_.elements.mesher_timeout_s = 0.05;
  EXPECT_EQ(Run("inp"), kExitNotUsable);
  EXPECT_THAT(screen_.str(), HasSubstr("ran out of time"));
  for (const auto& entry : fs::directory_iterator(request_.out)) {
    EXPECT_EQ(entry.path().filename(), "export.json");
  }
}

TEST_F(Export, ResumeKeepsWhatIsThere) {
  if (FindProgram("tetgen").empty()) GTEST_SKIP() << "no tetgen";
  EXPECT_EQ(Run("inp"), kExitNotUsable);  // the second frame crosses
  const Json before = Record();
  request_.elements.resume = true;
  UseFakeMesher("exit 1");
  EXPECT_EQ(Run("inp"), kExitNotUsable);
  EXPECT_THAT(screen_.str(),
              AllOf(HasSubstr("frame_0000  is there"),
                    HasSubstr("frame_0001  failed")));
  EXPECT_EQ(Record()["frames"], before["frames"]);
  // A format that is not there has to be made.
  request_.frames = "0";
  EXPECT_EQ(Run("inp,msh"), kExitNotUsable);
  EXPECT_THAT(screen_.str(), HasSubstr("the mesher ended with exit code 1"));
}

TEST_F(Export, ResumeRefusesTheFramesOfAnotherRunOrOtherFlags) {
  if (FindProgram("tetgen").empty()) GTEST_SKIP() << "no tetgen";
  EXPECT_EQ(Run("inp"), kExitNotUsable);  // the second frame crosses
  const std::string frame = FileText(request_.out + "/frame_0000.inp");
  request_.elements.resume = true;
  request_.elements.min_dihedral_deg = 1;
  ExpectInputError([&] { Run("inp"); }, {"export.json", "--resume"});
  request_.elements.min_dihedral_deg = 0;
  run_.report["inputs_hash"] = "another";
  run_.WriteReport();
  ExpectInputError([&] { Run("inp"); }, {"export.json", "another run"});
  EXPECT_EQ(FileText(request_.out + "/frame_0000.inp"), frame);
}

TEST_F(Export, TheProgramExitsAsAllDo) {
  const auto exit_code = [&](const std::string& arguments) {
    return RunCommandLine(MUSCLEWARP_EXPORT, arguments).exit_code;
  };
  const std::string in = "--in=" + run_.dir + " --out=" + request_.out;
  EXPECT_EQ(exit_code("--help"), kExitUsable);
  EXPECT_EQ(exit_code(in + " --format=crossings"), kExitUsable);
  EXPECT_EQ(exit_code(in + " --format=nothing"), kExitBadInput);
  EXPECT_EQ(exit_code(in + " --format=glb --unknown"), kExitBadInput);
  UseFakeMesher("exit 1");
  EXPECT_EQ(
      exit_code(in + " --format=msh --mesher=" + request_.elements.mesher),
      kExitNotUsable);
}

}  // namespace
}  // namespace musclewarp
