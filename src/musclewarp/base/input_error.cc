// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/base/input_error.h"

#include "musclewarp/base/setting_names.h"

namespace musclewarp {

InputError::InputError(const std::string& where,
                       const std::string& problem,
                       const std::string& advice)
    : std::runtime_error(
          WithFieldNames(where + ": " + problem + "; " + advice)),
      where_(std::make_shared<const std::string>(where)),
      problem_(std::make_shared<const std::string>(problem)),
      advice_(std::make_shared<const std::string>(advice)) {}

std::string InputError::WithFlags() const {
  return musclewarp::WithFlags(where() + ": " + problem() + "; " + advice());
}

}  // namespace musclewarp
