// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/deformer/preparation_cache.h"

#include <glog/logging.h>

#include <cereal/archives/binary.hpp>
#include <exception>
#include <filesystem>
#include <sstream>
#include <utility>
#include <vector>

#include "musclewarp/base/content_hash.h"
#include "musclewarp/base/input_error.h"
#include "musclewarp/base/input_file.h"
#include "musclewarp/base/output_file.h"
#include "musclewarp/base/stopwatch.h"
#include "musclewarp/deformer/preparation_archive.h"

namespace musclewarp {
namespace {

namespace fs = std::filesystem;

// The first bytes of a file; the number changes with what is in it.
constexpr char kMagic[] = "musclewarp preparation 1\n";

std::string ChecksumOf(std::string_view bytes) {
  ContentHash hash;
  hash.Add(bytes);
  return hash.Hex();
}

template <typename... Parts>
std::string Archived(const Parts&... parts) {
  std::ostringstream stream(std::ios::binary);
  cereal::BinaryOutputArchive archive(stream);
  archive(parts...);
  return stream.str();
}

// Returns the checksum of all that a preparation depends on.
std::string KeyOf(const PreparationCacheOptions& options, const Scene& scene) {
  ContentHash hash;
  hash.Add(kMagic);
  hash.Add(MUSCLEWARP_VERSION);
  hash.Add(options.options_key);
  hash.Add(Archived(scene.muscles, scene.bones, scene.poses, scene.warnings));
  for (const SceneMuscle& muscle : scene.muscles) {
    if (!muscle.mesh_path.empty()) hash.Add(ReadFile(muscle.mesh_path));
  }
  for (const SceneBone& bone : scene.bones) {
    if (!bone.mesh_path.empty()) hash.Add(ReadFile(bone.mesh_path));
  }
  return hash.Hex();
}

// The lines of the muscles, which preparing adds where there are none.
std::vector<std::vector<ActionLine>> LinesOf(const Scene& scene) {
  std::vector<std::vector<ActionLine>> lines;
  for (const SceneMuscle& muscle : scene.muscles) lines.push_back(muscle.lines);
  return lines;
}

// Returns what follows the magic bytes and the checksum, or nothing if either
// is not as it was written.
std::optional<std::string> PayloadOf(const std::string& file) {
  const size_t magic = sizeof(kMagic) - 1;
  const size_t begin = magic + ChecksumOf("").size();
  if (file.size() < begin || file.compare(0, magic, kMagic) != 0) return {};
  const std::string_view payload = std::string_view(file).substr(begin);
  if (ChecksumOf(payload) != file.substr(magic, begin - magic)) return {};
  return std::string(payload);
}

void MakeFolder(const std::string& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (!error) return;
  throw InputError(folder,
                   "cannot be made (" + error.message() + ")",
                   "choose another folder for preparations, or none");
}

}  // namespace

PreparationCache::PreparationCache(const PreparationCacheOptions& options,
                                   const Scene& scene) {
  MakeFolder(options.folder);
  path_ = (fs::path(options.folder) / (KeyOf(options, scene) + ".preparation"))
              .string();
}

std::optional<Preparation> PreparationCache::Read(const Scene& scene) const {
  if (!fs::exists(path_)) return std::nullopt;
  const Stopwatch reading;
  try {
    const std::optional<std::string> payload = PayloadOf(ReadFile(path_));
    if (!payload) {
      LOG(WARNING) << path_ << ": is damaged; the scene is prepared again";
      return std::nullopt;
    }
    std::istringstream stream(*payload, std::ios::binary);
    cereal::BinaryInputArchive archive(stream);
    Preparation preparation;
    std::vector<std::vector<ActionLine>> lines;
    archive(preparation.scene, preparation.rest, lines);
    CHECK_EQ(lines.size(), scene.muscles.size());
    preparation.scene.scene = scene;
    for (size_t i = 0; i < lines.size(); ++i) {
      preparation.scene.scene.muscles[i].lines = std::move(lines[i]);
      FactorNormalMatrix(&preparation.scene.muscles[i].model);
    }
    preparation.scene.is_cached = true;
    preparation.scene.wall_ms = reading.Milliseconds();
    return preparation;
  } catch (const InputError& error) {  // it may have been deleted just now
    LOG(WARNING) << error.what();
  } catch (const cereal::Exception& error) {
    LOG(WARNING) << path_ << ": cannot be read (" << error.what()
                 << "); the scene is prepared again";
  }
  return std::nullopt;
}

void PreparationCache::Write(const PreparedScene& scene,
                             const std::optional<SeparatedRest>& rest) const {
  try {
    const std::string payload = Archived(scene, rest, LinesOf(scene.scene));
    WriteTextAtomically(path_, kMagic + ChecksumOf(payload) + payload);
  } catch (const InputError& error) {
    LOG(WARNING) << error.what();
  }
}

}  // namespace musclewarp
