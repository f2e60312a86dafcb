// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "tools/posture_command.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <sstream>

#include "musclewarp/mesh_files/mesh_io.h"
#include "support/input_errors.h"
#include "support/meshes.h"
#include "support/temp_dir.h"
#include "tools/run_program.h"

namespace musclewarp {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;
using ::testing::HasSubstr;

// A run of two frames with one muscle, whose second frame is 2 mm larger, and
// that frame as a mesh of its own.
class Posture : public ::testing::Test {
 protected:
  void SetUp() override {
    for (int frame = 0; frame < 2; ++frame) {
      const std::string folder =
          PathOf("run/frame_000" + std::to_string(frame));
      fs::create_directories(folder);
      WriteTriangleSoup(folder + "/psoas.ply", Icosphere(10 + 2 * frame, 3));
    }
    WriteTriangleSoup(PathOf("segmented.ply"), Icosphere(12, 3));
    options_.posture = PathOf("segmented.ply");
    options_.in = PathOf("run");
    options_.muscle = "psoas";
  }

  std::string Run() {
    std::ostringstream screen;
    EXPECT_EQ(PostureCommand(options_, screen), 0);
    return screen.str();
  }

  std::string PathOf(const std::string& name) const {
    return dir_ + "/" + name;
  }

  const std::string dir_ = TestTempDir();
  PostureOptions options_;
};

TEST_F(Posture, ComparesAMuscleOfAFrame) {
  options_.out = PathOf("out");
  EXPECT_THAT(Run(), HasSubstr("Dice 1.000, Jaccard 1.000"));
  Json found = Json::parse(FileText(PathOf("out/posture.json")));
  EXPECT_LT(found.at("symmetric").at("hausdorff_mm").get<double>(), 1e-12);
  EXPECT_EQ(found.at("volume_ratio"), 1);
  options_.frame = "0";
  Run();
  found = Json::parse(FileText(PathOf("out/posture.json")));
  // Edges of 1.5 mm on a radius of 10 cut off 0.03 mm.
  EXPECT_NEAR(found.at("muscle_to_posture").at("signed_mean_mm").get<double>(),
              -2,
              0.05);
  EXPECT_NEAR(
      found.at("posture_to_muscle").at("hausdorff_mm").get<double>(), 2, 0.05);
}

TEST_F(Posture, ComparesAnyMesh) {
  options_.mesh = options_.posture;
  options_.in.clear();
  options_.muscle.clear();
  EXPECT_THAT(Run(), HasSubstr("ratio 1.000"));
}

TEST_F(Posture, WarnsOfOtherUnits) {
  TriangleSoup metres = Icosphere(0.012, 3);
  WriteTriangleSoup(options_.posture, metres);
  EXPECT_THAT(Run(), HasSubstr("are both files in millimetres?"));
}

TEST_F(Posture, NamesWhatIsWrong) {
  const auto run = [&] { Run(); };
  options_.muscle = "iliacus";
  ExpectInputError(run, {"--muscle=iliacus", "its meshes: psoas"});
  options_.muscle.clear();
  ExpectInputError(run, {"--muscle", "is missing"});
  options_.muscle = "psoas";
  options_.mesh = options_.posture;
  ExpectInputError(run, {"--mesh=", "cannot be used with --in"});
  options_.mesh.clear();
  options_.posture_spacing = -1;
  ExpectInputError(run, {"--posture_spacing", "0 or above"});
  options_.posture_spacing = 0;
  options_.frame = "7";
  ExpectInputError(run, {"7"});
  options_.frame = "0";
  options_.posture_spacing = 1e-4;
  ExpectInputError(run, {"--posture_spacing", "20 million"});
  options_.posture_spacing = 0;
  options_.out = options_.posture + "/out";
  ExpectInputError(run, {"--out=", "is not a folder that can be written"});
  options_.out.clear();
  options_.frame = "0,1";
  ExpectInputError(run, {"--frame=0,1", "allowed: one"});
}

TEST_F(Posture, RefusesAnOpenMesh) {
  TriangleSoup open = Icosphere(100, 2);
  open.triangles.conservativeResize(open.triangles.rows() / 2, 3);
  WriteTriangleSoup(options_.posture, open);
  ExpectInputError([&] { Run(); }, {"segmented.ply"});
  options_.repair.holes.max_perimeter = -1;
  ExpectInputError([&] { Run(); }, {"HoleLimits::max_perimeter is -1"});
  options_.repair.holes.max_perimeter = 2000;
  EXPECT_NO_THROW(Run());
}

}  // namespace
}  // namespace musclewarp
