// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/joints/joint_limits.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <map>
#include <set>
#include <string>

#include "musclewarp/base/described_checks.h"
#include "musclewarp/base/text.h"
#include "musclewarp/joints/joint_search.h"

namespace musclewarp {
namespace {

// Calls visit(field, sign) with every sign of every joint.
template <class Visit>
void VisitSigns(const Visit& visit) {
  VisitFields(kJointLimits, [&](const auto& joint, const auto& signs) {
    VisitFields(signs, [&](const auto& field, const JointSign& sign) {
      SCOPED_TRACE(std::string(joint.key) + "." + field.key);
      visit(field, sign);
    });
  });
}

// True if a number is typed in a text, outside braces. Units have digits, too.
bool HasNumber(std::string text) {
  for (size_t open; (open = text.find('{')) != std::string::npos;) {
    text.erase(open, text.find('}', open) - open + 1);
  }
  for (size_t at; (at = text.find("mm2")) != std::string::npos;) {
    text.erase(at, 3);
  }
  return std::any_of(text.begin(), text.end(), [](unsigned char letter) {
    return std::isdigit(letter) != 0;
  });
}

// The words of sentences that measures do not give.
const std::map<std::string, std::string> kOtherWords = {{"height", "."},
                                                        {"left", "1"},
                                                        {"reached", "1"},
                                                        {"right", "1"},
                                                        {"shape", "head"}};

TEST(JointLimits, AreValidAndSayWhatTheyAreAndRestOn) {
  std::string error;
  EXPECT_TRUE(IsValid(kJointLimits, &error)) << error;
  VisitSigns([](const auto& field, const JointSign& sign) {
    EXPECT_TRUE(sign.weak || sign.failed);
    EXPECT_FALSE(FilledText(field.text).empty());
    EXPECT_STRNE(sign.cause, "");
    EXPECT_STRNE(sign.source, "");
    const bool has_measure = sign.beyond != JointSign::Beyond::kYes;
    EXPECT_EQ(std::string(field.unit).empty(), !has_measure);
    if (!sign.weak || !sign.failed) return;
    EXPECT_EQ(*sign.failed > *sign.weak,
              sign.beyond == JointSign::Beyond::kAbove);
  });
}

TEST(JointLimits, AreTypedOnce) {
  VisitSigns([](const auto& field, const JointSign& sign) {
    EXPECT_FALSE(HasNumber(field.text));
    EXPECT_FALSE(HasNumber(sign.weak_sentence));
    EXPECT_FALSE(HasNumber(sign.failed_sentence));
  });
}

TEST(JointLimits, AreNotPassedUntilOneStepBeyond) {
  VisitSigns([](const auto& field, const JointSign& sign) {
    static_cast<void>(field);
    for (const SignLimit& limit : {sign.weak, sign.failed}) {
      if (!limit) continue;
      const bool is_below = sign.beyond == JointSign::Beyond::kBelow;
      const double step = is_below ? -1e-6 : 1e-6;
      const auto quality = [&](double value) {
        return QualityOf({sign, value});
      };
      const bool fails = limit == sign.failed;
      const JointQuality beyond =
          fails ? JointQuality::kFailed : JointQuality::kWeak;
      EXPECT_LT(quality(*limit), beyond);
      EXPECT_EQ(quality(*limit + step), beyond);
      EXPECT_LT(quality(*limit - step), beyond);
      // The same where the limit follows the size of a person.
      EXPECT_LT(QualityOf({sign, 23 * *limit, 23}), beyond);
    }
  });
}

TEST(JointLimits, HaveSentencesWithTheirNumbers) {
  VisitSigns([](const auto& field, const JointSign& sign) {
    static_cast<void>(field);
    const bool is_below = sign.beyond == JointSign::Beyond::kBelow;
    for (const SignLimit& limit : {sign.weak, sign.failed}) {
      const bool fails = limit == sign.failed;
      const std::string sentence =
          fails ? sign.failed_sentence : sign.weak_sentence;
      // Another sign speaks for one without a sentence.
      if (!limit || sentence.empty()) continue;
      const SignMeasure measure = {sign, *limit + (is_below ? -0.25 : 0.25)};
      JointVerdict verdict;
      Judge({measure, measure, measure, measure}, &verdict, kOtherWords);
      ASSERT_EQ(verdict.reasons.size(), 1u);
      EXPECT_EQ(verdict.reasons[0].find('{'), std::string::npos);
      if (sentence.find("{limit}") == std::string::npos) continue;
      EXPECT_NE(verdict.reasons[0].find(NumberText(*limit)), std::string::npos)
          << verdict.reasons[0];
    }
  });
}

}  // namespace
}  // namespace musclewarp
