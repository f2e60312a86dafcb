// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/program/help.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>
#include <string>
#include <vector>

namespace musclewarp {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

const ProgramText kHelpText = {
    "paint FILE [flags]\n\nPaints.\nExit code: 0 painted.",
    {{"paint --ink=red wall", "paints a wall"}},
    {"ink"}};

std::vector<ProgramFlag> FlagsOfPaint() {
  std::vector<ProgramFlag> flags(3);
  flags[0].name = "thick";
  flags[0].heading = "Brush";
  flags[1].name = "ink";
  flags[1].heading = "Paint";
  flags[1].value = "TEXT";
  flags[1].choices = {{"red", "blue"}, /*takes_several=*/true};
  flags[2].name = "water";
  flags[2].heading = "Paint";
  flags[2].value = "NUMBER";
  flags[2].default_value = "2";
  return flags;
}

std::string HelpText() {
  std::ostringstream out;
  PrintHelp(kHelpText, FlagsOfPaint(), out);
  return out.str();
}

// Each flag stands once, so that what is made of the help needs no rule for
// flags that come again.
TEST(Help, HasEachFlagOnceUnderItsHeading) {
  const std::string text = HelpText();
  EXPECT_THAT(text,
              HasSubstr("\nMost used:\n  --ink=red|blue,...\n      \n"
                        "\nBrush:\n  --thick\n      \n"
                        "\nPaint:\n  --water=NUMBER\n       [2]\n"));
  EXPECT_EQ(text.find("--ink=red|blue"), text.rfind("--ink=red|blue"));
}

TEST(Help, BeginsAsTheShortOneDoes) {
  std::ostringstream out;
  PrintShortHelp(kHelpText, FlagsOfPaint(), out);
  const std::string most_used = "\nMost used";
  const std::string start = out.str().substr(0, out.str().find(most_used));
  EXPECT_EQ(HelpText().substr(0, start.size()), start);
  EXPECT_THAT(start,
              HasSubstr("  paint --ink=red wall\n      paints a wall\n"));
  EXPECT_THAT(out.str(),
              AllOf(HasSubstr("--help lists all 3"),
                    HasSubstr("--ink"),
                    Not(HasSubstr("--water"))));
}

TEST(HelpDeathTest, RefusesMainFlagsThatAreNone) {
  std::ostringstream out;
  EXPECT_DEATH(PrintShortHelp(kHelpText, {}, out), "no flag --ink");
}

// Arguments after "--" are files, whatever they look like.
TEST(AsksForHelp, LooksAtFlagsOnly) {
  const auto asks = [](std::vector<std::string> words) {
    std::vector<char*> arguments;
    for (std::string& word : words) arguments.push_back(word.data());
    const int count = static_cast<int>(arguments.size());
    return (AsksForHelp(count, arguments.data()) ? "all" : "") +
           std::string(AsksForShortHelp(count, arguments.data()) ? "short"
                                                                 : "");
  };
  EXPECT_EQ(asks({"paint", "wall", "--help"}), "all");
  EXPECT_EQ(asks({"paint", "-h"}), "short");
  EXPECT_EQ(asks({"paint", "--helpshort"}), "short");
  EXPECT_EQ(asks({"--help", "help", "--", "--help", "-h"}), "");
}

}  // namespace
}  // namespace musclewarp
