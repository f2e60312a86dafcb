// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "musclewarp/base/described.h"
#include "musclewarp/run/frame_files.h"

namespace musclewarp {

// The setting of the formats of mesh files.
struct FormatSettings {
  std::string format = "ply";
};

constexpr auto FieldsOf(Described<FormatSettings>) {
  return std::make_tuple(Field(&FormatSettings::format, "format")
                             .Text("mesh files to write: ply, obj, vtp; commas")
                             .OneOf("ply, obj, vtp; commas")
                             .Changes(Effect::kFiles));
}

// Returns the formats of the settings, such as "ply". Throws InputError, naming
// the setting, if there is none, or this build cannot write one of them.
std::vector<std::string> OptionsOf(const FormatSettings& settings);

// The settings of the files of a run.
struct FileSettings : FormatSettings {
  std::string bones = ToString(FrameFileOptions().bones);
};

constexpr auto FieldsOf(Described<FileSettings>) {
  using S = FileSettings;
  return std::make_tuple(
      Inherited<FormatSettings>(),
      Field(&S::bones, "bones")
          .Text("which folders have the meshes of bones: every (those of all "
                "frames) or once (the rest folder only; bones.json of a frame "
                "has the motions of its bones, and vtp keeps them in every "
                "frame)")
          .OneOf("every, once")
          .Changes(Effect::kFiles));
}

// Returns the options that the settings mean. Throws InputError, naming the
// setting, for a value that is not allowed, a format that this build cannot
// write, and bones=once if every format has the bones in every frame.
FrameFileOptions OptionsOf(const FileSettings& settings);

}  // namespace musclewarp
