// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/program/program.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <map>
#include <string>

#include "support/input_errors.h"
#include "support/temp_dir.h"
#include "tools/run_program.h"

namespace musclewarp {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::MatchesRegex;
using ::testing::Not;

TEST(RunProgram, HelpShowsTheFlagsOfTheProgramAlone) {
  const ProgramRun run = RunCommandLine(MUSCLEWARP_CHECK, "--help");
  EXPECT_EQ(run.exit_code, kExitUsable);
  EXPECT_THAT(run.out,
              AllOf(HasSubstr("usage: musclewarp-check"),
                    HasSubstr("--require_clean"),
                    HasSubstr("--threads=NUMBER"),
                    Not(HasSubstr("logtostderr"))));
}

TEST(RunProgram, ShortHelpLeadsToTheOther) {
  const ProgramRun run = RunCommandLine(MUSCLEWARP_CHECK, "-h");
  EXPECT_EQ(run.exit_code, kExitUsable);
  EXPECT_THAT(run.out,
              AllOf(HasSubstr("usage: musclewarp-check"),
                    HasSubstr("Examples:\n  musclewarp-check "),
                    HasSubstr("--help lists all"),
                    HasSubstr("  --require_clean\n"),
                    Not(HasSubstr("--threads"))));
  EXPECT_EQ(RunCommandLine(MUSCLEWARP_CHECK, "--helpshort").out, run.out);
}

TEST(RunProgram, HelpShowsDefaultsAsOneWritesThem) {
  EXPECT_THAT(RunCommandLine(MUSCLEWARP_DEFORM, "--help").out,
              HasSubstr("follows the size of the body (mm; above 0, at most "
                        "0.5) [0.1]\n"));
}

TEST(RunProgram, SaysItsVersion) {
  const ProgramRun run = RunCommandLine(MUSCLEWARP_CHECK, "--version");
  EXPECT_EQ(run.exit_code, kExitUsable);
  EXPECT_THAT(run.out,
              MatchesRegex("musclewarp-check [0-9.]+ .sources [0-9a-f]+.\n"));
}

TEST(RunProgram, RefusesFlagsItDoesNotKnow) {
  const ProgramRun run = RunCommandLine(MUSCLEWARP_CHECK, "--colour=red");
  EXPECT_EQ(run.exit_code, kExitBadInput);
  EXPECT_EQ(run.errors,
            "musclewarp-check: --colour: is not a flag of this program; --help "
            "lists all flags\n");
}

TEST(RunProgram, NamesTheFlagThatWasMeant) {
  for (const auto& [given, meant] : std::map<std::string, std::string>{
           {"--scen=a.json", "--scene"},
           {"-scnee a.json", "--scene"},
           {"--out a --date-root=b", "--data_root"},
           {"--norezume", "--noresume"}}) {
    const ProgramRun run = RunCommandLine(MUSCLEWARP_DEFORM, given);
    EXPECT_EQ(run.exit_code, kExitBadInput);
    EXPECT_THAT(run.errors, HasSubstr("; did you mean " + meant + "? "))
        << given;
  }
}

// Flags are written in other ways, too: none of them may be refused.
TEST(RunProgram, KnowsFlagsHoweverTheyAreWritten) {
  for (const char* given : {"-require_clean --version",
                            "--require-clean --version",
                            "--norequire_clean --version",
                            "--json --colour --version",
                            "--undefok=colour --colour=red --version",
                            "--version -- --colour"}) {
    EXPECT_EQ(RunCommandLine(MUSCLEWARP_CHECK, given).exit_code, kExitUsable)
        << given;
  }
}

TEST(RunProgram, NamesTheLineOfAFileWithAFlagThatIsNone) {
  const std::string path = TestTempDir() + "/flags";
  std::ofstream(path) << "# of a run\n--gap=1\n--jsn=a\n";
  const ProgramRun run = RunCommandLine(MUSCLEWARP_CHECK, "--flagfile=" + path);
  EXPECT_EQ(run.exit_code, kExitBadInput);
  EXPECT_THAT(run.errors,
              HasSubstr("flags, line 3: --jsn: is not a flag of this program; "
                        "did you mean --json? "));
}

TEST(RunProgram, RefusesValuesOfAnotherType) {
  const ProgramRun run = RunCommandLine(MUSCLEWARP_CHECK, "--threads=many");
  EXPECT_EQ(run.exit_code, kExitBadInput);
  EXPECT_THAT(run.errors, AllOf(HasSubstr("threads"), HasSubstr("many")));
}

TEST(RunProgram, PrintsBadInputUnderItsName) {
  const ProgramRun run = RunCommandLine(MUSCLEWARP_CHECK, "none.ply");
  EXPECT_EQ(run.exit_code, kExitBadInput);
  EXPECT_EQ(run.errors.rfind("musclewarp-check: none.ply: ", 0), 0u)
      << run.errors;
}

// As with a file in a folder that must not be searched.
TEST(RunProgram, NamesAFileThatCannotBeReached) {
  const std::string too_long = std::string(300, 'a') + ".ply";
  const ProgramRun run = RunCommandLine(MUSCLEWARP_CHECK, too_long);
  EXPECT_EQ(run.exit_code, kExitBadInput);
  EXPECT_THAT(run.errors,
              HasSubstr("musclewarp-check: " + too_long + ": cannot be "));
}

TEST(UseThreads, AllowsFromAllCoresToAThousand) {
  for (const int threads : {-1, 1025, 1000000}) {
    ExpectInputError([&] { UseThreads({threads}); },
                     {"--threads: is " + std::to_string(threads) + ";",
                      "allowed: 0 to 1024"});
  }
}

TEST(RefuseArguments, NamesTheFirst) {
  const ProgramRun run = RunCommandLine(MUSCLEWARP_DEFORM, "scene.json more");
  EXPECT_EQ(run.exit_code, kExitBadInput);
  EXPECT_THAT(run.errors,
              AllOf(HasSubstr("scene.json: is not a flag"),
                    HasSubstr("--help"),
                    Not(HasSubstr("more"))));
}

}  // namespace
}  // namespace musclewarp
