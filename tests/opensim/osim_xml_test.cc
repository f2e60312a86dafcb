// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/opensim/osim_xml.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "musclewarp/base/nesting.h"
#include "opensim/read_models.h"

namespace musclewarp {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

TEST(OsimXml, PlacesNameTheLineTheElementAndItsName) {
  const OsimXml xml = Xml("<a>\n <b/>\n\n <c name=\"hip\"/>\n</a>\n");
  EXPECT_EQ(xml.LineOf(xml.root()), 1);
  EXPECT_EQ(xml.Where(xml.root().child("b")), xml.path() + ": line 2, <b>");
  EXPECT_EQ(xml.Where(xml.root().child("c")),
            xml.path() + ": line 4, <c name=\"hip\">");
  ExpectInputError([&] { xml.Child(xml.root(), "d"); }, {"line 1", "no <d>"});
}

TEST(OsimXml, RefusesElementsThatAreTooDeepInEachOther) {
  const auto nested = [](int depth) {
    std::string text;
    for (int i = 0; i < depth; ++i) text += "<a>";
    for (int i = 0; i < depth; ++i) text += "</a>";
    return text;
  };
  EXPECT_NO_THROW(Xml(nested(kDeepestNesting)));
  ExpectInputError([&] { Xml(nested(kDeepestNesting + 2)); },
                   {"part.osim", "more than 1000 deep"});
  ExpectInputError([&] { Xml(nested(100000)); }, {"more than 1000 deep"});
}

TEST(OsimXml, NumbersMayBeSeparatedInAnyUsualWay) {
  const OsimXml xml = Xml("<a> 1,-2.5e1\n\t+3 </a>");
  EXPECT_THAT(xml.Numbers(xml.root()), ElementsAre(1, -25, 3));
  EXPECT_EQ(xml.Text(xml.root()), "1,-2.5e1\n\t+3");
  const OsimXml empty = Xml("<a> \n </a>");
  EXPECT_THAT(empty.Numbers(empty.root()), IsEmpty());
  EXPECT_EQ(empty.Text(empty.root()), "");
}

TEST(OsimXml, RefusesWhatIsNotAFiniteNumber) {
  for (const std::string text : {"NaN", "inf", "1e999", "2x", "++1", "0x10"}) {
    const OsimXml xml = Xml("<a><b>1 " + text + "</b></a>");
    ExpectInputError([&] { xml.Numbers(xml.root().child("b")); },
                     {"part.osim", "line 1, <b>", "'" + text + "'"});
  }
}

TEST(OsimXml, ChildrenThatAreMissingHaveTheirDefault) {
  const OsimXml xml = Xml("<a><b>1 2 3</b><c>true</c><d>4</d></a>");
  EXPECT_EQ(xml.Vector(xml.root(), "b", {7, 8, 9}), Eigen::Vector3d(1, 2, 3));
  EXPECT_EQ(xml.Vector(xml.root(), "x", {7, 8, 9}), Eigen::Vector3d(7, 8, 9));
  EXPECT_EQ(xml.Number(xml.root(), "d", 5), 4);
  EXPECT_EQ(xml.Number(xml.root(), "x", 5), 5);
  EXPECT_TRUE(xml.Bool(xml.root(), "c", false));
  EXPECT_FALSE(xml.Bool(xml.root(), "x", false));
  ExpectInputError([&] { xml.Number(xml.root(), "b", 5); },
                   {"<b>", "3 numbers", "give 1"});
}

TEST(OsimXml, BoolsAreWordsOrDigits) {
  const OsimXml xml = Xml("<a><b> True </b><c>0</c><d>yes</d></a>");
  EXPECT_TRUE(xml.Bool(xml.root(), "b", false));
  EXPECT_FALSE(xml.Bool(xml.root(), "c", true));
  ExpectInputError([&] { xml.Bool(xml.root(), "d", true); },
                   {"<d>", "'yes'", "true, false"});
}

TEST(OsimXml, Latin1UnderAUtf8HeadIsReadWithAWarning) {
  const std::string head = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>";
  const OsimXml latin1 = Xml(head + "<a>Li\xe8ge</a>");
  EXPECT_EQ(latin1.Text(latin1.root()), "Li\xc3\xa8ge");
  ASSERT_EQ(latin1.warnings().size(), 1u);
  EXPECT_THAT(latin1.warnings()[0], HasSubstr("Latin-1"));
  const OsimXml utf8 = Xml(head + "<a>Li\xc3\xa8ge</a>");
  EXPECT_EQ(utf8.Text(utf8.root()), "Li\xc3\xa8ge");
  EXPECT_THAT(utf8.warnings(), IsEmpty());
}

TEST(OsimXml, RefusesXmlThatIsCutShort) {
  const std::string text = PinModel();
  for (const std::string& broken :
       {text.substr(0, text.size() / 2), std::string("time\n1\n")}) {
    ExpectInputError([&] { Xml(broken); },
                     {"part.osim", "line", "well-formed"});
  }
}

TEST(OsimXml, SetsHaveTheirElementsWithoutTextAndComments) {
  const OsimXml xml =
      Xml("<a><Set><objects> x <b/><!-- note --><c/> </objects>"
          "<groups><d/></groups></Set><Empty/></a>");
  const auto objects = ObjectsOf(xml.root(), "Set");
  ASSERT_EQ(objects.size(), 2u);
  EXPECT_STREQ(objects[0].name(), "b");
  EXPECT_STREQ(objects[1].name(), "c");
  EXPECT_THAT(ObjectsOf(xml.root(), "Empty"), IsEmpty());
  EXPECT_THAT(ObjectsOf(xml.root(), "Missing"), IsEmpty());
}

TEST(OsimXml, LastNamesOfPaths) {
  EXPECT_EQ(LastName("/bodyset/femur_r"), "femur_r");
  EXPECT_EQ(LastName("femur_r"), "femur_r");
  EXPECT_EQ(LastName("../"), "");
}

}  // namespace
}  // namespace musclewarp
