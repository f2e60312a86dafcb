// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/base/csv_field.h"

#include <gtest/gtest.h>

namespace musclewarp {
namespace {

TEST(CsvField, QuotesOnlyWhatNeedsIt) {
  EXPECT_EQ(CsvField("psoas major"), "psoas major");
  EXPECT_EQ(CsvField(""), "");
  EXPECT_EQ(CsvField("a,b"), "\"a,b\"");
  EXPECT_EQ(CsvField("5\" long"), "\"5\"\" long\"");
  EXPECT_EQ(CsvField("a\nb"), "\"a\nb\"");
  EXPECT_EQ(CsvField("a\rb"), "\"a\rb\"");
}

TEST(SpreadsheetField, IsNoFormula) {
  for (const std::string formula : {"=1+1", "+1", "-a", "@A1", "\tb"}) {
    EXPECT_EQ(SpreadsheetField(formula), "'" + formula);
  }
  EXPECT_EQ(SpreadsheetField("=a,\"b\""), "\"'=a,\"\"b\"\"\"");
  EXPECT_EQ(SpreadsheetField("a=b-c"), "a=b-c");
  EXPECT_EQ(SpreadsheetField(""), "");
}

}  // namespace
}  // namespace musclewarp
