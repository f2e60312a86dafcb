// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/label_images/label_table.h"

#include <gtest/gtest.h>

#include "musclewarp/base/output_file.h"
#include "support/input_errors.h"
#include "support/temp_dir.h"

namespace musclewarp {
namespace {

std::vector<LabelEntry> TableOf(const std::string& text) {
  const std::string path = TestTempDir() + "/labels.csv";
  WriteTextAtomically(path, text);
  return ReadLabelTable(path);
}

// Expects the rows 1 (psoas major, a muscle) and 2 (femur, a bone).
void ExpectPsoasAndFemur(const std::string& text) {
  const std::vector<LabelEntry> entries = TableOf(text);
  ASSERT_EQ(entries.size(), 2u) << text;
  EXPECT_EQ(entries[0].label, 1);
  EXPECT_EQ(entries[0].name, "psoas major");
  EXPECT_EQ(entries[0].is_bone, false);
  EXPECT_EQ(entries[1].label, 2);
  EXPECT_EQ(entries[1].name, "femur");
  EXPECT_EQ(entries[1].is_bone, true);
}

void ExpectTableRefused(const std::string& text,
                        const std::vector<std::string>& words) {
  ExpectInputError([&] { TableOf(text); }, words);
}

}  // namespace

TEST(LabelTable, ColumnsAreSeparatedByCommasTabsOrSemicolons) {
  ExpectPsoasAndFemur("1,psoas major,muscle\n2,femur,bone\n");
  ExpectPsoasAndFemur("1\tpsoas major\tmuscle\n2\tfemur\tbone\n");
  ExpectPsoasAndFemur("1; psoas major; Muscle\r\n2; femur; BONE\r\n");
  ExpectPsoasAndFemur("1,\"psoas major\",muscle\n\n# a note\n2,femur,bone");
}

TEST(LabelTable, AFirstLineMayNameTheColumns) {
  ExpectPsoasAndFemur("label,name,kind\n1,psoas major,muscle\n2,femur,bone\n");
  ExpectPsoasAndFemur(
      "Name,Color_R,Type,Label Value\n"
      "psoas major,9,muscle,1\nfemur,9,bone,2\n");
}

TEST(LabelTable, MayBeSavedByASpreadsheet) {
  const std::string rows =
      "LABEL;Name;Kind\r\n1,0;\"psoas major\";MUSCLE\r\n"
      "2.000;femur;Bone\r\n;;\r\n ; ;\r\n\"\";\"\";\r\n";
  ExpectPsoasAndFemur(rows);
  ExpectPsoasAndFemur("\xef\xbb\xbf" + rows);
  ExpectPsoasAndFemur("\xef\xbb\xbfsep=;\r\n" + rows);
  std::string little = "\xff\xfe", big = "\xfe\xff";
  for (const char letter : rows) {
    little += std::string{letter, '\0'};
    big += std::string{'\0', letter};
  }
  ExpectPsoasAndFemur(little);
  ExpectPsoasAndFemur(big);
  ExpectTableRefused("label,name\n1.5,femur\n", {"line 2", "'1.5'"});
  ExpectTableRefused("label,name\n.0,femur\n", {"line 2", "'.0'"});
}

// The first line says what separates columns.
TEST(LabelTable, NamesMayHoldOtherSeparators) {
  const auto name_in = [](const std::string& text) {
    return TableOf(text)[0].name;
  };
  EXPECT_EQ(name_in("label;name\n1;psoas, left\n"), "psoas, left");
  EXPECT_EQ(name_in("label,name\n1,\"psoas; left, long\"\n"),
            "psoas; left, long");
  EXPECT_EQ(name_in("label\tname\n1\tpsoas, left\n"), "psoas, left");
  EXPECT_EQ(name_in("label,name\n1,\"the \"\"long\"\" one\"\n"),
            "the \"long\" one");
}

TEST(LabelTable, ReadsColourTablesOfSlicer) {
  const std::vector<LabelEntry> entries = TableOf(
      "# Color table file\n# 3 values\n0 Background 0 0 0 0\n"
      "1 psoas_major 128 174 128 255\n20 femur 241 214 145 255\n");
  ASSERT_EQ(entries.size(), 2u);
  EXPECT_EQ(entries[0].name, "psoas_major");
  EXPECT_FALSE(entries[0].is_bone.has_value());
  EXPECT_EQ(entries[1].label, 20);
}

TEST(LabelTable, ReadsLabelDescriptionsOfItkSnap) {
  const std::vector<LabelEntry> entries = TableOf(
      "# ITK-SnAP Label Description File\n"
      "    0     0    0    0        0  0  0    \"Clear Label\"\n"
      "    1   255    0    0        1  1  1    \"psoas major\"\n");
  ASSERT_EQ(entries.size(), 1u);
  EXPECT_EQ(entries[0].label, 1);
  EXPECT_EQ(entries[0].name, "psoas major");
}

TEST(LabelTable, WordsBetweenBlanksWillDo) {
  const std::vector<LabelEntry> entries =
      TableOf("label name kind\n1 psoas muscle\n2 femur bone\n3 sacrum\n");
  ASSERT_EQ(entries.size(), 3u);
  EXPECT_EQ(entries[1].is_bone, true);
  EXPECT_FALSE(entries[2].is_bone.has_value());
}

TEST(LabelTable, RefusesBadLines) {
  ExpectTableRefused(
      "1,a\n2,b,tendon\n",
      {"labels.csv: line 2: has the kind 'tendon'", "allowed: muscle, bone"});
  ExpectTableRefused("1,a\n-2,b\n", {"line 2: has the label '-2'"});
  ExpectTableRefused("1,a\n2.5,b\n", {"line 2: has the label '2.5'"});
  ExpectTableRefused("1,a\n3000000000,b\n", {"line 2: has the label"});
  ExpectTableRefused("1,\n", {"line 1: label 1 has no name"});
  ExpectTableRefused("1,a/b\n", {"line 1", "a/b"});
  ExpectTableRefused("1 a b c\n", {"line 1: has 4 words"});
  ExpectTableRefused("1,a\n1,b\n", {"line 2: has label 1, as an earlier"});
  ExpectTableRefused("1,a\n2,a\n", {"line 2: has the name \"a\", as label 1"});
  ExpectTableRefused("name,kind\na,bone\n",
                     {"line 1", "none of them is 'label'"});
}

TEST(LabelTable, RefusesATableWithoutLabels) {
  ExpectTableRefused("0,background\n", {"has no label above 0"});
  ExpectTableRefused("", {"labels.csv: is empty"});
  ExpectInputError([] { ReadLabelTable("none.csv"); },
                   {"none.csv: does not exist"});
}

}  // namespace musclewarp
