// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/base/base64.h"

#include <gtest/gtest.h>

#include <random>
#include <string>

namespace musclewarp {
namespace {

// The examples of RFC 4648, section 10, and bytes above 127.
TEST(Base64, EncodesAsInTheRfc) {
  EXPECT_EQ(EncodeBase64(""), "");
  EXPECT_EQ(EncodeBase64("f"), "Zg==");
  EXPECT_EQ(EncodeBase64("fo"), "Zm8=");
  EXPECT_EQ(EncodeBase64("foo"), "Zm9v");
  EXPECT_EQ(EncodeBase64("foob"), "Zm9vYg==");
  EXPECT_EQ(EncodeBase64("fooba"), "Zm9vYmE=");
  EXPECT_EQ(EncodeBase64("foobar"), "Zm9vYmFy");
  EXPECT_EQ(EncodeBase64("\xff\xfe\xfd"), "//79");
}

TEST(Base64, DecodesWhatItEncoded) {
  std::mt19937 random(1);
  std::string bytes;
  for (int size = 0; size < 100; ++size) {
    EXPECT_EQ(DecodeBase64(EncodeBase64(bytes)), bytes) << size;
    bytes += static_cast<char>(random());
  }
}

TEST(Base64, DecodesEncodingsInARow) {
  EXPECT_EQ(DecodeBase64("Zg==Zm8=Zm9v"), "ffofoo");
}

TEST(Base64, SkipsBlanksBetweenCharacters) {
  EXPECT_EQ(DecodeBase64(" Zm\r\n9v\tYm Fy\n"), "foobar");
}

TEST(Base64, StopsAtTheFirstForeignCharacter) {
  EXPECT_EQ(DecodeBase64("Zm9v</DataArray>"), "foo");
  EXPECT_EQ(DecodeBase64("<Zm9v"), "");
}

}  // namespace
}  // namespace musclewarp
