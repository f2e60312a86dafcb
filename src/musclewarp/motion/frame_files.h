// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "musclewarp/motion/frame.h"

namespace musclewarp {

// "frame_0007"
std::string FrameFolder(int index);

// Writes all meshes of a frame to DIR/frame_0000/<name>.<format>, every file
// complete or not at all. Formats are extensions without dot; all of them keep
// double precision (.stl does not and is not offered by the programs).
void WriteFrame(const PreparedScene& scene,
                const Frame& frame,
                const std::vector<std::string>& formats,
                const std::string& dir);

// Writes DIR/motion.pvd, by which ParaView plays the .vtp files of `frames`.
void WritePvd(const PreparedScene& scene,
              const std::vector<int>& frames,
              const std::string& dir);

}  // namespace musclewarp
