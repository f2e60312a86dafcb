// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/report/screen_progress.h"

#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <iomanip>
#include <numeric>
#include <sstream>
#include <utility>

#include "musclewarp/base/text.h"

namespace musclewarp {
namespace {

constexpr double kPauseOnTerminal = 1000, kPauseElsewhere = 60000;  // ms

using Lock = std::lock_guard<std::mutex>;

// Returns the width of the terminal that is the standard output.
size_t TerminalColumns() {
  winsize size = {};
  const bool is_known =
      ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0;
  return is_known ? size.ws_col : 80;
}

// Returns the start of a text in UTF-8, at most `length` bytes.
std::string Cut(const std::string& text, size_t length) {
  if (text.size() <= length) return text;
  constexpr int kContinuation = 0x80, kContinuationMask = 0xc0;
  while (length > 0 && (text[length] & kContinuationMask) == kContinuation) {
    --length;
  }
  return text.substr(0, length);
}

}  // namespace

ScreenProgress::ScreenProgress(bool is_terminal, std::ostream* out)
    : is_terminal_(is_terminal), out_(out) {
  heartbeat_ = std::thread([this] { SayThatItGoesOn(); });
}

ScreenProgress::~ScreenProgress() {
  {
    const Lock lock(mutex_);
    is_over_ = true;
  }
  ended_.notify_all();
  heartbeat_.join();
}

void ScreenProgress::Say(const Progress& progress) {
  const Lock lock(mutex_);
  std::ostringstream line;
  if (!work_.empty()) line << Bar() << " ";
  line << progress.stage;
  if (progress.total > 0) {
    line << " " << progress.done << " of " << progress.total;
  } else if (progress.done > 0) {
    line << ", round " << progress.done;
  }
  if (!progress.item.empty()) line << ": " << progress.item;
  stage_ = line.str();
  PrintStage();
}

void ScreenProgress::PrintStage() {
  const double pause = is_terminal_ ? kPauseOnTerminal : kPauseElsewhere;
  if (has_output_ && since_output_.Milliseconds() < pause) return;
  Print(stage_ + " ... (" + RoundedTime(since_frame_.Milliseconds()) + ")",
        false);
}

void ScreenProgress::SayThatItGoesOn() {
  std::unique_lock<std::mutex> lock(mutex_);
  while (!ended_.wait_for(
      lock, std::chrono::seconds(1), [this] { return is_over_; })) {
    if (!stage_.empty()) PrintStage();
  }
}

void ScreenProgress::Clear() {
  const Lock lock(mutex_);
  stage_.clear();
  if (!is_terminal_ || length_ == 0) return;
  *out_ << "\r" << std::string(length_, ' ') << "\r" << std::flush;
  length_ = 0;
}

void ScreenProgress::StartFrames(int done, std::vector<double> work) {
  const Lock lock(mutex_);
  done_before_ = done;
  done_ = 0;
  work_ = std::move(work);
  since_frame_.Restart();
}

double ScreenProgress::MillisecondsLeft() const {
  const double left = std::accumulate(work_.begin() + done_, work_.end(), 0.0);
  return recent_work_ > 0 ? left * recent_ms_ / recent_work_ : 0;
}

std::string ScreenProgress::Bar() const {
  constexpr int kWidth = 24;
  const int done = done_before_ + static_cast<int>(done_);
  const int filled = kWidth * done / std::max(1, total());
  return is_terminal_ ? "[" + std::string(filled, '=') +
                            std::string(kWidth - filled, ' ') + "]"
                      : "frame " + std::to_string(done + 1) + ":";
}

void ScreenProgress::FrameDone(const FrameFigures& frame,
                               const std::string& name) {
  constexpr double kMemory = 0.8;
  const Lock lock(mutex_);
  stage_.clear();
  recent_ms_ = kMemory * recent_ms_ + since_frame_.Milliseconds();
  recent_work_ = kMemory * recent_work_ + work_[done_];
  since_frame_.Restart();
  ++done_;
  const int done = done_before_ + static_cast<int>(done_);
  const bool is_last = done == total();
  std::ostringstream line;
  line << (is_terminal_ ? Bar() : "frame") << " " << done << " of " << total()
       << ": " << name << ", " << std::fixed << std::setprecision(0)
       << frame.wall_ms << " ms, " << frame.intersections.triangle_pairs
       << " crossing pairs";
  if (!frame.IsUsable()) line << ", NOT usable";
  if (!is_last) line << ", " << RoundedTime(MillisecondsLeft()) << " left";
  Print(line.str(), is_last);
}

void ScreenProgress::Print(const std::string& text, bool is_last) {
  has_output_ = true;
  since_output_.Restart();
  if (!is_terminal_) {
    *out_ << text << "\n" << std::flush;
    return;
  }
  // A line that wraps could not be renewed.
  const std::string line = is_last ? text : Cut(text, TerminalColumns() - 1);
  // Blanks overwrite the rest of a longer previous line.
  const size_t rest = length_ > line.size() ? length_ - line.size() : 0;
  *out_ << "\r" << line << std::string(rest, ' ') << (is_last ? "\n" : "")
        << std::flush;
  length_ = is_last ? 0 : line.size();
}

std::string RoundedTime(double milliseconds) {
  const double seconds = milliseconds / 1000;
  if (seconds < 99.5) return RoundedText(seconds, 0) + " s";
  if (seconds < 99.5 * 60) return RoundedText(seconds / 60, 0) + " min";
  return RoundedText(seconds / 3600, 0) + " h";
}

}  // namespace musclewarp
