// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/exchange/glb_file.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "musclewarp/base/input_file.h"
#include "run/written_run.h"
#include "support/input_errors.h"
#include "support/temp_dir.h"

namespace musclewarp {
namespace {

using nlohmann::json;

// Half of the last digit of the floats is less.
constexpr double kToleranceMm = 1e-4;

std::uint32_t NumberAt(const std::string& bytes, size_t at) {
  std::uint32_t number = 0;
  std::memcpy(&number, &bytes[at], sizeof(number));
  return number;
}

// A .glb file, parsed.
struct Glb {
  json scene;
  std::string arrays;

  explicit Glb(const std::string& path) {
    const std::string bytes = ReadFile(path);
    EXPECT_EQ(bytes.substr(0, 4), "glTF");
    EXPECT_EQ(NumberAt(bytes, 4), 2u);
    EXPECT_EQ(NumberAt(bytes, 8), bytes.size());
    const std::uint32_t length = NumberAt(bytes, 12);
    EXPECT_EQ(bytes.substr(16, 4), "JSON");
    EXPECT_EQ(length % 4, 0u);
    scene = json::parse(bytes.substr(20, length));
    EXPECT_EQ(bytes.substr(24 + length, 4), std::string("BIN\0", 4));
    arrays = bytes.substr(28 + length);
    EXPECT_EQ(NumberAt(bytes, 20 + length), arrays.size());
    EXPECT_EQ(scene["buffers"][0]["byteLength"], arrays.size());
  }

  // The rows of an accessor of floats.
  Eigen::MatrixXd Floats(int number) const {
    const json& accessor = scene["accessors"][number];
    EXPECT_EQ(accessor["componentType"], 5126);
    const std::string type = accessor["type"];
    const int columns = type == "SCALAR" ? 1 : type == "VEC3" ? 3 : 4;
    const json& view = scene["bufferViews"][int{accessor["bufferView"]}];
    Eigen::Matrix<float, -1, -1, Eigen::RowMajor> rows(
        Eigen::Index{accessor["count"]}, columns);
    EXPECT_EQ(view["byteLength"], rows.size() * sizeof(float));
    std::memcpy(rows.data(),
                &arrays[size_t{view["byteOffset"]}],
                rows.size() * sizeof(float));
    if (accessor.contains("min")) {
      for (int k = 0; k < columns; ++k) {
        EXPECT_EQ(accessor["min"][k], rows.col(k).minCoeff());
        EXPECT_EQ(accessor["max"][k], rows.col(k).maxCoeff());
      }
    }
    return rows.cast<double>();
  }

  Eigen::RowVector3d Translation(const json& node) const {
    const json& t = node["translation"];
    return Eigen::RowVector3d(
        t[0].get<double>(), t[1].get<double>(), t[2].get<double>());
  }

  const json& Root() const { return scene["nodes"].back(); }

  // The values that a channel gives a node, by frame.
  Eigen::MatrixXd Channel(int node, const std::string& path) const {
    const json& animation = scene["animations"][0];
    for (const json& channel : animation["channels"]) {
      if (channel["target"]["node"] != node) continue;
      if (channel["target"]["path"] != path) continue;
      const json& sampler = animation["samplers"][int{channel["sampler"]}];
      return Floats(sampler["output"]);
    }
    ADD_FAILURE() << "no channel " << path << " of node " << node;
    return {};
  }
};

double FarthestMm(const Points& metres, const Points& expected) {
  return 1e3 * (metres - expected).rowwise().norm().maxCoeff();
}

class GlbFile : public ::testing::Test {
 protected:
  void SetUp() override {
    written_ = WriteRun(TestTempDir());
    run_ = ReadRunForExport(written_.dir, "0");
    path_ = written_.dir + "/motion.glb";
  }

  WrittenRun written_;
  RunOutline run_;
  std::string path_;
};

TEST_F(GlbFile, GivesMusclesBackInEveryFrame) {
  WriteGlb(path_, AnimationOf(run_, {0, 1}));
  const Glb glb(path_);
  const GltfConversion conversion = GltfFromAxes("ASR");
  const json& node = glb.scene["nodes"][0];
  EXPECT_EQ(node["name"], "muscle");
  const json& mesh = glb.scene["meshes"][int{node["mesh"]}];
  const json& primitive = mesh["primitives"][0];
  const Eigen::RowVector3d origin =
      glb.Translation(node) + glb.Translation(glb.Root());
  const Points rest =
      glb.Floats(primitive["attributes"]["POSITION"]).rowwise() + origin;
  EXPECT_LT(FarthestMm(rest, conversion.Convert(written_.muscle.points)),
            kToleranceMm);
  ASSERT_EQ(primitive["targets"].size(), 2u);
  EXPECT_EQ(mesh["weights"], json({0.0, 0.0}));
  EXPECT_EQ(mesh["extras"]["targetNames"].size(), 2u);
  const Eigen::MatrixXd weights = glb.Channel(0, "weights");
  EXPECT_EQ(weights.reshaped(2, 2), Eigen::Matrix2d::Identity());
  for (int i = 0; i < 2; ++i) {
    const Points moved = rest + glb.Floats(primitive["targets"][i]["POSITION"]);
    EXPECT_LT(FarthestMm(moved, conversion.Convert(written_.muscle_frames[i])),
              kToleranceMm);
  }
}

TEST_F(GlbFile, FramesHaveTheNumbersOfTheRun) {
  run_.frames[0].figures.index = 7;
  run_.frames[1].figures.index = 12;
  WriteGlb(path_, AnimationOf(run_, {0, 1}));
  const Glb glb(path_);
  EXPECT_EQ(glb.scene["meshes"][0]["extras"]["targetNames"],
            json({"frame_0007", "frame_0012"}));
  EXPECT_EQ(glb.scene["animations"][0]["extras"]["frames"], json({7, 12}));
}

TEST_F(GlbFile, MovesBonesAsNodes) {
  WriteGlb(path_, AnimationOf(run_, {0, 1}));
  const Glb glb(path_);
  const GltfConversion conversion = GltfFromAxes("ASR");
  const json& node = glb.scene["nodes"][1];
  EXPECT_EQ(node["name"], "bone");
  const json& mesh = glb.scene["meshes"][int{node["mesh"]}];
  const Points local =
      glb.Floats(mesh["primitives"][0]["attributes"]["POSITION"]);
  EXPECT_FALSE(mesh["primitives"][0].contains("targets"));
  const Eigen::MatrixXd turns = glb.Channel(1, "rotation");
  const Eigen::MatrixXd places = glb.Channel(1, "translation");
  ASSERT_EQ(turns.rows(), 2);
  for (int i = 0; i < 2; ++i) {
    const Eigen::Quaterniond turn(Eigen::Vector4d(turns.row(i)));
    EXPECT_NEAR(turn.norm(), 1, 1e-6);  // floats
    const Eigen::RowVector3d place =
        places.row(i) + glb.Translation(glb.Root());
    const Points moved =
        (local * turn.normalized().toRotationMatrix().transpose()).rowwise() +
        place;
    EXPECT_LT(FarthestMm(moved, conversion.Convert(written_.bone_frames[i])),
              kToleranceMm);
  }
}

TEST_F(GlbFile, KeepsItsPrecisionFarFromTheOrigin) {
  Animation animation = AnimationOf(run_, {1});
  const Eigen::RowVector3d far(1e5, -2e5, 3e5);  // 0.3 km
  const auto move = [&](RecordedPose pose) {
    for (auto* soups : {&pose.muscles, &pose.bones}) {
      for (TriangleSoup& soup : *soups) soup.points.rowwise() += far;
    }
    return pose;
  };
  animation.rest = move(animation.rest);
  animation.read = [&, read = animation.read](int i) { return move(read(i)); };
  WriteGlb(path_, animation);
  const Glb glb(path_);
  const json& node = glb.scene["nodes"][0];
  const json& primitive = glb.scene["meshes"][0]["primitives"][0];
  const Points moved = (glb.Floats(primitive["attributes"]["POSITION"]) +
                        glb.Floats(primitive["targets"][0]["POSITION"]))
                           .rowwise() +
                       (glb.Translation(node) + glb.Translation(glb.Root()));
  EXPECT_LT(FarthestMm(moved,
                       GltfFromAxes("ASR").Convert(
                           Points(written_.muscle_frames[1].rowwise() + far))),
            kToleranceMm);
}

TEST_F(GlbFile, IsTheSameIfBonesAreWrittenOnce) {
  WriteGlb(path_, AnimationOf(run_, {0, 1}));
  const std::string every = ReadFile(path_);
  written_.KeepBonesOnce();
  WriteGlb(path_, AnimationOf(run_, {0, 1}));
  EXPECT_TRUE(ReadFile(path_) == every);
}

TEST_F(GlbFile, IsNotThereIfAFrameCannotBeRead) {
  std::filesystem::remove(written_.dir + "/frame_0001/bone.ply");
  ExpectInputError(
      [&] {
        WriteGlb(path_, AnimationOf(run_, {0, 1}));
      },
      {"frame_0001", "bone"});
  for (const auto& entry : std::filesystem::directory_iterator(written_.dir)) {
    EXPECT_EQ(entry.path().string().find(".glb"), std::string::npos)
        << entry.path();
  }
  ExpectInputError(
      [&] { WriteGlb(written_.dir + "/no/a.glb", AnimationOf(run_, {0})); },
      {"no/a.glb", "cannot be written"});
}

}  // namespace
}  // namespace musclewarp
