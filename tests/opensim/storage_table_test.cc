// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/opensim/storage_table.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/input_errors.h"
#include "support/osim_models.h"

namespace musclewarp {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

constexpr char kHeader[] =
    "name\nversion=1\nnRows=2\nnColumns=3\ninDegrees=yes\n\nnotes\nendheader\n";

StorageTable TableIn(const std::string& text) {
  return ReadStorageTable(Written("motion.mot", text));
}

void ExpectTableRefused(const std::string& text,
                        std::vector<std::string> words) {
  words.push_back("motion.mot");
  ExpectInputError([&] { TableIn(text); }, words);
}

TEST(StorageTable, ReadsHeaderLabelsAndRows) {
  const auto table =
      TableIn(std::string(kHeader) + "time\ta\tb\n0\t1\t-2e1\n0.5 +3 4\t\t\n");
  EXPECT_EQ(table.in_degrees, true);
  EXPECT_THAT(table.labels, ElementsAre("a", "b"));
  EXPECT_THAT(table.times, ElementsAre(0, 0.5));
  EXPECT_EQ(table.values, (Eigen::Matrix2d() << 1, -20, 3, 4).finished());
  EXPECT_TRUE(table.warnings.empty());
}

TEST(StorageTable, ReadsTheOlderHeaderOfSimmAndWindowsLines) {
  const auto table = TableIn(
      "name x\r\ndatacolumns 2\r\ndatarows 1\r\nrange 0 1\r\nendheader\r\n"
      "time a\r\n0 1\r\n");
  EXPECT_EQ(table.in_degrees, std::nullopt);
  EXPECT_TRUE(table.warnings.empty());
}

TEST(StorageTable, CountsThatAreWrongAreAWarning) {
  const auto table = TableIn(std::string(kHeader) + "time\ta\tb\n0\t1\t2\n");
  ASSERT_EQ(table.times.size(), 1u);
  ASSERT_EQ(table.warnings.size(), 1u);
  EXPECT_THAT(table.warnings[0], HasSubstr("promises 2 rows, 1"));
}

TEST(StorageTable, LabelsMayOccurTwiceAndValuesMayBeMissing) {
  const auto table =
      TableIn(std::string(kHeader) + "time\ta\ta\n0\tNaN\t-1.#IND\n1\t2\t3\n");
  EXPECT_THAT(table.labels, ElementsAre("a", "a"));
  EXPECT_TRUE(table.values.row(0).array().isNaN().all());
  EXPECT_EQ(table.values(1, 1), 3);
  EXPECT_THAT(table.lines, ElementsAre(10, 11));
}

TEST(StorageTable, ARowThatIsRepeatedWholeIsLeftOut) {
  const auto table =
      TableIn(std::string(kHeader) + "time\ta\tb\n0\t1\t2\n0\t1\t2\n");
  EXPECT_THAT(table.times, ElementsAre(0));
  // It counts as a row of the two that the header promises.
  ASSERT_EQ(table.warnings.size(), 1u);
  EXPECT_THAT(table.warnings[0], HasSubstr("in line 11"));
}

TEST(StorageTable, TheRemarkAboutAnglesIsTakenAtItsWord) {
  const auto in_degrees = [](const std::string& header) {
    return TableIn("name\n" + header + "\nendheader\ntime a\n0 1\n").in_degrees;
  };
  EXPECT_EQ(in_degrees("Angles are in degrees."), true);
  EXPECT_EQ(in_degrees("Units are S.I. units; angles are in radians"), false);
  EXPECT_EQ(in_degrees("inDegrees=no\nAngles are in degrees."), false);
  // OpenSim's explanation of the key is no remark about this file.
  EXPECT_EQ(in_degrees("If the header above contains a line with 'inDegrees', "
                       "this indicates whether rotational values are in "
                       "degrees (yes) or radians (no)."),
            std::nullopt);
}

TEST(StorageTable, RefusesBadRows) {
  const std::string start = std::string(kHeader) + "time\ta\tb\n0\t1\t2\n";
  ExpectTableRefused(start + "1\t1\n", {"line 11", "2 values", "3 columns"});
  ExpectTableRefused(start + "1\t1\t2\t3\n", {"line 11", "4 values"});
  ExpectTableRefused(start + "nan\t1\t2\n", {"line 11", "time nan"});
  ExpectTableRefused(start + "1\t1\tabc\n", {"line 11", "\"b\"", "'abc'"});
  ExpectTableRefused(start + "1\t1\t2,5\n", {"line 11", "'2,5'"});
  ExpectTableRefused(start + "0\t1\t3\n",
                     {"line 11", "is not after that of the row before"});
}

TEST(StorageTable, RefusesBadHeaders) {
  ExpectTableRefused("name\ninDegrees=yes\ntime a\n0 1\n", {"endheader"});
  ExpectTableRefused("name\nendheader\nt a\n0 1\n", {"line 3", "\"time\""});
  ExpectTableRefused("name\nendheader\ntime a\n", {"no row"});
  ExpectTableRefused("name\ninDegrees=maybe\nendheader\ntime a\n0 1\n",
                     {"line 2", "'maybe'", "yes, no"});
  ExpectTableRefused("name\nnRows=many\nendheader\ntime a\n0 1\n", {"line 2"});
}

TEST(StorageTable, WhatIsWrittenReadsBackToTheBit) {
  StorageTable table;
  table.name = "lengths";
  table.in_degrees = false;
  table.labels = {"a", "b.c"};
  table.times = {0, 0.1};
  table.values.resize(2, 2);
  table.values << 1.0 / 3, -1e-300, 0, 5e22;
  const StorageTable back = TableIn(StorageText(table));
  EXPECT_EQ(back.name, table.name);
  EXPECT_EQ(back.in_degrees, table.in_degrees);
  EXPECT_EQ(back.labels, table.labels);
  EXPECT_EQ(back.times, table.times);
  EXPECT_EQ(back.values, table.values);
  EXPECT_TRUE(back.warnings.empty());
}

}  // namespace
}  // namespace musclewarp
