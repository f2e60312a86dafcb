// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/motion/state_bytes.h"

#include <cereal/archives/binary.hpp>
#include <sstream>

#include "musclewarp/motion/state_archive.h"

namespace musclewarp {

std::string BytesOf(const SceneState& state) {
  std::ostringstream stream(std::ios::binary);
  cereal::BinaryOutputArchive archive(stream);
  archive(state);
  return stream.str();
}

SceneState StateFrom(const std::string& bytes) {
  std::istringstream stream(bytes, std::ios::binary);
  cereal::BinaryInputArchive archive(stream);
  SceneState state;
  archive(state);
  return state;
}

}  // namespace musclewarp
