// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <string>

namespace musclewarp {

// Expects that the options are valid.
template <typename Options>
void ExpectValid(const Options& options) {
  std::string error;
  EXPECT_TRUE(options.IsValid(&error)) << error;
}

// Expects that the default options, changed by `change`, are refused with
// exactly `message`:
//
//   ExpectRefused<GaussNewtonOptions>(
//       [](auto* options) { options->max_iterations = 0; },
//       "GaussNewtonOptions::max_iterations is 0, allowed: above 0");
template <typename Options, typename Change>
void ExpectRefused(const Change& change, const std::string& message) {
  Options options;
  change(&options);
  std::string error;
  EXPECT_FALSE(options.IsValid(&error)) << "expected: " << message;
  EXPECT_EQ(error, message);
}

}  // namespace musclewarp
