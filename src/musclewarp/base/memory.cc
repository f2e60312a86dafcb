// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/base/memory.h"

#include <algorithm>
#include <fstream>
#include <limits>
#include <sstream>
#include <utility>

namespace musclewarp {
namespace {

constexpr double kUnknown = std::numeric_limits<double>::infinity();

// Returns the number in a file of one number; infinity for "max" and for a file
// that is not there.
double NumberIn(const std::string& path) {
  std::ifstream file(path);
  double number = 0;
  return file >> number ? number : kUnknown;
}

double AvailableInSystem() {
  std::ifstream meminfo("/proc/meminfo");
  std::string name;
  double kibibytes = 0;
  std::string unit;
  while (meminfo >> name >> kibibytes && std::getline(meminfo, unit)) {
    if (name == "MemAvailable:") return 1024 * kibibytes;
  }
  return kUnknown;
}

// Returns the bytes of files that the system keeps in memory for a control
// group and gives up when memory is needed.
double ReclaimableIn(const std::string& path) {
  std::ifstream statistics(path);
  std::string name;
  double bytes = 0, reclaimable = 0;
  while (statistics >> name >> bytes) {
    // With and, in the first version, without those of groups within it.
    if (name == "inactive_file" || name == "total_inactive_file") {
      reclaimable = std::max(reclaimable, bytes);
    }
  }
  return reclaimable;
}

// Of the first and the second version of control groups.
double LeftInControlGroup() {
  const std::string second = "/sys/fs/cgroup/memory.";
  const std::string first = "/sys/fs/cgroup/memory/memory.";
  const auto left = [](const std::string& files,
                       const std::string& limit,
                       const std::string& usage) {
    const double most = NumberIn(files + limit), used = NumberIn(files + usage);
    if (most == kUnknown || used == kUnknown) return kUnknown;
    return std::max(0.0, most - used + ReclaimableIn(files + "stat"));
  };
  return std::min(left(second, "max", "current"),
                  left(first, "limit_in_bytes", "usage_in_bytes"));
}

}  // namespace

std::string MemoryText(double bytes) {
  std::ostringstream text;
  text.precision(1);
  text << "about " << std::fixed << bytes / kBytesPerGib << " GiB of memory";
  return text.str();
}

double AvailableMemory() {
  return std::min(AvailableInSystem(), LeftInControlGroup());
}

}  // namespace musclewarp
