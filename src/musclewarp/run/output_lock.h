// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace musclewarp {

// Keeps a second run out of an output folder while a first one writes to it:
// the two would mix their files. The lock is the kernel's (flock), which
// releases it when the program ends, however it does; a file that is left by a
// program that was killed keeps nobody out.
//
//   const OutputLock lock(options.out);  // throws if another run has it
//
// The lock is on the hidden file .musclewarp.lock in the folder, which says
// whose it is. On file systems that have no locks there is none, and nothing is
// said.
class OutputLock {
 public:
  // Makes the folder if need be. Throws InputError, naming --out, if another
  // run has the lock: it names the run and says what to do.
  explicit OutputLock(const std::string& dir);

  // Removes the file, and the folders that the constructor made if nothing was
  // written to them.
  ~OutputLock() { Release(); }

  OutputLock(const OutputLock&) = delete;
  OutputLock& operator=(const OutputLock&) = delete;

  // Does what the destructor does, for a program that ends without it.
  void Release();

 private:
  // Returns false if the file was replaced while it was being locked.
  bool TryToLock();

  std::string dir_, file_;
  std::vector<std::string> made_;  // folders, the outermost first
  int descriptor_ = -1;            // of the file, or -1
};

}  // namespace musclewarp
