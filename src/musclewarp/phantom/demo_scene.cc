// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/phantom/demo_scene.h"

#include <filesystem>

#include "musclewarp/phantom/phantom_scene.h"

namespace musclewarp {
namespace {

namespace fs = std::filesystem;

fs::path FolderIn(const std::string& dir) { return fs::path(dir) / "scene"; }

}  // namespace

std::string DemoScenePath(const std::string& dir) {
  return (FolderIn(dir) / "motion.json").string();
}

void WriteDemoScene(const std::string& dir) {
  constexpr int kSeed = 1;  // that of data/phantom
  WritePhantomScene(MakePhantomScene("hip", kSeed), FolderIn(dir).string());
}

}  // namespace musclewarp
