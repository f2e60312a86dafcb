// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/report/progress.h"

#include <cmath>
#include <iomanip>
#include <sstream>

namespace musclewarp {

Progress::Progress(int done, int total, bool is_terminal, std::ostream* out)
    : first_(done),
      done_(done),
      total_(total),
      is_terminal_(is_terminal),
      out_(out) {}

void Progress::FrameDone(const FrameRecord& frame) {
  constexpr int kWidth = 24;
  ++done_;
  const double left =
      stopwatch_.Milliseconds() / (done_ - first_) * (total_ - done_);
  std::ostringstream line;
  if (is_terminal_) {
    const int filled = kWidth * done_ / total_;
    line << "\r[" << std::string(filled, '=')
         << std::string(kWidth - filled, ' ') << "] ";
  } else {
    line << "frame ";
  }
  line << done_ << " of " << total_ << ": " << frame.name << ", " << std::fixed
       << std::setprecision(0) << frame.wall_ms << " ms, "
       << frame.intersections.triangle_pairs << " crossing pairs";
  if (done_ < total_) line << ", " << RoundedTime(left) << " left";
  // Blanks over what a longer line before has left.
  if (is_terminal_) line << std::string(12, ' ');
  if (!is_terminal_ || done_ == total_) line << "\n";
  *out_ << line.str() << std::flush;
}

std::string RoundedTime(double milliseconds) {
  const double seconds = milliseconds / 1000;
  std::ostringstream text;
  text << std::fixed << std::setprecision(0);
  if (seconds < 99.5) {
    text << seconds << " s";
  } else if (seconds < 99.5 * 60) {
    text << seconds / 60 << " min";
  } else {
    text << seconds / 3600 << " h";
  }
  return text.str();
}

}  // namespace musclewarp
