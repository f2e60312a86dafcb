// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/label_images/nrrd_text.h"

#include <gtest/gtest.h>

#include "musclewarp/base/output_file.h"
#include "support/input_errors.h"
#include "support/temp_dir.h"

namespace musclewarp {
namespace {

NrrdText TextOfNrrd(const std::string& bytes) {
  const std::string path = TestTempDir() + "/a.nhdr";
  WriteTextAtomically(path, bytes);
  return ReadNrrdText(path);
}

using Names = std::vector<std::string>;

}  // namespace

TEST(NrrdText, FieldsAreFoundInAnyCaseAndBothSpellings) {
  const std::string header =
      "NRRD0004\r\n# a comment\r\nSizes: 1 2 3 \r\nlineskip: 2\r\n"
      "Segment0_Name:=left: femur\r\n\r\n";
  const NrrdText text = TextOfNrrd(header + "data");
  EXPECT_EQ(text.Find("sizes"), "1 2 3");
  EXPECT_EQ(text.Find("line skip"), "2");
  EXPECT_EQ(text.Find("byte skip"), "");
  EXPECT_EQ(text.values.at("Segment0_Name"), "left: femur");
  EXPECT_TRUE(text.data_files.empty());
  EXPECT_EQ(text.data_from, header.size());
}

TEST(NrrdText, DataMayBeInSeveralFiles) {
  // A header without data needs no empty line at its end.
  EXPECT_EQ(TextOfNrrd("NRRD0004\ndata file: a.raw").data_files,
            Names{"a.raw"});
  EXPECT_EQ(
      TextOfNrrd("NRRD0004\ndata file: LIST\na.raw\nb c.raw\n").data_files,
      (Names{"a.raw", "b c.raw"}));
  EXPECT_EQ(TextOfNrrd("NRRD0004\ndatafile: LIST 2\r\na.raw\r\n").data_files,
            Names{"a.raw"});
  EXPECT_EQ(TextOfNrrd("NRRD0004\ndata file: a%d.raw 9 11 1 2\n").data_files,
            (Names{"a9.raw", "a10.raw", "a11.raw"}));
  EXPECT_EQ(TextOfNrrd("NRRD0004\ndata file: 50%s.raw\n").data_files,
            Names{"50%s.raw"});
}

TEST(NrrdText, AHeaderWithoutAnEndIsRefused) {
  ExpectInputError([] { TextOfNrrd("NRRD0004\ntype: uint8\n"); },
                   {"is truncated: its header has no end"});
}

}  // namespace musclewarp
