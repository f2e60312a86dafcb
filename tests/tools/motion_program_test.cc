// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <vector>

#ifdef MUSCLEWARP_WITH_VTK
#include <vtkCellData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkXMLDataElement.h>
#include <vtkXMLPolyDataReader.h>
#include <vtkXMLUtilities.h>
#endif

#include "musclewarp/base/output_file.h"
#include "musclewarp/mesh_files/mesh_io.h"
#include "musclewarp/opensim/storage_table.h"
#include "support/meshes.h"
#include "support/osim_models.h"
#include "support/temp_dir.h"
#include "tools/run_program.h"

namespace musclewarp {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;
using ::testing::AllOf;
using ::testing::Contains;
using ::testing::HasSubstr;

// A spindle along y over a knee at (0, -400, 0) mm that turns about z, between
// two balls of bone; the knee bends by 30 degrees in 7 rows.
class MotionProgram : public ::testing::Test {
 protected:
  MotionProgram() : dir_(TestTempDir()) {
    TriangleSoup muscle = Spindle(12, 60, 3);
    const Points along_z = muscle.points;
    muscle.points.col(1) = -along_z.col(2);
    muscle.points.col(2) = along_z.col(1);
    muscle.points.rowwise() += Eigen::RowVector3d(25, -400, 0);
    WriteTriangleSoup(dir_ + "/muscle.ply", muscle);
    for (const int side : {-1, 1}) {
      TriangleSoup bone = Icosphere(9, 2);
      bone.points.rowwise() += Eigen::RowVector3d(25, -400 + 66 * side, 0);
      WriteTriangleSoup(dir_ + (side < 0 ? "/shank.ply" : "/thigh.ply"), bone);
    }
    model_ = Model4(Joint4("PinJoint", "knee"),
                    "",
                    Muscle("path",
                           Point4("p1", "thigh", "0.025 -0.345 0") +
                               Point4("p2", "thigh", "0.025 -0.38 0") +
                               Point4("p3", "shank", "0.025 -0.02 0") +
                               Point4("p4", "shank", "0.025 -0.055 0")));
    motion_ =
        "bend\nversion=1\nnRows=7\nnColumns=2\ninDegrees=yes\nendheader\n"
        "time\tknee\n";
    for (int i = 0; i < 7; ++i) {
      motion_ += std::to_string(0.1 * i) + "\t" + std::to_string(-5 * i) + "\n";
    }
    scene_ = Json::parse(R"({"name": "leg", "units": "mm",
      "muscles": [{"name": "muscle", "mesh": "muscle.ply", "lines": ["path"]}],
      "bones": [{"name": "thigh", "mesh": "thigh.ply", "body": "thigh"},
                {"name": "shank", "mesh": "shank.ply", "body": "shank"}],
      "model": "leg.osim", "motion": "bend.mot",
      "model_rest": {"coordinates": {"knee": 0}, "in_degrees": true}})");
  }

  std::string CommandLine(const std::string& flags, const std::string& out) {
    WriteTextAtomically(dir_ + "/scene.json", scene_.dump());
    WriteTextAtomically(dir_ + "/leg.osim", model_);
    WriteTextAtomically(dir_ + "/bend.mot", motion_);
    // Most are not about contact; flags that come later win.
    return "--contact=none --scene=" + dir_ + "/scene.json --out=" + out + " " +
           flags;
  }
  ProgramRun Run(const std::string& flags = "") {
    return RunCommandLine(MUSCLEWARP_DEFORM, CommandLine(flags, out()));
  }
  std::string out() const { return dir_ + "/out"; }
  Json Report() const { return Json::parse(FileText(out() + "/report.json")); }
  StorageTable Table(const std::string& name) const {
    return ReadStorageTable(out() + "/" + name + ".sto");
  }

  void ExpectRefused(const std::vector<std::string>& words) {
    const ProgramRun run = Run();
    EXPECT_EQ(run.exit_code, 2) << run.out << run.errors;
    for (const auto& word : words) EXPECT_THAT(run.errors, HasSubstr(word));
    EXPECT_FALSE(fs::exists(out()));
  }
  // The text with `from` replaced for one run.
  void ExpectRefusedWith(std::string* text,
                         const std::string& from,
                         const std::string& to,
                         const std::vector<std::string>& words) {
    const std::string good = *text;
    ASSERT_NE(text->find(from), std::string::npos) << from;
    text->replace(text->find(from), from.size(), to);
    ExpectRefused(words);
    *text = good;
  }

  const std::string dir_;
  std::string model_, motion_;
  Json scene_;
};

TEST_F(MotionProgram, FollowsTheMotionAndWritesItsTables) {
  const ProgramRun run = Run();
  ASSERT_EQ(run.exit_code, 0) << run.out << run.errors;
  EXPECT_THAT(run.out, AllOf(HasSubstr("frame 7 of 7"), HasSubstr(" left\n")));
  const Json report = Report();
  ASSERT_EQ(report["frames"].size(), 7u);
  EXPECT_TRUE(report["summary"]["finished"]);
  EXPECT_NEAR(report["frames"][6]["coordinates"]["knee"], -30, 1e-9);
  EXPECT_EQ(report["motion"]["coordinates"][0]["unit"], "degrees");
  const StorageTable lengths = Table("lengths");
  EXPECT_THAT(lengths.labels, testing::ElementsAre("path", "path_path"));
  for (size_t i = 0; i < 7; ++i) {
    const Json& muscle = report["frames"][i]["muscles"][0];
    EXPECT_NEAR(muscle["volume_ratio"], 1, 1e-6);
    EXPECT_EQ(lengths.times[i], report["frames"][i]["time"]);
    EXPECT_DOUBLE_EQ(lengths.values(i, 0),
                     1e-3 * muscle["line_lengths_mm"]["path"].get<double>());
    EXPECT_DOUBLE_EQ(lengths.values(i, 1),
                     1e-3 * muscle["path_lengths_mm"]["path"].get<double>());
  }
  // At rest the path is 110 mm. Its middle, between points at (25, 20) and
  // (25, -20) mm from the knee, is 2 sqrt(25^2 + 20^2) times the sine of half
  // the angle under which the knee sees it; the moment arm has the cosine.
  const double half_angle = std::atan2(20, 25) + 15 * M_PI / 180;
  const double between = 2 * std::hypot(25, 20) * std::sin(half_angle);
  EXPECT_NEAR(lengths.values(0, 1), 0.110, 1e-12);
  EXPECT_NEAR(lengths.values(6, 1), 1e-3 * (70 + between), 1e-9);
  const StorageTable arms = Table("moment_arms");
  EXPECT_THAT(arms.labels, testing::ElementsAre("path.knee", "path_path.knee"));
  const double arm = std::hypot(25, 20) * std::cos(half_angle);
  EXPECT_NEAR(arms.values(6, 1), 1e-3 * arm, 1e-8);
  EXPECT_EQ(Table("volumes").values.rows(), 7);
}

TEST_F(MotionProgram, FramesAreThoseOfTheirPosesWhateverCameBefore) {
  ASSERT_EQ(Run().exit_code, 0);
  const Points all = ReadTriangleSoup(out() + "/frame_0006/muscle.ply").points;
  ASSERT_EQ(Run("--frames=last").exit_code, 0);
  const Points alone =
      ReadTriangleSoup(out() + "/frame_0006/muscle.ply").points;
  // Both end within the solver's step threshold of the same minimum.
  EXPECT_LT((all - alone).rowwise().norm().maxCoeff(), 1e-3);
}

TEST_F(MotionProgram, NamesThatAreNotUtf8DoNotStopTheReport) {
  motion_ = "bend\ninDegrees=yes\nendheader\ntime\tknee\tf\xfc\xdf\n0\t-5\t0\n";
  const ProgramRun run = Run();
  ASSERT_EQ(run.exit_code, 0) << run.out << run.errors;
  EXPECT_TRUE(Report()["summary"]["finished"]);
}

TEST_F(MotionProgram, SelectsFramesByTime) {
  ASSERT_EQ(Run("--frames=0.15s:0.5s:2").exit_code, 0);
  std::vector<int> indices;
  const Json report = Report();
  for (const Json& frame : report["frames"]) indices.push_back(frame["index"]);
  EXPECT_THAT(indices, testing::ElementsAre(2, 4));
  EXPECT_EQ(Run("--frames=0.61s:1s").exit_code, 2);
  EXPECT_EQ(Run("--frames=0.1x").exit_code, 2);
}

TEST_F(MotionProgram, ContactGoesThereInSmallSteps) {
  const ProgramRun run = Run("--contact=paper --frames=0:6:6");
  ASSERT_EQ(run.exit_code, 0) << run.out << run.errors;
  const Json report = Report();
  EXPECT_EQ(report["frames"][0]["pose_steps"], 1);
  // 30 degrees by at most 5.
  EXPECT_GE(report["frames"][1]["pose_steps"], 6);
  EXPECT_EQ(report["frames"][1]["intersections"]["vertices_inside"], 0);
  EXPECT_NEAR(report["frames"][1]["muscles"][0]["volume_ratio"], 1, 1e-6);
}

TEST_F(MotionProgram, MusclesWithoutLinesGetThem) {
  scene_["muscles"][0].erase("lines");
  for (const int count : {1, 4}) {
    const ProgramRun run =
        Run("--auto_lines=" + std::to_string(count) + " --frames=last");
    ASSERT_EQ(run.exit_code, 0) << run.out << run.errors;
    const Json report = Report();
    EXPECT_EQ(report["prepare"]["muscles"][0]["lines"], count);
    EXPECT_EQ(report["frames"][0]["muscles"][0]["folded_triangles"], 0);
    EXPECT_GT(report["frames"][0]["muscles"][0]["max_displacement_mm"], 10);
  }
  EXPECT_EQ(Run("--auto_lines=0").exit_code, 2);
}

// All files but report.json, whose times differ, by name below `dir`.
std::map<std::string, std::string> Contents(const std::string& dir) {
  std::map<std::string, std::string> contents;
  for (const auto& entry : fs::recursive_directory_iterator(dir)) {
    if (!entry.is_regular_file()) continue;
    const std::string name = fs::relative(entry.path(), dir).string();
    if (name != "report.json") contents[name] = FileText(entry.path().string());
  }
  return contents;
}

// The report without what depends on the machine's mood and the command line.
Json WithoutTimes(Json report) {
  if (report.is_object()) {
    report.erase("command");
    report.erase("options");
  }
  if (report.is_structured()) {
    for (auto item = report.begin(); item != report.end();) {
      const bool is_time =
          report.is_object() && (item.key().find("_ms") != std::string::npos);
      if (is_time) {
        item = report.erase(item);
      } else {
        if (item->is_structured()) *item = WithoutTimes(*item);
        ++item;
      }
    }
  }
  return report;
}

TEST_F(MotionProgram, AKilledRunGoesOnToTheSameBytes) {
  const std::string flags = "--contact=paper --format=ply,obj --fibres=3";
  ASSERT_EQ(Run(flags).exit_code, 0);
  const auto whole = Contents(out());
  const Json report = WithoutTimes(Report());
  const std::string broken = dir_ + "/broken";
  const std::string arguments = CommandLine(flags + " --resume", broken);
  // Killed where it is, a little later every time, until it comes to its end.
  int kills = 0;
  for (double seconds = 0.1; kills < 100; seconds += 0.15) {
    const ProgramRun run = RunCommandLine(
        "timeout -s KILL " + std::to_string(seconds) + " " + MUSCLEWARP_DEFORM,
        arguments);
    if (run.exit_code == 0) break;
    ++kills;
    if (!fs::exists(broken)) continue;
    // What is there is complete.
    for (const auto& [name, bytes] : Contents(broken)) {
      if (name[0] == '.') continue;
      ASSERT_EQ(whole.count(name), 1u) << name;
      EXPECT_EQ(bytes, whole.at(name)) << name;
    }
  }
  EXPECT_GE(kills, 1);
  EXPECT_EQ(Contents(broken), whole);
  EXPECT_EQ(WithoutTimes(Json::parse(FileText(broken + "/report.json"))),
            report);
}

TEST_F(MotionProgram, AFinishedRunHasNothingToGoOnWith) {
  ASSERT_EQ(Run().exit_code, 0);
  const auto whole = Contents(out());
  ProgramRun run = Run("--resume");
  EXPECT_EQ(run.exit_code, 0) << run.errors;
  EXPECT_THAT(run.out, HasSubstr("finished already"));
  // With other options it is another run.
  run = Run("--resume --frames=0:2");
  EXPECT_EQ(run.exit_code, 0) << run.errors;
  EXPECT_EQ(run.out.find("finished already"), std::string::npos);
  EXPECT_EQ(Report()["frames"].size(), 3u);
}

TEST_F(MotionProgram, ResumeIsForTheSameInput) {
  fs::create_directories(out() + "/.resume");
  WriteTextAtomically(out() + "/.resume/inputs", "0123456789abcdef");
  const ProgramRun run = Run("--resume");
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_THAT(run.errors, AllOf(HasSubstr("--resume"), HasSubstr("other")));
  EXPECT_FALSE(fs::exists(out() + "/report.json"));
  EXPECT_EQ(Run().exit_code, 0);  // starts anew
  EXPECT_FALSE(fs::exists(out() + "/.resume"));
}

TEST_F(MotionProgram, RefusesMotionsThatDoNotFit) {
  ExpectRefusedWith(
      &motion_, "time\tknee", "time\thip", {"bend.mot", "\"hip\"", "knee"});
  ExpectRefusedWith(&motion_, "inDegrees=yes\n", "", {"bend.mot", "inDegrees"});
  ExpectRefusedWith(&motion_, "\t-15", "\tNaN", {"bend.mot", "line 11"});
  ExpectRefusedWith(&motion_, "\t-15", "\tabc", {"bend.mot", "line 11"});
  ExpectRefusedWith(&motion_, "\t-15", "", {"bend.mot", "line 11", "1 values"});
  ExpectRefusedWith(&motion_, "endheader", "", {"bend.mot", "endheader"});
}

TEST_F(MotionProgram, RefusesModelsThatDoNotFit) {
  const std::string good = model_;
  model_ = good.substr(0, good.size() / 2);
  ExpectRefused({"leg.osim", "line", "well-formed"});
  model_ = good;
  ExpectRefusedWith(&model_,
                    "<socket_parent_frame>/ground",
                    "<socket_parent_frame>/bodyset/shank",
                    {"leg.osim", "its own parent"});
  model_ = Model4(Joint4("EllipsoidJoint", "knee"));
  scene_["muscles"][0].erase("lines");
  ExpectRefused({"leg.osim", "EllipsoidJoint", "\"shank\""});
  model_ = good;
  scene_["muscles"][0]["lines"] = {"glut_med1_r"};
  ExpectRefused({"scene.json", "lines[0]", "glut_med1_r", "leg.osim"});
  scene_["muscles"][0]["lines"] = {"path"};
  scene_["bones"][0].erase("mesh");
  ExpectRefused({"\"thigh\"", "no mesh"});
  model_.replace(model_.find("<Body name=\"thigh\"/>"),
                 20,
                 "<Body name=\"thigh\"><attached_geometry><Mesh><mesh_file>"
                 "femur.vtp</mesh_file></Mesh></attached_geometry></Body>");
  ExpectRefused({"leg.osim", "femur.vtp", "not there"});
}

#ifdef MUSCLEWARP_WITH_VTK
vtkSmartPointer<vtkPolyData> ReadVtp(const std::string& path) {
  vtkNew<vtkXMLPolyDataReader> reader;
  reader->SetFileName(path.c_str());
  reader->Update();
  EXPECT_EQ(reader->GetErrorCode(), 0u) << path;
  return reader->GetOutput();
}

TEST_F(MotionProgram, VtkPlaysTheMotion) {
  const ProgramRun run = Run("--format=vtp --fibres=12");
  ASSERT_EQ(run.exit_code, 0) << run.out << run.errors;
  const auto root = vtkSmartPointer<vtkXMLDataElement>::Take(
      vtkXMLUtilities::ReadElementFromFile((out() + "/motion.pvd").c_str()));
  ASSERT_TRUE(root);
  vtkXMLDataElement* const sets = root->FindNestedElementWithName("Collection");
  ASSERT_TRUE(sets);
  std::map<double, std::set<std::string>> names_at;
  for (int i = 0; i < sets->GetNumberOfNestedElements(); ++i) {
    vtkXMLDataElement* const set = sets->GetNestedElement(i);
    double time = -1;
    ASSERT_TRUE(set->GetScalarAttribute("timestep", time));
    names_at[time].insert(set->GetAttribute("name"));
    const auto data = ReadVtp(out() + "/" + set->GetAttribute("file"));
    EXPECT_GT(data->GetNumberOfPoints(), 0);
  }
  ASSERT_EQ(names_at.size(), 7u);
  int row = 0;
  for (const auto& [time, names] : names_at) {
    EXPECT_DOUBLE_EQ(time, 0.1 * row++);
    EXPECT_EQ(
        names,
        (std::set<std::string>{
            "muscle", "thigh", "shank", "lines/muscle", "fibres/muscle"}));
  }
  const auto muscle = ReadVtp(out() + "/frame_0006/muscle.vtp");
  for (const char* field : {"displacement", "area_stretch", "gap", "contact"}) {
    EXPECT_TRUE(muscle->GetPointData()->HasArray(field)) << field;
  }
  const Json frame = Report()["frames"][6];
  double range[2];
  muscle->GetPointData()->GetArray("displacement")->GetRange(range, -1);
  EXPECT_NEAR(range[1], frame["muscles"][0]["max_displacement_mm"], 1e-9);
  muscle->GetPointData()->GetArray("gap")->GetRange(range);
  EXPECT_NEAR(range[0], frame["muscles"][0]["min_gap_mm"], 1e-12);
  const auto fibres = ReadVtp(out() + "/frame_0006/fibres/muscle.vtp");
  EXPECT_EQ(fibres->GetNumberOfLines(), 12);
  EXPECT_EQ(fibres->GetNumberOfPoints(), 12 * 16);
  fibres->GetCellData()->GetArray("length_mm")->GetRange(range);
  EXPECT_NEAR(range[1],
              *std::max_element(frame["muscles"][0]["fibre_lengths_mm"].begin(),
                                frame["muscles"][0]["fibre_lengths_mm"].end()),
              1e-9);
  EXPECT_EQ(Table("fibre_lengths").labels.size(), 12u);
  EXPECT_THAT(Table("fibre_moment_arms").labels,
              Contains("muscle_fibre_12.knee"));
}
#endif

// The embedded model says the same as the embedded poses.
TEST(MotionEmbeddedScene, EndsWhereThePoseOfTheSceneFileIs) {
  const std::string dir = TestTempDir();
  const std::string data = std::string(MUSCLEWARP_DATA_DIR) + "/phantom";
  ASSERT_EQ(RunCommandLine(MUSCLEWARP_DEFORM,
                           "--scene=" + data +
                               "/motion.json --frames=last "
                               "--contact=none --out=" +
                               dir + "/motion")
                .exit_code,
            0);
  ASSERT_EQ(RunCommandLine(MUSCLEWARP_DEFORM,
                           "--scene=" + data +
                               "/scene.json --frames=2 --contact=none --out=" +
                               dir + "/poses")
                .exit_code,
            0);
  for (const char* name : {"psoas_major_r", "gluteus_medius_r", "femur_r"}) {
    const std::string file = std::string(name) + ".ply";
    const Points by_motion =
        ReadTriangleSoup(dir + "/motion/frame_0014/" + file).points;
    const Points by_pose =
        ReadTriangleSoup(dir + "/poses/frame_0002/" + file).points;
    // The step threshold of the solver; the files have 12 digits.
    EXPECT_LT((by_motion - by_pose).rowwise().norm().maxCoeff(), 1e-3) << name;
  }
}

}  // namespace
}  // namespace musclewarp
