// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/opensim/model.h"

#include <algorithm>

namespace musclewarp {
namespace {

template <typename Named>
int Find(const std::vector<Named>& items, const std::string& name) {
  const auto found =
      std::find_if(items.begin(), items.end(), [&](const Named& item) {
        return item.name == name;
      });
  return found == items.end() ? -1 : static_cast<int>(found - items.begin());
}

}  // namespace

int Model::FindBody(const std::string& body) const {
  return Find(bodies, body);
}

int Model::FindCoordinate(const std::string& coordinate) const {
  return Find(coordinates, coordinate);
}

int Model::FindMuscle(const std::string& muscle) const {
  return Find(muscles, muscle);
}

}  // namespace musclewarp
