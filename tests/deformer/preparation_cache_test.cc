// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/deformer/preparation_cache.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "musclewarp/base/input_error.h"
#include "musclewarp/base/input_file.h"
#include "musclewarp/base/output_file.h"
#include "musclewarp/deformer/deformer.h"
#include "musclewarp/mesh_files/mesh_io.h"
#include "support/small_scene.h"
#include "support/temp_dir.h"

namespace musclewarp {
namespace {

namespace fs = std::filesystem;

// Options with a cache of their own folder.
DeformerOptions CachedOptions(ContactKind contact, const std::string& folder) {
  DeformerOptions options;
  options.frames.contact = contact;
  options.prepare.muscle.hull.coarse_vertices = 60;
  options.prepare.fibres.fibres = 3;
  options.cache = {folder, "60 " + ToString(contact)};
  return options;
}

std::string NewFolder(const std::string& name) {
  const fs::path folder = fs::path(TestTempDir()) / name;
  fs::remove_all(folder);
  return folder.string();
}

void ExpectEqual(const Frame& a, const Frame& b) {
  ASSERT_EQ(a.muscles.size(), b.muscles.size());
  for (size_t i = 0; i < a.muscles.size(); ++i) {
    EXPECT_EQ(a.muscles[i].points, b.muscles[i].points);
    EXPECT_EQ(a.muscles[i].lines, b.muscles[i].lines);
    EXPECT_EQ(a.muscles[i].fibres, b.muscles[i].fibres);
  }
  EXPECT_EQ(a.shortcomings, b.shortcomings);
}

// By bits: what is read is what was made.
TEST(PreparationCache, FramesAreTheSameAsWithoutIt) {
  for (const ContactKind contact :
       {ContactKind::kNone, ContactKind::kPaper, ContactKind::kCertified}) {
    const DeformerOptions options =
        CachedOptions(contact, NewFolder("cache_" + ToString(contact)));
    DeformerOptions without = options;
    without.cache = {};
    Deformer anew(SmallScene(), without);
    Deformer first(SmallScene(), options);
    Deformer second(SmallScene(), options);
    EXPECT_FALSE(anew.scene().is_cached);
    EXPECT_FALSE(first.scene().is_cached);
    EXPECT_TRUE(second.scene().is_cached);
    EXPECT_EQ(anew.scene().warnings, second.scene().warnings);
    ExpectEqual(anew.RestFrame(), second.RestFrame());
    const Frame frame = anew.MoveTo(FlexedPose(0.1));
    ExpectEqual(frame, first.MoveTo(FlexedPose(0.1)));
    ExpectEqual(frame, second.MoveTo(FlexedPose(0.1)));
  }
}

TEST(PreparationCache, EverythingThatCountsChangesTheFile) {
  const std::string folder = NewFolder("cache_keys");
  const auto path = [&](const Scene& scene,
                        const std::string& key = "default") {
    return PreparationCache({folder, key}, scene).path();
  };
  const Scene scene = SmallScene();
  EXPECT_EQ(path(scene), path(SmallScene()));
  EXPECT_NE(path(scene), path(scene, "--gap=0.2"));
  Scene other = scene;
  other.muscles[0].points(0, 0) += 1e-9;
  EXPECT_NE(path(scene), path(other));
  other = scene;
  other.bones[0].body = "another body";
  EXPECT_NE(path(scene), path(other));
  other = scene;
  other.muscles[1].lines[0].rest(0, 2) += 1;
  EXPECT_NE(path(scene), path(other));
  other = scene;
  other.poses.push_back(FlexedPose(0.3));
  EXPECT_NE(path(scene), path(other));
}

TEST(PreparationCache, FilesCountByTheirContents) {
  const std::string folder = NewFolder("cache_files");
  Scene scene = SmallScene();
  SceneMuscle& muscle = scene.muscles[0];
  muscle.mesh_path = (fs::path(TestTempDir()) / "cached.obj").string();
  const auto path_with = [&](double x) {
    muscle.points(0, 0) += x;
    WriteTriangleSoup(muscle.mesh_path, {muscle.points, muscle.triangles});
    muscle.points(0, 0) -= x;
    return PreparationCache({folder, "default"}, scene).path();
  };
  const std::string before = path_with(0);
  EXPECT_NE(path_with(0.5), before);
  EXPECT_EQ(path_with(0), before);
}

// Options that nothing tells apart would be taken for each other.
TEST(PreparationCache, AFolderNeedsAKey) {
  std::string error;
  EXPECT_TRUE(PreparationCacheOptions().IsValid(&error));
  EXPECT_FALSE(PreparationCacheOptions({"folder", ""}).IsValid(&error));
  EXPECT_NE(error.find("options_key"), std::string::npos) << error;
}

// As after a user has copied one over the other.
TEST(PreparationCache, TheFileOfAnotherSceneIsNotTaken) {
  const DeformerOptions options =
      CachedOptions(ContactKind::kNone, NewFolder("cache_renamed"));
  Scene scene = SmallScene();
  for (SceneBone& bone : scene.bones) bone.body = bone.name;
  Deformer(scene, options);
  Scene other = scene;
  other.muscles[0].points(0, 0) += 1e-3;
  const PreparationCache cache(options.cache, other);
  fs::copy_file(PreparationCache(options.cache, scene).path(), cache.path());
  EXPECT_FALSE(cache.Read(other));
}

// A changed byte anywhere, or a part that is missing.
TEST(PreparationCache, DamagedFilesAreMadeAgain) {
  const DeformerOptions options =
      CachedOptions(ContactKind::kNone, NewFolder("cache_damaged"));
  Scene scene = SmallScene();
  for (SceneBone& bone : scene.bones)
    bone.body = bone.name;  // as a Deformer has
  const PreparationCache cache(options.cache, scene);
  EXPECT_FALSE(cache.Read(scene));
  Deformer(scene, options);
  const std::string good = ReadFile(cache.path());
  EXPECT_TRUE(cache.Read(scene));
  for (const size_t place : {size_t{3}, size_t{30}, good.size() / 2}) {
    std::string bad = good;
    bad[place] = static_cast<char>(bad[place] ^ 1);
    WriteTextAtomically(cache.path(), bad);
    EXPECT_FALSE(cache.Read(scene));
  }
  for (const size_t size : {size_t{0}, size_t{20}, good.size() - 1}) {
    WriteTextAtomically(cache.path(), good.substr(0, size));
    EXPECT_FALSE(cache.Read(scene));
  }
  EXPECT_FALSE(Deformer(scene, options).scene().is_cached);
  EXPECT_TRUE(cache.Read(scene));
}

// The same scene and options, prepared by a program of other sources.
TEST(PreparationCache, WhatOtherCodeHasKeptIsNeitherReadNorReplaced) {
  const DeformerOptions options =
      CachedOptions(ContactKind::kNone, NewFolder("cache_code"));
  Scene scene = SmallScene();
  for (SceneBone& bone : scene.bones) bone.body = bone.name;
  Deformer(scene, options);
  const PreparationCache ours(options.cache, scene);
  const PreparationCache theirs(options.cache, scene, "0.1.0 of another day");
  EXPECT_TRUE(ours.Read(scene));
  ::testing::internal::CaptureStderr();
  EXPECT_FALSE(theirs.Read(scene));
  const std::string said = ::testing::internal::GetCapturedStderr();
  EXPECT_NE(said.find("other code"), std::string::npos) << said;
  EXPECT_NE(ours.path(), theirs.path());
  EXPECT_TRUE(fs::exists(ours.path()));
}

TEST(PreparationCache, AFolderThatCannotBeMadeIsRefused) {
  const std::string file = (fs::path(TestTempDir()) / "a_file").string();
  WriteTextAtomically(file, "");
  EXPECT_THROW(PreparationCache({file + "/folder", "default"}, SmallScene()),
               InputError);
}

}  // namespace
}  // namespace musclewarp
