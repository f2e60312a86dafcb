// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "musclewarp/build_info/build_info.h"
#include "musclewarp/frame_solvers/rest_result.h"
#include "musclewarp/preparation/prepared_scene.h"
#include "musclewarp/scene/scene.h"

namespace musclewarp {

// The folder of a PreparationCache, and the part of its key that stands for the
// options.
struct PreparationCacheOptions {
  // The folder of the cache, created once there is a preparation. Empty: no
  // cache. Its contents may be deleted at any time.
  std::string folder;

  // A text that identifies the options of the preparation: options that lead to
  // different preparations need different texts. Must not be empty if `folder`
  // is set. Programs pass their flags.
  std::string options_key;

  // Returns false and names the field, its value and the rule if a field is out
  // of range.
  bool IsValid(std::string* error) const;
};

// The result of preparing a scene, which takes long to compute.
struct Preparation {
  PreparedScene scene;
  std::optional<RestResult> rest;  // with certified contact
};

// Caches the preparation of a scene on disk, one file per scene, so that later
// runs with the same meshes, lines, poses, options and code read it in a
// fraction of the time. Preparations are restored bit for bit, and so are the
// frames computed from them. Files of other versions of the code are neither
// read nor replaced.
//
//   const PreparationCache cache({folder, flags}, scene);
//   std::optional<Preparation> preparation = cache.Read(scene);
//   if (!preparation) {
//     preparation = Prepare(scene);
//     cache.Write(*preparation);
//   }
//
// Files are written atomically, so several programs may share a folder.
class PreparationCache {
 public:
  // Computes the path of the file from the contents of the scene and its mesh
  // files, the options and the code. Throws InputError if the folder cannot be
  // written, or a file of the scene cannot be read. Precondition (CHECKed): the
  // options are valid and name a folder.
  PreparationCache(const PreparationCacheOptions& options,
                   const Scene& scene,
                   const std::string& code_key = CodeKey());

  // Returns the preparation of `scene`, the scene of the constructor, or
  // nothing if none is stored. Logs a warning if the file is damaged or of
  // another scene, or if only another version of the code has stored one.
  std::optional<Preparation> Read(const Scene& scene) const;

  // Writes a preparation. A failure, as on a full disk, is logged and has no
  // other effect.
  void Write(const Preparation& preparation) const;

  // Returns the path of the file.
  const std::string& path() const { return path_; }

 private:
  std::string folder_;
  std::string scene_key_;  // prefix of the name of every file of the scene
  std::string key_;        // of scene and code, also stored in the file
  std::string path_;
};

}  // namespace musclewarp
