// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/exchange/measured_run.h"

#include <filesystem>
#include <utility>

#include "musclewarp/base/input_error.h"
#include "musclewarp/base/input_file.h"
#include "musclewarp/run/kept_model.h"
#include "musclewarp/run/run_reader.h"

namespace musclewarp {
namespace {

bool IsOfDesign(const JsonField& report) {
  return report.At("motion").Has("design");
}

// Throws InputError if the report of a run says that its paths will not do.
void CheckReport(const JsonField& report) {
  const JsonField summary = report.At("summary");
  if (!summary.At("finished").AsBool()) {
    summary.At("finished").Fail("is false", "finish the run with {resume}");
  }
  if (report.At("motion").IsNull()) {
    report.At("motion").Fail("is null: the run has no OpenSim model",
                             "run a scene with \"model\" and \"motion\"");
  }
  if (!summary.At("usable").AsBool() && !IsOfDesign(report)) {
    summary.At("usable").Fail(
        "is false: lengths of such a run mean little",
        "see the shortcomings of its frames, or choose others with {frames} "
        "of musclewarp-deform");
  }
}

// Returns the lines and fibres of a run at rest. Runs of earlier builds have
// none.
std::vector<MuscleLines> LinesAtRest(const RunOutline& run) {
  const std::string file =
      (std::filesystem::path(run.rest) / kLinesFile).string();
  if (run.rest.empty() || !std::filesystem::exists(file)) return {};
  return ReadLinesFile(file);
}

// Each run has a copy of its model.
bool AreEqual(const std::string& model, const std::string& other) {
  return model == other || ReadFile(model) == ReadFile(other);
}

}  // namespace

std::vector<MeasuredRun> ReadMeasuredRuns(const std::vector<std::string>& dirs,
                                          const std::string& model_path,
                                          Model* model) {
  std::string first_model;
  std::vector<MeasuredRun> runs;
  for (const std::string& dir : dirs) {
    const JsonField report = ReadReport(dir);
    CheckReport(report);
    const RunOutline outline = OutlineOf(dir, report);
    MeasuredRun run;
    run.name = dir;
    run.contact = outline.contact;
    run.is_of_design = IsOfDesign(report);
    run.at_rest = LinesAtRest(outline);
    for (const RecordedFrame& frame : outline.frames) {
      run.frames.push_back(frame.figures);
    }
    const std::string of_run = ModelOfRun(dir, report.At("motion"));
    if (runs.empty()) {
      first_model = of_run;
    } else if (model_path.empty() && !AreEqual(of_run, first_model)) {
      report.At("motion").At("model").Fail(
          "is " + of_run + ", that of " + dirs[0] + " is " + first_model,
          "give runs of one model, or name it in {model}");
    }
    runs.push_back(std::move(run));
  }
  if (runs.empty()) {
    throw InputError("{in}", "is missing", "name the folder of a run");
  }
  *model = ReadModel(model_path.empty() ? first_model : model_path);
  return runs;
}

}  // namespace musclewarp
