// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/studies/literature_score.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "musclewarp/base/infinity.h"

namespace musclewarp {
namespace {

// Studies within this of an angle are about the same angle, degrees.
constexpr double kNearAngle = 7.5;
// A motion reaches an angle to this, degrees.
constexpr double kSameAngle = 0.1;
// The width of a band beyond what was measured.
constexpr double kWidening = 0.1;
constexpr double kSingleStudy = 0.3;
// A change below this is none, and an arm below it has no sign, mm.
constexpr double kNoChange = 3;

// An arm at an angle, with the signs of the measured coordinate.
struct ArmAt {
  double angle_deg, arm_mm;
};

// The arms of a muscle over a coordinate, ascending by angle.
using ArmCurve = std::vector<ArmAt>;

double Interpolated(const ArmCurve& curve, double angle) {
  if (angle <= curve.front().angle_deg) return curve.front().arm_mm;
  for (size_t i = 1; i < curve.size(); ++i) {
    const ArmAt &a = curve[i - 1], &b = curve[i];
    if (angle > b.angle_deg) continue;
    const double width = b.angle_deg - a.angle_deg;
    const double share = width > 0 ? (angle - a.angle_deg) / width : 0;
    return a.arm_mm + share * (b.arm_mm - a.arm_mm);
  }
  return curve.back().arm_mm;
}

const MuscleFigures& Named(const FrameFigures& frame,
                           const std::string& muscle) {
  return *std::find_if(frame.muscles.begin(),
                       frame.muscles.end(),
                       [&](const auto& other) { return other.name == muscle; });
}

// Returns the mean arm of the lines of a muscle in a frame, or nothing if it
// has none about the coordinate.
std::optional<double> MeanArm(const FrameFigures& frame,
                              const MuscleFigures& muscle,
                              const std::string& coordinate,
                              ArmKind kind) {
  double sum = 0;
  int count = 0;
  for (const auto& [line, length] : muscle.path_lengths) {
    const auto& arms = kind == ArmKind::kPath ? frame.path_moment_arms
                                              : muscle.line_moment_arms;
    const auto of_line = arms.find(line);
    if (of_line == arms.end()) continue;
    const auto arm = of_line->second.find(coordinate);
    // Without an entry nothing that the line depends on moves.
    sum += arm == of_line->second.end() ? 0 : arm->second;
    ++count;
  }
  if (count == 0) return std::nullopt;
  return sum / count;
}

ArmCurve CurveOf(const std::vector<FrameFigures>& frames,
                 const std::string& muscle,
                 const ArmPlace& place,
                 ArmKind kind) {
  const double sign = place.turned ? -1 : 1;
  ArmCurve curve;
  for (const FrameFigures& frame : frames) {
    const auto angle = frame.coordinates.find(place.coordinate);
    const auto arm =
        MeanArm(frame, Named(frame, muscle), place.coordinate, kind);
    if (angle == frame.coordinates.end() || !arm) continue;
    curve.push_back({sign * angle->second, sign * *arm});
  }
  std::sort(curve.begin(), curve.end(), [](const ArmAt& a, const ArmAt& b) {
    return a.angle_deg < b.angle_deg;
  });
  return curve;
}

// The series of a study: one method and condition, ascending by angle.
using Studies = std::map<std::string, ArmCurve>;

Studies StudiesOf(const std::vector<const MeasuredArm*>& arms) {
  Studies studies;
  for (const MeasuredArm* arm : arms) {
    studies[arm->source + "; " + arm->method + "; " + arm->condition].push_back(
        {*arm->angle_deg, arm->arm_mm});
  }
  for (auto& [name, curve] : studies) {
    std::sort(curve.begin(), curve.end(), [](const ArmAt& a, const ArmAt& b) {
      return a.angle_deg < b.angle_deg;
    });
  }
  return studies;
}

// Returns the band around an angle.
std::pair<double, double> BandAt(double angle,
                                 const std::vector<const MeasuredArm*>& arms) {
  double low = kInfinity, high = -kInfinity;
  std::set<std::string> studies;
  for (const MeasuredArm* arm : arms) {
    if (std::abs(*arm->angle_deg - angle) > kNearAngle) continue;
    low = std::min(low, arm->arm_mm);
    high = std::max(high, arm->arm_mm);
    studies.insert(arm->source);
  }
  const double widening = studies.size() > 1 ? kWidening : kSingleStudy;
  return {low - widening * std::abs(low), high + widening * std::abs(high)};
}

std::optional<bool> TrendOf(const ArmCurve& curve, const Studies& studies) {
  int found = 0, as_run = 0;
  for (const auto& [name, series] : studies) {
    const ArmAt &first = series.front(), &last = series.back();
    const double change = last.arm_mm - first.arm_mm;
    if (std::abs(change) < kNoChange) continue;
    const double of_run = Interpolated(curve, last.angle_deg) -
                          Interpolated(curve, first.angle_deg);
    ++found;
    as_run += (of_run > 0) == (change > 0);
  }
  if (found == 0) return std::nullopt;
  return 2 * as_run > found;
}

ArmVerdict VerdictOf(const ArmCurve& curve,
                     const std::vector<const MeasuredArm*>& arms) {
  ArmVerdict verdict;
  verdict.low_mm = kInfinity;
  verdict.high_mm = -kInfinity;
  verdict.has_sign = true;
  int inside = 0;
  for (const MeasuredArm* measured : arms) {
    const double angle = *measured->angle_deg;
    const double arm = Interpolated(curve, angle);
    verdict.low_mm = std::min(verdict.low_mm, arm);
    verdict.high_mm = std::max(verdict.high_mm, arm);
    const auto [low, high] = BandAt(angle, arms);
    inside += low <= arm && arm <= high;
    const bool is_signed = low > kNoChange || high < -kNoChange;
    if (is_signed && (arm > 0) != (low > 0)) verdict.has_sign = false;
  }
  verdict.inside =
      static_cast<double>(inside) / static_cast<double>(arms.size());
  verdict.has_trend = TrendOf(curve, StudiesOf(arms));
  return verdict;
}

ScoredMuscle Score(const std::string& muscle,
                   const ArmPlace& place,
                   const std::vector<const MeasuredArm*>& arms,
                   const std::vector<FrameFigures>& frames) {
  ScoredMuscle scored;
  scored.muscle = muscle;
  scored.measured = arms[0]->muscle;
  scored.coordinate = place.coordinate;
  scored.turned = place.turned;
  scored.values = static_cast<int>(arms.size());
  std::set<std::string> studies;
  scored.first_deg = scored.measured_low_mm = kInfinity;
  scored.last_deg = scored.measured_high_mm = -kInfinity;
  for (const MeasuredArm* arm : arms) {
    studies.insert(arm->source);
    scored.first_deg = std::min(scored.first_deg, *arm->angle_deg);
    scored.last_deg = std::max(scored.last_deg, *arm->angle_deg);
    scored.measured_low_mm = std::min(scored.measured_low_mm, arm->arm_mm);
    scored.measured_high_mm = std::max(scored.measured_high_mm, arm->arm_mm);
  }
  scored.studies = static_cast<int>(studies.size());
  scored.path = VerdictOf(CurveOf(frames, muscle, place, ArmKind::kPath), arms);
  scored.carried =
      VerdictOf(CurveOf(frames, muscle, place, ArmKind::kCarried), arms);
  return scored;
}

}  // namespace

std::vector<ScoredMuscle> ScoreArms(const MeasuredArms& measured,
                                    const ArmsOfRun& run,
                                    const std::vector<FrameFigures>& frames) {
  // By muscle, coordinate and name in the table, in the order of the run.
  using Key = std::pair<std::string, std::string>;
  std::vector<ScoredMuscle> scored;
  for (const std::string& muscle : run.muscles) {
    std::map<Key, std::pair<ArmPlace, std::vector<const MeasuredArm*>>> found;
    for (const MeasuredArm& arm : measured.arms) {
      const auto place = PlaceOf(arm, run);
      if (!place || !arm.angle_deg || arm.condition == "MVC" ||
          std::count(place->muscles.begin(), place->muscles.end(), muscle) ==
              0) {
        continue;
      }
      const ArmCurve curve = CurveOf(frames, muscle, *place, ArmKind::kPath);
      if (curve.size() < 2 ||
          *arm.angle_deg < curve.front().angle_deg - kSameAngle ||
          *arm.angle_deg > curve.back().angle_deg + kSameAngle) {
        continue;
      }
      auto& group = found[{place->coordinate, arm.muscle}];
      group.first = *place;
      group.second.push_back(&arm);
    }
    for (const auto& [key, group] : found) {
      scored.push_back(Score(muscle, group.first, group.second, frames));
    }
  }
  return scored;
}

}  // namespace musclewarp
