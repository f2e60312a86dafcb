// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "tools/motion_program.h"

#include <gmock/gmock.h>

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

#include "musclewarp/base/angles.h"
#include "musclewarp/mesh_files/mesh_io.h"
#include "support/osim_models.h"
#include "support/temp_dir.h"

namespace musclewarp {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;
using ::testing::AllOf;
using ::testing::Contains;
using ::testing::HasSubstr;

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
  const double half_angle = std::atan2(20, 25) + RadiansOf(15);
  const double between = 2 * std::hypot(25, 20) * std::sin(half_angle);
  EXPECT_NEAR(lengths.values(0, 1), 0.110, 1e-12);
  EXPECT_NEAR(lengths.values(6, 1), 1e-3 * (70 + between), 1e-9);
  const StorageTable arms = Table("moment_arms");
  EXPECT_THAT(arms.labels, testing::ElementsAre("path.knee", "path_path.knee"));
  const double arm = std::hypot(25, 20) * std::cos(half_angle);
  EXPECT_NEAR(arms.values(6, 1), 1e-3 * arm, 1e-8);
  EXPECT_EQ(Table("volumes").values.rows(), 7);
}

TEST_F(MotionProgram, TheMotionMayBeInTheSceneFile) {
  ASSERT_EQ(Run().exit_code, 0);
  const Json of_file = Report();
  const std::string last = out() + "/frame_0006/muscle.ply";
  const std::string mesh = FileText(last);
  scene_["motion"] = {{"frames", 7}, {"coordinates", {{"knee", {0, -30}}}}};
  const ProgramRun run = Run("--overwrite --html");
  ASSERT_EQ(run.exit_code, 0) << run.out << run.errors;
  EXPECT_EQ(FileText(last), mesh);
  const Json report = Report();
  EXPECT_EQ(report["motion"]["coordinates"], of_file["motion"]["coordinates"]);
  EXPECT_EQ(report["motion"]["file"], "../scene.json");
  EXPECT_EQ(report["frames"][3]["time"], 0.5);
  EXPECT_EQ(report["frames"][3]["coordinates"]["knee"],
            of_file["frames"][3]["coordinates"]["knee"]);
  // It counts as an input: another motion is another run.
  scene_["motion"]["coordinates"]["knee"] = {0, -29};
  EXPECT_EQ(Run("--resume").exit_code, 2);
  // A file that the run names replaces it.
  ASSERT_EQ(Run("--overwrite --motion=bend.mot").exit_code, 0);
  EXPECT_EQ(FileText(last), mesh);
  scene_["motion"]["frames"] = 1;
  EXPECT_EQ(Run("--overwrite").exit_code, 2);
}

TEST_F(MotionProgram, ARunNamesNoFoldersOfTheMachine) {
  const std::string below = dir_.substr(1);
  // Paths on the command line may lead from the working folder.
  const std::string here = fs::relative(dir_).string();
  const std::string arguments = Arguments("--html", here + "/out") +
                                " --scene=" + here + "/scene.json" +
                                " --motion=" + dir_ + "/bend.mot";
  const ProgramRun run = RunCommandLine(MUSCLEWARP_DEFORM, arguments);
  ASSERT_EQ(run.exit_code, 0) << run.out << run.errors;
  for (const char* file : {"/report.json", "/report.html"}) {
    const std::string text = FileText(out() + file);
    EXPECT_EQ(text.find(below), std::string::npos) << file;
    EXPECT_EQ(text.find(here), std::string::npos) << file;
  }
  const Json report = Report();
  EXPECT_EQ(report["prepare"]["muscles"][0]["mesh"], "../muscle.ply");
  EXPECT_EQ(report["motion"]["model"], "../leg.osim");
  EXPECT_EQ(report["motion"]["kept_model"], "rest/model.osim");
  EXPECT_EQ(FileText(out() + "/rest/model.osim"), model_);
  EXPECT_EQ(report["options"]["out"], ".");
  // The command repeats the run, called in its folder wherever that is now.
  fs::create_directories(dir_ + "/moved");
  for (const auto& entry : fs::directory_iterator(dir_)) {
    if (entry.path().filename() == "moved") continue;
    fs::rename(entry.path(),
               dir_ + "/moved/" + entry.path().filename().string());
  }
  const std::string mesh = dir_ + "/moved/out/frame_0006/muscle.ply";
  const std::string before = FileText(mesh);
  const std::string command = report["command"];
  const ProgramRun again =
      RunCommandLine("cd " + dir_ + "/moved/out && " + MUSCLEWARP_DEFORM,
                     command.substr(command.find(' ')));
  EXPECT_EQ(again.exit_code, 0) << again.out << again.errors;
  EXPECT_EQ(FileText(mesh), before);
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

// A knee with three coordinates of which two move and one is locked: moment
// arms are there for both, and are the slopes of the lengths.
TEST_F(MotionProgram, MomentArmsAreExactForEveryFreeCoordinate) {
  const auto replace = [this](const std::string& from, const std::string& to) {
    ASSERT_NE(model_.find(from), std::string::npos) << from;
    model_.replace(model_.find(from), from.size(), to);
  };
  replace("<PinJoint name=\"knee_joint\">",
          "<GimbalJoint name=\"knee_joint\">");
  replace("</PinJoint>", "</GimbalJoint>");
  replace("<Coordinate name=\"knee\"/>",
          "<Coordinate name=\"lean\"/><Coordinate name=\"twist\">"
          "<locked>true</locked></Coordinate><Coordinate name=\"knee\"/>");
  motion_ =
      "bend\ninDegrees=yes\nendheader\ntime\tknee\tlean\n"
      "0\t-12\t5\n1\t-11\t5\n2\t-10\t5\n3\t-9\t5\n4\t-8\t5\n5\t-8\t6\n";
  for (const std::string flags : {"", "--solver=reference"}) {
    const ProgramRun run = Run("--fibres=2 " + flags);
    ASSERT_EQ(run.exit_code, 0) << run.out << run.errors;
    const StorageTable arms = Table("moment_arms");
    EXPECT_THAT(
        arms.labels,
        testing::ElementsAre(
            "path.lean", "path.knee", "path_path.lean", "path_path.knee"));
    const StorageTable fibre_arms = Table("fibre_moment_arms");
    EXPECT_THAT(fibre_arms.labels,
                testing::ElementsAre("muscle_fibre_1.lean",
                                     "muscle_fibre_1.knee",
                                     "muscle_fibre_2.lean",
                                     "muscle_fibre_2.knee"));
    // By a polynomial through five frames, which is exact to 1e-10 m. Solvers
    // end within 1e-8 m of the minimum.
    const auto slope = [](const Eigen::VectorXd& l) {
      return (8 * (l[3] - l[1]) - (l[4] - l[0])) / RadiansOf(12);
    };
    const StorageTable lengths = Table("lengths");
    EXPECT_NEAR(arms.values(2, 1), -slope(lengths.values.col(0)), 1e-6);
    EXPECT_NEAR(arms.values(2, 3), -slope(lengths.values.col(1)), 1e-6);
    const StorageTable fibres = Table("fibre_lengths");
    for (int k = 0; k < 2; ++k) {
      EXPECT_NEAR(
          fibre_arms.values(2, 2 * k + 1), -slope(fibres.values.col(k)), 1e-6);
    }
    const Json frame = Report()["frames"][2];
    EXPECT_EQ(frame["moment_arms_converged"], true);
    EXPECT_GT(frame["moment_arms_ms"], 0);
    EXPECT_NEAR(frame["muscles"][0]["line_moment_arms_mm"]["path"]["lean"],
                1e3 * arms.values(2, 0),
                1e-9);
  }
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

TEST_F(MotionProgram, RefusesMotionsThatDoNotFit) {
  ExpectRefusedWith(
      &motion_, "time\tknee", "time\thip", {"bend.mot", "no column", "knee"});
  ExpectRefusedWith(&motion_,
                    "time\tknee",
                    "time\tkne",
                    {"bend.mot", "\"kne\"", "nearly named as \"knee\""});
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
  ExpectRefused({"leg.osim", "femur.vtp", "none of the folders"});
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
