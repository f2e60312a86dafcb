// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/report/resume_log.h"

#include <filesystem>
#include <utility>

#include "musclewarp/base/input_error.h"
#include "musclewarp/base/input_file.h"
#include "musclewarp/base/output_file.h"
#include "musclewarp/motion/frame_files.h"

namespace musclewarp {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

Json ToJson(const Points& points) {
  return std::vector<double>(points.data(), points.data() + points.size());
}

Points PointsFromJson(const Json& json) {
  const auto values = json.get<std::vector<double>>();
  return Eigen::Map<const Points>(values.data(), values.size() / 3, 3);
}

}  // namespace

ResumeLog::ResumeLog(const std::string& dir, const std::string& inputs_hash)
    : folder_((fs::path(dir) / ".resume").string()),
      inputs_hash_(inputs_hash) {}

std::string ResumeLog::KeyFile() const {
  return (fs::path(folder_) / "inputs").string();
}

std::string ResumeLog::FrameFile(int index) const {
  return (fs::path(folder_) / (FrameFolder(index) + ".cbor")).string();
}

std::vector<FrameRecord> ResumeLog::Continue(
    const std::vector<int>& selected, std::vector<MuscleState>* muscles) const {
  std::vector<FrameRecord> records;
  if (!fs::exists(KeyFile())) return records;
  if (ReadFile(KeyFile()) != inputs_hash_) {
    throw InputError("--resume",
                     folder_ + " is of a run with other input or options",
                     "run without --resume, or choose another --out");
  }
  for (const int index : selected) {
    if (!fs::exists(FrameFile(index))) break;
    const std::string bytes = ReadFile(FrameFile(index));
    const Json json = Json::from_cbor(bytes, true, /*allow_exceptions=*/false);
    if (json.is_discarded()) {
      throw InputError(FrameFile(index), "is damaged", "run without --resume");
    }
    records.push_back(FrameRecordFromJson(json.at("record")));
    muscles->clear();
    for (const Json& muscle : json.at("muscles")) {
      MuscleState state;
      state.coarse = PointsFromJson(muscle.at("coarse"));
      state.contact.free_coarse = PointsFromJson(muscle.at("free_coarse"));
      state.contact.fine_offset = PointsFromJson(muscle.at("fine_offset"));
      muscles->push_back(std::move(state));
    }
  }
  return records;
}

void ResumeLog::StartAnew() const {
  fs::remove_all(folder_);
  fs::create_directories(folder_);
  WriteTextAtomically(KeyFile(), inputs_hash_);
}

void ResumeLog::FrameDone(const FrameRecord& record,
                          const std::vector<MuscleState>& muscles) const {
  Json states = Json::array();
  for (const MuscleState& muscle : muscles) {
    states.push_back({{"coarse", ToJson(muscle.coarse)},
                      {"free_coarse", ToJson(muscle.contact.free_coarse)},
                      {"fine_offset", ToJson(muscle.contact.fine_offset)}});
  }
  const auto bytes = Json::to_cbor(
      Json{{"record", musclewarp::ToJson(record)}, {"muscles", states}});
  WriteTextAtomically(FrameFile(record.index),
                      std::string(bytes.begin(), bytes.end()));
}

void ResumeLog::Finish() const { fs::remove_all(folder_); }

}  // namespace musclewarp
