// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/exchange/run_paths.h"

#include <filesystem>
#include <sstream>

#include "musclewarp/base/angles.h"
#include "musclewarp/base/input_error.h"
#include "musclewarp/base/input_file.h"
#include "musclewarp/opensim/kinematics.h"
#include "musclewarp/run/frame_files.h"
#include "musclewarp/run/kept_model.h"
#include "musclewarp/scene/json_fields.h"

namespace musclewarp {
namespace {

namespace fs = std::filesystem;

JsonField ReadReport(const std::string& dir, const std::string& version) {
  if (!fs::is_directory(dir)) {
    throw InputError(dir, "there is no such folder", "check --in");
  }
  JsonField report =
      JsonField::ParseFile((fs::path(dir) / "report.json").string());
  if (report.At("version").AsString() != version) {
    report.At("version").Fail(
        "is " + report.At("version").AsString(),
        "run musclewarp-deform of this version, " + version);
  }
  const JsonField summary = report.At("summary");
  if (!summary.At("finished").AsBool()) {
    summary.At("finished").Fail("is false", "finish the run with --resume");
  }
  if (!summary.At("usable").AsBool()) {
    summary.At("usable").Fail(
        "is false: lengths of such a run mean little",
        "see the shortcomings of its frames, or choose others with --frames "
        "of musclewarp-deform");
  }
  if (report.At("motion").value().is_null()) {
    report.At("motion").Fail("is null: the run has no OpenSim model",
                             "run a scene with \"model\" and \"motion\"");
  }
  return report;
}

// The coordinates of a frame in the units of the model.
CoordinateValues ValuesOf(const JsonField& frame, const Model& model) {
  CoordinateValues values = DefaultValues(model);
  const JsonField given = frame.At("coordinates");
  given.CheckObject();
  for (const auto& item : given.value().items()) {
    const JsonField field = given.At(item.key());
    const int index = model.FindCoordinate(item.key());
    if (index < 0) {
      field.Fail("is not a coordinate of the model " + model.path,
                 "check --model");
    }
    const bool is_angle =
        model.coordinates[index].kind == CoordinateKind::kRotational;
    values[index] = field.AsNumber() * (is_angle ? kRadiansPerDegree : 1);
  }
  ApplyCouplers(model, &values);
  return values;
}

// The coordinates must be those of the first line of the first run.
void CheckCoordinates(const JsonField& arms,
                      std::vector<std::string>* coordinates) {
  arms.CheckObject();
  std::vector<std::string> names;
  for (const auto& item : arms.value().items()) names.push_back(item.key());
  if (coordinates->empty()) *coordinates = names;
  if (names.empty() || names != *coordinates) {
    arms.Fail("has other coordinates than the first line of the first run",
              "give runs of one scene and model");
  }
}

void AddSample(const JsonField& muscle,
               const std::string& line,
               const CoordinateValues& values,
               RunPaths* paths) {
  PathSample sample;
  sample.length = muscle.At("line_lengths_mm").At(line).AsNumber();
  const JsonField all = muscle.At("line_moment_arms_mm");
  if (!all.Has(line)) {
    all.Fail("has no moment arms of \"" + line + "\"",
             "use --contact=certified or none, which have them");
  }
  const JsonField arms = all.At(line);
  CheckCoordinates(arms, &paths->coordinates);
  const int count = static_cast<int>(paths->coordinates.size());
  sample.arms.resize(count);
  sample.coordinates.resize(count);
  for (int k = 0; k < count; ++k) {
    const std::string& name = paths->coordinates[k];
    const int index = paths->model.FindCoordinate(name);
    if (index < 0) {
      arms.Fail("names \"" + name + "\", which is not in " + paths->model.path,
                "check --model");
    }
    sample.arms[k] = arms.At(name).AsNumber();
    sample.coordinates[k] = values[index];
  }
  paths->lines[line].push_back(std::move(sample));
}

// The folder of a frame and its time, as far as the report has them.
std::string NameOfFrame(const JsonField& frame) {
  std::ostringstream name;
  if (frame.Has("index")) {
    name << " (" << FrameFolder(static_cast<int>(frame.At("index").AsNumber()));
    if (frame.Has("time")) {
      name << ", at " << frame.At("time").AsNumber() << " s";
    }
    name << ")";
  }
  return name.str();
}

void AddFrames(const JsonField& frames, RunPaths* paths) {
  for (size_t i = 0; i < frames.ArraySize(); ++i) {
    const JsonField frame = frames.At(i);
    const JsonField muscles = frame.At("muscles");
    if (!frame.At("moment_arms_converged").AsBool()) {
      frame.At("moment_arms_converged")
          .Fail("is false: the moment arms of the frame" + NameOfFrame(frame) +
                    " mean nothing",
                "run without the frame (--frames of musclewarp-deform)");
    }
    const CoordinateValues values = ValuesOf(frame, paths->model);
    for (size_t m = 0; m < muscles.ArraySize(); ++m) {
      const JsonField lengths = muscles.At(m).At("line_lengths_mm");
      lengths.CheckObject();
      for (const auto& item : lengths.value().items()) {
        if (paths->model.FindMuscle(item.key()) < 0) {
          paths->lines_without_muscle.insert(item.key());
        } else {
          AddSample(muscles.At(m), item.key(), values, paths);
        }
      }
    }
  }
}

// Muscles that push each other have other paths than those that do not: one fit
// of both would be neither.
void CheckContact(const std::string& dir,
                  const std::string& contact,
                  const std::string& first_dir,
                  const std::string& first_contact) {
  if (contact == first_contact) return;
  throw InputError(dir,
                   "was made with --contact=" + contact + ", " + first_dir +
                       " with --contact=" + first_contact,
                   "give runs of one contact mode");
}

// Each run has a copy of its model.
bool AreEqual(const std::string& model, const std::string& other) {
  return model == other || ReadFile(model) == ReadFile(other);
}

}  // namespace

RunPaths ReadRunPaths(const std::vector<std::string>& dirs,
                      const std::string& model_path,
                      const std::string& version) {
  RunPaths paths;
  std::string first_model, contact;
  size_t frames = 0;
  for (const std::string& dir : dirs) {
    const JsonField report = ReadReport(dir, version);
    const std::string mode =
        report.Has("contact") ? report.At("contact").AsString() : "";
    if (dir == dirs[0]) contact = mode;
    CheckContact(dir, mode, dirs[0], contact);
    const std::string model = ModelOfRun(dir, report.At("motion"));
    if (dir == dirs[0]) {
      first_model = model;
      paths.model = ReadModel(model_path.empty() ? model : model_path);
    } else if (model_path.empty() && !AreEqual(model, first_model)) {
      report.At("motion").At("model").Fail(
          "is " + model + ", that of " + dirs[0] + " is " + first_model,
          "give runs of one model, or name it in --model");
    }
    AddFrames(report.At("frames"), &paths);
    frames += report.At("frames").ArraySize();
    for (const auto& line : paths.lines) {
      if (line.second.size() == frames) continue;
      throw InputError(
          dir,
          "does not have the lines of the other runs: \"" + line.first + "\"",
          "give runs of one scene");
    }
  }
  if (paths.lines.empty()) {
    throw InputError(dirs.empty() ? "--in" : dirs[0],
                     "has no line that is a muscle of " + paths.model.path,
                     "check --model and the \"lines\" of the scene");
  }
  return paths;
}

}  // namespace musclewarp
