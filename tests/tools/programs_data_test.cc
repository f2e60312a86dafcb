// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "tools/programs_data.h"

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <string>

#include "musclewarp/mesh_files/mesh_io.h"
#include "support/temp_dir.h"
#include "tools/run_program.h"

namespace musclewarp {
namespace {

using Json = nlohmann::json;

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
      EXPECT_NEAR(muscle["volume_error"], 0, 1e-6) << where;
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

}  // namespace
}  // namespace musclewarp
