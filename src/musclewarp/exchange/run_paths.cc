// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/exchange/run_paths.h"

#include <filesystem>

#include "musclewarp/base/angles.h"
#include "musclewarp/base/input_error.h"
#include "musclewarp/base/input_file.h"
#include "musclewarp/base/near_name.h"
#include "musclewarp/base/text.h"
#include "musclewarp/exchange/path_beyond.h"
#include "musclewarp/opensim/kinematics.h"
#include "musclewarp/run/frame_files.h"
#include "musclewarp/run/kept_model.h"
#include "musclewarp/run/lines_file.h"
#include "musclewarp/run/run_reader.h"

namespace musclewarp {
namespace {

// Throws InputError if the report of a run says that its paths will not do.
void CheckReport(const JsonField& report) {
  const JsonField summary = report.At("summary");
  if (!summary.At("finished").AsBool()) {
    summary.At("finished").Fail("is false", "finish the run with {resume}");
  }
  if (!summary.At("usable").AsBool()) {
    summary.At("usable").Fail(
        "is false: lengths of such a run mean little",
        "see the shortcomings of its frames, or choose others with {frames} "
        "of musclewarp-deform");
  }
  if (report.At("motion").IsNull()) {
    report.At("motion").Fail("is null: the run has no OpenSim model",
                             "run a scene with \"model\" and \"motion\"");
  }
}

// Finds the parts of paths that the muscles of a run do not carry. Runs of
// earlier builds have no lines at rest.
std::map<std::string, double> PartsBeyond(const RunOutline& run,
                                          const Model& model) {
  std::map<std::string, double> beyond;
  const std::string file =
      (std::filesystem::path(run.rest) / kLinesFile).string();
  if (run.rest.empty() || !std::filesystem::exists(file)) return beyond;
  for (const MuscleLines& muscle : ReadLinesFile(file)) {
    for (const NamedLine& line : muscle.lines) {
      const int index = model.FindMuscle(line.name);
      if (index < 0) continue;
      const double length =
          LengthBeyond(DefaultPath(model, index), line.points);
      if (length > 0) beyond[line.name] = length;
    }
  }
  return beyond;
}

// The frames of one run, whose report is `file`.
class FramesOfRun {
 public:
  FramesOfRun(const RunOutline& run, const std::string& file, RunPaths* paths)
      : run_(run), file_(file), paths_(*paths) {}

  void Add() {
    for (size_t i = 0; i < run_.frames.size(); ++i) {
      const FrameFigures& frame = run_.frames[i].figures;
      const std::string where = file_ + ": frames[" + std::to_string(i) + "].";
      if (!frame.moment_arms_converged) {
        throw InputError(
            where + "moment_arms_converged",
            "is false: the moment arms of the frame (" +
                FrameFolder(frame.index) + ", at " + NumberText(frame.time) +
                " s) mean nothing",
            "run without the frame ({frames} of musclewarp-deform)");
      }
      const CoordinateValues values =
          ValuesOf(frame.coordinates, where + "coordinates");
      for (size_t m = 0; m < frame.muscles.size(); ++m) {
        AddMuscle(
            frame.muscles[m],
            values,
            where + "muscles[" + std::to_string(m) + "].line_moment_arms_mm");
      }
    }
  }

 private:
  // The coordinates of a frame in the units of the model.
  CoordinateValues ValuesOf(const std::map<std::string, double>& given,
                            const std::string& where) const {
    CoordinateValues values = DefaultValues(paths_.model);
    for (const auto& [name, value] : given) {
      const int index = IndexOf(name, where);
      const bool is_angle =
          paths_.model.coordinates[index].kind == CoordinateKind::kRotational;
      values[index] = value * (is_angle ? kRadiansPerDegree : 1);
    }
    ApplyCouplers(paths_.model, &values);
    return values;
  }

  int IndexOf(const std::string& coordinate, const std::string& where) const {
    const int index = paths_.model.FindCoordinate(coordinate);
    if (index >= 0) return index;
    std::vector<std::string> known;
    for (const Coordinate& other : paths_.model.coordinates) {
      known.push_back(other.name);
    }
    throw InputError(where,
                     "names \"" + coordinate +
                         "\", which is no coordinate of " + paths_.model.path,
                     DidYouMean(coordinate, known) + "check {model}");
  }

  void AddMuscle(const MuscleFigures& muscle,
                 const CoordinateValues& values,
                 const std::string& where) {
    for (const auto& [line, length] : muscle.line_lengths) {
      if (paths_.model.FindMuscle(line) < 0) {
        paths_.lines_without_muscle.insert(line);
        continue;
      }
      const auto arms = muscle.line_moment_arms.find(line);
      if (arms == muscle.line_moment_arms.end()) {
        throw InputError(where,
                         "has no moment arms of \"" + line + "\"",
                         "use {contact}=certified or none, which have them");
      }
      CheckCoordinates(arms->second, where);
      PathSample& sample = paths_.lines[line].emplace_back();
      const auto beyond = paths_.beyond.find(line);
      sample.length =
          length + (beyond == paths_.beyond.end() ? 0 : beyond->second);
      sample.arms.resize(static_cast<int>(arms->second.size()));
      sample.coordinates.resize(sample.arms.size());
      int k = 0;
      for (const auto& [name, arm] : arms->second) {
        sample.arms[k] = arm;
        sample.coordinates[k++] = values[IndexOf(name, where)];
      }
    }
  }

  // The coordinates must be those of the first line of the first run.
  void CheckCoordinates(const std::map<std::string, double>& arms,
                        const std::string& where) {
    std::vector<std::string> names;
    for (const auto& item : arms) names.push_back(item.first);
    if (paths_.coordinates.empty()) paths_.coordinates = names;
    if (!names.empty() && names == paths_.coordinates) return;
    throw InputError(
        where,
        "has other coordinates than the first line of the first run",
        "give runs of one scene and model");
  }

  const RunOutline& run_;
  const std::string file_;
  RunPaths& paths_;
};

// Muscles that push each other have other paths than those that do not: one fit
// of both would be neither.
void CheckContact(const std::string& dir,
                  const std::string& contact,
                  const std::string& first_dir,
                  const std::string& first_contact) {
  if (contact == first_contact) return;
  throw InputError(dir,
                   "was made with {contact}=" + contact + ", " + first_dir +
                       " with {contact}=" + first_contact,
                   "give runs of one contact mode");
}

// Each run has a copy of its model.
bool AreEqual(const std::string& model, const std::string& other) {
  return model == other || ReadFile(model) == ReadFile(other);
}

}  // namespace

RunPaths ReadRunPaths(const std::vector<std::string>& dirs,
                      const std::string& model_path) {
  RunPaths paths;
  std::string first_model, contact;
  size_t frames = 0;
  for (const std::string& dir : dirs) {
    const JsonField report = ReadReport(dir);
    CheckReport(report);
    const RunOutline run = OutlineOf(dir, report);
    if (dir == dirs[0]) contact = run.contact;
    CheckContact(dir, run.contact, dirs[0], contact);
    const std::string model = ModelOfRun(dir, report.At("motion"));
    if (dir == dirs[0]) {
      first_model = model;
      paths.model = ReadModel(model_path.empty() ? model : model_path);
      paths.beyond = PartsBeyond(run, paths.model);
    } else if (model_path.empty() && !AreEqual(model, first_model)) {
      report.At("motion").At("model").Fail(
          "is " + model + ", that of " + dirs[0] + " is " + first_model,
          "give runs of one model, or name it in {model}");
    }
    FramesOfRun(run, report.file(), &paths).Add();
    frames += run.frames.size();
    for (const auto& line : paths.lines) {
      if (line.second.size() == frames) continue;
      throw InputError(
          dir,
          "does not have the lines of the other runs: \"" + line.first + "\"",
          "give runs of one scene");
    }
  }
  if (paths.lines.empty()) {
    throw InputError(dirs.empty() ? "{in}" : dirs[0],
                     "has no line that is a muscle of " + paths.model.path,
                     "check {model} and the \"lines\" of the scene");
  }
  return paths;
}

}  // namespace musclewarp
