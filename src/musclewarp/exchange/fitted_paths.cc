// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/exchange/fitted_paths.h"

#include <algorithm>
#include <cstdio>

#include "musclewarp/base/input_error.h"
#include "musclewarp/base/parallel_for.h"
#include "musclewarp/base/stopwatch.h"
#include "musclewarp/run/pose_name.h"

namespace musclewarp {
namespace {

using OrderedJson = nlohmann::ordered_json;

constexpr std::uint32_t kSeed = 1;  // of the lines of surveys

// What a function is judged by: errors at its samples where none could be held
// back.
const PathErrors& JudgedErrors(const PathFit& fit) {
  return fit.held_back.length.worst_sample < 0 ? fit.at_samples : fit.held_back;
}

// A function of doubtful samples alone was not judged.
bool IsWithin(const PathFit& fit, const PathBounds& bounds) {
  const PathErrors& errors = JudgedErrors(fit);
  return errors.length.worst_sample >= 0 &&
         errors.length.mean <= bounds.max_length_error &&
         errors.arm.mean <= bounds.max_arm_error &&
         errors.arm.largest <= bounds.largest_arm_error;
}

// Returns the time in which all functions are evaluated once, on the mean over
// the samples.
double MicrosecondsOf(const std::vector<FittedPath>& paths) {
  constexpr int kLeastRounds = 1000;
  std::vector<std::vector<Eigen::VectorXd>> places(paths.size());
  size_t samples = 1;
  for (size_t i = 0; i < paths.size(); ++i) {
    for (const PathSample& sample : paths[i].path->samples) {
      places[i].push_back(sample.coordinates(paths[i].fit.path.coordinates));
    }
    samples = places[i].size();
  }
  const int rounds = std::max<int>(1, kLeastRounds / static_cast<int>(samples));
  PathValue value;
  double sum = 0;
  const Stopwatch stopwatch;
  for (int round = 0; round < rounds; ++round) {
    for (size_t s = 0; s < samples; ++s) {
      for (size_t i = 0; i < paths.size(); ++i) {
        Evaluate(paths[i].fit.path, places[i][s], &value);
        sum += value.length;
      }
    }
  }
  const double count = rounds * static_cast<double>(samples);
  // The sum is used so that the loop is not removed.
  return sum == -1 ? 0 : 1e3 * stopwatch.Milliseconds() / count;
}

OrderedJson Rows(const Eigen::MatrixXi& matrix) {
  OrderedJson rows = OrderedJson::array();
  for (Eigen::Index i = 0; i < matrix.rows(); ++i) {
    OrderedJson row = OrderedJson::array();
    for (Eigen::Index k = 0; k < matrix.cols(); ++k)
      row.push_back(matrix(i, k));
    rows.push_back(row);
  }
  return rows;
}

OrderedJson ErrorJson(const ErrorFigures& figures, const RunPaths& paths) {
  OrderedJson json = {{"mean", figures.mean},
                      {"quantile_95", figures.quantile_95},
                      {"largest", figures.largest}};
  if (figures.worst_sample >= 0) {
    json["worst_frame"] = paths.frames[figures.worst_sample];
  }
  return json;
}

OrderedJson HeldBackJson(const PathFit& fit, const RunPaths& paths) {
  if (fit.held_back.length.worst_sample < 0) return nullptr;
  return {{"length_error_mm", ErrorJson(fit.held_back.length, paths)},
          {"arm_error_mm", ErrorJson(fit.held_back.arm, paths)}};
}

OrderedJson PathJson(const FittedPath& fitted, const RunPaths& paths) {
  const PathFit& fit = fitted.fit;
  const PathFunction& function = fit.path;
  const MeasuredPath& path = *fitted.path;
  OrderedJson names = OrderedJson::array();
  OrderedJson ranges = OrderedJson::object();
  for (Eigen::Index k = 0; k < function.low.size(); ++k) {
    const std::string& name = paths.coordinates[function.coordinates[k]];
    names.push_back(name);
    ranges[name] = {function.low[k], function.high[k]};
  }
  const PathSurvey& survey = fitted.survey;
  return {{"muscle", path.muscle},
          {"fibres", path.fibres.size()},
          {"coordinates", names},
          {"range", ranges},
          {"order", function.exponents.rowwise().sum().maxCoeff()},
          {"terms", function.coefficients.size()},
          {"samples", path.samples.size()},
          {"length_error_max_mm", fit.at_samples.length.largest},
          {"length_error_rms_mm", fit.at_samples.length.rms},
          {"arm_error_max_mm", fit.at_samples.arm.largest},
          {"arm_error_rms_mm", fit.at_samples.arm.rms},
          {"held_back", HeldBackJson(fit, paths)},
          {"within_bounds", fitted.within_bounds},
          {"beyond_muscle_mm", path.beyond.length},
          {"largest_other_arm_mm", path.largest_other_arm},
          {"lines_through_range",
           {{"lines", survey.lines},
            {"jumps", survey.jumps},
            {"with_sign_change", survey.lines_with_sign_change},
            {"most_sign_changes", survey.most_sign_changes},
            {"steepest_arm_mm", survey.steepest}}},
          {"exponents", Rows(function.exponents)},
          {"coefficients_mm",
           std::vector<double>(
               function.coefficients.data(),
               function.coefficients.data() + function.coefficients.size())}};
}

}  // namespace

bool FittedPaths::AreWithinBounds() const {
  return std::all_of(paths.begin(), paths.end(), [](const FittedPath& path) {
    return path.within_bounds;
  });
}

FittedPaths FitPaths(const RunPaths& paths, const PathBounds& bounds) {
  FittedPaths fitted;
  for (const MeasuredPath& path : paths.paths) {
    if (path.coordinates.size() > kMostPathCoordinates) {
      throw InputError(
          "line \"" + path.name + "\"",
          "crosses " + std::to_string(path.coordinates.size()) + " coordinates",
          "functions have at most " + std::to_string(kMostPathCoordinates) +
              "; lock those of the model that do not move");
    }
    if (path.coordinates.empty()) {
      fitted.without_coordinates.push_back(path.name);
    } else {
      fitted.paths.emplace_back().path = &path;
    }
  }
  if (fitted.paths.empty()) {
    throw InputError("{in}",
                     "has no path that crosses a coordinate of its motion",
                     "run a scene whose model has the joints that the muscles "
                     "cross");
  }
  ParallelFor(fitted.paths.size(), [&](size_t i) {
    FittedPath& one = fitted.paths[i];
    one.fit = FitPath(one.path->samples, one.path->coordinates);
    one.survey = SurveyPath(one.fit.path, kSurveyLines, kSeed);
    one.within_bounds = IsWithin(one.fit, bounds);
  });
  fitted.microseconds = MicrosecondsOf(fitted.paths);
  return fitted;
}

OrderedJson FitJson(const RunPaths& paths,
                    const FittedPaths& fitted,
                    const PathBounds& bounds) {
  OrderedJson coordinates = OrderedJson::array();
  for (const std::string& name : paths.coordinates) {
    const Coordinate& coordinate =
        paths.model.coordinates[paths.model.FindCoordinate(name)];
    const std::string unit = UnitInReports(coordinate.kind);
    coordinates.push_back(
        {{"name", name}, {"unit", unit == "degrees" ? "rad" : unit}});
  }
  OrderedJson functions = OrderedJson::object();
  for (const FittedPath& one : fitted.paths) {
    functions[one.path->name] = PathJson(one, paths);
  }
  return {{"max_length_error_mm", bounds.max_length_error},
          {"max_arm_error_mm", bounds.max_arm_error},
          {"largest_arm_error_mm", bounds.largest_arm_error},
          {"within_bounds", fitted.AreWithinBounds()},
          {"coordinates", coordinates},
          {"frames", paths.frames.size()},
          {"frames_left_out", paths.frames_left_out},
          {"frames_doubtful", paths.frames_doubtful},
          {"without_coordinates", fitted.without_coordinates},
          {"microseconds", fitted.microseconds},
          {"muscles", functions}};
}

void PrintFits(const RunPaths& paths,
               const FittedPaths& fitted,
               std::ostream& screen) {
  for (const std::string& frame : paths.frames_left_out) {
    screen << "left out: " << frame << "\n";
  }
  for (const std::string& frame : paths.frames_doubtful) {
    screen << "counts a tenth: " << frame << "\n";
  }
  char line[300];
  for (const FittedPath& one : fitted.paths) {
    const PathErrors& errors = JudgedErrors(one.fit);
    std::snprintf(
        line,
        sizeof line,
        "%-24s order %d, %3d terms of %d coordinates; held back: "
        "length %.2f mm, 95 %% %.2f, largest %.2f; arm %.2f mm, 95 %% "
        "%.2f, largest %.2f; %d jumps, sign changes on %d of %d "
        "lines%s\n",
        one.path->name.c_str(),
        one.fit.path.exponents.rowwise().sum().maxCoeff(),
        static_cast<int>(one.fit.path.coefficients.size()),
        static_cast<int>(one.fit.path.exponents.cols()),
        errors.length.mean,
        errors.length.quantile_95,
        errors.length.largest,
        errors.arm.mean,
        errors.arm.quantile_95,
        errors.arm.largest,
        one.survey.jumps,
        one.survey.lines_with_sign_change,
        one.survey.lines,
        one.within_bounds ? "" : "  ABOVE THE BOUND");
    screen << line;
  }
  for (const std::string& path : fitted.without_coordinates) {
    screen << "warning: the line \"" << path
           << "\" crosses no coordinate that the runs have and has no "
              "function\n";
  }
  const auto beyond = std::count_if(
      paths.paths.begin(), paths.paths.end(), [](const MeasuredPath& path) {
        return path.beyond.length > 0;
      });
  if (beyond > 0) {
    screen << beyond
           << " paths go on beyond their muscles, as through a tendon: these "
              "parts are as long as at rest in all poses\n";
  }
  std::snprintf(line,
                sizeof line,
                "%d functions of %d frames, %d of them doubtful, %d left out; "
                "%.1f microseconds for all lengths and arms\n",
                static_cast<int>(fitted.paths.size()),
                static_cast<int>(paths.frames.size()),
                static_cast<int>(paths.frames_doubtful.size()),
                static_cast<int>(paths.frames_left_out.size()),
                fitted.microseconds);
  screen << line;
}

}  // namespace musclewarp
