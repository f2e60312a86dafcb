// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace musclewarp {

// Keeps a second run out of an output folder while a first one writes to it, as
// their files would mix. The lock is one of the kernel (flock), which releases
// it when the program ends for whatever reason; a file that a killed program
// has left keeps nobody out.
//
//   const OutputLock lock(options.out);  // throws if another run has it
//
// The lock is on the hidden file .musclewarp.lock in the folder, which contains
// the owner of the lock. On file systems without locks nothing is locked, and
// no message says so.
class OutputLock {
 public:
  // Makes the folder if it does not exist. Throws InputError, naming {out}, if
  // another run has the lock; the message names the run and what to do.
  explicit OutputLock(const std::string& dir);

  // Removes the file, and the folders that the constructor made if they are
  // empty.
  ~OutputLock() { Release(); }

  OutputLock(const OutputLock&) = delete;
  OutputLock& operator=(const OutputLock&) = delete;

  // Does the same as the destructor, for a program that ends without it.
  void Release();

 private:
  // Returns false if the file was replaced while it was being locked.
  bool TryToLock();

  std::string dir_, file_;
  std::vector<std::string> made_;  // folders, outermost first
  int descriptor_ = -1;            // of the file, or -1
};

}  // namespace musclewarp
