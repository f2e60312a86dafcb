// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/scene/length_unit.h"

#include <cmath>
#include <sstream>

#include "musclewarp/base/input_error.h"

namespace musclewarp {
namespace {

struct LengthUnit {
  const char* symbol;
  const char* name;
  double millimetres;
};
constexpr LengthUnit kUnits[] = {
    {"mm", "millimetres", 1}, {"cm", "centimetres", 10}, {"m", "metres", 1000}};

constexpr double kShortest = 1, kLongest = 2e4;          // mm
constexpr double kSmallest = 0.05, kLargest = 2e10;      // mm^3
constexpr double kLikelyShort = 10, kLikelyLong = 1000;  // mm, of people

}  // namespace

std::optional<double> MillimetresPer(const std::string& unit) {
  for (const LengthUnit& known : kUnits) {
    if (unit == known.symbol) return known.millimetres;
  }
  return std::nullopt;
}

void CheckMuscleSize(const std::string& where,
                     double diagonal,
                     std::optional<double> volume,
                     double mm_per_unit) {
  const double size = volume ? std::abs(*volume) : kSmallest;
  if (diagonal >= kShortest && diagonal <= kLongest && size >= kSmallest &&
      size <= kLargest) {
    return;
  }
  std::ostringstream problem;
  problem.precision(3);
  problem << "is " << diagonal << " mm across";
  if (volume) problem << " and holds " << size << " mm3";
  problem << ", which no muscle does";
  std::string likely;
  for (const LengthUnit& unit : kUnits) {
    const double across = diagonal / mm_per_unit * unit.millimetres;
    if (unit.millimetres == mm_per_unit || across < kLikelyShort ||
        across > kLikelyLong) {
      continue;
    }
    likely += (likely.empty() ? "" : " or ") + std::string(unit.name);
  }
  if (!likely.empty()) problem << ": is it in " << likely << "?";
  throw InputError(
      where,
      problem.str(),
      std::string("state the unit of the mesh (units: ") + kLengthUnits + ")");
}

}  // namespace musclewarp
