// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/base/child_process.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <csignal>
#include <filesystem>

#include "musclewarp/base/output_file.h"
#include "support/input_errors.h"
#include "support/temp_dir.h"

namespace musclewarp {
namespace {

using ::testing::HasSubstr;

ChildResult RunShell(const std::string& script, double timeout_s = 60) {
  return RunChild({"/bin/sh", "-c", script}, TestTempDir(), timeout_s);
}

TEST(FindProgram, LooksInThePath) {
  EXPECT_NE(FindProgram("sh"), "");
  EXPECT_EQ(FindProgram("no-such-program-of-musclewarp"), "");
  EXPECT_EQ(FindProgram(""), "");
  EXPECT_EQ(FindProgram("/bin/sh"), "/bin/sh");
  EXPECT_EQ(FindProgram("/etc/passwd"), "");          // not to be executed
  EXPECT_EQ(FindProgram(std::string(300, 'a')), "");  // longer than names are
}

TEST(RunChild, GivesExitCodeAndOutput) {
  const ChildResult fine = RunShell("echo one; echo two >&2");
  EXPECT_TRUE(fine.IsFine());
  EXPECT_EQ(fine.output, "one\ntwo\n");
  const ChildResult failed = RunShell("echo no licence; exit 7");
  EXPECT_FALSE(failed.IsFine());
  EXPECT_EQ(failed.exit_code, 7);
  EXPECT_EQ(failed.Text(),
            "ended with exit code 7, having said \"no licence\"");
}

TEST(RunChild, RunsInItsFolder) {
  const std::string dir = TestTempDir();
  RunChild({"/bin/sh", "-c", "echo here > file"}, dir, 60);
  EXPECT_TRUE(std::filesystem::exists(dir + "/file"));
}

TEST(RunChild, SaysHowAProgramWasKilled) {
  const ChildResult killed = RunShell("kill -SEGV $$");
  EXPECT_EQ(killed.signal, SIGSEGV);
  EXPECT_THAT(killed.Text(), HasSubstr("was killed by signal 11"));
}

TEST(RunChild, StopsWhatTakesTooLong) {
  const ChildResult slow = RunShell("exec sleep 300", 0.05);
  EXPECT_TRUE(slow.timed_out);
  EXPECT_FALSE(slow.IsFine());
  EXPECT_EQ(slow.Text(), "ran out of time");
}

TEST(RunChild, WhatCannotBeStartedIsNamed) {
  ExpectInputError([] { RunChild({"/no/such/program"}, TestTempDir(), 60); },
                   {"/no/such/program", "cannot be started"});
}

}  // namespace
}  // namespace musclewarp
