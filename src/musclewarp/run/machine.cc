// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/run/machine.h"

#include <fstream>
#include <thread>

#include "musclewarp/base/threads.h"

namespace musclewarp {

Machine ThisMachine() {
  Machine machine;
  machine.processor = "unknown";
  machine.cores = static_cast<int>(std::thread::hardware_concurrency());
  machine.threads = NumThreads();
  std::ifstream cpuinfo("/proc/cpuinfo");
  std::string line;
  while (std::getline(cpuinfo, line)) {
    const size_t colon = line.find(": ");
    if (line.rfind("model name", 0) == 0 && colon != std::string::npos) {
      machine.processor = line.substr(colon + 2);
      break;
    }
  }
  return machine;
}

}  // namespace musclewarp
