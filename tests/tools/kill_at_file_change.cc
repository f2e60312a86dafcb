// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0

// A library to preload into a program, which it kills at a chosen change of the
// file system:
//   MUSCLEWARP_KILL_BEFORE_RENAME  before a file or folder is renamed to a path
//                                  that ends with this text;
//   MUSCLEWARP_KILL_AFTER_RENAME   right after that;
//   MUSCLEWARP_KILL_AFTER_REMOVE   right after a file of this name is removed
//                                  with the folder that it is in.

#include <dlfcn.h>

#include <csignal>
#include <cstdlib>
#include <string>

namespace {

void KillIfEndsAs(const std::string& path, const char* variable) {
  const char* const value = std::getenv(variable);
  if (!value) return;
  const std::string end = value;
  if (path.size() >= end.size() &&
      path.compare(path.size() - end.size(), end.size(), end) == 0) {
    std::raise(SIGKILL);
  }
}

}  // namespace

extern "C" {

int rename(const char* from, const char* to) {
  KillIfEndsAs(to, "MUSCLEWARP_KILL_BEFORE_RENAME");
  const auto next = reinterpret_cast<int (*)(const char*, const char*)>(
      dlsym(RTLD_NEXT, "rename"));
  const int result = next(from, to);
  KillIfEndsAs(to, "MUSCLEWARP_KILL_AFTER_RENAME");
  return result;
}

// What std::filesystem::remove_all calls, with names in an open folder.
int unlinkat(int folder, const char* name, int flags) {
  const auto next = reinterpret_cast<int (*)(int, const char*, int)>(
      dlsym(RTLD_NEXT, "unlinkat"));
  const int result = next(folder, name, flags);
  KillIfEndsAs(name, "MUSCLEWARP_KILL_AFTER_REMOVE");
  return result;
}

}  // extern "C"
