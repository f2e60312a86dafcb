// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/run/step_recorder.h"

#include <filesystem>
#include <iomanip>
#include <sstream>
#include <utility>
#include <vector>

#include "musclewarp/base/output_file.h"
#include "musclewarp/run/frame_files.h"
#include "musclewarp/run/output_folder.h"

namespace musclewarp {
namespace {

namespace fs = std::filesystem;

}  // namespace

StepRecorder::StepRecorder(std::string folder, const std::string& flags)
    : folder_(std::move(folder)) {
  MakeFolder(folder_);
  WriteTextAtomically((fs::path(folder_) / "flags").string(), flags);
}

void StepRecorder::BeginFrame(int index) { frame_ = FrameFolder(index); }

void StepRecorder::Write(int number, const RecordedStep& step) const {
  const std::string prefix = frame_ + "_step_";
  if (number == 1) {
    std::vector<fs::path> earlier;
    for (const auto& entry : fs::directory_iterator(folder_)) {
      if (entry.path().filename().string().rfind(prefix, 0) == 0) {
        earlier.push_back(entry.path());
      }
    }
    for (const fs::path& path : earlier) fs::remove(path);
  }
  std::ostringstream name;
  name << prefix << std::setw(2) << std::setfill('0') << number << ".step";
  WriteRecordedStep((fs::path(folder_) / name.str()).string(), step);
}

}  // namespace musclewarp
