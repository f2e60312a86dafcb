// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "tools/motion_program.h"

#include <gmock/gmock.h>

#include <filesystem>

#include "musclewarp/base/output_file.h"
#include "musclewarp/mesh_files/mesh_io.h"
#include "support/meshes.h"
#include "support/osim_models.h"
#include "support/temp_dir.h"

namespace musclewarp {

namespace fs = std::filesystem;
using Json = nlohmann::json;
using ::testing::HasSubstr;

MotionProgram::MotionProgram() : dir_(TestTempDir()) {
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

std::string MotionProgram::Arguments(const std::string& flags,
                                     const std::string& out) {
  WriteTextAtomically(dir_ + "/scene.json", scene_.dump());
  WriteTextAtomically(dir_ + "/leg.osim", model_);
  WriteTextAtomically(dir_ + "/bend.mot", motion_);
  // Flags that come later win.
  return "--contact=none --scene=" + dir_ + "/scene.json --out=" + out + " " +
         flags;
}

ProgramRun MotionProgram::Run(const std::string& flags) {
  return RunCommandLine(MUSCLEWARP_DEFORM, Arguments(flags, out()));
}

Json MotionProgram::Report() const {
  return Json::parse(FileText(out() + "/report.json"));
}

StorageTable MotionProgram::Table(const std::string& name) const {
  return ReadStorageTable(out() + "/" + name + ".sto");
}

void MotionProgram::ExpectRefused(const std::vector<std::string>& words) {
  const ProgramRun run = Run();
  EXPECT_EQ(run.exit_code, 2) << run.out << run.errors;
  for (const auto& word : words) EXPECT_THAT(run.errors, HasSubstr(word));
  EXPECT_FALSE(fs::exists(out()));
}

void MotionProgram::ExpectRefusedWith(std::string* text,
                                      const std::string& from,
                                      const std::string& to,
                                      const std::vector<std::string>& words) {
  const std::string good = *text;
  ASSERT_NE(text->find(from), std::string::npos) << from;
  text->replace(text->find(from), from.size(), to);
  ExpectRefused(words);
  *text = good;
}

}  // namespace musclewarp
