// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/run/run_outline.h"

#include <filesystem>
#include <map>

#include "musclewarp/base/input_error.h"
#include "musclewarp/base/text.h"
#include "musclewarp/geometry/view.h"
#include "musclewarp/run/frame_files.h"
#include "musclewarp/run/run_files.h"
#include "musclewarp/scene/json_fields.h"

namespace musclewarp {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> NamesOf(const JsonField& list) {
  std::vector<std::string> names;
  for (size_t i = 0; i < list.ArraySize(); ++i) {
    names.push_back(list.At(i).At("name").AsString());
  }
  return names;
}

void ReadFrames(const JsonField& frames, RunOutline* run) {
  const std::map<int, std::string> folders = FrameFoldersIn(run->dir);
  run->has_times = true;
  for (size_t i = 0; i < frames.ArraySize(); ++i) {
    const JsonField field = frames.At(i);
    OutlinedFrame frame;
    frame.index = static_cast<int>(field.At("index").AsNumber());
    frame.pose.name = field.At("name").AsString();
    frame.pose.time = field.At("time").AsNumber();
    frame.usable = field.At("usable").AsBool();
    const auto folder = folders.find(frame.index);
    if (folder == folders.end()) {
      run->warnings.push_back(FrameFolder(frame.index) +
                              " is in report.json, its folder is missing");
      continue;
    }
    frame.folder = folder->second;
    if (!run->frames.empty() &&
        frame.pose.time <= run->frames.back().pose.time) {
      run->has_times = false;
    }
    run->frames.push_back(std::move(frame));
  }
}

void AddWarnings(const JsonField& report,
                 const std::string& version,
                 RunOutline* run) {
  const std::string of_run = report.At("version").AsString();
  if (of_run != version) {
    run->warnings.push_back("the run is of version " + of_run +
                            ", this program of " + version);
  }
  const JsonField summary = report.At("summary");
  if (!summary.At("finished").AsBool()) {
    run->warnings.push_back(
        "the run is not finished: only the frames that are "
        "there are exported");
  }
  if (!summary.At("usable").AsBool()) {
    run->warnings.push_back(
        "the run is not usable: its report says why, frame by frame");
  }
}

}  // namespace

RunOutline ReadRunOutline(const std::string& dir, const std::string& version) {
  if (!fs::is_directory(dir)) {
    throw InputError(dir, "there is no such folder", "check --in");
  }
  const JsonField report =
      JsonField::ParseFile((fs::path(dir) / "report.json").string());
  RunOutline run;
  run.dir = dir;
  run.rest = (fs::path(dir) / kRestFolder).string();
  run.scene = report.At("scene").AsString();
  run.inputs_hash = report.At("inputs_hash").AsString();
  run.axes = report.At("axes").AsString();
  if (!AreBodyAxes(run.axes)) {
    report.At("axes").Fail("is \"" + run.axes + "\"",
                           "give three different letters, such as LPS");
  }
  run.contact = report.At("contact").AsString();
  run.names = {NamesOf(report.At("prepare").At("muscles")),
               NamesOf(report.At("prepare").At("bones"))};
  AddWarnings(report, version, &run);
  ReadFrames(report.At("frames"), &run);
  if (run.frames.empty()) {
    throw InputError(
        dir, "the run has no frame", "run musclewarp-deform --resume first");
  }
  return run;
}

std::string AtTime(const RunOutline& run, const OutlinedFrame& frame) {
  if (!run.has_times) return "";
  return ", at " + NumberText(frame.pose.time) + " s";
}

}  // namespace musclewarp
