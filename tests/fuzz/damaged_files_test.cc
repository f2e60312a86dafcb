// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
//
// Gives the seeds of the fuzzed readers to them, damaged at random: what cannot
// be read is refused, and nothing else happens. scripts/fuzz.sh does the same
// at length, guided by what the damage reaches.
#include <glog/logging.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <exception>
#include <filesystem>
#include <random>
#include <string>
#include <vector>

#include "fuzz/readers.h"
#include "musclewarp/base/input_error.h"
#include "musclewarp/base/input_file.h"
#include "musclewarp/base/output_file.h"
#include "support/temp_dir.h"

namespace musclewarp {
namespace {

namespace fs = std::filesystem;

constexpr int kDamagesOfSeed = 100;

// Numbers at which readers count, allocate or leave a loop.
const std::vector<std::string> kOddTexts = {
    "-1", "0", "4294967295", "1e308", "nan", "\xff\xff\xff\xff", "\n", " ", ""};

class Damage {
 public:
  explicit Damage(std::uint32_t seed) : engine_(seed) {}

  std::string Of(std::string text) {
    for (int count = 1 + Below(4); count > 0; --count) text = Once(text);
    return text;
  }

 private:
  size_t Below(size_t count) { return count == 0 ? 0 : engine_() % count; }

  std::string Once(std::string text) {
    const size_t at = Below(text.size());
    const size_t length = 1 + Below(std::min<size_t>(32, text.size() - at));
    switch (Below(5)) {
      case 0:  // a bit
        if (!text.empty()) text[at] ^= static_cast<char>(1 << Below(8));
        return text;
      case 1:  // the end is missing
        return text.substr(0, at);
      case 2:  // a part is missing
        return text.erase(at, length);
      case 3:  // a part stands twice
        return text.insert(at, text.substr(at, length));
      default:
        return text.replace(at, length, kOddTexts[Below(kOddTexts.size())]);
    }
  }

  std::mt19937 engine_;
};

class DamagedFiles : public ::testing::TestWithParam<std::string> {};

TEST_P(DamagedFiles, AreReadOrRefused) {
  FLAGS_minloglevel = google::GLOG_FATAL;  // damage is warned of
  const FuzzedReader& reader = ReaderNamed(GetParam());
  const std::string path = TestTempDir() + "/" + reader.file;
  std::vector<std::string> seeds = {"x"};
  const fs::path folder = fs::path(MUSCLEWARP_FUZZ_SEEDS) / reader.name;
  if (fs::exists(folder)) {
    for (const auto& entry : fs::directory_iterator(folder)) {
      seeds.push_back(ReadFile(entry.path().string()));
    }
  }
  for (size_t s = 0; s < seeds.size(); ++s) {
    Damage damage(static_cast<std::uint32_t>(s + 1));
    for (int i = 0; i < kDamagesOfSeed; ++i) {
      WriteTextAtomically(path, damage.Of(seeds[s]));
      try {
        reader.read(path);
      } catch (const InputError& error) {
        EXPECT_FALSE(error.problem().empty() || error.advice().empty());
      } catch (const std::exception& error) {
        ADD_FAILURE() << "seed " << s << ", damage " << i << ": "
                      << error.what();
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Readers,
                         DamagedFiles,
                         ::testing::ValuesIn(NamesOfReaders()),
                         [](const auto& test) { return test.param; });

}  // namespace
}  // namespace musclewarp
