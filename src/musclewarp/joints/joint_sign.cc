// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/joints/joint_sign.h"

#include <glog/logging.h>

#include <algorithm>
#include <map>

#include "musclewarp/base/text.h"
#include "musclewarp/joints/joint_search.h"

namespace musclewarp {
namespace {

// Angles are counted in sectors, so that they may be at a limit but for the
// rounding of their conversion.
bool IsBeyond(JointSign::Beyond beyond, double value, double limit) {
  constexpr double kRounding = 1e-12;  // by the limit
  return beyond == JointSign::Beyond::kBelow ? value < limit * (1 - kRounding)
                                             : value > limit * (1 + kRounding);
}

// Returns the number of a search that sentences name; an empty text if there is
// none.
std::string SearchNumber(const std::string& key) {
  const std::map<std::string, double> numbers = {
      {"largest_head_radius", kJointSearch.head.largest_head_radius},
      {"least_head_radius", kJointSearch.head.least_head_radius},
      {"reach", kJointSearch.facing.reach},
      {"spacing", kJointSearch.sampling.spacing},
      {"start_tilt", kJointSearch.knee.start_tilt},
      {"usual_head_radius", kJointSearch.head.usual_head_radius}};
  const auto number = numbers.find(key);
  return number == numbers.end() ? "" : NumberText(number->second);
}

}  // namespace

JointQuality QualityOf(const SignMeasure& measure) {
  const auto is_beyond = [&](const SignLimit& limit) {
    return limit &&
           IsBeyond(measure.sign.beyond, measure.value, *limit * measure.scale);
  };
  return is_beyond(measure.sign.failed) ? JointQuality::kFailed
         : is_beyond(measure.sign.weak) ? JointQuality::kWeak
                                        : JointQuality::kGood;
}

std::string FilledText(const std::string& text,
                       const std::map<std::string, std::string>& words) {
  std::string filled;
  size_t next = 0;
  for (size_t open; (open = text.find('{', next)) != std::string::npos;) {
    const size_t close = text.find('}', open);
    CHECK(close != std::string::npos) << text;
    const std::string key = text.substr(open + 1, close - open - 1);
    const auto word = words.find(key);
    const bool is_given = word != words.end();
    const std::string by = is_given ? word->second : SearchNumber(key);
    CHECK(is_given || !by.empty()) << "no word {" << key << "}: " << text;
    filled += text.substr(next, open - next) + by;
    next = close + 1;
  }
  return filled + text.substr(next);
}

JointQuality Judge(const std::vector<SignMeasure>& measures,
                   JointVerdict* verdict,
                   std::map<std::string, std::string> words) {
  JointQuality quality = JointQuality::kGood;
  for (const SignMeasure& measure : measures) {
    quality = std::max(quality, QualityOf(measure));
  }
  if (quality == JointQuality::kGood) return quality;
  const bool fails = quality == JointQuality::kFailed;
  for (size_t i = 0; i < measures.size(); ++i) {
    const auto& [sign, value, scale] = measures[i];
    const std::string number = i == 0 ? "" : std::to_string(i + 1);
    const SignLimit& limit = fails ? sign.failed : sign.weak;
    words["value" + number] = RoundedText(value, sign.digits);
    if (!limit) continue;
    words["limit" + number] = scale == 1
                                  ? NumberText(*limit)
                                  : RoundedText(*limit * scale, sign.digits);
  }
  const JointSign& first = measures.front().sign;
  words["cause"] = first.cause;
  if (fails) {
    verdict->Fail(FilledText(first.failed_sentence, words));
  } else {
    verdict->Weaken(FilledText(first.weak_sentence, words));
  }
  return quality;
}

}  // namespace musclewarp
