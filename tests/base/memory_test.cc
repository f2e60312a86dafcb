// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/base/memory.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <limits>
#include <string>

#include "musclewarp/base/output_file.h"
#include "support/temp_dir.h"

namespace musclewarp {
namespace {

TEST(AvailableMemory, IsSomeOfWhatTheMachineHas) {
  const double all = static_cast<double>(sysconf(_SC_PHYS_PAGES)) *
                     static_cast<double>(sysconf(_SC_PAGE_SIZE));
  EXPECT_LT(AvailableMemory(), all);
  EXPECT_GT(AvailableMemory(), 0.01 * kBytesPerGib);  // or no test would run
}

void WriteUnder(const std::string& root,
                const std::string& path,
                const std::string& text) {
  const std::filesystem::path file = root + path;
  std::filesystem::create_directories(file.parent_path());
  WriteTextAtomically(file.string(), text);
}

TEST(LeftInControlGroups, TakesTheLeastOfAGroupAndThoseAroundIt) {
  const std::string root = TestTempDir();
  WriteUnder(root, "/proc/self/cgroup", "0::/slurm/job_7\n");
  const std::string groups = "/sys/fs/cgroup/slurm";
  WriteUnder(root, groups + "/job_7/memory.max", "max\n");
  WriteUnder(root, groups + "/job_7/memory.current", "300\n");
  EXPECT_EQ(LeftInControlGroups(root), std::numeric_limits<double>::infinity());
  WriteUnder(root, groups + "/memory.max", "5000\n");
  WriteUnder(root, groups + "/memory.current", "1000\n");
  EXPECT_EQ(LeftInControlGroups(root), 4000);
  WriteUnder(root, groups + "/job_7/memory.max", "2000\n");
  EXPECT_EQ(LeftInControlGroups(root), 1700);
  // Files that are kept in memory are given up when memory is needed.
  WriteUnder(root,
             groups + "/job_7/memory.stat",
             "anon 100\ninactive_file 150\nactive_file 20\n");
  EXPECT_EQ(LeftInControlGroups(root), 1850);
}

TEST(LeftInControlGroups, ReadsTheFirstVersionAndContainers) {
  const std::string root = TestTempDir();
  WriteUnder(root,
             "/proc/self/cgroup",
             "5:cpu,cpuacct:/docker/ab\n4:memory:/docker/ab\n");
  // A container has no folder of that name, but its group as the mount.
  const std::string mount = "/sys/fs/cgroup/memory";
  WriteUnder(root, mount + "/memory.limit_in_bytes", "900\n");
  WriteUnder(root, mount + "/memory.usage_in_bytes", "1000\n");
  EXPECT_EQ(LeftInControlGroups(root), 0);
}

}  // namespace
}  // namespace musclewarp
