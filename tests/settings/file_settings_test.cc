// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/settings/file_settings.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/input_errors.h"

namespace musclewarp {
namespace {

using ::testing::ElementsAre;

FrameFileOptions OptionsWith(const std::string& format,
                             const std::string& bones = "every") {
  FileSettings settings;
  settings.format = format;
  settings.bones = bones;
  return OptionsOf(settings);
}

TEST(FileSettings, NameFormatsWithCommas) {
  EXPECT_THAT(OptionsWith("ply").formats, ElementsAre("ply"));
  EXPECT_THAT(OptionsWith("obj,ply").formats, ElementsAre("obj", "ply"));
  EXPECT_EQ(OptionsWith("ply", "once").bones, BoneFiles::kOnce);
}

TEST(FileSettings, RefuseFormatsThatCannotBeWritten) {
  ExpectInputError([] { OptionsWith("stl"); },
                   {"--format=stl", "allowed: ply, obj, vtp"});
  ExpectInputError([] { OptionsWith("ply,stl"); }, {"--format=ply,stl"});
  ExpectInputError([] { OptionsWith(""); }, {"--format=: ", "allowed: ply"});
}

#ifdef MUSCLEWARP_WITH_VTK
TEST(FileSettings, RefuseBonesOnceWithVtpAlone) {
  ExpectInputError([] { OptionsWith("vtp", "once"); },
                   {"--bones=once", "--format=vtp", "--bones=every"});
  EXPECT_TRUE(OptionsWith("vtp,ply", "once").HasFormat("vtp"));
}
#endif

}  // namespace
}  // namespace musclewarp
