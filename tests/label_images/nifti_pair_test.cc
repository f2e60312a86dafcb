// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/label_images/nifti_pair.h"

#include <gtest/gtest.h>

#include "musclewarp/base/output_file.h"
#include "support/input_errors.h"
#include "support/temp_dir.h"

namespace musclewarp {
namespace {

std::string HeaderNamed(const std::string& name) {
  return std::string(344, '\0') + name + '\0';
}

TEST(NiftiPair, IsKnownByItsNames) {
  for (const char* name :
       {"a.img", "a.hdr", "a.IMG", "a.img.gz", "a.b.HDR.GZ"}) {
    EXPECT_TRUE(IsNiftiPairFile(name)) << name;
  }
  for (const char* name : {"a.nii", "a.img.nii", "img", "a.gz", ""}) {
    EXPECT_FALSE(IsNiftiPairFile(name)) << name;
  }
}

TEST(NiftiPair, TheHeaderIsFoundFromEitherFile) {
  const std::string dir = TestTempDir();
  for (const std::string stem : {"/a", "/b.c"}) {
    WriteTextAtomically(dir + stem + ".hdr", HeaderNamed("ni1"));
    WriteTextAtomically(dir + stem + ".img.gz", "voxels");
    for (const std::string ending : {".hdr", ".img.gz", ".img"}) {
      EXPECT_EQ(CheckedNiftiHeader(dir + stem + ending), dir + stem + ".hdr");
    }
  }
  WriteTextAtomically(dir + "/D.HDR", HeaderNamed("n+1"));
  WriteTextAtomically(dir + "/D.IMG", "voxels");
  EXPECT_EQ(CheckedNiftiHeader(dir + "/D.IMG"), dir + "/D.HDR");
}

TEST(NiftiPair, AnalyzeAndHalfPairsAreRefused) {
  const std::string dir = TestTempDir();
  WriteTextAtomically(dir + "/a.img", "voxels");
  ExpectInputError([&] { CheckedNiftiHeader(dir + "/a.img"); },
                   {"a.img", "there is no", "a.hdr", "one folder"});
  for (const std::string& header :
       {HeaderNamed(std::string(3, '\0')), std::string("short")}) {
    WriteTextAtomically(dir + "/a.hdr", header);
    ExpectInputError([&] { CheckedNiftiHeader(dir + "/a.img"); },
                     {"a.hdr", "ANALYZE 7.5", "left and right", ".nii.gz"});
  }
}

}  // namespace
}  // namespace musclewarp
