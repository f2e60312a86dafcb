// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/mujoco/mjcf_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdint>
#include <cstring>
#include <pugixml.hpp>
#include <string>

#include "support/input_errors.h"
#include "support/osim_models.h"

namespace musclewarp {
namespace {

using ::testing::StartsWith;

// A knee with one bone, muscle and skin.
struct SmallMjcf {
  Model model =
      ReadModel(Written("leg.osim", Model4(Joint4("PinJoint", "knee"))));
  MjcfModel mjcf;

  SmallMjcf() {
    mjcf.name = "leg & more";
    mjcf.tree = MakeMjcfTree(model, {-1}, {1});
    Points corners(4, 3);
    corners << 0, 0, 0, 10, 0, 0, 0, 10, 0, 0, 0, 10;
    Triangles triangles(4, 3);
    triangles << 0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3;
    mjcf.bones.push_back({"femur", 1, {corners, triangles}});
    MjcfMuscle muscle;
    muscle.name = "vastus";
    muscle.path.sites = {{1, {0, 10, 0}}, {2, {0, -20, 5}}};
    muscle.force = 500;
    muscle.length_range = {100, 140};
    mjcf.muscles.push_back(muscle);
    MjcfSkin skin;
    skin.name = "vastus";
    skin.skin.places = corners;
    skin.skin.weights.resize(4, 2);
    skin.skin.weights << 1, 0, 0.5, 0.5, 0, 1, 0.25, 0.75;
    skin.triangles = triangles;
    skin.bones = {{"thigh", Eigen::Matrix4d::Identity()},
                  {"shank", Eigen::Matrix4d::Identity()}};
    skin.bones[1].rest_from_body(0, 3) = 1000;
    mjcf.skins.push_back(skin);
  }
};

TEST(MjcfFile, HasItsPartsWhereMujocoLooksForThem) {
  const SmallMjcf small;
  pugi::xml_document document;
  ASSERT_TRUE(document.load_string(MjcfText(small.mjcf, small.model).c_str()));
  const pugi::xml_node root = document.child("mujoco");
  EXPECT_STREQ(root.attribute("model").value(), "leg & more");
  const pugi::xml_node thigh = root.child("worldbody").child("body");
  EXPECT_STREQ(thigh.attribute("name").value(), "thigh");
  EXPECT_TRUE(thigh.child("inertial"));
  EXPECT_STREQ(thigh.child("geom").attribute("mesh").value(), "femur");
  const pugi::xml_node shank = thigh.child("body");
  EXPECT_STREQ(shank.child("joint").attribute("name").value(), "knee");
  EXPECT_STREQ(shank.child("site").attribute("pos").value(), "0 -0.02 0.005");
  EXPECT_STREQ(
      root.child("actuator").child("muscle").attribute("tendon").value(),
      root.child("tendon").child("spatial").attribute("name").value());
  EXPECT_STREQ(
      root.child("actuator").child("muscle").attribute("lengthrange").value(),
      "0.1 0.14");
  EXPECT_STREQ(root.child("deformable").child("skin").attribute("file").value(),
               "vastus.skn");
}

// Reads numbers of a .skn file one after the other.
class SknReader {
 public:
  explicit SknReader(std::string bytes) : bytes_(std::move(bytes)) {}
  template <typename Number>
  Number Next() {
    Number number;
    std::memcpy(&number, bytes_.data() + at_, sizeof number);
    at_ += sizeof number;
    return number;
  }
  std::string Name() {
    at_ += 40;
    return bytes_.data() + at_ - 40;
  }
  bool IsAtEnd() const { return at_ == bytes_.size(); }

 private:
  std::string bytes_;
  size_t at_ = 0;
};

TEST(MjcfFile, SkinHasTheLayoutOfMujoco) {
  const SmallMjcf small;
  SknReader file(SknBytes(small.mjcf.skins[0]));
  EXPECT_EQ(file.Next<std::int32_t>(), 4);  // vertices
  EXPECT_EQ(file.Next<std::int32_t>(), 0);  // texture coordinates
  EXPECT_EQ(file.Next<std::int32_t>(), 4);  // faces
  EXPECT_EQ(file.Next<std::int32_t>(), 2);  // bones
  for (int i = 0; i < 3; ++i) EXPECT_EQ(file.Next<float>(), 0);
  EXPECT_EQ(file.Next<float>(), 0.01F);
  for (int i = 0; i < 8; ++i) file.Next<float>();
  for (int i = 0; i < 12; ++i) file.Next<std::int32_t>();
  const char* names[] = {"thigh", "shank"};
  for (int b = 0; b < 2; ++b) {
    EXPECT_EQ(file.Name(), names[b]);
    EXPECT_EQ(file.Next<float>(), b == 0 ? 0 : 1);  // m
    for (int i = 0; i < 2; ++i) EXPECT_EQ(file.Next<float>(), 0);
    EXPECT_EQ(file.Next<float>(), 1);  // of the quaternion
    for (int i = 0; i < 3; ++i) EXPECT_EQ(file.Next<float>(), 0);
    // Vertices with a weight of 0 are not named.
    ASSERT_EQ(file.Next<std::int32_t>(), 3);
    for (int i = 0; i < 3; ++i) file.Next<std::int32_t>();
    float sum = 0;
    for (int i = 0; i < 3; ++i) sum += file.Next<float>();
    EXPECT_EQ(sum, b == 0 ? 1.75F : 2.25F);
  }
  EXPECT_TRUE(file.IsAtEnd());
}

TEST(MjcfFile, RefusesNamesThatASkinCannotHold) {
  SmallMjcf small;
  small.mjcf.skins[0].bones[1].body = std::string(40, 'x');
  ExpectInputError([&] { SknBytes(small.mjcf.skins[0]); },
                   {"has a name of 40 bytes"});
}

TEST(MjcfFile, MeshesAreInMetres) {
  const SmallMjcf small;
  EXPECT_THAT(MeshText(small.mjcf.bones[0].mesh),
              StartsWith("v 0 0 0\nv 0.01 0 0\nv 0 0.01 0\n"));
}

}  // namespace
}  // namespace musclewarp
