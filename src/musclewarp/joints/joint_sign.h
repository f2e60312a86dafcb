// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// The signs by which a joint is weak or failed. Each is typed once, with its
// limits (joint_limits.h): verdicts, their sentences and the table of
// docs/joints.md follow from it.

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "musclewarp/base/described.h"
#include "musclewarp/joints/found_joint.h"

namespace musclewarp {

// What makes a joint weak or failed: a measure beyond a limit, or an
// observation that is made or not. The unit and the text of the sign are those
// of its field.
//
// Sentences have words in braces, which Judge fills in: {value} and {limit},
// {cause}, and some numbers of the searches by their names (FilledText). Of a
// sign without sentences the one that is judged with it speaks, which calls its
// measure {value2}, and so on.
struct JointSign {
  enum class Beyond {
    kAbove,  // the joint is weak or failed above the limit
    kBelow,  // below it
    kYes,    // if the observation is made, whose value is then 1 and else 0
  };
  Beyond beyond = Beyond::kYes;
  std::optional<double> weak, failed;  // none: the sign never tells this
  const char* weak_sentence = "";
  const char* failed_sentence = "";
  const char* cause = "";   // the usual one
  const char* source = "";  // what the limits rest on
  int digits = 0;           // of the value in sentences, behind the point

  // Return the same sign with a sentence, its cause and source, or digits.
  constexpr JointSign Weak(const char* sentence) const {
    JointSign sign = *this;
    sign.weak_sentence = sentence;
    return sign;
  }
  constexpr JointSign Failed(const char* sentence) const {
    JointSign sign = *this;
    sign.failed_sentence = sentence;
    return sign;
  }
  constexpr JointSign From(const char* cause_, const char* source_) const {
    JointSign sign = *this;
    sign.cause = cause_;
    sign.source = source_;
    return sign;
  }
  constexpr JointSign Digits(int count) const {
    JointSign sign = *this;
    sign.digits = count;
    return sign;
  }
};

constexpr auto FieldsOf(Described<JointSign>) {
  using F = JointSign;
  return std::make_tuple(
      Field(&F::beyond, "beyond").Text("on which side of the limits"),
      Field(&F::weak, "weak").Text("the joint is weak beyond this").AtLeast(0),
      Field(&F::failed, "failed").Text("it failed beyond this").AtLeast(0),
      Field(&F::weak_sentence, "weak_sentence").Text("what a verdict says"),
      Field(&F::failed_sentence, "failed_sentence").Text("the same"),
      Field(&F::cause, "cause").Text("the usual cause"),
      Field(&F::source, "source").Text("what the limits rest on"),
      Field(&F::digits, "digits").Text("digits of the value").Within(0, 3));
}

// Return a sign of a measure whose limits these are.
using SignLimit = std::optional<double>;
constexpr JointSign Above(SignLimit weak, SignLimit failed = {}) {
  return {JointSign::Beyond::kAbove, weak, failed};
}
constexpr JointSign Below(SignLimit weak, SignLimit failed = {}) {
  return {JointSign::Beyond::kBelow, weak, failed};
}

// Return a sign without a measure.
constexpr JointSign WeakIf(const char* sentence) {
  return JointSign{JointSign::Beyond::kYes, 0.0, {}}.Weak(sentence);
}
constexpr JointSign FailedIf(const char* sentence) {
  return JointSign{JointSign::Beyond::kYes, {}, 0.0}.Failed(sentence);
}

// The measure of a sign on the bones of one person.
struct SignMeasure {
  const JointSign& sign;
  double value = 1;  // in the unit of its sentence
  double scale = 1;  // of the limits to that unit, such as the radius of a head
};

// Returns what a measure says of a joint. Beyond a limit is what differs from
// it by more than rounding.
JointQuality QualityOf(const SignMeasure& measure);

// Replaces the words in braces of a text: by those given, or by the numbers of
// searches (joint_search.h) that sentences name.
std::string FilledText(const std::string& text,
                       const std::map<std::string, std::string>& words = {});

// Weakens or fails a verdict by what is measured, with the sentence of the
// first sign. Returns the worst that the measures say.
JointQuality Judge(const std::vector<SignMeasure>& measures,
                   JointVerdict* verdict,
                   std::map<std::string, std::string> words = {});

}  // namespace musclewarp
