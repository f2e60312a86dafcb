// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/scene/scene_names.h"

#include <gtest/gtest.h>

#include "support/input_errors.h"

namespace musclewarp {
namespace {

void ExpectNoFileName(const std::string& name, const std::string& why) {
  ExpectInputError([&] { CheckFileName("scene.json", "muscle", name); },
                   {"scene.json: ", "muscle", why});
}

TEST(CheckFileName, AcceptsNamesAsPeopleGiveThem) {
  for (const char* name : {"gluteus_medius_r",
                           "m",
                           "M. iliacus (right)",
                           "a.b",
                           "-",
                           "~a",
                           "Ges\xc3\xa4\xc3\x9fmuskel",
                           "a b",
                           "10%"}) {
    EXPECT_NO_THROW(CheckFileName("scene.json", "muscle", name)) << name;
  }
  EXPECT_NO_THROW(
      CheckFileName("scene.json", "muscle", std::string(kLongestName, 'x')));
}

TEST(CheckFileName, RefusesWhatIsNoNameOfAVisibleFile) {
  ExpectNoFileName("a/b", "has a \"/\"");
  ExpectNoFileName(".", "begins with a dot");
  ExpectNoFileName("..", "begins with a dot");
  ExpectNoFileName(".hidden", "begins with a dot");
  ExpectNoFileName(" a", "begins with a blank");
  ExpectNoFileName("a ", "ends with a blank");
  ExpectNoFileName("", "no name");
}

TEST(CheckFileName, RefusesControlCharactersAndShowsThemEscaped) {
  ExpectNoFileName("a\nb", R"("a\nb")");
  ExpectNoFileName("a\tb", R"("a\tb")");
  ExpectNoFileName(std::string("a\0b", 3), R"("a\u0000b")");
  ExpectNoFileName("a\x7f", R"("a\u007f")");
  ExpectNoFileName("\x1b[31m", R"("\u001b[31m")");
}

// Characters in UTF-8, beside their numbers.
TEST(CheckFileName, RefusesWhatBreaksLinesOrIsNotSeen) {
  ExpectNoFileName("a\xc2\x80", "control character (U+0080)");
  ExpectNoFileName("a\xc2\x9f", "control character (U+009F)");
  ExpectNoFileName("a\xe2\x80\xa8", "separator of lines (U+2028)");
  ExpectNoFileName("a\xe2\x80\xa9", "separator of lines (U+2029)");
  ExpectNoFileName("a\xe2\x80\xae", "mark of direction (U+202E)");
  ExpectNoFileName("a\xe2\x81\xa6", "mark of direction (U+2066)");
  ExpectNoFileName("a\xe2\x80\x8b", "character without width (U+200B)");
  ExpectNoFileName(
      "\xef\xbb\xbf"
      "a",
      "character without width (U+FEFF)");
  // A no-break space, joiners as Persian needs them, a letter beyond 16 bits.
  for (const char* name : {"a\xc2\xa0"
                           "b",
                           "\xd9\x85\xdb\x8c\xe2\x80\x8c\xd8\xb1",
                           "\xe2\x80\x8d",
                           "\xf0\x9d\x92\x9c"}) {
    EXPECT_NO_THROW(CheckFileName("scene.json", "muscle", name)) << name;
  }
}

TEST(CheckFileName, RefusesLongNamesByTheirBytes) {
  ExpectNoFileName(std::string(kLongestName + 1, 'x'), "201 bytes");
  std::string umlauts;
  for (int i = 0; i < kLongestName / 2 + 1; ++i) umlauts += "\xc3\xa4";
  ExpectNoFileName(umlauts, "202 bytes");
}

TEST(CheckColumnName, AcceptsWhatOnlyFilesCannotBeCalled) {
  for (const char* name : {"a/b", ".", " a "}) {
    EXPECT_NO_THROW(CheckColumnName("scene.json", "line", name)) << name;
  }
  const std::string longer(kLongestName + 1, 'x');
  ExpectInputError([&] { CheckColumnName("scene.json", "line", longer); },
                   {"line", "201 bytes", "at most 200"});
}

TEST(CheckPrintable, LimitsNoLength) {
  const std::string longer(10000, 'x');
  EXPECT_NO_THROW(CheckPrintable("scene.json", "pose", longer));
  ExpectInputError([&] { CheckPrintable("scene.json", "pose", longer + "\n"); },
                   {"pose", "xxx...", "control character"});
}

}  // namespace
}  // namespace musclewarp
