// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/exchange/run_paths.h"

#include <glog/logging.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "musclewarp/base/input_error.h"
#include "musclewarp/base/text.h"
#include "musclewarp/exchange/fibre_bands.h"
#include "musclewarp/exchange/path_beyond.h"
#include "musclewarp/exchange/path_coordinates.h"
#include "musclewarp/opensim/kinematics.h"
#include "musclewarp/run/frame_files.h"

namespace musclewarp {
namespace {

// The parts of paths that the muscles of a run do not carry, by line.
std::map<std::string, PartsBeyond> PartsBeyondMuscles(
    const std::vector<MuscleLines>& at_rest, const Model& model) {
  std::map<std::string, PartsBeyond> beyond;
  for (const MuscleLines& muscle : at_rest) {
    for (const NamedLine& line : muscle.lines) {
      const int index = model.FindMuscle(line.name);
      if (index < 0) continue;
      beyond[line.name] =
          FindPartsBeyond(DefaultPath(model, index), line.points);
    }
  }
  return beyond;
}

// Returns the coordinates of a run's moment arms, by name.
std::vector<std::string> CoordinatesOf(const FrameFigures& frame) {
  for (const MuscleFigures& muscle : frame.muscles) {
    for (const auto& line : muscle.line_moment_arms) {
      std::vector<std::string> names;
      for (const auto& arm : line.second) names.push_back(arm.first);
      return names;
    }
  }
  return {};
}

// Adds the bands of a muscle to `paths`, each with its fibres and what it
// replaces.
void AddBands(const MeasuredRun& run,
              const std::string& muscle,
              int paths_per_muscle,
              const Model& model,
              std::vector<MeasuredPath>* paths) {
  const auto at_rest = std::find_if(
      run.at_rest.begin(), run.at_rest.end(), [&](const auto& one) {
        return one.name == muscle;
      });
  if (at_rest == run.at_rest.end() || at_rest->fibres.empty()) {
    throw InputError(run.name,
                     "has no fibres of " + muscle,
                     "run musclewarp-deform with {fibres}=40");
  }
  std::vector<std::string> replaces;
  std::vector<Points> lines;
  for (const NamedLine& line : at_rest->lines) {
    if (model.FindMuscle(line.name) < 0) continue;
    replaces.push_back(line.name);
    lines.push_back(line.points);
  }
  const auto bands = FibreBands(at_rest->fibres, paths_per_muscle);
  for (size_t b = 0; b < bands.size(); ++b) {
    MeasuredPath path;
    path.name = muscle + "_" + std::to_string(b + 1);
    path.muscle = muscle;
    path.fibres = bands[b];
    path.share = static_cast<double>(bands[b].size()) /
                 static_cast<double>(at_rest->fibres.size());
    path.replaces = replaces;
    if (!lines.empty()) {
      path.nearest = replaces[NearestLine(at_rest->fibres, bands[b], lines)];
    }
    paths->push_back(std::move(path));
  }
}

// Adds the paths of the first run, without samples.
void AddPaths(const MeasuredRun& run, int paths_per_muscle, RunPaths* paths) {
  const FrameFigures& frame = run.frames[0];
  paths->coordinates = CoordinatesOf(frame);
  std::vector<int> indices;
  for (const std::string& name : paths->coordinates) {
    indices.push_back(CoordinateNamed(paths->model, name, run.name));
  }
  const auto beyond = PartsBeyondMuscles(run.at_rest, paths->model);
  for (const MuscleFigures& muscle : frame.muscles) {
    if (paths_per_muscle > 0) {
      AddBands(run, muscle.name, paths_per_muscle, paths->model, &paths->paths);
      continue;
    }
    for (const auto& line : muscle.line_lengths) {
      const bool has_arms = muscle.line_moment_arms.count(line.first) > 0;
      const bool is_in_model = paths->model.FindMuscle(line.first) >= 0;
      if (!has_arms && !is_in_model) {
        paths->lines_without_arms.push_back(line.first);
        continue;
      }
      MeasuredPath path;
      path.name = line.first;
      path.muscle = muscle.name;
      path.nearest = line.first;
      if (is_in_model) path.replaces = {line.first};
      paths->paths.push_back(std::move(path));
    }
  }
  for (MeasuredPath& path : paths->paths) {
    const auto part = beyond.find(path.nearest);
    if (part != beyond.end()) path.beyond = part->second;
    path.coordinates = CrossedCoordinates(
        paths->model,
        indices,
        BodiesOfPath(paths->model, frame, path.muscle, path.name));
  }
}

// The frames of one run.
class FramesOfRun {
 public:
  FramesOfRun(const MeasuredRun& run, RunPaths* paths)
      : run_(run), paths_(*paths) {}

  void Add() {
    for (size_t i = 0; i < run_.frames.size(); ++i) {
      const FrameFigures& frame = run_.frames[i];
      const std::string where =
          run_.name + ": frames[" + std::to_string(i) + "].";
      const std::string name =
          run_.name + ": " + FrameFolder(frame.index) + " (" + frame.name + ")";
      if (run_.is_of_design) {
        const std::string reason = WhyNoSample(frame);
        if (!reason.empty()) {
          paths_.frames_left_out.push_back(name + ": " + reason);
          continue;
        }
      }
      if (!frame.moment_arms_converged) {
        throw InputError(
            where + "moment_arms_converged",
            "is false: the moment arms of the frame (" +
                FrameFolder(frame.index) + ", at " + NumberText(frame.time) +
                " s) mean nothing",
            "run without the frame ({frames} of musclewarp-deform)");
      }
      const std::string doubt = run_.is_of_design ? WhyDoubtful(frame) : "";
      if (!doubt.empty()) paths_.frames_doubtful.push_back(name + ": " + doubt);
      AddFrame(frame, doubt.empty() ? 1 : kDoubtfulWeight, where);
      paths_.frames.push_back(name);
    }
  }

 private:
  void AddFrame(const FrameFigures& frame,
                double weight,
                const std::string& where) {
    const CoordinateValues values =
        ModelValuesOf(paths_.model, frame, where + "coordinates");
    Eigen::VectorXd at(static_cast<Eigen::Index>(paths_.coordinates.size()));
    for (Eigen::Index k = 0; k < at.size(); ++k) {
      at[k] =
          values[CoordinateNamed(paths_.model, paths_.coordinates[k], where)];
    }
    size_t found = 0;
    for (size_t m = 0; m < frame.muscles.size(); ++m) {
      const MuscleFigures& muscle = frame.muscles[m];
      for (MeasuredPath& path : paths_.paths) {
        if (path.muscle != muscle.name) continue;
        ++found;
        const std::string field = where + "muscles[" + std::to_string(m) + "].";
        PathSample sample = path.fibres.empty()
                                ? OfLine(muscle, path.name, field)
                                : OfBand(muscle, path.fibres, field);
        sample.coordinates = at;
        sample.weight = weight;
        sample.length += path.beyond.length;
        NoteOtherArms(sample, &path);
        NoteLength(muscle, sample, &path);
        path.samples.push_back(std::move(sample));
      }
      CheckLines(muscle);
    }
    if (found != paths_.paths.size()) FailOtherLines(paths_.paths[found].name);
  }

  // A run with more lines than the first is no run of its scene either.
  void CheckLines(const MuscleFigures& muscle) const {
    if (paths_.paths.empty() || !paths_.paths[0].fibres.empty()) return;
    for (const auto& line : muscle.line_lengths) {
      const bool is_known = std::any_of(
          paths_.paths.begin(),
          paths_.paths.end(),
          [&](const MeasuredPath& path) { return path.name == line.first; });
      const bool has_arms = muscle.line_moment_arms.count(line.first) > 0;
      if (!is_known && has_arms) FailOtherLines(line.first);
    }
  }

  [[noreturn]] void FailOtherLines(const std::string& line) const {
    throw InputError(
        run_.name,
        "does not have the lines of the other runs: \"" + line + "\"",
        "give runs of one scene");
  }

  PathSample OfLine(const MuscleFigures& muscle,
                    const std::string& line,
                    const std::string& where) const {
    const auto length = muscle.line_lengths.find(line);
    if (length == muscle.line_lengths.end()) FailOtherLines(line);
    const auto arms = muscle.line_moment_arms.find(line);
    if (arms == muscle.line_moment_arms.end()) {
      FailNoArms("\"" + line + "\"", where + "line_moment_arms_mm");
    }
    PathSample sample;
    sample.length = length->second;
    sample.arms.resize(static_cast<Eigen::Index>(arms->second.size()));
    std::vector<std::string> names;
    for (const auto& [name, arm] : arms->second) {
      sample.arms[static_cast<Eigen::Index>(names.size())] = arm;
      names.push_back(name);
    }
    if (names.empty() || names != paths_.coordinates) {
      throw InputError(
          where + "line_moment_arms_mm",
          "has other coordinates than the first line of the first run",
          "give runs of one scene and model");
    }
    return sample;
  }

  // The mean of the fibres.
  PathSample OfBand(const MuscleFigures& muscle,
                    const std::vector<int>& fibres,
                    const std::string& where) const {
    const auto num_fibres = static_cast<int>(muscle.fibre_lengths.size());
    if (fibres.back() >= num_fibres) {
      throw InputError(where + "fibre_lengths_mm",
                       "has " + std::to_string(num_fibres) +
                           " fibres, the first run has more",
                       "give runs with the same {fibres}");
    }
    if (muscle.fibre_moment_arms.empty()) {
      FailNoArms("the fibres", where + "fibre_moment_arms_mm");
    }
    const double share = 1 / static_cast<double>(fibres.size());
    PathSample sample;
    sample.arms.setZero(static_cast<Eigen::Index>(paths_.coordinates.size()));
    for (const int fibre : fibres) {
      sample.length += share * muscle.fibre_lengths[fibre];
      for (Eigen::Index k = 0; k < sample.arms.size(); ++k) {
        // A coordinate that changes no fibre is left out.
        const auto arms = muscle.fibre_moment_arms.find(paths_.coordinates[k]);
        if (arms == muscle.fibre_moment_arms.end()) continue;
        sample.arms[k] += share * arms->second.at(fibre);
      }
    }
    return sample;
  }

  [[noreturn]] static void FailNoArms(const std::string& what,
                                      const std::string& where) {
    throw InputError(where,
                     "has no moment arms of " + what,
                     "use {contact}=certified or none, which have them");
  }

  static void NoteOtherArms(const PathSample& sample, MeasuredPath* path) {
    for (Eigen::Index k = 0; k < sample.arms.size(); ++k) {
      const bool is_crossed = std::binary_search(path->coordinates.begin(),
                                                 path->coordinates.end(),
                                                 static_cast<int>(k));
      if (is_crossed) continue;
      path->largest_other_arm =
          std::max(path->largest_other_arm, std::abs(sample.arms[k]));
    }
  }

  // Takes a sample into the mean of how much a band is longer than its line.
  static void NoteLength(const MuscleFigures& muscle,
                         const PathSample& sample,
                         MeasuredPath* path) {
    const auto line = muscle.line_lengths.find(path->nearest);
    if (line == muscle.line_lengths.end()) return;
    const double longer = sample.length - line->second - path->beyond.length;
    path->longer +=
        (longer - path->longer) / static_cast<double>(path->samples.size() + 1);
  }

  const MeasuredRun& run_;
  RunPaths& paths_;
};

// Muscles that push each other have other paths than those that do not: one fit
// of both would be neither.
void CheckContact(const MeasuredRun& run, const MeasuredRun& first) {
  if (run.contact == first.contact) return;
  throw InputError(run.name,
                   "was made with {contact}=" + run.contact + ", " +
                       first.name + " with {contact}=" + first.contact,
                   "give runs of one contact mode");
}

}  // namespace

std::string WhyNoSample(const FrameFigures& frame) {
  if (!frame.shortcomings.empty()) return frame.shortcomings[0];
  if (!frame.IsUsable()) return frame.stop_reason();
  return frame.moment_arms_converged ? "" : "moment arms did not converge";
}

std::string WhyDoubtful(const FrameFigures& frame) {
  if (frame.bone_overlaps.empty()) return "";
  const BoneOverlap& overlap = frame.bone_overlaps[0];
  return overlap.a + " and " + overlap.b + " are " +
         MeasureText(overlap.depth_mm) + " mm deep in each other";
}

double ForceOf(const MeasuredPath& path, const ModelDynamics& dynamics) {
  double force = 0;
  for (const std::string& name : path.replaces) {
    const auto muscle = dynamics.muscles.find(name);
    if (muscle != dynamics.muscles.end()) force += muscle->second.force;
  }
  return path.share * force;
}

RunPaths PathsOf(Model model,
                 const std::vector<MeasuredRun>& runs,
                 int paths_per_muscle) {
  CHECK(!runs.empty());
  RunPaths paths;
  paths.model = std::move(model);
  for (const MeasuredRun& run : runs) {
    if (run.frames.empty()) {
      throw InputError(
          run.name, "has no frames", "run musclewarp-deform again");
    }
    CheckContact(run, runs[0]);
    if (&run == &runs[0]) AddPaths(run, paths_per_muscle, &paths);
    FramesOfRun(run, &paths).Add();
  }
  if (paths.paths.empty() || paths.frames.empty()) {
    throw InputError(runs[0].name,
                     paths.paths.empty()
                         ? "has no line that is a muscle of " +
                               paths.model.path + " or has moment arms"
                         : "has no frame that is usable",
                     "run a scene whose muscles have lines");
  }
  return paths;
}

RunPaths ReadRunPaths(const std::vector<std::string>& dirs,
                      const std::string& model_path,
                      int paths_per_muscle) {
  Model model;
  const std::vector<MeasuredRun> runs =
      ReadMeasuredRuns(dirs, model_path, &model);
  return PathsOf(std::move(model), runs, paths_per_muscle);
}

}  // namespace musclewarp
