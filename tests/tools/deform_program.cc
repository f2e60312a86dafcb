// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "tools/deform_program.h"

#include <gmock/gmock.h>

#include <filesystem>

#include "musclewarp/base/output_file.h"
#include "musclewarp/mesh_files/mesh_io.h"
#include "support/meshes.h"
#include "support/temp_dir.h"

namespace musclewarp {

ProgramRun Deform(const std::string& arguments) {
  // Flags that come later win.
  return RunCommandLine(MUSCLEWARP_DEFORM, "--contact=none " + arguments);
}

DeformProgram::DeformProgram() : dir_(TestTempDir()) {
  TriangleSoup bone = Icosphere(10, 2);
  bone.points.rowwise() += Eigen::RowVector3d(22, 0, 30);
  WriteTriangleSoup(dir_ + "/muscle.ply", Spindle(12, 60, 3));
  WriteTriangleSoup(dir_ + "/bone.ply", bone);
  scene_ = nlohmann::json::parse(R"({"name": "spindle", "units": "mm",
      "muscles": [{"name": "muscle", "mesh": "muscle.ply", "lines":
        [{"name": "line", "rest": [[0,0,-55],[0,0,0],[0,0,55]]}]}],
      "bones": [{"name": "bone", "mesh": "bone.ply", "body": "bone"}],
      "poses": [{"name": "rest"}, {"name": "bent", "lines":
        {"line": [[0,0,-55],[0,0,0],[30,0,45]]}}]})");
}

ProgramRun DeformProgram::Run(const std::string& flags) {
  WriteTextAtomically(dir_ + "/scene.json", scene_.dump());
  return Deform("--scene=" + dir_ + "/scene.json --out=" + out() + " " + flags);
}

void DeformProgram::ExpectRefused(const std::vector<std::string>& words,
                                  const std::string& flags) {
  const ProgramRun run = Run(flags);
  EXPECT_EQ(run.exit_code, 2) << run.out << run.errors;
  for (const auto& word : words) {
    EXPECT_THAT(run.errors, ::testing::HasSubstr(word));
  }
  EXPECT_FALSE(std::filesystem::exists(out()));
}

void DeformProgram::WriteMuscle(const TriangleSoup& soup) {
  WriteTriangleSoup(dir_ + "/muscle.ply", soup);
}

}  // namespace musclewarp
