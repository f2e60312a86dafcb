// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/page/packed_numbers.h"

#include <glog/logging.h>
#include <zlib.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <cstdint>

#include "musclewarp/base/base64.h"

namespace musclewarp {

nlohmann::ordered_json PackedNumbers::Add(const std::vector<int>& numbers,
                                          int stride) {
  const std::size_t at = bytes_.size();
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const std::int64_t before =
        i < static_cast<std::size_t>(stride) ? 0 : numbers[i - stride];
    const std::int64_t difference = numbers[i] - before;
    std::uint64_t code = static_cast<std::uint64_t>(difference) << 1;
    if (difference < 0) code = ~code;
    for (; code > 127; code >>= 7) {
      bytes_ += static_cast<char>((code & 127) | 128);
    }
    bytes_ += static_cast<char>(code);
  }
  return {{"at", at}, {"count", numbers.size()}, {"stride", stride}};
}

nlohmann::ordered_json PackedNumbers::Add(const Triangles& triangles) {
  return Add({triangles.data(), triangles.data() + triangles.size()}, 3);
}

std::string PackedNumbers::Base64() const { return DeflatedBase64(bytes_); }

std::string DeflatedBase64(const std::string& bytes) {
  uLongf size = compressBound(bytes.size());
  std::string packed(size, '\0');
  const int result = compress2(reinterpret_cast<Bytef*>(packed.data()),
                               &size,
                               reinterpret_cast<const Bytef*>(bytes.data()),
                               bytes.size(),
                               Z_BEST_COMPRESSION);
  CHECK_EQ(result, Z_OK);
  packed.resize(size);
  return EncodeBase64(packed);
}

void AppendRounded(const Points& points,
                   double step,
                   std::vector<int>* numbers) {
  for (Eigen::Index i = 0; i < points.size(); ++i) {
    const double rounded = std::round(points.data()[i] / step);
    CHECK_LT(std::abs(rounded), 1 << 30);
    numbers->push_back(static_cast<int>(rounded));
  }
}

}  // namespace musclewarp
