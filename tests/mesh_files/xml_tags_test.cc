// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/mesh_files/xml_tags.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace musclewarp {
namespace {

std::vector<std::string> TagsOf(std::string_view text) {
  std::vector<std::string> tags;
  XmlTag tag;
  while (NextXmlTag(text, tag.end, &tag)) tags.emplace_back(tag.text);
  return tags;
}

XmlTag FirstTag(std::string_view text) {
  XmlTag tag;
  EXPECT_TRUE(NextXmlTag(text, 0, &tag)) << text;
  return tag;
}

TEST(NextXmlTag, FindsTheTagsInOrder) {
  EXPECT_EQ(TagsOf("a<b> c <d e='f'/></b>\n"),
            (std::vector<std::string>{"b", "d e='f'/", "/b"}));
}

TEST(NextXmlTag, PassesOverCommentsAndDeclarations) {
  EXPECT_EQ(TagsOf("<?xml version='1.0'?><!DOCTYPE a><!-- <b> -- <c> --><d>"),
            (std::vector<std::string>{"d"}));
}

TEST(NextXmlTag, ABracketInQuotesDoesNotEndATag) {
  EXPECT_EQ(TagsOf("<a b='1>2' c=\"'>\"><d>"),
            (std::vector<std::string>{"a b='1>2' c=\"'>\"", "d"}));
}

TEST(NextXmlTag, WhatDoesNotEndIsNoTag) {
  for (const char* text : {"", "a", "<a", "<a b='>", "<!-- <a>"}) {
    EXPECT_TRUE(TagsOf(text).empty()) << text;
  }
}

TEST(XmlTag, TellsOpeningFromClosingAndEmpty) {
  const XmlTag opening = FirstTag("<Piece NumberOfPoints=\"3\">");
  EXPECT_EQ(opening.name(), "Piece");
  EXPECT_FALSE(opening.is_closing());
  EXPECT_FALSE(opening.is_empty_element());
  const XmlTag closing = FirstTag("</Piece>");
  EXPECT_EQ(closing.name(), "Piece");
  EXPECT_TRUE(closing.is_closing());
  const XmlTag empty = FirstTag("<Verts/>");
  EXPECT_EQ(empty.name(), "Verts");
  EXPECT_TRUE(empty.is_empty_element());
}

TEST(XmlTag, HasTheValuesOfItsAttributes) {
  const XmlTag tag =
      FirstTag("<DataArray type='Int32'\n Name = \"a b='c'\" offset='7'/>");
  EXPECT_EQ(tag.Attribute("type"), "Int32");
  EXPECT_EQ(tag.Attribute("Name"), "a b='c'");
  EXPECT_EQ(tag.Attribute("offset"), "7");
  // Neither parts of names nor names within values count.
  EXPECT_EQ(tag.Attribute("set"), "");
  EXPECT_EQ(tag.Attribute("b"), "");
}

}  // namespace
}  // namespace musclewarp
