// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/anatomy/bone_places.h"

#include <glog/logging.h>

#include <algorithm>
#include <map>
#include <sstream>

#include "musclewarp/anatomy/bone_place_rows.h"

namespace musclewarp {
namespace {

// The rows of all regions of the body, as made by two functions of a table.
template <typename Row>
std::vector<Row> Together(std::vector<Row> rows, const std::vector<Row>& more) {
  rows.insert(rows.end(), more.begin(), more.end());
  return rows;
}

const std::vector<PlaceRow>& PlaceRows() {
  static const auto* rows =
      new std::vector<PlaceRow>(Together(PlaceRowsOfLeg(), PlaceRowsOfArm()));
  return *rows;
}

const std::vector<WholeRow>& WholeRows() {
  static const auto* rows =
      new std::vector<WholeRow>(Together(WholeRowsOfLeg(), WholeRowsOfArm()));
  return *rows;
}

bool Has(const std::vector<BonePlace>& places, const std::string& bone) {
  return std::any_of(places.begin(), places.end(), [&](const BonePlace& place) {
    return place.bone == bone;
  });
}

// A part lies off the axis of its whole: what is seen as plantar from the axis
// of the first metatarsal is plantar and medial from that of the foot.
BonePlace PlaceInWhole(const PlaceRow& place, const WholeRow& whole) {
  const double length = whole.end - whole.begin;
  return {
      whole.whole,
      whole.begin + place.begin * length,
      whole.begin + place.end * length,
      DirectionOfWords(std::string(place.direction) + " " + whole.direction)};
}

}  // namespace

Eigen::Vector3d DirectionOfWords(const std::string& words) {
  static const auto* directions = new std::map<std::string, Eigen::Vector3d>{
      {"anterior", {1, 0, 0}},
      {"palmar", {1, 0, 0}},
      {"posterior", {-1, 0, 0}},
      {"superior", {0, 1, 0}},
      {"inferior", {0, -1, 0}},
      {"plantar", {0, -1, 0}},
      {"lateral", {0, 0, 1}},
      {"medial", {0, 0, -1}},
  };
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  std::istringstream stream(words);
  for (std::string word; stream >> word;) {
    const auto found = directions->find(word);
    CHECK(found != directions->end()) << "no direction: " << word;
    sum += found->second;
  }
  CHECK_GT(sum.norm(), 0) << "no direction: " << words;
  return sum.normalized();
}

Eigen::Vector3d LongAxisOf(const std::string& bone) {
  if (bone == "clavicle") return Eigen::Vector3d::UnitZ();
  for (const char* of_foot : {"talus",
                              "calcaneus",
                              "navicular",
                              "cuboid",
                              "cuneiform",
                              "tarsal",
                              "metatarsal",
                              "toe",
                              "foot"}) {
    if (bone.rfind(of_foot, 0) == 0) return Eigen::Vector3d::UnitX();
  }
  return -Eigen::Vector3d::UnitY();
}

std::vector<BonePlace> PlacesOfLandmark(const std::string& landmark) {
  std::vector<BonePlace> places;
  for (const PlaceRow& row : PlaceRows()) {
    if (row.landmark != landmark) continue;
    places.push_back(
        {row.bone, row.begin, row.end, DirectionOfWords(row.direction)});
  }
  CHECK(!places.empty()) << "no landmark: " << landmark;
  for (const PlaceRow& row : PlaceRows()) {
    if (row.landmark != landmark) continue;
    for (const WholeRow& whole : WholeRows()) {
      if (std::string(row.bone) != whole.part) continue;
      if (!Has(places, whole.whole)) {
        places.push_back(PlaceInWhole(row, whole));
      }
    }
  }
  return places;
}

std::vector<std::string> LandmarkNames() {
  std::vector<std::string> names;
  for (const PlaceRow& row : PlaceRows()) {
    if (std::find(names.begin(), names.end(), row.landmark) == names.end()) {
      names.emplace_back(row.landmark);
    }
  }
  return names;
}

}  // namespace musclewarp
