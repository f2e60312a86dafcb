// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <nlohmann/json.hpp>
#include <string>

#include "musclewarp/mesh_files/mesh_io.h"
#include "musclewarp/opensim/storage_table.h"
#include "support/temp_dir.h"
#include "tools/run_program.h"

namespace musclewarp {
namespace {

using Json = nlohmann::json;

class ProgramsDataTest : public ::testing::Test {
 protected:
  void SetUp() override {
    const char* root = std::getenv("MUSCLEWARP_DATA_ROOT");
    if (!root) GTEST_SKIP() << "MUSCLEWARP_DATA_ROOT is not set";
    root_ = root;
  }

  // Runs a delivered scene and returns its report.
  Json Deform(const std::string& scene,
              const std::string& solver,
              const std::string& out,
              const std::string& flags = "") {
    const ProgramRun run =
        RunCommandLine(MUSCLEWARP_DEFORM,
                       "--scene=" MUSCLEWARP_DATA_DIR "/scenes/" + scene +
                           ".json --data_root=" + root_ +
                           " --contact=none --solver=" + solver +
                           " --out=" + out + " " + flags);
    EXPECT_EQ(run.exit_code, 0) << run.out << run.errors;
    return Json::parse(FileText(out + "/report.json"));
  }

  std::string root_;
};

void ExpectKept(const Json& report) {
  std::map<std::string, int> vertices;
  for (const Json& muscle : report["prepare"]["muscles"]) {
    EXPECT_TRUE(muscle["hull_encloses"]) << muscle["name"];
    EXPECT_NEAR(muscle["coarse_vertices"], 200, 40) << muscle["name"];
    vertices[muscle["name"]] = muscle["fine_vertices"];
  }
  for (const Json& frame : report["frames"]) {
    for (const Json& muscle : frame["muscles"]) {
      const std::string where = frame["name"].get<std::string>() + " " +
                                muscle["name"].get<std::string>();
      EXPECT_NEAR(muscle["volume_ratio"], 1, 1e-6) << where;
      EXPECT_EQ(muscle["stop_reason"], "converged") << where;
      // Below 0.1 % of the triangles, of which there are two a vertex.
      EXPECT_LE(muscle["folded_triangles"],
                0.001 * 2 * vertices[muscle["name"]])
          << where;
    }
  }
}

// The largest distance of a vertex between two runs of one scene, mm.
double Distance(const Json& report,
                const std::string& a,
                const std::string& b) {
  double largest = 0;
  for (const Json& frame : report["frames"]) {
    for (const Json& muscle : frame["muscles"]) {
      char folder[32];
      std::snprintf(
          folder, sizeof(folder), "/frame_%04d/", frame["index"].get<int>());
      const std::string file =
          folder + muscle["name"].get<std::string>() + ".ply";
      largest = std::max(largest,
                         (ReadTriangleSoup(a + file).points -
                          ReadTriangleSoup(b + file).points)
                             .rowwise()
                             .norm()
                             .maxCoeff());
    }
  }
  return largest;
}

}  // namespace

TEST_F(ProgramsDataTest, LhdlHipKeepsVolumeAndBothSolversAgree) {
  const std::string dir = TestTempDir();
  const Json ceres = Deform("lhdl_hip", "ceres", dir + "/ceres");
  const Json reference = Deform("lhdl_hip", "reference", dir + "/reference");
  ExpectKept(ceres);
  ExpectKept(reference);
  ASSERT_EQ(ceres["frames"].size(), 5u);
  for (const Json& report : {ceres, reference}) {
    EXPECT_EQ(report["frames"][0]["name"], "rest");
    for (const Json& muscle : report["frames"][0]["muscles"]) {
      EXPECT_LT(muscle["max_displacement_mm"], 1e-6) << muscle["name"];
    }
  }
  EXPECT_LT(Distance(ceres, dir + "/ceres", dir + "/reference"), 1e-3);
}

TEST_F(ProgramsDataTest, PaperCaseKeepsVolumeAndBothSolversAgree) {
  const std::string dir = TestTempDir();
  const Json ceres = Deform("bodyparts3d_gluteals", "ceres", dir + "/ceres");
  const Json reference =
      Deform("bodyparts3d_gluteals", "reference", dir + "/reference");
  ExpectKept(ceres);
  ExpectKept(reference);
  EXPECT_LT(Distance(ceres, dir + "/ceres", dir + "/reference"), 1e-3);
}

// Paper mode: nearly nothing inside, volume kept, both solvers alike.
void ExpectApart(const Json& none, const Json& paper) {
  ASSERT_EQ(none["frames"].size(), paper["frames"].size());
  for (size_t i = 0; i < paper["frames"].size(); ++i) {
    const Json& frame = paper["frames"][i];
    EXPECT_EQ(frame["stop_reason"], "converged") << frame["name"];
    const int before = none["frames"][i]["intersections"]["vertices_inside"];
    // The aim is a tenth; what is reached is nearly nothing.
    EXPECT_LE(frame["intersections"]["vertices_inside"].get<int>(),
              before / 100)
        << frame["name"];
    for (const Json& muscle : frame["muscles"]) {
      EXPECT_NEAR(muscle["volume_ratio"], 1, 1e-6) << frame["name"];
    }
  }
}

TEST_F(ProgramsDataTest, PaperContactPartsThePapersCaseInBothSolvers) {
  const std::string dir = TestTempDir();
  const std::string scene = "bodyparts3d_gluteals";
  const Json none = Deform(scene, "reference", dir + "/none");
  for (const char* solver : {"reference", "ceres"}) {
    ExpectApart(none,
                Deform(scene, solver, dir + "/" + solver, "--contact=paper"));
  }
}

TEST_F(ProgramsDataTest, PaperContactPartsTheHamstrings) {
  const std::string dir = TestTempDir();
  const std::string scene = "bodyparts3d_hamstrings";
  ExpectApart(Deform(scene, "ceres", dir + "/none"),
              Deform(scene, "ceres", dir + "/paper", "--contact=paper"));
}

TEST_F(ProgramsDataTest, PaperContactPartsTheLhdlHip) {
  const std::string dir = TestTempDir();
  for (const char* level : {"coarse", "fine"}) {
    ExpectApart(Deform("lhdl_hip", "ceres", dir + "/none", "--frames=last"),
                Deform("lhdl_hip",
                       "ceres",
                       dir + "/paper",
                       std::string("--frames=last --contact=paper "
                                   "--contact_level=") +
                           level));
  }
}

TEST_F(ProgramsDataTest, PaperContactDoesNotDependOnThreads) {
  const std::string dir = TestTempDir();
  for (const char* level : {"coarse", "fine"}) {
    for (const char* threads : {"1", "3"}) {
      Deform("bodyparts3d_gluteals",
             "ceres",
             dir + "/" + threads,
             std::string("--frames=last --contact=paper --contact_level=") +
                 level + " --threads=" + threads);
    }
    for (const char* muscle : {"gluteus_medius", "gluteus_minimus"}) {
      const std::string file = std::string("/frame_0004/") + muscle + ".ply";
      EXPECT_EQ(FileText(dir + "/1" + file), FileText(dir + "/3" + file));
    }
  }
}

// Every frame holds what certified contact promises, and musclewarp-check finds
// nothing that crosses in the files of one of them.
void ExpectCertified(const Json& report, const std::string& out) {
  EXPECT_EQ(report["rest"]["after_initial_fix"]["triangle_pairs"], 0);
  EXPECT_GT(report["rest"]["intersections"]["triangle_pairs"], 1000);
  EXPECT_EQ(report["summary"]["frames_clean"], report["summary"]["frames"]);
  for (const Json& frame : report["frames"]) {
    EXPECT_TRUE(frame["usable"]) << frame["name"] << frame["shortcomings"];
    EXPECT_EQ(frame["intersections"]["triangle_pairs"], 0) << frame["name"];
    EXPECT_EQ(frame["intersections"]["vertices_inside"], 0) << frame["name"];
    for (const Json& muscle : frame["muscles"]) {
      EXPECT_NEAR(muscle["volume_ratio"], 1, 4e-4) << muscle["name"];
      EXPECT_LE(muscle["max_contact_displacement_mm"],
                2 * muscle["depth_without_contact_mm"].get<double>() + 1)
          << frame["name"] << muscle["name"];
    }
  }
  std::string files;
  for (const char* kind : {"muscles", "bones"}) {
    for (const Json& mesh : report["prepare"][kind]) {
      files += out + "/frame_0002/" + mesh["name"].get<std::string>() + ".ply ";
    }
  }
  const std::string check_file = out + "/check.json";
  RunCommandLine(MUSCLEWARP_CHECK, "--json=" + check_file + " " + files);
  const Json check = Json::parse(FileText(check_file));
  const size_t muscles = report["prepare"]["muscles"].size();
  std::vector<std::string> bones;
  for (const Json& bone : report["prepare"]["bones"]) {
    bones.push_back(bone["name"]);
  }
  EXPECT_EQ(check["files"].size(), muscles + bones.size());
  int of_muscles = 0;
  for (const Json& pair : check["pairs"]) {
    const auto is_bone = [&](const char* key) {
      const std::string file = pair[key];
      return std::any_of(
          bones.begin(), bones.end(), [&](const std::string& name) {
            return file.find(name + ".ply") != std::string::npos;
          });
    };
    if (is_bone("a") && is_bone("b")) continue;
    ++of_muscles;
    EXPECT_EQ(pair["triangle_pairs"], 0) << pair;
  }
  EXPECT_GT(of_muscles, 0);
}

TEST_F(ProgramsDataTest, CertifiedContactHoldsForTheBodyParts3dHip) {
  const std::string out = TestTempDir() + "/run";
  ExpectCertified(
      Deform("bodyparts3d_hip", "ceres", out, "--contact=certified"), out);
}

TEST_F(ProgramsDataTest, CertifiedContactHoldsForTheHamstrings) {
  const std::string out = TestTempDir() + "/run";
  ExpectCertified(Deform("bodyparts3d_hamstrings_leg",
                         "ceres",
                         out,
                         "--contact=certified --frames=0:2"),
                  out);
}

TEST_F(ProgramsDataTest, CertifiedContactHoldsForTheOriginalHamstrings) {
  const std::string out = TestTempDir() + "/run";
  ExpectCertified(Deform("bodyparts3d_hamstrings_leg_original",
                         "ceres",
                         out,
                         "--contact=certified --frames=0:2"),
                  out);
}

// Lines and attachments in use.
TEST_F(ProgramsDataTest, CertifiedContactHoldsForLhdlFlexion) {
  const std::string out = TestTempDir() + "/run";
  ExpectCertified(Deform("lhdl_hip_attached",
                         "ceres",
                         out,
                         "--contact=certified --attachment_weight=1"),
                  out);
}

// The repaired originals, with their slivers.
TEST_F(ProgramsDataTest, CertifiedContactHoldsForTheOriginalHip) {
  const std::string out = TestTempDir() + "/run";
  ExpectCertified(Deform("bodyparts3d_hip_original",
                         "ceres",
                         out,
                         "--contact=certified --frames=0:3"),
                  out);
}

TEST_F(ProgramsDataTest, CheckCountsWhatTheDataSetSays) {
  const std::string dir = TestTempDir();
  std::string files;
  for (const char* name : {"gluteus_maximus_r",
                           "gluteus_medius_r",
                           "iliacus_r",
                           "psoas_major_r",
                           "hip_bone_r",
                           "sacrum",
                           "femur_r"}) {
    files += root_ + "/lhdl_hip/" + name + ".ply ";
  }
  ASSERT_EQ(
      RunCommandLine(MUSCLEWARP_CHECK, files + "--json=" + dir + "/c.json")
          .exit_code,
      0);
  const Json json = Json::parse(FileText(dir + "/c.json"));
  std::map<std::string, int> counts;
  double deepest = 0;
  for (const Json& pair : json["pairs"]) {
    const auto stem = [](const std::string& path) {
      const size_t begin = path.rfind('/') + 1;
      return path.substr(begin, path.rfind('.') - begin);
    };
    const int count = pair["triangle_pairs"];
    if (count) counts[stem(pair["a"]) + " " + stem(pair["b"])] = count;
    deepest = std::max<double>(deepest, pair["max_depth_mm"]);
  }
  // lhdl_hip/README.md, "Rest-pose intersections"; it leaves bone x bone out.
  EXPECT_EQ(counts.erase("hip_bone_r sacrum"), 1u);
  const std::map<std::string, int> expected = {
      {"gluteus_maximus_r gluteus_medius_r", 297},
      {"gluteus_maximus_r hip_bone_r", 544},
      {"gluteus_maximus_r femur_r", 98},
      {"gluteus_maximus_r sacrum", 54},
      {"gluteus_medius_r hip_bone_r", 648},
      {"iliacus_r psoas_major_r", 220},
      {"iliacus_r hip_bone_r", 1038},
      {"psoas_major_r hip_bone_r", 360}};
  EXPECT_EQ(counts, expected);
  EXPECT_NEAR(deepest, 9.1, 0.05);
}

// Largest change of a column from row to row over the median one.
double JumpRatio(const Eigen::VectorXd& column) {
  std::vector<double> changes;
  for (Eigen::Index i = 0; i + 1 < column.size(); ++i) {
    changes.push_back(std::abs(column[i + 1] - column[i]));
  }
  std::sort(changes.begin(), changes.end());
  return changes.back() / changes[changes.size() / 2];
}

// psoas_upper runs on the pelvis alone: nothing pulls at it.
bool IsPulled(const std::string& label) {
  return label.find("psoas_upper") == std::string::npos;
}

class MotionsDataTest : public ProgramsDataTest,
                        public ::testing::WithParamInterface<const char*> {};

TEST_P(MotionsDataTest, EveryFrameKeepsItsVolumeAndNoLineJumps) {
  const std::string out = TestTempDir();
  const std::string motion = GetParam();
  const Json report = Deform("lhdl_hip_motion",
                             "ceres",
                             out,
                             "--motion=lhdl_hip/motions/" + motion + ".mot");
  for (const Json& frame : report["frames"]) {
    for (const Json& muscle : frame["muscles"]) {
      EXPECT_NEAR(muscle["volume_ratio"], 1, 1e-4) << frame["name"];
      EXPECT_EQ(muscle["folded_triangles"], 0) << frame["name"];
    }
  }
  const StorageTable lengths = ReadStorageTable(out + "/lengths.sto");
  EXPECT_EQ(lengths.times.size(), report["frames"].size());
  EXPECT_EQ(lengths.labels.size(), 18u);
  for (size_t i = 0; i < lengths.labels.size(); ++i) {
    if (!IsPulled(lengths.labels[i])) continue;
    EXPECT_LT(JumpRatio(lengths.values.col(i)), 3) << lengths.labels[i];
  }
}

INSTANTIATE_TEST_SUITE_P(Lhdl,
                         MotionsDataTest,
                         ::testing::Values("hip_flexion",
                                           "hip_adduction",
                                           "hip_rotation"));

TEST_F(ProgramsDataTest, LhdlFlexionRunsToTheEndInContact) {
  const Json report =
      Deform("lhdl_hip_motion", "ceres", TestTempDir(), "--contact=paper");
  EXPECT_EQ(report["frames"].size(), 36u);
  for (const Json& frame : report["frames"]) {
    EXPECT_TRUE(frame["usable"]) << frame["name"];
    for (const Json& muscle : frame["muscles"]) {
      EXPECT_NEAR(muscle["volume_ratio"], 1, 1e-4) << frame["name"];
    }
    // Of 19 427 vertices; 1 was seen.
    EXPECT_LE(frame["intersections"]["vertices_inside"], 5) << frame["name"];
  }
}

// Straight paths over hip flexion -10 to 60 degrees.
TEST_F(ProgramsDataTest, LhdlMomentArmsAreThoseOfTheirMuscles) {
  const std::string out = TestTempDir();
  Deform("lhdl_hip_motion", "ceres", out);
  const StorageTable lengths = ReadStorageTable(out + "/lengths.sto");
  const StorageTable arms = ReadStorageTable(out + "/moment_arms.sto");
  const auto column = [](const StorageTable& table, const std::string& label) {
    const auto found =
        std::find(table.labels.begin(), table.labels.end(), label);
    EXPECT_NE(found, table.labels.end()) << label;
    return Eigen::VectorXd(table.values.col(found - table.labels.begin()));
  };
  constexpr double kDegree = M_PI / 180;
  for (const char* line : {"glut_max1_r",
                           "glut_max2_r",
                           "glut_max3_r",
                           "glut_med1_r",
                           "glut_med2_r",
                           "glut_med3_r",
                           "psoas_r",
                           "iliacus_r"}) {
    const std::string path = std::string(line) + "_path";
    const Eigen::VectorXd length = column(lengths, path);
    const Eigen::VectorXd arm = column(arms, path + ".hip_flexion_r");
    for (Eigen::Index i = 0; i + 1 < length.size(); ++i) {
      // Rows are 2 degrees apart. Where a point of psoas (40 degrees) or
      // iliacus (54) is switched off the length has a step.
      const bool is_switched =
          (i == 25 && path[0] == 'p') || (i == 32 && path[0] == 'i');
      if (is_switched) continue;
      const double slope = (length[i + 1] - length[i]) / 2;
      const double expected = -(arm[i] + arm[i + 1]) / 2 * kDegree;
      EXPECT_NEAR(slope, expected, 0.1e-3) << line << " row " << i;
    }
  }
  // Psoas and iliacus flex, with 20 to 35 mm over most of the range; gluteus
  // maximus extends.
  EXPECT_GT(column(arms, "psoas_r_path.hip_flexion_r").minCoeff(), 0.018);
  EXPECT_LT(column(arms, "psoas_r_path.hip_flexion_r").maxCoeff(), 0.035);
  EXPECT_GT(column(arms, "iliacus_r_path.hip_flexion_r").minCoeff(), 0.020);
  EXPECT_LT(column(arms, "iliacus_r_path.hip_flexion_r").maxCoeff(), 0.035);
  for (const char* line : {"glut_max1_r", "glut_max2_r", "glut_max3_r"}) {
    EXPECT_LT(
        column(arms, std::string(line) + "_path.hip_flexion_r").maxCoeff(),
        -0.025);
  }
}

}  // namespace musclewarp
