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

struct PreparationCacheOptions {
  // The folder in which preparations are kept from run to run; it is made if
  // need be. Empty: none are kept. Whatever is in it may be deleted at any
  // time.
  std::string folder;

  // A text that differs between any two sets of options with which a scene is
  // prepared differently; it must not be empty if there is a folder. Programs
  // give their flags.
  std::string options_key;

  // Returns false and names the field, its value and the rule if a field is out
  // of range.
  bool IsValid(std::string* error) const;
};

// What preparing a scene comes to: all that takes long.
struct Preparation {
  PreparedScene scene;
  std::optional<RestResult> rest;  // with certified contact
};

// Keeps the preparation of a scene on disk, in a file of its own, so that a
// later run with the same meshes, lines, poses and options, by the same code,
// has it in a fraction of the time. What it reads is bit for bit what was
// written, and so are the frames. What other code has kept is neither read nor
// replaced.
//
//   const PreparationCache cache({folder, flags}, scene);
//   std::optional<Preparation> preparation = cache.Read(scene);
//   if (!preparation) {
//     preparation = Prepare(scene);
//     cache.Write(*preparation);
//   }
//
// Files appear complete or not at all, so that several programs may share a
// folder.
class PreparationCache {
 public:
  // Finds the file that belongs to the scene, by its contents and those of its
  // mesh files, and to the code. Throws InputError if the folder cannot be
  // made, or a file of the scene cannot be read. Precondition (CHECKed): the
  // options are valid and name a folder.
  PreparationCache(const PreparationCacheOptions& options,
                   const Scene& scene,
                   const std::string& code_key = CodeKey());

  // Returns the preparation of `scene`, the one of the constructor, or nothing
  // if it is not there. If only other code has kept one, or if the file is
  // damaged or that of another scene, that is logged.
  std::optional<Preparation> Read(const Scene& scene) const;

  // Writes a preparation. That it cannot be written, because the disk is full,
  // is logged and changes nothing else.
  void Write(const Preparation& preparation) const;

  // Returns the path of the file.
  const std::string& path() const { return path_; }

 private:
  std::string folder_;
  std::string scene_key_;  // begins the name of every file of the scene
  std::string key_;        // in the file: of scene and code
  std::string path_;
};

}  // namespace musclewarp
