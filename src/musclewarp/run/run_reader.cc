// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/run/run_reader.h"

#include <filesystem>
#include <map>
#include <utility>

#include "musclewarp/base/input_error.h"
#include "musclewarp/base/text.h"
#include "musclewarp/figures/figures_json.h"
#include "musclewarp/geometry/view.h"
#include "musclewarp/run/frame_files.h"

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

std::vector<FrameFigures> FiguresIn(const JsonField& report) {
  std::vector<FrameFigures> figures;
  if (!report.Has("frames")) report.At("frames");  // says that it is missing
  const Json& frames = report.value().at("frames");
  const FieldPath path = {nullptr, "frames"};
  try {
    ReadJson(frames, path, &figures);
  } catch (const InputError& error) {
    throw InputError(
        report.file() + ": " + error.where(), error.problem(), kRunAgain);
  }
  std::string error;
  if (!IsValid(figures, &error, path)) {
    throw InputError(report.file(), error, kRunAgain);
  }
  for (size_t i = 0; i < figures.size(); ++i) {
    if (frames[i].at("usable") == false && figures[i].IsUsable()) {
      figures[i].shortcomings.emplace_back("report.json calls it not usable");
    }
  }
  return figures;
}

}  // namespace

JsonField ReadReport(const std::string& dir) {
  if (!fs::is_directory(dir)) {
    throw InputError(dir, "there is no such folder", "check the name");
  }
  return JsonField::ParseFile((fs::path(dir) / "report.json").string());
}

RunOutline OutlineOf(const std::string& dir, const JsonField& report) {
  RunOutline run;
  run.dir = dir;
  run.rest = (fs::path(dir) / kRestFolder).string();
  run.scene = report.At("scene").AsString();
  run.version = report.At("version").AsString();
  run.inputs_hash = report.At("inputs_hash").AsString();
  run.axes = report.At("axes").AsString();
  if (!AreBodyAxes(run.axes)) {
    report.At("axes").Fail("is \"" + run.axes + "\"",
                           "give three different letters, such as LPS");
  }
  if (report.Has("side")) run.side = report.At("side").AsString();
  run.contact = report.At("contact").AsString();
  if (report.Has("body_size")) {
    run.body_size = report.At("body_size").AsNumber();
  }
  const JsonField summary = report.At("summary");
  run.is_finished = summary.At("finished").AsBool();
  run.is_usable = summary.At("usable").AsBool();
  run.names = {NamesOf(report.At("prepare").At("muscles")),
               NamesOf(report.At("prepare").At("bones"))};
  run.has_times = true;
  const std::map<int, std::string> folders = FrameFoldersIn(dir);
  for (FrameFigures& figures : FiguresIn(report)) {
    if (!run.frames.empty() && figures.time <= run.frames.back().figures.time) {
      run.has_times = false;
    }
    const auto folder = folders.find(figures.index);
    run.frames.push_back(
        {std::move(figures), folder == folders.end() ? "" : folder->second});
  }
  return run;
}

void DropMissingFrames(RunOutline* run) {
  std::vector<RecordedFrame> there;
  for (RecordedFrame& frame : run->frames) {
    if (frame.folder.empty()) {
      run->warnings.push_back(FrameFolder(frame.figures.index) +
                              " is in report.json, its folder is missing");
    } else {
      there.push_back(std::move(frame));
    }
  }
  run->frames = std::move(there);
}

RunOutline ReadRunForExport(const std::string& dir,
                            const std::string& version) {
  RunOutline run = OutlineOf(dir, ReadReport(dir));
  if (run.version != version) {
    run.warnings.push_back("the run is of version " + run.version +
                           ", this program of " + version);
  }
  if (!run.is_finished) {
    run.warnings.push_back(
        "the run is not finished: only the frames that are there are exported");
  }
  if (!run.is_usable) {
    run.warnings.push_back(
        "the run is not usable: its report says why, frame by frame");
  }
  DropMissingFrames(&run);
  if (run.frames.empty()) {
    throw InputError(
        dir, "the run has no frame", "run musclewarp-deform {resume} first");
  }
  return run;
}

std::string AtTime(const RunOutline& run, const RecordedFrame& frame) {
  if (!run.has_times) return "";
  return ", at " + NumberText(frame.figures.time) + " s";
}

}  // namespace musclewarp
