// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/run/output_lock.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <system_error>

#include "musclewarp/base/input_error.h"

namespace musclewarp {
namespace {

namespace fs = std::filesystem;

constexpr char kLockFile[] = ".musclewarp.lock";

// Returns the missing folders on the path `dir`, outermost first.
std::vector<std::string> MissingFolders(const std::string& dir) {
  std::vector<std::string> missing;
  std::error_code error;
  fs::path path = fs::absolute(dir, error).lexically_normal();
  if (!path.has_filename()) path = path.parent_path();
  for (; !fs::exists(path, error) && path.has_relative_path();
       path = path.parent_path()) {
    missing.insert(missing.begin(), path.string());
  }
  return missing;
}

std::string CommandLineOfThisProcess() {
  constexpr size_t kMost = 1000;  // characters
  std::ifstream file("/proc/self/cmdline", std::ios::binary);
  std::string line{std::istreambuf_iterator<char>(file), {}};
  while (!line.empty() && line.back() == '\0') line.pop_back();
  std::replace(line.begin(), line.end(), '\0', ' ');
  std::replace(line.begin(), line.end(), '\n', ' ');
  if (line.size() > kMost) line = line.substr(0, kMost) + " ...";
  return line;
}

// Returns a description of this run, for the message to runs that do not get
// the lock.
std::string ThisRun() {
  std::array<char, 256> host = {};
  if (gethostname(host.data(), host.size() - 1) != 0) host[0] = '\0';
  std::array<char, 32> since = {};
  const std::time_t now = std::time(nullptr);
  std::tm local = {};
  localtime_r(&now, &local);
  std::strftime(since.data(), since.size(), "%Y-%m-%d %H:%M:%S", &local);
  return "process " + std::to_string(getpid()) + " on " + host.data() +
         ", since " + since.data() + ": " + CommandLineOfThisProcess();
}

std::string TextOf(int descriptor) {
  constexpr size_t kMost = 4096;  // bytes
  std::string text(kMost, '\0');
  const ssize_t size = pread(descriptor, text.data(), text.size(), 0);
  text.resize(size > 0 ? static_cast<size_t>(size) : 0);
  return text;
}

// Writes the text if possible: the lock holds without it.
void WriteText(int descriptor, const std::string& text) {
  if (ftruncate(descriptor, 0) != 0) return;
  if (pwrite(descriptor, text.data(), text.size(), 0) < 0) return;
}

// Returns true if the open file is still the one with that name.
bool IsFile(int descriptor, const std::string& file) {
  struct stat open = {}, named = {};
  return fstat(descriptor, &open) == 0 && stat(file.c_str(), &named) == 0 &&
         open.st_dev == named.st_dev && open.st_ino == named.st_ino;
}

}  // namespace

OutputLock::OutputLock(const std::string& dir)
    : dir_(dir), file_((fs::path(dir) / kLockFile).string()) {
  made_ = MissingFolders(dir);
  std::error_code error;
  fs::create_directories(dir, error);
  try {
    while (!TryToLock()) {
    }
  } catch (...) {
    Release();
    throw;
  }
}

bool OutputLock::TryToLock() {
  descriptor_ = open(file_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
  // The file may belong to another user.
  if (descriptor_ < 0) descriptor_ = open(file_.c_str(), O_RDONLY | O_CLOEXEC);
  // Whoever writes to the folder reports what is wrong with it.
  if (descriptor_ < 0) return true;
  if (flock(descriptor_, LOCK_EX | LOCK_NB) != 0) {
    const bool is_locked = errno == EWOULDBLOCK;
    const std::string other = is_locked ? TextOf(descriptor_) : "";
    close(descriptor_);
    descriptor_ = -1;
    if (!is_locked) {
      unlink(file_.c_str());
      return true;
    }
    throw InputError("{out}=" + dir_,
                     "another run writes to this folder" +
                         (other.empty() ? std::string() : " (" + other + ")"),
                     "wait until it has ended, or choose another {out}");
  }
  if (!IsFile(descriptor_, file_)) {
    close(descriptor_);
    descriptor_ = -1;
    return false;
  }
  WriteText(descriptor_, ThisRun());
  return true;
}

void OutputLock::Release() {
  if (descriptor_ >= 0) {
    // The file is removed first: a run that has opened it before finds that it
    // is no longer the one with that name.
    unlink(file_.c_str());
    flock(descriptor_, LOCK_UN);  // also for children that inherited it
    close(descriptor_);
    descriptor_ = -1;
  }
  std::error_code not_empty;
  for (auto folder = made_.rbegin(); folder != made_.rend(); ++folder) {
    if (!fs::is_empty(*folder, not_empty)) break;
    fs::remove(*folder, not_empty);
  }
  made_.clear();
}

}  // namespace musclewarp
