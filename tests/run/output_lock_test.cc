// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/run/output_lock.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <filesystem>
#include <memory>
#include <string>

#include "musclewarp/base/output_file.h"
#include "support/input_errors.h"
#include "support/temp_dir.h"

namespace musclewarp {
namespace {

namespace fs = std::filesystem;

// Runs `function` in a child process, which then ends without cleaning up.
template <typename Function>
int ExitCodeOfKilledChild(const Function& function) {
  const pid_t child = fork();
  if (child == 0) _exit(function());
  int status = 0;
  waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

TEST(OutputLock, KeepsASecondRunOutAndNamesTheFirst) {
  const std::string out = TestTempDir() + "/out";
  const OutputLock lock(out);
  ExpectInputError([&] { OutputLock second(out); },
                   {"--out=" + out,
                    "another run writes to this folder",
                    "process " + std::to_string(getpid()),
                    "since 2",
                    "run_test",
                    "wait until it has ended, or choose another --out"});
  const OutputLock elsewhere(out + "/below");
}

TEST(OutputLock, KeepsOutOtherProcesses) {
  const std::string out = TestTempDir();
  const auto is_kept_out = [&] {
    try {
      OutputLock second(out);
      return 0;
    } catch (const std::exception&) {
      return 1;
    }
  };
  auto lock = std::make_unique<OutputLock>(out);
  EXPECT_EQ(ExitCodeOfKilledChild(is_kept_out), 1);
  lock.reset();
  EXPECT_EQ(ExitCodeOfKilledChild(is_kept_out), 0);
}

TEST(OutputLock, LeavesNothing) {
  const std::string dir = TestTempDir();
  { const OutputLock lock(dir + "/a/b/"); }
  EXPECT_TRUE(fs::is_empty(dir));
  {
    const OutputLock lock(dir + "/a/b");
    WriteTextAtomically(dir + "/a/result", "");
  }
  EXPECT_TRUE(fs::exists(dir + "/a/result"));
  EXPECT_FALSE(fs::exists(dir + "/a/b"));
  fs::create_directory(dir + "/empty");
  { const OutputLock lock(dir + "/empty"); }
  EXPECT_TRUE(fs::is_empty(dir + "/empty"));
}

TEST(OutputLock, OfAKilledRunKeepsNobodyOut) {
  const std::string out = TestTempDir() + "/out";
  EXPECT_EQ(ExitCodeOfKilledChild([&] {
              new OutputLock(out);
              return 7;
            }),
            7);
  EXPECT_TRUE(fs::exists(out + "/.musclewarp.lock"));
  { const OutputLock lock(out); }
  EXPECT_FALSE(fs::exists(out + "/.musclewarp.lock"));
}

}  // namespace
}  // namespace musclewarp
