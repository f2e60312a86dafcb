// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/run/resume_log.h"

#include <glog/logging.h>

#include <cstdint>
#include <exception>
#include <filesystem>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "musclewarp/base/content_hash.h"
#include "musclewarp/base/input_error.h"
#include "musclewarp/base/input_file.h"
#include "musclewarp/base/output_file.h"
#include "musclewarp/build_info/build_info.h"
#include "musclewarp/figures/figures_json.h"
#include "musclewarp/motion/state_bytes.h"
#include "musclewarp/run/frame_files.h"

namespace musclewarp {
namespace {

namespace fs = std::filesystem;
using OrderedJson = nlohmann::ordered_json;

// The first line of the key file. The number grows whenever a file of the log
// gets another layout; logs before the first number had no such line.
constexpr char kFormat[] = "musclewarp resume log 9";

constexpr char kAdvice[] = "run without {resume}, or choose another {out}";

// The figures and the state of a frame.
struct LoggedFrame {
  FrameFigures record;
  SceneState state;
};

LoggedFrame LoggedFrameFromJson(const nlohmann::json& json) {
  LoggedFrame frame;
  ReadJson(json.at("record"), {}, &frame.record);
  const std::vector<std::uint8_t>& bytes = json.at("state").get_binary();
  frame.state = StateFrom({bytes.begin(), bytes.end()});
  return frame;
}

// What a file of a frame begins with: the number of the frame and a checksum of
// the rest, so that neither damage nor a file of another frame passes.
std::string HeaderOf(int index, std::string_view bytes) {
  ContentHash hash;
  hash.Add(bytes);
  return "frame " + std::to_string(index) + "\n" + hash.Hex() + "\n";
}

// Returns nothing for a file that is damaged or of another frame.
std::optional<LoggedFrame> ReadLoggedFrame(const std::string& file, int index) {
  try {
    const std::string contents = ReadFile(file);
    const size_t size = HeaderOf(index, "").size();
    if (contents.size() < size) return std::nullopt;
    const std::string_view bytes = std::string_view(contents).substr(size);
    if (contents.substr(0, size) != HeaderOf(index, bytes)) return std::nullopt;
    return LoggedFrameFromJson(nlohmann::json::from_cbor(bytes));
  } catch (const std::exception&) {  // of the file, JSON, cereal or memory
    return std::nullopt;
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

std::string ResumeLog::FramePath(int index) const {
  return (fs::path(folder_).parent_path() / FrameFolder(index)).string();
}

std::vector<std::string> ResumeLog::Missing(
    const std::vector<int>& indices) const {
  std::vector<std::string> missing;
  const auto look = [&](const fs::path& path) {
    if (!fs::exists(path)) missing.push_back(path.filename().string());
  };
  look(fs::path(folder_).parent_path() / kRestFolder);
  for (const int index : indices) look(FramePath(index));
  return missing;
}

std::string ResumeLog::FrameFile(int index) const {
  return (fs::path(folder_) / (FrameFolder(index) + ".cbor")).string();
}

std::vector<FrameFigures> ResumeLog::Continue(const std::vector<int>& selected,
                                              SceneState* state) const {
  std::vector<FrameFigures> records;
  if (!fs::exists(KeyFile())) return records;
  const std::string key = ReadFile(KeyFile());
  if (key.rfind(kFormat + std::string("\n"), 0) != 0) {
    throw InputError(
        KeyFile(), "was written by another version of musclewarp", kAdvice);
  }
  const std::string of_inputs = kFormat + ("\n" + inputs_hash_ + "\n");
  if (key.rfind(of_inputs, 0) != 0) {
    throw InputError("{resume}",
                     folder_ + " is of a run with other input or options",
                     kAdvice);
  }
  if (key != KeyText()) {
    throw InputError("{resume}",
                     folder_ + " is of a run by other code of musclewarp (" +
                         key.substr(of_inputs.size()) + "); this is " +
                         CodeKey(),
                     kAdvice);
  }
  for (const int index : selected) {
    if (!fs::exists(FrameFile(index))) break;
    if (!fs::exists(FramePath(index))) {
      LOG(WARNING) << FramePath(index)
                   << ": is missing; the run goes on from the frame before";
      break;
    }
    std::optional<LoggedFrame> frame = ReadLoggedFrame(FrameFile(index), index);
    if (!frame) {
      LOG(WARNING) << FrameFile(index)
                   << ": is damaged; the run goes on from the frame before";
      break;
    }
    records.push_back(std::move(frame->record));
    *state = std::move(frame->state);
  }
  return records;
}

std::string ResumeLog::PreparationFolder() const {
  return (fs::path(folder_) / "preparation").string();
}

void ResumeLog::StartAnew() const {
  fs::create_directories(folder_);
  for (const auto& entry : fs::directory_iterator(folder_)) {
    if (entry.path() != PreparationFolder()) fs::remove_all(entry.path());
  }
  WriteTextAtomically(KeyFile(), KeyText());
}

void ResumeLog::FrameDone(const FrameFigures& record,
                          const SceneState& state) const {
  const std::string state_bytes = BytesOf(state);
  const auto bytes = OrderedJson::to_cbor(OrderedJson{
      {"record", JsonOf(record)},
      {"state",
       OrderedJson::binary({state_bytes.begin(), state_bytes.end()})}});
  const std::string text(bytes.begin(), bytes.end());
  WriteTextAtomically(FrameFile(record.index),
                      HeaderOf(record.index, text) + text);
}

void ResumeLog::Finish() const { fs::remove_all(folder_); }

}  // namespace musclewarp
