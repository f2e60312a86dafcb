// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/motion/recorded_step.h"

#include <cereal/archives/binary.hpp>
#include <exception>
#include <sstream>

#include "musclewarp/base/content_hash.h"
#include "musclewarp/base/input_error.h"
#include "musclewarp/base/input_file.h"
#include "musclewarp/base/output_file.h"
#include "musclewarp/motion/state_archive.h"

namespace musclewarp {
namespace {

// The first bytes of a file, followed by a checksum of the rest. The number is
// incremented with every change of the layout.
constexpr char kMagic[] = "musclewarp step 4\n";

constexpr char kAdvice[] =
    "record it again with musclewarp-deform {record_steps}";

std::string StepChecksum(const std::string& bytes) {
  ContentHash hash;
  hash.Add(bytes);
  return hash.Hex();
}

}  // namespace

// MUSCLEWARP_ARCHIVE would add the fields to the key of prepared scenes.
template <class Archive>
void serialize(Archive& archive, RecordedStep& step) {
  archive(step.pose,
          step.is_settling,
          step.max_push,
          step.reach,
          step.sweeps,
          step.unfolds,
          step.is_still,
          step.reaches,
          step.before,
          step.after);
}

StepOptions RecordedStep::OptionsIn(const StepOptions& of_run) const {
  StepOptions options = of_run;
  options.reach = reach;
  options.sweeps = sweeps;
  options.unfolds = unfolds;
  return options;
}

void WriteRecordedStep(const std::string& path, const RecordedStep& step) {
  std::ostringstream stream(std::ios::binary);
  cereal::BinaryOutputArchive archive(stream);
  archive(step);
  WriteTextAtomically(path, kMagic + StepChecksum(stream.str()) + stream.str());
}

RecordedStep ReadRecordedStep(const std::string& path) {
  const std::string bytes = ReadFile(path);
  const std::string magic = kMagic;
  if (bytes.compare(0, magic.size(), magic) != 0) {
    throw InputError(path, "is no recorded step of this version", kAdvice);
  }
  const size_t begin = magic.size() + StepChecksum("").size();
  const std::string archived =
      begin <= bytes.size() ? bytes.substr(begin) : std::string();
  if (bytes.substr(magic.size(), begin - magic.size()) !=
      StepChecksum(archived)) {
    throw InputError(path, "is damaged", kAdvice);
  }
  std::istringstream stream(archived, std::ios::binary);
  cereal::BinaryInputArchive archive(stream);
  RecordedStep step;
  try {
    archive(step);
  } catch (const std::exception& error) {
    throw InputError(
        path, std::string("cannot be read (") + error.what() + ")", kAdvice);
  }
  return step;
}

}  // namespace musclewarp
