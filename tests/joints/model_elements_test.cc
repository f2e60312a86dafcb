// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/joints/model_elements.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <sstream>

namespace musclewarp {
namespace {

TEST(ExactText, ReadsBackAsTheSameNumber) {
  for (const double number :
       {0.1, -1.0 / 3, 1e-300, 123456789.123456789, std::nextafter(1, 2)}) {
    EXPECT_EQ(std::stod(ExactText(number)), number);
  }
  EXPECT_EQ(ExactText(-0.0), "0");
}

// Returns a document after it was written and read.
void WriteAndRead(const pugi::xml_document& written, pugi::xml_document* read) {
  std::ostringstream text;
  written.save(text);
  ASSERT_TRUE(read->load_string(text.str().c_str(), pugi::parse_full))
      << text.str();
}

TEST(ModelElements, KeepNamesAndTextsThatXmlWouldTakeForItsOwn) {
  const std::string text = "a<b> & \"c\" 'd' -->]]>";
  pugi::xml_document written, read;
  AddText(AddNamed(written, "Body", text), "mesh_file", text);
  WriteAndRead(written, &read);
  const pugi::xml_node body = read.child("Body");
  EXPECT_EQ(body.attribute("name").value(), text);
  EXPECT_EQ(body.child_value("mesh_file"), text);
}

TEST(AddComment, EndsWhereItShould) {
  for (const std::string text : {"a-->b", "a----b", "a-", "--"}) {
    pugi::xml_document written, read;
    pugi::xml_node model = written.append_child("Model");
    AddComment(model, text);
    AddText(model, "after", "x");
    WriteAndRead(written, &read);
    EXPECT_STREQ(read.child("Model").child_value("after"), "x") << text;
    EXPECT_EQ(read.child("Model").first_child().type(), pugi::node_comment);
  }
}

TEST(FramePathOf, TheGroundIsNoBodyOfTheSet) {
  EXPECT_EQ(FramePathOf("ground"), "/ground");
  EXPECT_EQ(FramePathOf("femur_r"), "/bodyset/femur_r");
}

}  // namespace
}  // namespace musclewarp
