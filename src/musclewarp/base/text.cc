// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/base/text.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>

#include "musclewarp/base/angles.h"

namespace musclewarp {

std::string NumberText(double value, int digits) {
  std::ostringstream text;
  text << std::setprecision(digits) << value;
  return text.str();
}

std::string RoundedText(double value, int digits, double body_size) {
  const double smaller = std::max(0.0, -std::log10(body_size));
  std::ostringstream text;
  text << std::fixed
       << std::setprecision(digits + static_cast<int>(std::ceil(smaller)))
       << value;
  return text.str();
}

std::string DegreesText(double angle, int digits) {
  return RoundedText(angle / kRadiansPerDegree, digits) + " degrees";
}

std::string PlaceText(const Eigen::RowVector3d& place, double body_size) {
  const auto text = [&](int axis) {
    return RoundedText(body_size * place[axis], 1, body_size);
  };
  return "(" + text(0) + ", " + text(1) + ", " + text(2) + ")";
}

std::string MeasureText(double value) {
  std::ostringstream text;
  const bool is_long = std::abs(value) >= 999.5 && std::abs(value) < 1e9;
  if (is_long) text << std::fixed;
  text << std::setprecision(is_long ? 0 : 3) << value;
  return text.str();
}

std::string FixedText(double value, int digits) {
  // What is smaller than the last of the further digits is rounding.
  constexpr int kSignificant = 3, kFurther = 5;
  if (std::isfinite(value) &&
      std::abs(value) >= std::pow(10, -(digits + kFurther))) {
    const int first = static_cast<int>(std::floor(std::log10(std::abs(value))));
    digits =
        std::max(digits, std::min(kSignificant - 1 - first, digits + kFurther));
  }
  return RoundedText(value, digits);
}

std::string LengthText(double length, double body_size) {
  return MeasureText(length * body_size) + " mm";
}

std::string BodySizeText(double body_size) {
  return body_size < 1 ? "1/" + MeasureText(1 / body_size) + " of"
                       : MeasureText(body_size) + " times";
}

std::vector<std::string> Split(const std::string& text, char separator) {
  std::vector<std::string> parts;
  std::istringstream stream(text);
  for (std::string part; std::getline(stream, part, separator);) {
    parts.push_back(part);
  }
  return parts;
}

}  // namespace musclewarp
