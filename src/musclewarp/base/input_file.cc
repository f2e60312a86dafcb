// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/base/input_file.h"

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <system_error>

#include "musclewarp/base/input_error.h"

namespace musclewarp {
namespace {

namespace fs = std::filesystem;

void CheckIsFile(const std::string& path) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (!fs::exists(status)) {
    throw InputError(path, "does not exist", "check the name and the folder");
  }
  if (fs::is_directory(status)) {
    throw InputError(path, "is a folder", "name a file in it");
  }
  // Reading a pipe could block for ever.
  if (!fs::is_regular_file(status)) {
    throw InputError(path, "is not a regular file", "name a file");
  }
}

}  // namespace

std::string ReadFile(const std::string& path) {
  CheckIsFile(path);
  std::error_code error;
  const std::uintmax_t size = fs::file_size(path, error);
  std::ifstream file(path, std::ios::binary);
  if (error || !file) {
    throw InputError(
        path, "cannot be opened", "check that you are allowed to read it");
  }
  if (size == 0) {
    throw InputError(path, "is empty (0 bytes)", "copy or export it again");
  }
  std::string bytes(size, '\0');
  file.read(bytes.data(), static_cast<std::streamsize>(size));
  if (static_cast<std::uintmax_t>(file.gcount()) != size) {
    throw InputError(path,
                     "could be read up to byte " +
                         std::to_string(file.gcount()) + " of " +
                         std::to_string(size),
                     "check the disk and try again");
  }
  return bytes;
}

}  // namespace musclewarp
