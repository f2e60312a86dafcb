// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <string>
#include <vector>

#include "musclewarp/opensim/model.h"
#include "musclewarp/opensim/osim_xml.h"
#include "support/input_errors.h"
#include "support/osim_models.h"

namespace musclewarp {

// The index of the shank among the bodies of the models of osim_models.h.
constexpr int kShank = 2;

// Rounding of transforms of some hundred mm.
constexpr double kTransformRounding = 1e-12;

inline void ExpectNear(const Eigen::Matrix4d& a, const Eigen::Matrix4d& b) {
  EXPECT_LT((a - b).cwiseAbs().maxCoeff(), kTransformRounding) << a << "\n\n"
                                                               << b;
}

// Reads the text of a model from a file "leg.osim" of the running test.
inline Model ReadText(const std::string& text) {
  return ReadModel(Written("leg.osim", text));
}

// Expects that the text of a model is refused by a message that has the words
// and the name of the file.
inline void ExpectRefused(const std::string& text,
                          std::vector<std::string> words) {
  words.push_back("leg.osim");
  ExpectInputError([&] { ReadText(text); }, words);
}

// The XML of a single element, as that of a file "part.osim".
inline OsimXml Xml(const std::string& element) {
  return OsimXml(element, "part.osim");
}

// A model of OpenSim 4 whose shank turns about a pin with the coordinate "q".
inline std::string PinModel() { return Model4(Joint4("PinJoint", "q")); }

// The same with a muscle from the thigh to `point`.
inline std::string PinModelWithPoint(const std::string& point) {
  return Model4(Joint4("PinJoint", "q"),
                "",
                Muscle("m", Point4("p1", "thigh", "0 0 0") + point));
}

}  // namespace musclewarp
