// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/run/earlier_run.h"

#include <algorithm>
#include <filesystem>

#include "musclewarp/base/input_error.h"
#include "musclewarp/base/output_file.h"
#include "musclewarp/run/frame_files.h"
#include "musclewarp/run/motion_tables.h"
#include "musclewarp/run/resume_log.h"
#include "musclewarp/scene/json_fields.h"

namespace musclewarp {
namespace {

namespace fs = std::filesystem;

constexpr char kReport[] = "report.json";

std::vector<std::string> NamesOfFrameFolders(const std::string& dir) {
  std::vector<std::string> names;
  if (!fs::is_directory(dir)) return names;
  for (const auto& [index, folder] : FrameFoldersIn(dir)) {
    names.push_back(FrameFolder(index));
  }
  return names;
}

// Reports of earlier versions do not say which code wrote them.
std::string TextOrNothing(const JsonField& report, const std::string& key) {
  return report.Has(key) ? report.At(key).AsString() : "";
}

}  // namespace

std::optional<EarlierRun> ReadEarlierRun(const std::string& dir) {
  const std::string path = (fs::path(dir) / kReport).string();
  if (!fs::exists(path)) return std::nullopt;
  const JsonField report = JsonField::ParseFile(path);
  EarlierRun run;
  run.inputs_hash = TextOrNothing(report, "inputs_hash");
  run.code_key = TextOrNothing(report, "code");
  const JsonField summary = report.At("summary");
  run.is_finished = summary.At("finished").AsBool();
  run.is_usable = summary.At("usable").AsBool();
  const JsonField frames = report.At("frames");
  for (size_t i = 0; i < frames.ArraySize(); ++i) {
    const double index = frames.At(i).At("index").AsNumber();
    run.frames.push_back(FrameFolder(static_cast<int>(index)));
  }
  return run;
}

void CheckNoStrangeFrames(const std::string& dir, bool overwrite) {
  if (overwrite || ResumeLog::IsIn(dir)) return;
  const std::vector<std::string> folders = NamesOfFrameFolders(dir);
  if (folders.empty()) return;
  const std::optional<EarlierRun> run = ReadEarlierRun(dir);
  for (const std::string& folder : folders) {
    if (run && std::count(run->frames.begin(), run->frames.end(), folder)) {
      continue;
    }
    throw InputError(
        dir,
        "has " + folder + ", which no " + kReport + " there names: it is of " +
            "another run, and would be taken for a frame of this one",
        "choose another folder, or give {overwrite} to remove it");
  }
}

int RemoveEarlierRun(const std::string& dir) {
  const std::vector<std::string> frames = NamesOfFrameFolders(dir);
  for (const std::string& folder : frames) {
    RemoveFolderAtomically((fs::path(dir) / folder).string());
  }
  RemoveFolderAtomically((fs::path(dir) / kRestFolder).string());
  // Without a report, tables and pages are not those of a run.
  if (!fs::exists(fs::path(dir) / kReport)) {
    return static_cast<int>(frames.size());
  }
  for (const std::string& table : MotionTableNames()) {
    fs::remove(fs::path(dir) / table);
  }
  for (const char* file : {"motion.pvd", "report.html", kReport}) {
    fs::remove(fs::path(dir) / file);
  }
  return static_cast<int>(frames.size());
}

}  // namespace musclewarp
