// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "page/packed_text.h"

#include <gtest/gtest.h>
#include <zlib.h>

#include <cstdint>

#include "musclewarp/base/base64.h"

namespace musclewarp {
namespace {

std::string Inflated(const std::string& bytes) {
  std::string text(1 << 23, '\0');
  uLongf size = text.size();
  EXPECT_EQ(uncompress(reinterpret_cast<Bytef*>(text.data()),
                       &size,
                       reinterpret_cast<const Bytef*>(bytes.data()),
                       bytes.size()),
            Z_OK);
  text.resize(size);
  return text;
}

}  // namespace

std::vector<int> UnpackedNumbers(const std::string& text,
                                 const nlohmann::ordered_json& where) {
  const std::string bytes = Inflated(DecodeBase64(text));
  std::size_t at = where["at"];
  const std::size_t count = where["count"], stride = where["stride"];
  std::vector<int> numbers;
  for (std::size_t i = 0; i < count; ++i) {
    std::uint64_t code = 0;
    for (int shift = 0;; shift += 7) {
      const auto byte = static_cast<unsigned char>(bytes.at(at++));
      code |= static_cast<std::uint64_t>(byte & 127) << shift;
      if (byte < 128) break;
    }
    const auto half = static_cast<std::int64_t>(code >> 1);
    const std::int64_t difference = code & 1 ? -half - 1 : half;
    numbers.push_back(
        static_cast<int>(difference + (i < stride ? 0 : numbers[i - stride])));
  }
  return numbers;
}

Points UnpackedPose(const std::string& text,
                    const nlohmann::ordered_json& motion,
                    int pose) {
  const std::size_t size = motion["coordinates"];
  const double step = motion["step_mm"];
  Points points(size / 3, 3);
  const std::vector<int> first = UnpackedNumbers(text, motion["first"]);
  for (std::size_t i = 0; i < size; ++i) points.data()[i] = step * first[i];
  if (pose == 0) return points;
  const std::vector<int> counts =
      UnpackedNumbers(text, motion["corrections_by_pose"]);
  const std::vector<int> shapes = UnpackedNumbers(text, motion["shapes"]);
  const std::vector<int> weights = UnpackedNumbers(text, motion["weights"]);
  const double weight_step = motion["weight_step"];
  for (std::size_t mode = 0; mode < motion["modes"]; ++mode) {
    const double weight =
        weight_step * weights[mode * counts.size() + pose - 1];
    for (std::size_t i = 0; i < size; ++i) {
      points.data()[i] += weight * step * shapes[mode * size + i];
    }
  }
  const std::vector<int> corrections =
      UnpackedNumbers(text, motion["corrections"]);
  std::size_t pair = 0, at = 0;
  for (int before = 0; before + 1 < pose; ++before) pair += counts[before];
  for (int i = 0; i < counts[pose - 1]; ++i, ++pair) {
    at += corrections[2 * pair];
    points.data()[at] +=
        motion["correction_step_mm"].get<double>() * corrections[2 * pair + 1];
  }
  return points;
}

nlohmann::json PageJson(const std::string& html, const std::string& id) {
  return nlohmann::json::parse(Inflated(DecodeBase64(ScriptText(html, id))));
}

std::string ScriptText(const std::string& html, const std::string& id) {
  const std::size_t begin = html.find('>', html.find("id=\"" + id + "\"")) + 1;
  return html.substr(begin, html.find("</script>", begin) - begin);
}

}  // namespace musclewarp
