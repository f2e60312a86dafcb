// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/report/resume_log.h"

#include <array>
#include <filesystem>
#include <utility>

#include "musclewarp/base/input_error.h"
#include "musclewarp/base/input_file.h"
#include "musclewarp/base/output_file.h"
#include "musclewarp/build_info/build_info.h"
#include "musclewarp/motion/frame_files.h"

namespace musclewarp {
namespace {

namespace fs = std::filesystem;
using OrderedJson = nlohmann::ordered_json;

OrderedJson ToJson(const Points& points) {
  return std::vector<double>(points.data(), points.data() + points.size());
}

Points PointsFromJson(const OrderedJson& json) {
  const auto values = json.get<std::vector<double>>();
  return Eigen::Map<const Points>(values.data(), values.size() / 3, 3);
}

// A pose may lie between those of the scene, if a frame was given up.
OrderedJson ToJson(const ScenePose& pose) {
  OrderedJson bodies = OrderedJson::object(), lines = OrderedJson::object();
  for (const auto& [name, target] : pose.bodies) {
    bodies[name] =
        std::vector<double>(target.data(), target.data() + target.size());
  }
  for (const auto& [name, line] : pose.lines) lines[name] = ToJson(line);
  return {{"name", pose.name},
          {"time", pose.time},
          {"coordinates", pose.coordinates},
          {"bodies", bodies},
          {"lines", lines},
          {"model_values", pose.model_values},
          {"path_lengths", pose.path_lengths}};
}

ScenePose PoseFromJson(const OrderedJson& json) {
  ScenePose pose;
  json.at("name").get_to(pose.name);
  json.at("time").get_to(pose.time);
  json.at("coordinates").get_to(pose.coordinates);
  for (const auto& [name, target] : json.at("bodies").items()) {
    const auto values = target.get<std::array<double, 16>>();
    pose.bodies[name] = Eigen::Map<const Eigen::Matrix4d>(values.data());
  }
  for (const auto& [name, line] : json.at("lines").items()) {
    pose.lines[name] = PointsFromJson(line);
  }
  json.at("model_values").get_to(pose.model_values);
  json.at("path_lengths").get_to(pose.path_lengths);
  return pose;
}

// The first line of the key file. The number grows whenever a file of the log
// gets another layout; logs before the first number had no such line.
constexpr char kFormat[] = "musclewarp resume log 5";

constexpr char kAdvice[] = "run without --resume, or choose another --out";

// The figures and the state of a frame.
struct LoggedFrame {
  FrameRecord record;
  SceneState state;
};

LoggedFrame LoggedFrameFromJson(const OrderedJson& json) {
  LoggedFrame frame;
  frame.record = FrameRecordFromJson(json.at("record"));
  frame.state.pose = PoseFromJson(json.at("pose"));
  for (const OrderedJson& item : json.at("muscles")) {
    MuscleState muscle;
    muscle.coarse = PointsFromJson(item.at("coarse"));
    muscle.corrections.fine_offset = PointsFromJson(item.at("fine_offset"));
    frame.state.muscles.push_back(std::move(muscle));
  }
  for (const OrderedJson& coarse : json.at("free_coarse")) {
    frame.state.free_coarse.push_back(PointsFromJson(coarse));
  }
  return frame;
}

LoggedFrame ReadLoggedFrame(const std::string& file) {
  const OrderedJson json =
      OrderedJson::from_cbor(ReadFile(file), true, /*allow_exceptions=*/false);
  if (json.is_discarded()) throw InputError(file, "is damaged", kAdvice);
  try {
    return LoggedFrameFromJson(json);
  } catch (const OrderedJson::exception&) {
    throw InputError(
        file,
        "does not hold what this build of musclewarp keeps of a frame",
        kAdvice);
  }
}

}  // namespace

ResumeLog::ResumeLog(const std::string& dir, const std::string& inputs_hash)
    : folder_((fs::path(dir) / ".resume").string()),
      inputs_hash_(inputs_hash) {}

bool ResumeLog::IsIn(const std::string& dir) {
  return fs::exists(ResumeLog(dir, "").KeyFile());
}

std::string ResumeLog::KeyFile() const {
  return (fs::path(folder_) / "inputs").string();
}

std::string ResumeLog::KeyText() const {
  return kFormat + ("\n" + inputs_hash_ + "\n" + CodeKey());
}

std::string ResumeLog::FrameFile(int index) const {
  return (fs::path(folder_) / (FrameFolder(index) + ".cbor")).string();
}

std::vector<FrameRecord> ResumeLog::Continue(const std::vector<int>& selected,
                                             SceneState* state) const {
  std::vector<FrameRecord> records;
  if (!fs::exists(KeyFile())) return records;
  const std::string key = ReadFile(KeyFile());
  if (key.rfind(kFormat + std::string("\n"), 0) != 0) {
    throw InputError(
        KeyFile(), "was written by another version of musclewarp", kAdvice);
  }
  const std::string of_inputs = kFormat + ("\n" + inputs_hash_ + "\n");
  if (key.rfind(of_inputs, 0) != 0) {
    throw InputError("--resume",
                     folder_ + " is of a run with other input or options",
                     kAdvice);
  }
  if (key != KeyText()) {
    throw InputError("--resume",
                     folder_ + " is of a run by other code of musclewarp (" +
                         key.substr(of_inputs.size()) + "); this is " +
                         CodeKey(),
                     kAdvice);
  }
  for (const int index : selected) {
    if (!fs::exists(FrameFile(index))) break;
    LoggedFrame frame = ReadLoggedFrame(FrameFile(index));
    records.push_back(std::move(frame.record));
    *state = std::move(frame.state);
  }
  return records;
}

void ResumeLog::StartAnew() const {
  fs::remove_all(folder_);
  fs::create_directories(folder_);
  WriteTextAtomically(KeyFile(), KeyText());
}

void ResumeLog::FrameDone(const FrameRecord& record,
                          const SceneState& state) const {
  OrderedJson muscles = OrderedJson::array(),
              free_coarse = OrderedJson::array();
  for (const MuscleState& muscle : state.muscles) {
    muscles.push_back(
        {{"coarse", ToJson(muscle.coarse)},
         {"fine_offset", ToJson(muscle.corrections.fine_offset)}});
  }
  for (const Points& coarse : state.free_coarse) {
    free_coarse.push_back(ToJson(coarse));
  }
  const auto bytes =
      OrderedJson::to_cbor(OrderedJson{{"record", musclewarp::ToJson(record)},
                                       {"pose", ToJson(state.pose)},
                                       {"muscles", muscles},
                                       {"free_coarse", free_coarse}});
  WriteTextAtomically(FrameFile(record.index),
                      std::string(bytes.begin(), bytes.end()));
}

void ResumeLog::Finish() const { fs::remove_all(folder_); }

}  // namespace musclewarp
