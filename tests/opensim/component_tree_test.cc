// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/opensim/component_tree.h"

#include <gtest/gtest.h>

#include <string>

#include "opensim/read_models.h"

namespace musclewarp {
namespace {

// A model with a body that has a part of its own, and a joint without a name.
OsimXml SmallModel() {
  return Xml(R"(<OpenSimDocument><defaults><Body name="standard"/></defaults>
    <Model name="leg"><BodySet name="bodyset"><objects>
     <Body name="thigh"><components><Station name="tip"/></components></Body>
    </objects></BodySet>
    <JointSet><objects><PinJoint name=""><frames>
     <PhysicalOffsetFrame name="end"/></frames></PinJoint></objects></JointSet>
    </Model></OpenSimDocument>)");
}

TEST(ComponentTree, PathsLeadDownFromTheModelAndUpToOwners) {
  const OsimXml xml = SmallModel();
  const pugi::xml_node model = xml.root().child("Model");
  const auto named = [&](pugi::xml_node from, const std::string& path) {
    return std::string(FindComponent(from, path).attribute("name").value());
  };
  const auto tip = FindComponent(model, "/bodyset/thigh/tip");
  EXPECT_STREQ(tip.name(), "Station");
  EXPECT_EQ(named(tip, "/bodyset/thigh"), "thigh");
  EXPECT_EQ(named(tip, ".."), "thigh");
  EXPECT_EQ(named(tip, "../.."), "bodyset");
  EXPECT_EQ(named(tip, "../../../jointset/pinjoint/end"), "end");
  EXPECT_EQ(named(model, "bodyset/thigh"), "thigh");
  EXPECT_EQ(OwnerOf(tip), FindComponent(model, "/bodyset/thigh"));
  // Above the model there is nothing, and defaults are no part of it.
  EXPECT_FALSE(FindComponent(tip, "../../../.."));
  EXPECT_FALSE(FindComponent(model, "/bodyset/standard"));
  EXPECT_FALSE(FindComponent(model, "/bodyset/shank"));
}

TEST(ComponentTree, WithoutANameThatOfTheElementCounts) {
  EXPECT_EQ(ComponentName(Xml("<PinJoint name=\"\"/>").root()), "pinjoint");
  EXPECT_EQ(ComponentName(Xml("<PinJoint/>").root()), "pinjoint");
  EXPECT_EQ(ComponentName(Xml("<PinJoint name=\"a\"/>").root()), "a");
}

TEST(ComponentTree, SocketsAreFoundInTheFormsOfAllVersions) {
  for (const std::string& socket :
       {std::string("<socket_parent>thigh</socket_parent>"),
        std::string("<socket_parent_connectee_name>thigh"
                    "</socket_parent_connectee_name>"),
        std::string("<connector_parent_connectee_name>thigh"
                    "</connector_parent_connectee_name>"),
        std::string("<connectors><Connector_PhysicalFrame_ name=\"child\">"
                    "<connectee_name>shank</connectee_name>"
                    "</Connector_PhysicalFrame_>"
                    "<Connector_PhysicalFrame_ name=\"parent\">"
                    "<connectee_name>thigh</connectee_name>"
                    "</Connector_PhysicalFrame_></connectors>")}) {
    const OsimXml xml = Xml("<Frame>" + socket + "</Frame>");
    EXPECT_EQ(xml.Text(SocketOf(xml, xml.root(), {"parent_frame", "parent"})),
              "thigh")
        << socket;
    EXPECT_FALSE(FindSocket(xml.root(), {"grandparent"}));
    ExpectInputError([&] { SocketOf(xml, xml.root(), {"grandparent"}); },
                     {"part.osim", "<Frame>", "no <socket_grandparent>"});
  }
}

TEST(ComponentTree, ElementsAreFoundAnywhereButInDefaults) {
  const OsimXml xml = SmallModel();
  EXPECT_EQ(ElementsNamed(xml.root(), "Body").size(), 1u);
  EXPECT_EQ(ElementsNamed(xml.root(), "Station").size(), 1u);
}

}  // namespace
}  // namespace musclewarp
