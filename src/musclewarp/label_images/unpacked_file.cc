// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/label_images/unpacked_file.h"

#include <zlib.h>

#include <algorithm>
#include <memory>

#include "musclewarp/base/input_error.h"
#include "musclewarp/mesh_files/export_advice.h"

namespace musclewarp {

std::string ReadUnpacked(const std::string& path, std::uint64_t most) {
  const std::unique_ptr<gzFile_s, int (*)(gzFile)> file(
      gzopen(path.c_str(), "rb"), gzclose);
  if (!file) {
    throw InputError(path, "cannot be opened", "check the name and the folder");
  }
  constexpr std::uint64_t kStep = 1 << 26;
  std::string bytes;
  while (bytes.size() < most) {
    const std::size_t before = bytes.size();
    bytes.resize(before + std::min(kStep, most - before));
    const int read = gzread(file.get(),
                            bytes.data() + before,
                            static_cast<unsigned>(bytes.size() - before));
    bytes.resize(before + std::max(read, 0));
    if (read < 0) {
      throw InputError(
          path, "cannot be unpacked: its gzip data are damaged", kCopyAgain);
    }
    if (read == 0) break;
  }
  return bytes;
}

}  // namespace musclewarp
