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
std::map<std::string, double> PartsBeyond(
    const std::vector<MuscleLines>& at_rest, const Model& model) {
  std::map<std::string, double> beyond;
  for (const MuscleLines& muscle : at_rest) {
    for (const NamedLine& line : muscle.lines) {
      const int index = model.FindMuscle(line.name);
      if (index < 0) continue;
      beyond[line.name] = LengthBeyond(DefaultPath(model, index), line.points);
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

// Adds the paths of the first run, without samples. `bands` has the fibres of
// each path that is a band.
void AddPaths(const MeasuredRun& run,
              int paths_per_muscle,
              RunPaths* paths,
              std::map<std::string, std::vector<int>>* bands) {
  const FrameFigures& frame = run.frames[0];
  paths->coordinates = CoordinatesOf(frame);
  std::vector<int> indices;
  for (const std::string& name : paths->coordinates) {
    indices.push_back(CoordinateNamed(paths->model, name, run.name));
  }
  const auto add = [&](const std::string& name, const std::string& muscle) {
    MeasuredPath path;
    path.name = name;
    path.muscle = muscle;
    path.coordinates = CrossedCoordinates(
        paths->model, indices, BodiesOfPath(paths->model, frame, muscle, name));
    paths->paths.push_back(std::move(path));
  };
  const auto beyond = PartsBeyond(run.at_rest, paths->model);
  for (const MuscleFigures& muscle : frame.muscles) {
    if (paths_per_muscle == 0) {
      for (const auto& line : muscle.line_lengths) {
        const bool has_arms = muscle.line_moment_arms.count(line.first) > 0;
        if (!has_arms && paths->model.FindMuscle(line.first) < 0) {
          paths->lines_without_arms.push_back(line.first);
          continue;
        }
        add(line.first, muscle.name);
        const auto part = beyond.find(line.first);
        if (part != beyond.end()) paths->paths.back().beyond = part->second;
      }
      continue;
    }
    const auto lines = std::find_if(
        run.at_rest.begin(), run.at_rest.end(), [&](const auto& one) {
          return one.name == muscle.name;
        });
    if (lines == run.at_rest.end() || lines->fibres.empty()) {
      throw InputError(run.name,
                       "has no fibres of " + muscle.name,
                       "run musclewarp-deform with {fibres}=40");
    }
    const auto of_muscle = FibreBands(lines->fibres, paths_per_muscle);
    for (size_t b = 0; b < of_muscle.size(); ++b) {
      add(muscle.name + "_" + std::to_string(b + 1), muscle.name);
      paths->paths.back().fibres = static_cast<int>(of_muscle[b].size());
      (*bands)[paths->paths.back().name] = of_muscle[b];
    }
  }
}

// The frames of one run.
class FramesOfRun {
 public:
  FramesOfRun(const MeasuredRun& run,
              const std::map<std::string, std::vector<int>>& bands,
              RunPaths* paths)
      : run_(run), bands_(bands), paths_(*paths) {}

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
        PathSample sample = path.fibres > 0
                                ? OfBand(muscle, bands_.at(path.name), field)
                                : OfLine(muscle, path.name, field);
        sample.coordinates = at;
        sample.weight = weight;
        sample.length += path.beyond;
        NoteOtherArms(sample, &path);
        path.samples.push_back(std::move(sample));
      }
      CheckLines(muscle);
    }
    if (found != paths_.paths.size()) FailOtherLines(paths_.paths[found].name);
  }

  // A run with more lines than the first is no run of its scene either.
  void CheckLines(const MuscleFigures& muscle) const {
    if (!bands_.empty()) return;
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

  const MeasuredRun& run_;
  const std::map<std::string, std::vector<int>>& bands_;
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

bool IsInModel(const RunPaths& paths, const MeasuredPath& path) {
  return paths.model.FindMuscle(path.name) >= 0;
}

RunPaths PathsOf(Model model,
                 const std::vector<MeasuredRun>& runs,
                 int paths_per_muscle) {
  CHECK(!runs.empty());
  RunPaths paths;
  paths.model = std::move(model);
  std::map<std::string, std::vector<int>> bands;
  for (const MeasuredRun& run : runs) {
    if (run.frames.empty()) {
      throw InputError(
          run.name, "has no frames", "run musclewarp-deform again");
    }
    CheckContact(run, runs[0]);
    if (&run == &runs[0]) AddPaths(run, paths_per_muscle, &paths, &bands);
    FramesOfRun(run, bands, &paths).Add();
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
