// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace musclewarp {

// A reader of files from outside.
struct FuzzedReader {
  std::string name;  // of the target, fuzz_<name>
  std::string file;  // the name of the file that it reads
  std::function<void(const std::string& path)> read;
};

// Returns the reader of a name. Precondition (CHECKed): there is one.
const FuzzedReader& ReaderNamed(const std::string& name);

// Returns the names of all readers.
std::vector<std::string> NamesOfReaders();

}  // namespace musclewarp
