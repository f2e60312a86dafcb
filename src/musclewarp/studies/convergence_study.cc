// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/studies/convergence_study.h"

#include <glog/logging.h>

#include <algorithm>
#include <cmath>

namespace musclewarp {
namespace {

// Returns true if `a` is coarser than `b`.
bool IsCoarser(StudyKind kind,
               const Discretisation& a,
               const Discretisation& b) {
  const double difference = ValueOf(kind, a) - ValueOf(kind, b);
  return kind == StudyKind::kSpacing ? difference > 0 : difference < 0;
}

ConvergenceStudy SortedStudy(StudyKind kind,
                             std::vector<Discretisation> discretisations) {
  std::sort(discretisations.begin(),
            discretisations.end(),
            [&](const Discretisation& a, const Discretisation& b) {
              return IsCoarser(kind, a, b);
            });
  discretisations.erase(
      std::unique(discretisations.begin(), discretisations.end()),
      discretisations.end());
  return {kind, std::move(discretisations)};
}

// Adds the study of a field if it has values.
template <typename Value>
void AddStudy(StudyKind kind,
              const std::vector<Value>& values,
              Value Discretisation::*field,
              const Discretisation& as_set,
              std::vector<ConvergenceStudy>* studies) {
  if (values.empty()) return;
  std::vector<Discretisation> discretisations = {as_set};
  for (const Value& value : values) {
    discretisations.push_back(as_set);
    discretisations.back().*field = value;
  }
  studies->push_back(SortedStudy(kind, std::move(discretisations)));
}

const DiscretisationResult& ResultOf(
    const Discretisation& discretisation,
    const std::vector<DiscretisationResult>& results) {
  const auto found = std::find_if(
      results.begin(), results.end(), [&](const DiscretisationResult& result) {
        return result.discretisation == discretisation;
      });
  CHECK(found != results.end()) << "no result of a discretisation";
  return *found;
}

// Returns the largest difference between moment arms of the same line about the
// same coordinate.
std::optional<double> LargestArmDifference(const DiscretisedMuscle& muscle,
                                           const DiscretisedMuscle& finest) {
  std::optional<double> largest;
  for (const auto& [line, arms] : muscle.moment_arms) {
    const auto found = finest.moment_arms.find(line);
    if (found == finest.moment_arms.end()) continue;
    for (const auto& [coordinate, arm] : arms) {
      const auto other = found->second.find(coordinate);
      if (other == found->second.end()) continue;
      largest = std::max(largest.value_or(0), std::abs(arm - other->second));
    }
  }
  return largest;
}

void CompareWith(const DiscretisedMuscle& finest,
                 const DiscretisedMuscle& muscle,
                 ConvergenceRow* row) {
  row->coarse_vertices = muscle.coarse_vertices;
  row->samples = muscle.samples;
  row->fine_vertices = muscle.fine_vertices;
  row->is_reconstructed = muscle.is_reconstructed;
  row->rest_distance = muscle.rest_distance;
  const Eigen::VectorXd distances =
      (muscle.displacements - finest.displacements).rowwise().norm();
  row->largest_distance = distances.maxCoeff();
  row->mean_distance = distances.mean();
  row->volume_ratio = muscle.volume_ratio;
  row->stretch = muscle.stretch;
  row->moment_arm_difference = LargestArmDifference(muscle, finest);
}

}  // namespace

std::string ToString(StudyKind kind) {
  switch (kind) {
    case StudyKind::kVertices:
      return "vertices";
    case StudyKind::kSpacing:
      return "spacing";
    case StudyKind::kDensity:
      break;
  }
  return "density";
}

double ValueOf(StudyKind kind, const Discretisation& discretisation) {
  switch (kind) {
    case StudyKind::kVertices:
      return discretisation.coarse_vertices;
    case StudyKind::kSpacing:
      return discretisation.sample_spacing;
    case StudyKind::kDensity:
      break;
  }
  return discretisation.density;
}

std::vector<ConvergenceStudy> StudiesOf(const StudyValues& values,
                                        const Discretisation& as_set) {
  std::vector<ConvergenceStudy> studies;
  AddStudy(StudyKind::kVertices,
           values.vertices,
           &Discretisation::coarse_vertices,
           as_set,
           &studies);
  AddStudy(StudyKind::kSpacing,
           values.spacings,
           &Discretisation::sample_spacing,
           as_set,
           &studies);
  AddStudy(StudyKind::kDensity,
           values.densities,
           &Discretisation::density,
           as_set,
           &studies);
  return studies;
}

std::vector<Discretisation> AllDiscretisations(
    const std::vector<ConvergenceStudy>& studies,
    const Discretisation& as_set) {
  std::vector<Discretisation> all = {as_set};
  for (const ConvergenceStudy& study : studies) {
    for (const Discretisation& discretisation : study.discretisations) {
      if (std::find(all.begin(), all.end(), discretisation) == all.end()) {
        all.push_back(discretisation);
      }
    }
  }
  return all;
}

std::vector<ConvergenceRow> RowsOf(
    const ConvergenceStudy& study,
    const std::vector<DiscretisationResult>& results,
    const Discretisation& as_set,
    const StudiedFrames& studied) {
  const DiscretisationResult* finest = nullptr;
  for (const Discretisation& discretisation : study.discretisations) {
    const DiscretisationResult& result = ResultOf(discretisation, results);
    if (result.failure.empty()) finest = &result;
  }
  std::vector<ConvergenceRow> rows;
  for (const Discretisation& discretisation : study.discretisations) {
    const DiscretisationResult& result = ResultOf(discretisation, results);
    ConvergenceRow row;
    row.study = study.kind;
    row.value = ValueOf(study.kind, discretisation);
    row.is_as_set = discretisation == as_set;
    row.is_finest = &result == finest;
    row.failure = result.failure;
    if (!row.failure.empty()) rows.push_back(row);
    for (size_t i = 0; i < result.frames.size(); ++i) {
      const DiscretisedFrame& frame = result.frames[i];
      row.frame = studied.frames[i];
      row.pose = studied.poses[i];
      row.ms = frame.ms;
      row.is_usable = frame.is_usable;
      for (size_t m = 0; m < frame.muscles.size(); ++m) {
        row.muscle = studied.muscles[m];
        CompareWith(finest->frames[i].muscles[m], frame.muscles[m], &row);
        rows.push_back(row);
      }
    }
  }
  return rows;
}

}  // namespace musclewarp
