// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/opensim/model.h"

#include <algorithm>

#include "musclewarp/base/short_list.h"

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

// The names in a path, but for "value" at its end.
std::vector<std::string> NamesIn(const std::string& path) {
  std::vector<std::string> names;
  size_t begin = 0;
  for (size_t end = 0; end != std::string::npos; begin = end + 1) {
    end = path.find('/', begin);
    if (end != begin && begin < path.size()) {
      names.push_back(path.substr(begin, end - begin));
    }
  }
  if (names.size() > 1 && names.back() == "value") names.pop_back();
  return names;
}

}  // namespace

int Model::FindBody(const std::string& body) const {
  return Find(bodies, body);
}

int Model::FindCoordinate(const std::string& coordinate) const {
  const int exact = Find(coordinates, coordinate);
  if (exact >= 0) return exact;
  const std::vector<std::string> names = NamesIn(coordinate);
  if (names.size() < 2) return -1;
  const std::string& owner = names[names.size() - 2];
  const int told_apart = Find(coordinates, owner + "/" + names.back());
  return told_apart >= 0 ? told_apart : Find(coordinates, names.back());
}

std::vector<std::string> Model::CoordinatesCalled(
    const std::string& last_name) const {
  std::vector<std::string> called;
  for (const Coordinate& coordinate : coordinates) {
    if (coordinate.name == coordinate.joint + "/" + last_name) {
      called.push_back(coordinate.name);
    }
  }
  return called;
}

std::string WhyNoCoordinate(const Model& model, const std::string& name) {
  const std::vector<std::string> names = NamesIn(name);
  const auto called =
      names.empty() ? names : model.CoordinatesCalled(names.back());
  if (called.empty()) return "is not a coordinate of the model";
  return "is the name of " + std::to_string(called.size()) +
         " coordinates, which are told apart by their joints: " +
         ShortList(called);
}

int Model::FindMuscle(const std::string& muscle) const {
  return Find(muscles, muscle);
}

}  // namespace musclewarp
