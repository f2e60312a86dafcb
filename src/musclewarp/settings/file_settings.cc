// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/settings/file_settings.h"

#include <algorithm>

#include "musclewarp/base/text.h"
#include "musclewarp/mesh_files/mesh_io.h"
#include "musclewarp/settings/checked_settings.h"

namespace musclewarp {

std::vector<std::string> OptionsOf(const FormatSettings& settings) {
  CheckSettings(settings);
  const std::vector<std::string> formats = Split(settings.format, ',');
  for (const std::string& name : formats) {
    if (IsMeshExtension(name)) continue;
    throw InputError("{format}=" + settings.format,
                     "\"" + name + "\" cannot be written by this build",
                     "build it with VTK, or leave " + name + " out");
  }
  return formats;
}

FrameFileOptions OptionsOf(const FileSettings& settings) {
  CheckSettings(settings);
  FrameFileOptions files;
  files.formats = OptionsOf(PartOf<FormatSettings>(settings));
  files.bones = Named(settings.bones, {BoneFiles::kEvery, BoneFiles::kOnce});
  const auto has_bones = [&](const std::string& format) {
    return files.HasBonesInFrames(format);
  };
  if (files.bones == BoneFiles::kOnce &&
      std::all_of(files.formats.begin(), files.formats.end(), has_bones)) {
    throw InputError("{bones}=once",
                     "changes nothing with {format}=" + settings.format +
                         ": ParaView plays .vtp files as they are, so bones "
                         "have to be in every frame",
                     "add ply or obj to {format}, or use {bones}=every");
  }
  return files;
}

}  // namespace musclewarp
