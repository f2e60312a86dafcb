// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/base/csv_table.h"

#include <gtest/gtest.h>

#include "musclewarp/base/csv_field.h"
#include "musclewarp/base/output_file.h"
#include "support/input_errors.h"
#include "support/temp_dir.h"

namespace musclewarp {
namespace {

CsvTable TableOf(const std::string& text) {
  const std::string path = TestTempDir() + "/table.csv";
  WriteTextAtomically(path, text);
  return CsvTable(path);
}

TEST(CsvTable, ReadsWhatWasWritten) {
  const std::string odd = "a \"b\", c\nd";
  const CsvTable table =
      TableOf("name,value\n" + CsvField(odd) + ",2.5\nplain,-1e3\n");
  ASSERT_EQ(table.NumRows(), 2u);
  EXPECT_EQ(table.Text(0, "name"), odd);
  EXPECT_EQ(table.Number(0, "value"), 2.5);
  EXPECT_EQ(table.Number(1, "value"), -1000);
}

TEST(CsvTable, IsTheSameWithOtherLineEndsAndAByteOrderMark) {
  for (const char* text : {"a,b\n1,\n\n,2\n",
                           "a,b\r\n1,\r\n\r\n,2\r\n",
                           "\xEF\xBB\xBF"
                           "a,b\n1,\n,2"}) {
    const CsvTable table = TableOf(text);
    ASSERT_EQ(table.NumRows(), 2u);
    EXPECT_EQ(table.Number(0, "a"), 1);
    EXPECT_EQ(table.Number(0, "b"), std::nullopt);
    EXPECT_EQ(table.Number(1, "b"), 2);
    EXPECT_EQ(table.Text(0, "c"), "");  // no such column
  }
}

TEST(CsvTable, RefusesWhatIsNoTable) {
  ExpectInputError([] { TableOf(""); }, {"table.csv", "is empty"});
  ExpectInputError([] { TableOf("a,a\n1,2\n"); }, {"two columns 'a'"});
  ExpectInputError([] { TableOf("a,b\n1,2\n1\n"); },
                   {"line 3", "has 1 fields, the header has 2"});
  ExpectInputError([] { TableOf("a,b\n1,\"2\n3,4\n"); },
                   {"line 2", "a quote that does not end"});
  const CsvTable table = TableOf("a,b\n1,two\n1,nan\n");
  ExpectInputError([&] { table.Number(0, "b"); }, {"line 2", "b 'two'"});
  ExpectInputError([&] { table.Number(1, "b"); }, {"line 3", "b 'nan'"});
  ExpectInputError(
      [&] {
        table.Require({"a", "c"});
      },
      {"has no column c; it has a, b"});
}

}  // namespace
}  // namespace musclewarp
