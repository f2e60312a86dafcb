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

// A header of NIfTI-1 or 2 that says nothing but its size, its dimensions and
// the type of its voxels.
std::string Header(std::int64_t size,
                   std::int64_t dimensions,
                   bool is_little,
                   std::int64_t type = 4) {
  std::string bytes(352, '\0');
  const auto put = [&](std::size_t at, std::size_t count, std::int64_t value) {
    for (std::size_t i = 0; i < count; ++i) {
      const std::size_t k = is_little ? i : count - 1 - i;
      bytes[at + k] = static_cast<char>(value >> (8 * i) & 0xff);
    }
  };
  put(0, 4, size);
  size == 540 ? put(16, 8, dimensions) : put(40, 2, dimensions);
  put(size == 540 ? 12 : 70, 2, type);
  return bytes;
}

// VTK takes the number for the length of a list.
TEST(NiftiDimensions, AreOneToSeven) {
  const std::string path = TestTempDir() + "/image.nii";
  for (const std::int64_t size : {348, 540}) {
    for (const bool is_little : {true, false}) {
      for (const std::int64_t dimensions : {1, 3, 7}) {
        WriteTextAtomically(path, Header(size, dimensions, is_little));
        EXPECT_NO_THROW(CheckNiftiFields(path));
      }
      for (const std::int64_t dimensions : {0, 8, 0x7f00}) {
        WriteTextAtomically(path, Header(size, dimensions, is_little));
        ExpectInputError([&] { CheckNiftiFields(path); },
                         {"image.nii", "dimensions", "1 to 7"});
      }
    }
  }
  WriteTextAtomically(path, Header(347, 3, true));
  ExpectInputError([&] { CheckNiftiFields(path); }, {"the size of"});
  WriteTextAtomically(path, Header(348, 3, true).substr(0, 100));
  ExpectInputError([&] { CheckNiftiFields(path); }, {"ends after 100 bytes"});
}

// VTK looks for it in a list, and beyond the end of the list.
TEST(NiftiVoxelType, IsOneOfTheFormat) {
  const std::string path = TestTempDir() + "/image.nii";
  for (const std::int64_t size : {348, 540}) {
    for (const bool is_little : {true, false}) {
      for (const std::int64_t type : {2, 8, 512, 1280}) {
        WriteTextAtomically(path, Header(size, 3, is_little, type));
        EXPECT_NO_THROW(CheckNiftiFields(path));
      }
      for (const std::int64_t type : {0, 1, 1536, 14134}) {
        WriteTextAtomically(path, Header(size, 3, is_little, type));
        ExpectInputError([&] { CheckNiftiFields(path); },
                         {"image.nii", "of type " + std::to_string(type)});
      }
    }
  }
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
