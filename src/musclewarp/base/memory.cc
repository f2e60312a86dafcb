// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/base/memory.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <limits>
#include <string>

#include "musclewarp/base/text.h"

namespace musclewarp {
namespace {

namespace fs = std::filesystem;

constexpr double kUnknown = std::numeric_limits<double>::infinity();

// Returns the number in a file of one number; infinity for "max" and for a file
// that is not there.
double NumberIn(const fs::path& path) {
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
double ReclaimableIn(const fs::path& path) {
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

// Returns what the limit of one control group leaves, by the files of the first
// or the second version of control groups; infinity if it has no limit.
double LeftInGroup(const fs::path& group, bool is_second) {
  const double most =
      NumberIn(group / (is_second ? "memory.max" : "memory.limit_in_bytes"));
  const double used = NumberIn(
      group / (is_second ? "memory.current" : "memory.usage_in_bytes"));
  if (most == kUnknown || used == kUnknown) return kUnknown;
  return std::max(0.0, most - used + ReclaimableIn(group / "memory.stat"));
}

}  // namespace

double LeftInControlGroups(const std::string& root) {
  std::ifstream groups(root + "/proc/self/cgroup");
  double left = kUnknown;
  for (std::string line; std::getline(groups, line);) {
    // "4:memory:/slurm/job_7" or, of the second version, "0::/user.slice".
    const size_t first = line.find(':');
    const size_t second = line.find(':', first + 1);
    if (second == std::string::npos) continue;
    const std::string controllers = line.substr(first + 1, second - first - 1);
    const bool is_second = controllers.empty();
    if (!is_second && controllers != "memory") continue;
    const fs::path mount =
        root + (is_second ? "/sys/fs/cgroup" : "/sys/fs/cgroup/memory");
    // Limits of the groups around it hold as well. A container sees only the
    // innermost, as the mount itself.
    fs::path group = line.substr(second + 1);
    while (group.has_relative_path()) {
      left =
          std::min(left, LeftInGroup(mount / group.relative_path(), is_second));
      group = group.parent_path();
    }
    left = std::min(left, LeftInGroup(mount, is_second));
  }
  return left;
}

std::string MemoryText(double bytes) {
  return FixedText(bytes / kBytesPerGib, 1) + " GiB of memory";
}

double AvailableMemory() {
  return std::min(AvailableInSystem(), LeftInControlGroups(""));
}

}  // namespace musclewarp
