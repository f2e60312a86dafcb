// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

namespace musclewarp {

// A place of a landmark; rows with the same landmark are alternatives.
struct PlaceRow {
  const char* landmark;
  const char* bone;
  double begin;
  double end;
  const char* direction;  // words for DirectionOfWords()
};

// Where a bone lies in a mesh of several bones.
struct WholeRow {
  const char* part;
  const char* whole;
  double begin;           // of the part, along the whole
  double end;             // of the part, along the whole
  const char* direction;  // of the part, from the axis of the whole; or ""
};

// The tables of the lower and of the upper limb with the trunk.
std::vector<PlaceRow> PlaceRowsOfLeg();
std::vector<PlaceRow> PlaceRowsOfArm();
std::vector<WholeRow> WholeRowsOfLeg();
std::vector<WholeRow> WholeRowsOfArm();

}  // namespace musclewarp
