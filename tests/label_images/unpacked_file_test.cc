// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/label_images/unpacked_file.h"

#include <gtest/gtest.h>
#include <zlib.h>

#include "musclewarp/base/output_file.h"
#include "support/input_errors.h"
#include "support/temp_dir.h"

namespace musclewarp {
namespace {

TEST(ReadUnpacked, IsTheSameOfPackedAndPlainFiles) {
  const std::string dir = TestTempDir();
  const std::string text(1000, 'x');
  WriteTextAtomically(dir + "/plain", text);
  gzFile file = gzopen((dir + "/packed").c_str(), "wb");
  gzwrite(file, text.data(), static_cast<unsigned>(text.size()));
  gzclose(file);
  for (const std::string name : {"/plain", "/packed"}) {
    EXPECT_EQ(ReadUnpacked(dir + name, 5000), text);
    EXPECT_EQ(ReadUnpacked(dir + name, 10), text.substr(0, 10));
  }
}

TEST(ReadUnpacked, WhatCannotBeReadIsRefused) {
  const std::string dir = TestTempDir();
  ExpectInputError([&] { ReadUnpacked(dir + "/absent", 10); },
                   {"absent", "cannot be opened"});
  WriteTextAtomically(
      dir + "/damaged",
      std::string("\x1f\x8b\x08\0\0\0\0\0\0\3", 10) + std::string(50, '\xff'));
  ExpectInputError([&] { ReadUnpacked(dir + "/damaged", 10); },
                   {"damaged", "gzip"});
}

}  // namespace
}  // namespace musclewarp
