// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <sstream>
#include <string>

#include "musclewarp/page/recorded_run.h"

namespace musclewarp {

// Reads a run, silently.
inline RecordedRun ReadQuietly(const std::string& dir) {
  std::ostringstream log;
  return ReadRecordedRun(dir, log);
}

}  // namespace musclewarp
