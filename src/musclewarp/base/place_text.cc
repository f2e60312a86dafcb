// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/base/place_text.h"

#include <iomanip>
#include <sstream>

namespace musclewarp {

std::string PlaceText(const Eigen::RowVector3d& place) {
  std::ostringstream text;
  text << std::fixed << std::setprecision(1) << "(" << place.x() << ", "
       << place.y() << ", " << place.z() << ")";
  return text.str();
}

std::string MeasureText(double value) {
  std::ostringstream text;
  text << std::setprecision(3) << value;
  return text.str();
}

}  // namespace musclewarp
