// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/base/place_text.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>

namespace musclewarp {
namespace {

// Digits behind the point that show a tenth of a millimetre of a human body.
int DigitsOfBody(double body_size) {
  return 1 + static_cast<int>(std::ceil(std::max(0.0, -std::log10(body_size))));
}

}  // namespace

std::string PlaceText(const Eigen::RowVector3d& place, double body_size) {
  const Eigen::RowVector3d mm = body_size * place;
  std::ostringstream text;
  text << std::fixed << std::setprecision(DigitsOfBody(body_size)) << "("
       << mm.x() << ", " << mm.y() << ", " << mm.z() << ")";
  return text.str();
}

std::string MeasureText(double value) {
  std::ostringstream text;
  const bool is_long = std::abs(value) >= 999.5 && std::abs(value) < 1e9;
  if (is_long) text << std::fixed;
  text << std::setprecision(is_long ? 0 : 3) << value;
  return text.str();
}

std::string FixedText(double value, int digits) {
  constexpr int kSignificant = 3, kMost = 12;
  if (value != 0 && std::isfinite(value)) {
    const int first = static_cast<int>(std::floor(std::log10(std::abs(value))));
    digits = std::max(digits, std::min(kSignificant - 1 - first, kMost));
  }
  std::ostringstream text;
  text << std::fixed << std::setprecision(digits) << value;
  return text.str();
}

std::string LengthText(double length, double body_size) {
  return MeasureText(length * body_size) + " mm";
}

std::string BodySizeText(double body_size) {
  return body_size < 1 ? "1/" + MeasureText(1 / body_size) + " of"
                       : MeasureText(body_size) + " times";
}

}  // namespace musclewarp
