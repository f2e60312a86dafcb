// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/run/kept_model.h"

#include <filesystem>
#include <system_error>

#include "musclewarp/base/input_file.h"
#include "musclewarp/base/output_file.h"

namespace musclewarp {

namespace fs = std::filesystem;

void KeepModel(const Scene& scene, const std::string& dir) {
  std::error_code error;
  if (!scene.model || !fs::exists(scene.model->model.path, error)) return;
  WriteTextAtomically((fs::path(dir) / kKeptModel).string(),
                      ReadFile(scene.model->model.path));
}

bool IsModelKept(const std::string& dir) {
  std::error_code error;
  return !dir.empty() && fs::exists(fs::path(dir) / kKeptModel, error);
}

std::string ModelOfRun(const std::string& dir, const JsonField& motion) {
  if (motion.Has("kept_model")) {
    const fs::path kept = fs::path(dir) / motion.At("kept_model").AsString();
    if (fs::exists(kept)) return kept.string();
  }
  const std::string recorded = motion.At("model").AsString();
  const fs::path beside = fs::path(dir) / recorded;
  return fs::exists(beside) ? beside.string() : recorded;
}

}  // namespace musclewarp
