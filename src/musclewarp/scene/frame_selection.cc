// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/scene/frame_selection.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cstdint>
#include <numeric>
#include <sstream>

#include "musclewarp/base/input_error.h"
#include "musclewarp/base/text.h"

namespace musclewarp {
namespace {

[[noreturn]] void FailFrames(const std::string& frames,
                             const std::string& problem) {
  throw InputError("{frames}=" + frames,
                   problem,
                   "allowed: all, last, N, FIRST:LAST, FIRST:LAST:STEP, "
                   "PART/PARTS; FIRST and LAST may be times (0.1s)");
}

int ParseFrameNumber(const std::string& text, const std::string& frames) {
  if (text.empty() || text.size() > 8 ||
      !std::all_of(text.begin(), text.end(), [](unsigned char c) {
        return std::isdigit(c);
      })) {
    FailFrames(frames, "\"" + text + "\" is not a frame number");
  }
  return std::stoi(text);
}

// Returns the number of the frame at an end of a range, which is given as a
// number or as a time with its unit.
int ParseRangeEnd(const std::string& text,
                  bool is_first,
                  const std::vector<ScenePose>& poses,
                  const std::vector<int>& numbers,
                  const std::string& frames) {
  if (text.empty() || text.back() != 's') {
    return ParseFrameNumber(text, frames);
  }
  double time = 0;
  const char* const end = text.data() + text.size() - 1;
  const auto result = std::from_chars(text.data(), end, time);
  if (result.ptr != end || result.ec != std::errc()) {
    FailFrames(frames, "\"" + text + "\" is not a time");
  }
  // Half of the last digit of times in usual files.
  constexpr double kSlack = 1e-9;
  const int count = static_cast<int>(poses.size());
  if (is_first) {
    int i = 0;
    while (i < count && poses[i].time < time - kSlack) ++i;
    return i < count ? numbers[i] : numbers.back() + 1;
  }
  int i = count - 1;
  while (i >= 0 && poses[i].time > time + kSlack) --i;
  return i >= 0 ? numbers[i] : numbers.front() - 1;
}

// Returns the indices of one of `frames` = PART/PARTS equal parts of `count`
// poses.
std::vector<int> SelectPart(const std::string& frames, int count) {
  const size_t slash = frames.find('/');
  const int part = ParseFrameNumber(frames.substr(0, slash), frames);
  const int parts = ParseFrameNumber(frames.substr(slash + 1), frames);
  if (part < 1 || part > parts) {
    FailFrames(frames, "parts are numbered from 1");
  }
  if (parts > count) {
    FailFrames(
        frames,
        "has more parts than there are frames, " + std::to_string(count));
  }
  // In 64 bits: both numbers may have 8 digits.
  const auto begin = [&](std::int64_t k) {
    return static_cast<int>(k * count / parts);
  };
  std::vector<int> selected(begin(part) - begin(part - 1));
  std::iota(selected.begin(), selected.end(), begin(part - 1));
  return selected;
}

// Returns a text on the frames that can be selected.
std::string RangeText(const std::vector<ScenePose>& poses,
                      const std::vector<int>& numbers) {
  std::ostringstream range;
  range << "there are frames " << numbers.front() << " to " << numbers.back();
  const auto count = static_cast<int>(numbers.size());
  if (numbers.back() - numbers.front() + 1 > count) {
    range << " (" << count << " of them)";
  }
  if (poses.front().time < poses.back().time) {
    range << ", " << poses.front().time << "s to " << poses.back().time << "s";
  }
  return range.str();
}

}  // namespace

std::vector<int> SelectFrames(const std::string& frames,
                              const std::vector<ScenePose>& poses) {
  std::vector<int> numbers(poses.size());
  std::iota(numbers.begin(), numbers.end(), 0);
  return SelectFrames(frames, poses, numbers);
}

std::vector<int> SelectFrames(const std::string& frames,
                              const std::vector<ScenePose>& poses,
                              const std::vector<int>& numbers) {
  if (frames.find('/') != std::string::npos) {
    return SelectPart(frames, static_cast<int>(poses.size()));
  }
  int first = numbers.front();
  int last = numbers.back();
  int step = 1;
  if (frames == "last") {
    first = last;
  } else if (frames != "all") {
    const std::vector<std::string> parts = Split(frames, ':');
    if (parts.empty() || parts.size() > 3 || frames.back() == ':') {
      ParseFrameNumber("", frames);
    }
    first = ParseRangeEnd(parts[0], true, poses, numbers, frames);
    last = ParseRangeEnd(
        parts.size() > 1 ? parts[1] : parts[0], false, poses, numbers, frames);
    if (parts.size() > 2) step = ParseFrameNumber(parts[2], frames);
  }
  std::vector<int> selected;
  if (first >= numbers.front() && last <= numbers.back() && step > 0) {
    for (size_t i = 0; i < numbers.size(); ++i) {
      const int number = numbers[i];
      if (number < first || number > last) continue;
      if ((number - first) % step == 0) selected.push_back(static_cast<int>(i));
    }
  }
  if (!selected.empty()) return selected;
  throw InputError("{frames}=" + frames,
                   "selects no frame or one that is not there",
                   RangeText(poses, numbers));
}

}  // namespace musclewarp
