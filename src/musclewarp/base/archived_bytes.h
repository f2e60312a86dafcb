// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Objects as bytes, for another process of the same build. To be included by
// the few sources that need it, after the archives of the objects
// (archived_fields.h), as it brings all of cereal along.

#include <cereal/archives/binary.hpp>
#include <exception>
#include <sstream>
#include <string>

#include "musclewarp/base/archived_fields.h"
#include "musclewarp/base/content_hash.h"
#include "musclewarp/base/input_error.h"

namespace musclewarp {

// Returns objects as bytes, which begin with a checksum of the fields that this
// build archives.
template <typename... Objects>
std::string ArchivedBytes(const Objects&... objects) {
  ContentHash fields;
  fields.Add(ArchivedFields());
  std::ostringstream stream(std::ios::binary);
  cereal::BinaryOutputArchive archive(stream);
  archive(fields.Hex(), objects...);
  return stream.str();
}

// Restores the objects, bit for bit. Throws InputError, naming `where`, if the
// bytes are damaged or of a build with other fields.
template <typename... Objects>
void RestoreArchived(const std::string& bytes,
                     const std::string& where,
                     Objects*... objects) {
  ContentHash fields;
  fields.Add(ArchivedFields());
  std::istringstream stream(bytes, std::ios::binary);
  std::string key;
  try {
    cereal::BinaryInputArchive archive(stream);
    archive(key);
    if (key == fields.Hex()) archive(*objects...);
  } catch (const InputError&) {
    throw;
  } catch (const std::exception& error) {  // of cereal or memory
    throw InputError(where,
                     "is damaged (" + std::string(error.what()) + ")",
                     "make it again");
  }
  if (key != fields.Hex()) {
    throw InputError(where,
                     "was made by another version of musclewarp",
                     "make it again with this one");
  }
}

}  // namespace musclewarp
