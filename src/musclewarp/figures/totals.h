// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// What the numbers of muscles and frames come to.

#include <algorithm>
#include <cmath>
#include <vector>

namespace musclewarp {

// Returns the larger number; what is no number is larger than all others.
template <class Number>
Number Larger(Number a, Number b) {
  return b > a || b != b ? b : a;
}

// Returns the largest size of a figure, whatever its sign; 0 of no parts.
//
//   LargestOf(frame.muscles, &MuscleFigures::volume_error)
template <class Part, class Whole, class Number>
Number LargestOf(const std::vector<Part>& parts, Number Whole::*figure) {
  Number largest = 0;
  for (const Part& part : parts) {
    largest = Larger(largest, static_cast<Number>(std::abs(part.*figure)));
  }
  return largest;
}

// Returns the sum of a figure.
template <class Part, class Whole, class Number>
Number SumOf(const std::vector<Part>& parts, Number Whole::*figure) {
  Number sum = 0;
  for (const Part& part : parts) sum += part.*figure;
  return sum;
}

// Returns the upper median of a figure; 0 of no parts.
template <class Part, class Whole>
double MedianOf(const std::vector<Part>& parts, double Whole::*figure) {
  std::vector<double> values;
  for (const Part& part : parts) values.push_back(part.*figure);
  if (values.empty()) return 0;
  const auto middle = values.begin() + values.size() / 2;
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace musclewarp
