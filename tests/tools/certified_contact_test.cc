// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string>

#include "musclewarp/base/output_file.h"
#include "support/temp_dir.h"
#include "tools/run_program.h"

namespace musclewarp {
namespace {

using Json = nlohmann::json;

// The scene of musclewarp-phantom in dir/scene.
std::string PhantomScene(const std::string& name, const std::string& dir) {
  EXPECT_EQ(RunCommandLine(MUSCLEWARP_PHANTOM,
                           "--scene=" + name + " --out=" + dir + "/scene")
                .exit_code,
            0);
  return dir + "/scene/scene.json";
}

void DeformScene(const std::string& scene,
                 const std::string& flags,
                 const std::string& out) {
  const ProgramRun run = RunCommandLine(
      MUSCLEWARP_DEFORM, "--scene=" + scene + " --out=" + out + " " + flags);
  EXPECT_EQ(run.exit_code, 0) << run.out << run.errors;
}

}  // namespace

// Not a bit of what is written.
TEST(CertifiedContact, DoesNotDependOnTheOrderOfMuscles) {
  const std::string dir = TestTempDir();
  const std::string scene = PhantomScene("stress_attachment", dir);
  Json json = Json::parse(FileText(scene));
  std::reverse(json["muscles"].begin(), json["muscles"].end());
  WriteTextAtomically(dir + "/scene/reversed.json", json.dump());
  DeformScene(scene, "--frames=0:1", dir + "/out");
  DeformScene(dir + "/scene/reversed.json", "--frames=0:1", dir + "/reversed");
  for (const Json& muscle : json["muscles"]) {
    for (const char* frame : {"/frame_0000/", "/frame_0001/"}) {
      const std::string file =
          frame + muscle["name"].get<std::string>() + ".ply";
      EXPECT_EQ(FileText(dir + "/out" + file),
                FileText(dir + "/reversed" + file))
          << file;
    }
  }
}

// What the coarse mesh carries makes way with it: the line through a muscle
// that a bone bends aside.
TEST(CertifiedContact, MovesTheLinesThatAreCarried) {
  const std::string dir = TestTempDir();
  const std::string scene = PhantomScene("stress_edge", dir);
  const auto lines = [&](const std::string& contact) {
    const std::string out = dir + "/" + contact;
    DeformScene(
        scene, "--frames=3 --bone_push=false --contact=" + contact, out);
    return Json::parse(FileText(
        out + "/frame_0003/lines.json"))["muscles"][0]["lines"][0]["points"];
  };
  const Json free = lines("none");
  const Json bent = lines("certified");
  ASSERT_EQ(free.size(), bent.size());
  double farthest = 0;
  for (size_t i = 0; i < free.size(); ++i) {
    for (int k = 0; k < 3; ++k) {
      farthest = std::max(
          farthest,
          std::abs(free[i][k].get<double>() - bent[i][k].get<double>()));
    }
  }
  // The edge goes 10 mm into the muscle.
  EXPECT_GT(farthest, 1);
  EXPECT_LT(farthest, 10);
}

}  // namespace musclewarp
