// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/base/output_file.h"

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <vector>

#include "musclewarp/base/input_error.h"

namespace musclewarp {
namespace fs = std::filesystem;

namespace {

// The part of a name that marks what is being written.
constexpr char kPartial[] = ".partial";

// Returns the path of a folder without a slash at the end, so that it has a
// name.
fs::path NamedFolder(const std::string& path) {
  const fs::path folder(path);
  return folder.has_filename() ? folder : folder.parent_path();
}

// Puts a folder back that was moved away, or removes it if another program has
// written to its place meanwhile.
void PutBack(const fs::path& moved, const fs::path& target) {
  std::error_code ignored;
  fs::rename(moved, target, ignored);
  if (fs::exists(target, ignored)) fs::remove_all(moved, ignored);
}

}  // namespace

std::string ObstacleToWriting(const std::string& dir) {
  fs::path existing = fs::absolute(dir);
  std::error_code error;
  while (!fs::exists(existing, error) && existing.has_relative_path()) {
    existing = existing.parent_path();
  }
  const bool is_writable = fs::is_directory(existing, error) &&
                           access(existing.c_str(), W_OK | X_OK) == 0;
  return is_writable ? "" : existing.string();
}

void WriteFileAtomically(const std::string& path,
                         const std::function<void(const std::string&)>& write) {
  const fs::path target(path);
  // The extension is the same because writers choose the format by it.
  const fs::path partial =
      target.parent_path() /
      ("." + target.stem().string() + kPartial + std::to_string(getpid()) +
       target.extension().string());
  try {
    write(partial.string());
    fs::rename(partial, target);
  } catch (const fs::filesystem_error& error) {
    std::error_code ignored;
    fs::remove(partial, ignored);
    throw InputError(path,
                     "cannot be written (" + error.code().message() + ")",
                     "choose a folder that exists and can be written");
  } catch (...) {
    std::error_code ignored;
    fs::remove(partial, ignored);
    throw;
  }
}

void WriteTextAtomically(const std::string& path, const std::string& text) {
  WriteFileAtomically(path, [&](const std::string& partial) {
    std::ofstream file(partial, std::ios::binary);
    file << text;
    file.close();
    if (!file) {
      throw InputError(path,
                       "cannot be written",
                       "choose a folder that exists, can be written and has "
                       "room");
    }
  });
}

void RemoveFolderAtomically(const std::string& path) {
  const fs::path target(path);
  if (!fs::exists(target)) return;
  const fs::path hidden =
      target.parent_path() /
      ("." + target.filename().string() + kPartial + ".replaced");
  fs::remove_all(hidden);
  fs::rename(target, hidden);
  fs::remove_all(hidden);
}

void WriteFolderAtomically(
    const std::string& path,
    const std::function<void(const std::string&)>& write) {
  const fs::path target = NamedFolder(path);
  // Programs that write the same folder at once must not share this one.
  const fs::path partial =
      target.parent_path() /
      (kPartial + std::to_string(getpid()) + "." + target.filename().string());
  const fs::path replaced = partial.string() + ".replaced";
  const auto give_up = [&] {
    std::error_code ignored;
    fs::remove_all(partial, ignored);
    PutBack(replaced, target);
  };
  try {
    fs::remove_all(partial);
    fs::remove_all(replaced);
    fs::create_directories(partial);
    write(partial.string());
    // A program that is killed while it removes a folder leaves half of it, so
    // this one is hidden first.
    if (fs::exists(target)) fs::rename(target, replaced);
    fs::rename(partial, target);
    fs::remove_all(replaced);
  } catch (const fs::filesystem_error& error) {
    give_up();
    throw InputError(path,
                     "cannot be written (" + error.code().message() + ")",
                     "choose a folder that can be written and has room");
  } catch (...) {
    give_up();
    throw;
  }
}

void RemovePartialOutput(const std::string& dir) {
  std::vector<fs::path> partial;
  for (const auto& entry : fs::directory_iterator(dir)) {
    const std::string name = entry.path().filename().string();
    if (name[0] == '.' && name.find(kPartial) != std::string::npos) {
      partial.push_back(entry.path());
    }
  }
  for (const fs::path& path : partial) fs::remove_all(path);
}

}  // namespace musclewarp
