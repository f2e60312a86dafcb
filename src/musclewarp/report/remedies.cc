// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/report/remedies.h"

#include <algorithm>

namespace musclewarp {
namespace {

// Words of a sentence about what a frame does not hold, and what to do then.
struct KnownShortcoming {
  const char* words;
  const char* remedy;
};

// The first that fits counts.
constexpr KnownShortcoming kKnown[] = {
    {"timed out after",
     "a frame took longer than {frame_timeout_s} allows: allow more time, or "
     "take smaller steps from pose to pose"},
    {"given up, as triangles crossed",
     "meshes could not be moved apart on the way: a finer motion, smaller "
     "{max_step_turn} and {max_step_move}, or another line for the muscle "
     "usually helps"},
    {"as it was delivered", ""},
    {"crossing triangle pairs",
     "nothing may cross with {contact}=certified, and no flag allows it: a "
     "finer motion or another line for the muscle usually helps, or more room "
     "between the bones there"},
    {"less than the gap of",
     "{gap} sets the distance that is kept: a smaller one or a finer motion "
     "usually helps"},
    {"of its volume of",
     "{max_loss} sets how much volume may be lost: mend the mesh where it lies "
     "in others, or allow more"},
    {" cm2 of the muscle are gone",
     "{max_lost_area} sets how much surface may be lost: mend the mesh where "
     "it lies in others, or allow more"},
    {"short of where the delivered mesh",
     "{max_lost_extent} sets how much of an end may be lost: mend the mesh "
     "there, or allow more"},
    {"is not attached to",
     "the attachment was lost with the part of the mesh that lies in others: "
     "mend the mesh there"},
    {"torn by contact",
     "{max_torn_patch} sets how large a torn patch may be: allow more, or give "
     "the muscle another line"},
    {"volume off by",
     "the solver did not keep the volume, for which no flag sets a limit: a "
     "larger {max_iterations} or a finer motion usually helps"},
    {"times its length",
     "no flag allows more stretch: look whether the line of the muscle and its "
     "motion are right"},
    {"self-intersecting triangle pairs",
     "a muscle may not cross itself, and no flag allows it: a finer motion or "
     "another line usually helps"},
    {"folded triangles",
     "no flag allows more folded triangles: a finer motion or another line "
     "usually helps"},
    {"by contact, allowed",
     "contact pushes a muscle far, for which no flag sets a limit: give it a "
     "line that keeps out of bones, or more lines"},
};

// "frame 4 is usable" with its flag, or "frames 0 to 16".
std::string UsableText(const std::vector<int>& frames) {
  const std::string first = std::to_string(frames.front());
  if (frames.size() == 1) {
    return "frame " + first + " is usable: {frames}=" + first +
           " computes it alone";
  }
  const std::string last = std::to_string(frames.back());
  const int step = frames[1] - frames[0];
  bool is_even = step > 0;
  for (size_t i = 1; i < frames.size(); ++i) {
    is_even = is_even && frames[i] - frames[i - 1] == step;
  }
  const std::string text = "frames " + first + " to " + last + " are usable";
  if (!is_even) return text;
  return text + ": {frames}=" + first + ":" + last +
         (step == 1 ? "" : ":" + std::to_string(step)) + " computes them alone";
}

void AddOnce(const std::string& line, std::vector<std::string>* lines) {
  if (line.empty() || std::count(lines->begin(), lines->end(), line) > 0) {
    return;
  }
  lines->push_back(line);
}

}  // namespace

std::string RemedyFor(const std::string& shortcoming) {
  for (const KnownShortcoming& known : kKnown) {
    if (shortcoming.find(known.words) != std::string::npos) {
      return known.remedy;
    }
  }
  return "";
}

std::vector<std::string> RemediesFor(const RunRecord& run) {
  std::vector<int> usable;
  for (const FrameFigures& frame : run.frames) {
    if (!frame.IsUsable()) break;
    usable.push_back(frame.index);
  }
  if (usable.size() == run.frames.size()) return {};
  std::vector<std::string> lines;
  if (!usable.empty()) lines.push_back(UsableText(usable));
  for (const FrameFigures& frame : run.frames) {
    for (const std::string& shortcoming : frame.shortcomings) {
      AddOnce(RemedyFor(shortcoming), &lines);
    }
    if (frame.stop_reason() != ToString(StopReason::kConverged)) {
      AddOnce(
          "a solve did not converge: a larger {max_iterations} or a finer "
          "motion usually helps",
          &lines);
    }
  }
  return lines;
}

}  // namespace musclewarp
