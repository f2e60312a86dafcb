// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "musclewarp/base/input_error.h"

namespace musclewarp {

// Expects that `read` throws an InputError whose message has all the words,
// with settings named as fields or as flags.
template <typename Read>
void ExpectInputError(const Read& read, const std::vector<std::string>& words) {
  try {
    read();
    ADD_FAILURE() << "nothing was refused; expected: " << words[0];
  } catch (const InputError& error) {
    for (const std::string& word : words) {
      EXPECT_THAT(error.what() + ("\n" + error.WithFlags()),
                  ::testing::HasSubstr(word));
    }
  }
}

}  // namespace musclewarp
