// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace musclewarp {

// Returns the number of letters to change, add, remove or swap with their
// neighbour to turn one text into the other (optimal string alignment).
int EditDistance(const std::string& a, const std::string& b);

// Returns the known name that someone who wrote `name` most likely meant: the
// nearest by EditDistance(), without regard to capitals, of several the first.
// Empty if none is near: if more than a third of the letters of `name`, and
// more than one, would have to change. For messages on names that do not exist.
std::string NearName(const std::string& name,
                     const std::vector<std::string>& known);

// Returns "did you mean femur_r? " to stand before an advice, or an empty text
// if no known name is near. `before` stands before the name: "--" for flags.
std::string DidYouMean(const std::string& name,
                       const std::vector<std::string>& known,
                       const std::string& before = "");

}  // namespace musclewarp
