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

std::vector<FrameRecord> ResumeLog::Continue(const std::vector<int>& selected,
                                             SceneState* state) const {
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
    *state = SceneState();
    for (const Json& item : json.at("muscles")) {
      MuscleState muscle;
      muscle.coarse = PointsFromJson(item.at("coarse"));
      muscle.corrections.fine_offset = PointsFromJson(item.at("fine_offset"));
      state->muscles.push_back(std::move(muscle));
    }
    for (const Json& coarse : json.at("free_coarse")) {
      state->free_coarse.push_back(PointsFromJson(coarse));
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
                          const SceneState& state) const {
  Json muscles = Json::array(), free_coarse = Json::array();
  for (const MuscleState& muscle : state.muscles) {
    muscles.push_back(
        {{"coarse", ToJson(muscle.coarse)},
         {"fine_offset", ToJson(muscle.corrections.fine_offset)}});
  }
  for (const Points& coarse : state.free_coarse) {
    free_coarse.push_back(ToJson(coarse));
  }
  const auto bytes = Json::to_cbor(Json{{"record", musclewarp::ToJson(record)},
                                        {"muscles", muscles},
                                        {"free_coarse", free_coarse}});
  WriteTextAtomically(FrameFile(record.index),
                      std::string(bytes.begin(), bytes.end()));
}

void ResumeLog::Finish() const { fs::remove_all(folder_); }

}  // namespace musclewarp
