// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/run/output_folder.h"

#include <filesystem>

#include "musclewarp/base/input_error.h"
#include "musclewarp/base/output_file.h"
#include "musclewarp/mesh_files/mesh_path.h"

namespace musclewarp {

namespace fs = std::filesystem;

void CheckWritable(const std::string& dir) {
  if (dir.empty()) {
    throw InputError("{out}", "is missing", "give the folder for the results");
  }
  const std::string obstacle = ObstacleToWriting(dir);
  if (!obstacle.empty()) {
    throw InputError("{out}=" + dir,
                     obstacle + " is not a folder that can be written",
                     "choose another folder");
  }
}

void MakeFolder(const std::string& dir) {
  std::error_code error;
  fs::create_directories(dir, error);
  if (error) {
    throw InputError("{out}=" + dir,
                     "cannot be made (" + error.message() + ")",
                     "choose another folder");
  }
}

void CheckInputsStay(const std::vector<std::string>& files,
                     const std::string& dir,
                     const std::vector<std::string>& names) {
  for (const std::string& file : files) {
    for (const std::string& name : names) {
      std::error_code error;
      const auto result = std::filesystem::path(dir) / name;
      if (!std::filesystem::equivalent(result, MeshFileOf(file), error)) {
        continue;
      }
      throw InputError("{out}=" + dir,
                       "has the input " + file + ", which would be replaced",
                       "choose another folder");
    }
  }
}

}  // namespace musclewarp
