// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0

// Gives bytes of libFuzzer to a reader as a file. An InputError is an answer;
// anything else that is thrown, a sanitizer, a signal or a time beyond the
// limit of libFuzzer is a finding.

#include <glog/logging.h>
#include <unistd.h>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>

#include "fuzz/readers.h"
#include "musclewarp/base/input_error.h"

// CMakeLists.txt sets it to a name of readers.cc.
#ifndef MUSCLEWARP_READER
#define MUSCLEWARP_READER "ply"
#endif

namespace {

// A folder in memory, where writing takes little time.
std::string FolderOfProcess() {
  const std::string folder = "/dev/shm/musclewarp_fuzz_" MUSCLEWARP_READER "_" +
                             std::to_string(getpid());
  std::filesystem::create_directories(folder);
  return folder;
}

}  // namespace

extern "C" int LLVMFuzzerInitialize(int* /*argc*/, char*** /*argv*/) {
  FLAGS_minloglevel = google::GLOG_FATAL;
  return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data,
                                      std::size_t size) {
  static const musclewarp::FuzzedReader& reader =
      musclewarp::ReaderNamed(MUSCLEWARP_READER);
  static const std::string path = FolderOfProcess() + "/" + reader.file;
  std::ofstream(path, std::ios::binary)
      .write(reinterpret_cast<const char*>(data),
             static_cast<std::streamsize>(size));
  try {
    reader.read(path);
  } catch (const musclewarp::InputError&) {
  }
  return 0;
}
