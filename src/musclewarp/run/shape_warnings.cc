// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/run/shape_warnings.h"

#include <algorithm>
#include <functional>
#include <map>
#include <utility>

#include "musclewarp/base/text.h"
#include "musclewarp/frames/triangle_stretch.h"
#include "musclewarp/preparation/attachments.h"

namespace musclewarp {
namespace {

constexpr size_t kFewestFrames = 5;

std::string At(const Eigen::RowVector3d& place, double body_size) {
  return "at " + PlaceText(place / body_size, body_size);
}

// Returns the number of the frame with the largest value, or -1 if no value is
// above the limit.
int Worst(const std::vector<FrameFigures>& frames,
          double limit,
          const std::function<double(const FrameFigures&)>& value) {
  int worst = -1;
  for (size_t f = 0; f < frames.size(); ++f) {
    const double here = value(frames[f]);
    if (!(here > limit)) continue;
    limit = here;
    worst = static_cast<int>(f);
  }
  return worst;
}

void WarnOfDrift(const std::vector<FrameFigures>& frames,
                 size_t muscle,
                 double body_size,
                 std::vector<std::string>* warnings) {
  const double limit = kLargestDrift * body_size;
  const size_t count = frames[0].muscles[muscle].attachments.size();
  for (size_t area = 0; area < count; ++area) {
    const auto drift_in = [&](const FrameFigures& f) -> const AttachmentDrift& {
      return f.muscles[muscle].attachments[area];
    };
    const int worst = Worst(
        frames, limit, [&](const FrameFigures& f) { return drift_in(f).max; });
    if (worst < 0) continue;
    const AttachmentDrift& drift = drift_in(frames[worst]);
    warnings->push_back(frames[worst].muscles[muscle].name + " leaves " +
                        drift.body + ", to which it is attached, by up to " +
                        RoundedText(drift.max, 1, body_size) + " mm (" +
                        RoundedText(drift.mean, 1, body_size) +
                        " on average) in " + frames[worst].name + " " +
                        At(drift.place, body_size));
  }
}

// Returns how much of the surface is stretched, to follow the largest stretch;
// nothing for records of earlier versions, which do not have it.
std::string StretchedAreas(const MuscleFigures& record, double body_size) {
  const StretchMeasures& stretch = record.shape.triangles;
  if (stretch.largest == 1) return "";
  std::string text = ", 99 % of its surface to at most " +
                     RoundedText(stretch.quantile_99, 2, body_size) +
                     ", 99.9 % to " +
                     RoundedText(stretch.quantile_999, 2, body_size);
  if (stretch.largest_patch == 0) return text;
  text += "; the largest patch beyond " + MeasureText(kStretchOfPatches) +
          " has " + RoundedText(stretch.largest_patch / 100, 2, body_size) +
          " cm2, " + At(stretch.patch_place, body_size);
  if (record.torn_patch.area == 0) return text;
  return text + ", and the largest that contact has torn " +
         RoundedText(record.torn_patch.area / 100, 2, body_size) + " cm2";
}

void WarnOfStretch(const std::vector<FrameFigures>& frames,
                   size_t muscle,
                   double body_size,
                   std::vector<std::string>* warnings) {
  const int worst =
      Worst(frames, kStretchBeyondAnatomy, [&](const FrameFigures& f) {
        return f.muscles[muscle].shape.max_stretch;
      });
  if (worst < 0) return;
  const MuscleFigures& record = frames[worst].muscles[muscle];
  warnings->push_back(record.name + " is stretched to " +
                      RoundedText(record.shape.max_stretch, 2, body_size) +
                      " times its length at rest in " + frames[worst].name +
                      " " + At(record.shape.stretch_place, body_size) +
                      StretchedAreas(record, body_size));
}

// The first frame has no frame before it. The moves of a design are not of one
// length, so that their median says nothing.
void WarnOfJumps(const std::vector<FrameFigures>& frames,
                 size_t muscle,
                 double body_size,
                 std::vector<std::string>* warnings) {
  if (frames.size() < kFewestFrames || frames[0].reached_from) return;
  const auto change_in = [&](const FrameFigures& f) {
    return &f == &frames[0] ? 0 : f.muscles[muscle].shape.max_change;
  };
  std::vector<double> changes;
  for (size_t f = 1; f < frames.size(); ++f) {
    changes.push_back(change_in(frames[f]));
  }
  const auto middle = changes.begin() + changes.size() / 2;
  std::nth_element(changes.begin(), middle, changes.end());
  const double median = *middle;
  const int worst = Worst(
      frames, std::max(kLeastJump * body_size, kJumpRatio * median), change_in);
  if (worst < 0) return;
  const MuscleFigures& record = frames[worst].muscles[muscle];
  warnings->push_back(record.name + " jumps by " +
                      RoundedText(record.shape.max_change, 1, body_size) +
                      " mm from " + frames[worst - 1].name + " to " +
                      frames[worst].name + " (the median of its changes is " +
                      RoundedText(median, 1, body_size) + " mm) " +
                      At(record.shape.change_place, body_size));
}

// Sentences of the worst frame of each pair of bones.
void WarnOfBones(const std::vector<FrameFigures>& frames,
                 double body_size,
                 std::vector<std::string>* warnings) {
  std::map<std::pair<std::string, std::string>,
           std::pair<const FrameFigures*, const BoneOverlap*>>
      worst;
  for (const FrameFigures& frame : frames) {
    for (const BoneOverlap& overlap : frame.bone_overlaps) {
      auto& found = worst[{overlap.a, overlap.b}];
      if (!found.second || overlap.depth_mm > found.second->depth_mm) {
        found = {&frame, &overlap};
      }
    }
  }
  for (const auto& [names, found] : worst) {
    warnings->push_back(names.first + " and " + names.second + " are " +
                        RoundedText(found.second->depth_mm, 1, body_size) +
                        " mm deep in each other in " + found.first->name + " " +
                        At(found.second->place, body_size) +
                        ": muscles between them have no room there");
  }
}

}  // namespace

std::vector<std::string> ShapeWarnings(const std::vector<FrameFigures>& frames,
                                       double body_size) {
  std::vector<std::string> warnings;
  if (frames.empty()) return warnings;
  for (size_t muscle = 0; muscle < frames[0].muscles.size(); ++muscle) {
    WarnOfDrift(frames, muscle, body_size, &warnings);
    WarnOfStretch(frames, muscle, body_size, &warnings);
    WarnOfJumps(frames, muscle, body_size, &warnings);
  }
  WarnOfBones(frames, body_size, &warnings);
  return warnings;
}

}  // namespace musclewarp
