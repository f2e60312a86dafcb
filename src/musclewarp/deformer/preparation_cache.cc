// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/deformer/preparation_cache.h"

#include <glog/logging.h>

#include <cereal/archives/binary.hpp>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <utility>
#include <vector>

#include "musclewarp/base/content_hash.h"
#include "musclewarp/base/input_error.h"
#include "musclewarp/base/input_file.h"
#include "musclewarp/base/invalid_option.h"
#include "musclewarp/base/output_file.h"
#include "musclewarp/base/stopwatch.h"
#include "musclewarp/deformer/preparation_archive.h"
#include "musclewarp/mesh_files/mesh_path.h"
#include "musclewarp/scene/scene.h"

namespace musclewarp {
namespace {

namespace fs = std::filesystem;

// The first bytes of a file, followed by the key and a checksum of the rest.
constexpr char kMagic[] = "musclewarp preparation 3\n";

constexpr char kExtension[] = ".preparation";

std::string ChecksumOf(std::string_view bytes) {
  ContentHash hash;
  hash.Add(bytes);
  return hash.Hex();
}

// Returns the checksum of the code and of the archived fields.
std::string KeyOfCode(const std::string& code_key) {
  ContentHash hash;
  hash.Add(code_key);
  hash.Add(ArchivedFields());
  return hash.Hex();
}

template <typename... Parts>
std::string Archived(const Parts&... parts) {
  std::ostringstream stream(std::ios::binary);
  cereal::BinaryOutputArchive archive(stream);
  archive(parts...);
  return stream.str();
}

// Returns the checksum of the options, the scene and its mesh files.
std::string KeyOf(const PreparationCacheOptions& options, const Scene& scene) {
  ContentHash hash;
  hash.Add(options.options_key);
  hash.Add(Archived(scene.muscles,
                    scene.bones,
                    scene.poses,
                    scene.warnings,
                    RestPose(scene)));
  for (const SceneMuscle& muscle : scene.muscles) {
    if (muscle.mesh_path.empty()) continue;
    hash.Add(ReadFile(MeshFileOf(muscle.mesh_path)));
  }
  for (const SceneBone& bone : scene.bones) {
    if (bone.mesh_path.empty()) continue;
    hash.Add(ReadFile(MeshFileOf(bone.mesh_path)));
  }
  return hash.Hex();
}

// Returns the lines of the muscles. Preparation makes lines for muscles without
// any.
std::vector<std::vector<ActionLine>> LinesOf(const Scene& scene) {
  std::vector<std::vector<ActionLine>> lines;
  for (const SceneMuscle& muscle : scene.muscles) lines.push_back(muscle.lines);
  return lines;
}

// Returns a scene without the bones that its preparation has left out.
Scene WithBonesOf(const PreparedScene& prepared, Scene scene) {
  std::vector<SceneBone> bones;
  for (SceneBone& bone : scene.bones) {
    const bool is_next = bones.size() < prepared.bones.size() &&
                         prepared.bones[bones.size()].mesh.name == bone.name;
    if (is_next) bones.push_back(std::move(bone));
  }
  scene.bones = std::move(bones);
  return scene;
}

// Returns true if a file starts with the header of `key` and its checksum
// matches. Leaves the file positioned at the archived data.
bool IsIntact(const std::string& key, std::istream* file) {
  const std::string begin = kMagic + key;
  std::string header(begin.size() + ChecksumOf("").size(), '\0');
  file->read(header.data(), static_cast<std::streamsize>(header.size()));
  const std::streamoff start = file->tellg();
  file->seekg(0, std::ios::end);
  const std::streamoff end = file->tellg();
  if (start < 0 || end < start) return false;
  std::string rest(end - start, '\0');
  file->seekg(start);
  file->read(rest.data(), static_cast<std::streamsize>(rest.size()));
  if (header != begin + ChecksumOf(rest)) return false;
  file->clear();
  file->seekg(static_cast<std::streamoff>(header.size()));
  return true;
}

// Logs a preparation of the scene by another version of the code, if any.
// Called if this version has not stored one.
void SayIfOtherCodeHasOne(const std::string& folder,
                          const std::string& scene_key) {
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder, error)) {
    const std::string name = entry.path().filename().string();
    if (name.rfind(scene_key + "-", 0) != 0 ||
        entry.path().extension() != kExtension) {
      continue;
    }
    LOG(WARNING) << entry.path().string()
                 << ": was made by other code of musclewarp; the scene is "
                    "prepared again, and the file is left as it is";
    return;
  }
}

void CheckFolder(const std::string& folder) {
  const std::string obstacle = ObstacleToWriting(folder);
  if (obstacle.empty()) return;
  throw InputError(folder,
                   obstacle + " is not a folder that can be written",
                   "choose another folder for preparations, or none");
}

}  // namespace

bool PreparationCacheOptions::IsValid(std::string* error) const {
  if (folder.empty() || !options_key.empty()) return true;
  return InvalidOption("PreparationCacheOptions::options_key",
                       "\"\"",
                       "a text, as there is a folder",
                       error);
}

PreparationCache::PreparationCache(const PreparationCacheOptions& options,
                                   const Scene& scene,
                                   const std::string& code_key)
    : folder_(options.folder) {
  std::string error;
  CHECK(options.IsValid(&error)) << error;
  CHECK(!options.folder.empty());
  CheckFolder(folder_);
  scene_key_ = KeyOf(options, scene);
  key_ = scene_key_ + "-" + KeyOfCode(code_key);
  path_ = (fs::path(folder_) / (key_ + kExtension)).string();
}

std::optional<Preparation> PreparationCache::Read(const Scene& scene) const {
  std::ifstream file(path_, std::ios::binary);
  if (!file) {
    SayIfOtherCodeHasOne(folder_, scene_key_);
    return std::nullopt;
  }
  const Stopwatch reading;
  try {
    if (!IsIntact(key_, &file)) {
      LOG(WARNING) << path_ << ": is damaged; the scene is prepared again";
      return std::nullopt;
    }
    cereal::BinaryInputArchive archive(file);
    Preparation preparation;
    std::vector<std::vector<ActionLine>> lines;
    archive(preparation.scene, preparation.rest, lines);
    preparation.scene.scene = WithBonesOf(preparation.scene, scene);
    for (size_t i = 0; i < scene.muscles.size(); ++i) {
      preparation.scene.scene.muscles[i].lines = std::move(lines.at(i));
      FactorNormalMatrix(&preparation.scene.muscles.at(i).model);
    }
    AddBoneTrees(&preparation.scene.bones);
    preparation.scene.is_cached = true;
    preparation.scene.wall_ms = reading.Milliseconds();
    return preparation;
  } catch (const std::exception& error) {  // any error of a damaged file
    LOG(WARNING) << path_ << ": cannot be read (" << error.what()
                 << "); the scene is prepared again";
  }
  return std::nullopt;
}

void PreparationCache::Write(const Preparation& preparation) const {
  try {
    const std::string archived = Archived(
        preparation.scene, preparation.rest, LinesOf(preparation.scene.scene));
    std::error_code error;
    fs::create_directories(folder_, error);  // writing fails without it
    WriteTextAtomically(path_, kMagic + key_ + ChecksumOf(archived) + archived);
  } catch (const InputError& error) {
    LOG(WARNING) << error.what();
  }
}

}  // namespace musclewarp
