// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "tools/export_osim.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <sstream>

#include "musclewarp/base/angles.h"
#include "musclewarp/base/child_process.h"
#include "musclewarp/base/input_file.h"
#include "musclewarp/base/output_file.h"
#include "musclewarp/build_info/build_info.h"
#include "musclewarp/figures/figures_json.h"
#include "musclewarp/figures/frame_figures.h"
#include "musclewarp/opensim/kinematics.h"
#include "musclewarp/program/program.h"
#include "support/input_errors.h"
#include "support/temp_dir.h"
#include "tools/run_program.h"

namespace musclewarp {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;
using ::testing::HasSubstr;

const char kModel[] =
    "<OpenSimDocument Version=\"30000\"><Model name=\"leg\">"
    "<BodySet><objects><Body name=\"ground\"/><Body name=\"femur\"><Joint>"
    "<PinJoint name=\"hip\"><parent_body>ground</parent_body>"
    "<CoordinateSet><objects><Coordinate name=\"flexion\"/></objects>"
    "</CoordinateSet></PinJoint></Joint></Body></objects></BodySet>"
    "<ForceSet><objects><Thelen2003Muscle name=\"psoas\">"
    "<GeometryPath><PathPointSet><objects>"
    "<PathPoint name=\"a\"><location>0 0 0</location><body>ground</body>"
    "</PathPoint><PathPoint name=\"b\"><location>0 1 0</location>"
    "<body>femur</body></PathPoint></objects></PathPointSet></GeometryPath>"
    "</Thelen2003Muscle></objects></ForceSet></Model></OpenSimDocument>";

double Length(double radians) { return 200 + 30 * std::sin(radians); }

// A run whose line has the length above, and a line that the model lacks.
class ExportOsimTest : public ::testing::Test {
 protected:
  void SetUp() override {
    dir_ = TestTempDir();
    WriteTextAtomically(dir_ + "/leg.osim", kModel);
    report_ = {
        {"version", kVersion},
        {"scene", "leg"},
        {"axes", "LPS"},
        {"inputs_hash", "0123"},
        {"contact", "certified"},
        {"motion", {{"model", dir_ + "/leg.osim"}}},
        {"prepare", {{"muscles", Json::array()}, {"bones", Json::array()}}},
        {"summary", {{"finished", true}, {"usable", true}}},
        {"frames", Json::array()}};
    for (int degrees = -10; degrees <= 90; degrees += 10) {
      const double q = RadiansOf(degrees);
      FrameFigures frame;
      frame.index = 7 + static_cast<int>(report_["frames"].size());
      frame.time = 0.5 * frame.index;
      frame.coordinates = {{"flexion", degrees}};
      MuscleFigures& muscle = frame.muscles.emplace_back();
      muscle.solver = NothingToSolve();
      muscle.line_lengths = {{"psoas", Length(q)}, {"extra", 1}};
      muscle.line_moment_arms = {{"psoas", {{"flexion", -30 * std::cos(q)}}}};
      report_["frames"].push_back(Json(JsonOf(frame)));
    }
  }

  int Run(const std::string& runs) {
    screen_.str("");
    return ExportOsim(runs, out_(), options_, screen_);
  }

  int Run() {
    WriteTextAtomically(dir_ + "/report.json", report_.dump());
    return Run(dir_);
  }

  void ExpectRefused(const std::vector<std::string>& words) {
    ExpectInputError([&] { Run(); }, words);
    EXPECT_FALSE(fs::exists(out_()));
  }

  std::string out_() const { return dir_ + "/fitted.osim"; }

  std::string dir_;
  Json report_;
  PathExportOptions options_;
  std::ostringstream screen_;
};

TEST_F(ExportOsimTest, ModelHasTheLengthsOfTheRun) {
  EXPECT_EQ(Run(), kExitUsable);
  EXPECT_THAT(screen_.str(), HasSubstr("line \"extra\" is not a muscle"));
  const Json record = Json::parse(ReadFile(dir_ + "/fitted.fit.json"));
  const double error = record["muscles"]["psoas"]["length_error_max_mm"];
  EXPECT_LE(error, 0.5);
  const Model model = ReadModel(out_());
  for (int degrees = -10; degrees <= 90; degrees += 10) {
    const double q = RadiansOf(degrees);
    const double length =
        PathLength(model.muscles[0], BodyFrames(model, {q}), {q});
    EXPECT_LE(std::abs(length - Length(q)), error + 1e-9);
  }
}

TEST_F(ExportOsimTest, SeveralRunsMakeOneModel) {
  EXPECT_EQ(Run(), kExitUsable);
  EXPECT_EQ(Run(dir_ + "," + dir_), kExitUsable);
  const Json record = Json::parse(ReadFile(dir_ + "/fitted.fit.json"));
  EXPECT_EQ(record["muscles"]["psoas"]["samples"], 22);
}

TEST_F(ExportOsimTest, ARunHasItsModelWhereverItIsTaken) {
  const std::string run = dir_ + "/run";
  fs::create_directories(run + "/rest");
  fs::rename(dir_ + "/leg.osim", run + "/rest/model.osim");
  report_["motion"] = {{"model", "../leg.osim"},
                       {"kept_model", "rest/model.osim"}};
  WriteTextAtomically(run + "/report.json", report_.dump());
  EXPECT_EQ(Run(run), kExitUsable);
  fs::create_directories(dir_ + "/elsewhere");
  fs::rename(run, dir_ + "/elsewhere/taken");
  EXPECT_EQ(Run(dir_ + "/elsewhere/taken"), kExitUsable);
  const Json record = Json::parse(ReadFile(dir_ + "/fitted.fit.json"));
  EXPECT_EQ(record["model"], "elsewhere/taken/rest/model.osim");
  EXPECT_EQ(record["runs"][0], "elsewhere/taken");
}

TEST_F(ExportOsimTest, TheModelOfARunMayLieBesideIt) {
  const std::string run = dir_ + "/run";
  fs::create_directories(run);
  report_["motion"]["model"] = "../leg.osim";
  WriteTextAtomically(run + "/report.json", report_.dump());
  EXPECT_EQ(Run(run), kExitUsable);
}

TEST_F(ExportOsimTest, ModelsOfSeveralRunsAreComparedByWhatTheyHold) {
  for (const std::string name : {"one", "two"}) {
    const std::string run = dir_ + "/" + name;
    fs::create_directories(run + "/rest");
    WriteTextAtomically(run + "/rest/model.osim", kModel);
    report_["motion"] = {{"model", "../" + name + ".osim"},
                         {"kept_model", "rest/model.osim"}};
    WriteTextAtomically(run + "/report.json", report_.dump());
  }
  const std::string both = dir_ + "/one," + dir_ + "/two";
  EXPECT_EQ(Run(both), kExitUsable);
  WriteTextAtomically(dir_ + "/two/rest/model.osim",
                      kModel + std::string("<!-- other -->"));
  ExpectInputError([&] { Run(both); }, {"two", "motion.model", "--model"});
}

TEST_F(ExportOsimTest, ErrorsAboveTheBoundAreSaid) {
  options_.bounds.max_length_error = 1e-12;
  EXPECT_EQ(Run(), kExitNotUsable);
  EXPECT_THAT(screen_.str(), HasSubstr("ABOVE THE BOUND"));
}

TEST_F(ExportOsimTest, RefusesRunsThatWillNotDo) {
  const Json good = report_;
  report_["summary"]["usable"] = false;
  ExpectRefused({"report.json: summary.usable", "is false"});
  report_ = good;
  report_["summary"]["finished"] = false;
  ExpectRefused({"summary.finished", "--resume"});
  report_ = good;
  report_["motion"] = nullptr;
  ExpectRefused({"motion: is null"});
  report_ = good;
  report_["frames"][3]["moment_arms_converged"] = false;
  ExpectRefused({"frames[3].moment_arms_converged",
                 "frame_0010, at 5 s",
                 "mean nothing"});
  report_ = good;
  report_["frames"][0]["muscles"][0]["line_moment_arms_mm"] = Json::object();
  ExpectRefused({"line_moment_arms_mm", "psoas", "--contact=certified"});
  report_ = good;
  for (Json& frame : report_["frames"]) {
    frame["muscles"][0]["line_lengths_mm"] = {{"extra", 1}};
  }
  ExpectRefused({"has no line that is a muscle"});
}

TEST_F(ExportOsimTest, RefusesRunsOfDifferentContactModes) {
  EXPECT_EQ(Run(), kExitUsable);
  const std::string other = dir_ + "/other";
  fs::create_directory(other);
  report_["contact"] = "none";
  WriteTextAtomically(other + "/report.json", report_.dump());
  const std::string record = ReadFile(dir_ + "/fitted.fit.json");
  ExpectInputError([&] { Run(dir_ + "," + other); },
                   {other + ": was made with --contact=none",
                    dir_ + " with --contact=certified",
                    "give runs of one contact mode"});
  EXPECT_EQ(ReadFile(dir_ + "/fitted.fit.json"), record);
  const ProgramRun program = RunCommandLine(
      MUSCLEWARP_EXPORT,
      "--in=" + dir_ + "," + other + " --out=" + out_() + " --format=osim");
  EXPECT_EQ(program.exit_code, kExitBadInput);
  EXPECT_EQ(Run(other + "," + other), kExitUsable);
}

// Reads the model as a program does that is not ours.
TEST_F(ExportOsimTest, PythonReadsModelsOfAllEncodings) {
  if (FindProgram("python3").empty()) GTEST_SKIP() << "no python3";
  WriteTextAtomically(
      dir_ + "/names.py",
      "import sys, xml.etree.ElementTree as tree\n"
      "root = tree.parse(sys.argv[1]).getroot()\n"
      "muscle = root.find('.//Thelen2003Muscle')\n"
      "name = muscle.get('name') + muscle.find('.//coordinate_paths').text\n"
      "sys.stdout.buffer.write(name.encode('utf-8'))\n");
  const std::string model = std::string(kModel).replace(
      std::string(kModel).find("psoas"), 5, "L\xfc");
  for (Json& frame : report_["frames"]) {
    Json& muscle = frame["muscles"][0];
    muscle["line_lengths_mm"] = {
        {"L\xc3\xbc", muscle["line_lengths_mm"]["psoas"]}};
    muscle["line_moment_arms_mm"] = {
        {"L\xc3\xbc", muscle["line_moment_arms_mm"]["psoas"]}};
  }
  for (const std::string head :
       {"<?xml version=\"1.0\" encoding=\"ISO-8859-1\"?>",
        "<?xml version=\"1.0\" encoding=\"windows-1252\"?>\n",
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n",
        ""}) {
    WriteTextAtomically(dir_ + "/leg.osim", head + model);
    EXPECT_EQ(Run(), kExitUsable);
    const ProgramRun python =
        RunCommandLine("python3", dir_ + "/names.py " + out_());
    EXPECT_EQ(python.exit_code, 0) << head << python.errors;
    EXPECT_EQ(python.out, "L\xc3\xbc/jointset/hip/flexion") << head;
  }
}

TEST_F(ExportOsimTest, RefusesToReplaceTheModel) {
  WriteTextAtomically(dir_ + "/report.json", report_.dump());
  ExpectInputError(
      [&] { ExportOsim(dir_, dir_ + "/leg.osim", options_, screen_); },
      {"--out", "the model that is read"});
  EXPECT_EQ(ReadFile(dir_ + "/leg.osim"), kModel);
  ExpectInputError([&] { ExportOsim(dir_, "leg.xml", options_, screen_); },
                   {"--out=leg.xml", ".osim"});
}

}  // namespace
}  // namespace musclewarp
