// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include <glog/logging.h>

#include <algorithm>
#include <array>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include "musclewarp/base/setting_names.h"
#include "python/src/bindings.h"

namespace musclewarp::python {
namespace {

namespace py = pybind11;

// Keeps lines until ForwardLog(): who logs, on whatever thread, must not wait
// for the interpreter, as glog holds a lock meanwhile.
class Lines : public google::LogSink {
 public:
  void send(google::LogSeverity severity,
            const char* /*full_filename*/,
            const char* /*base_filename*/,
            int /*line*/,
            const google::LogMessageTime& /*time*/,
            const char* message,
            size_t length) override {
    const std::lock_guard<std::mutex> lock(mutex_);
    lines_.emplace_back(severity, WithFieldNames(std::string(message, length)));
  }

  std::vector<std::pair<google::LogSeverity, std::string>> Take() {
    const std::lock_guard<std::mutex> lock(mutex_);
    return std::exchange(lines_, {});
  }

 private:
  std::mutex mutex_;
  std::vector<std::pair<google::LogSeverity, std::string>> lines_;
};

// Never destroyed: something may be logged while the process ends.
Lines& LinesOfProcess() {
  static Lines& lines = *new Lines;
  return lines;
}

}  // namespace

void ForwardLog() {
  // Levels of logging by the severities of glog.
  constexpr std::array<int, 4> kLevels = {20, 30, 40, 50};
  const auto lines = LinesOfProcess().Take();
  if (lines.empty()) return;
  const py::object logger =
      py::module_::import("logging").attr("getLogger")("musclewarp");
  for (const auto& [severity, text] : lines) {
    const int level = kLevels[std::clamp(severity, 0, 3)];
    const py::object message = py::reinterpret_steal<py::object>(
        PyUnicode_DecodeUTF8(text.data(), text.size(), "replace"));
    logger.attr("log")(level, "%s", message);
  }
}

void BindLog(py::module_* /*module*/) {
  if (!google::IsGoogleLoggingInitialized()) {
    google::InitGoogleLogging("musclewarp");
  }
  // Neither to files nor, but for what ends the process, to the screen.
  for (int severity = 0; severity < google::NUM_SEVERITIES; ++severity) {
    google::SetLogDestination(severity, "");
  }
  FLAGS_stderrthreshold = google::GLOG_FATAL;
  google::AddLogSink(&LinesOfProcess());
}

}  // namespace musclewarp::python
