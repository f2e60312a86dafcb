// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0

// What holds for every list of settings: a setting is refused outside of its
// range, by its name, and options of values within it are valid.

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <set>

#include "musclewarp/deformer/length_options.h"
#include "musclewarp/settings/articulation_settings.h"
#include "musclewarp/settings/checked_settings.h"
#include "musclewarp/settings/deformer_settings.h"
#include "musclewarp/settings/file_settings.h"
#include "musclewarp/settings/label_settings.h"
#include "musclewarp/settings/separation_settings.h"
#include "support/input_errors.h"

namespace musclewarp {
namespace {

template <class Options>
bool IsValidIfItSays(const Options& options, std::string* error) {
  if constexpr (std::is_same_v<Options, DeformerOptions> ||
                std::is_same_v<Options, RestSeparationOptions>) {
    return options.IsValid(error);
  } else {
    return true;
  }
}

template <class Settings>
class SettingsLaws : public ::testing::Test {
 protected:
  // Calls visit(field, settings, value) for each field, with settings of their
  // own and the value of the field in them.
  template <class Visit>
  static void VisitEach(const Visit& visit) {
    VisitFields(Settings(), [&](const auto& field, const auto& /*value*/) {
      Settings settings;
      visit(field, &settings, &std::invoke(field.access, settings));
    });
  }

  static void ExpectAccepted(const Settings& settings, const char* key) {
    std::string error;
    try {
      EXPECT_TRUE(IsValidIfItSays(OptionsOf(settings), &error))
          << key << ": " << error;
    } catch (const InputError& refused) {
      ADD_FAILURE() << key << ": " << refused.what();
    }
  }

  static void ExpectRefused(const Settings& settings, const char* key) {
    ExpectInputError([&] { OptionsOf(settings); },
                     {"--" + std::string(key), "allowed: "});
  }
};

using AllSettings = ::testing::Types<ArticulationSettings,
                                     DeformerSettings,
                                     FileSettings,
                                     LabelSettings,
                                     SeparationSettings>;
TYPED_TEST_SUITE(SettingsLaws, AllSettings);

TYPED_TEST(SettingsLaws, DefaultsAreAllowed) {
  this->ExpectAccepted(TypeParam(), "the defaults");
}

TYPED_TEST(SettingsLaws, EachHasANameAndAText) {
  std::set<std::string> keys;
  this->VisitEach([&](const auto& field, auto*, auto*) {
    EXPECT_TRUE(keys.insert(field.key).second) << field.key << " twice";
    EXPECT_GT(std::string(field.text).size(), 10U) << field.key;
    EXPECT_NE(std::string(field.text).back(), '.') << field.key;
  });
}

TYPED_TEST(SettingsLaws, NumbersAreRefusedOutsideOfTheirRanges) {
  this->VisitEach([&](const auto& field, TypeParam* settings, auto* value) {
    using Value = std::decay_t<decltype(*value)>;
    if constexpr (std::is_arithmetic_v<Value> && !std::is_same_v<Value, bool>) {
      const ValueRange& range = field.range;
      const auto set = [&](double number) {
        *value = static_cast<Value>(number);
        return *settings;
      };
      if (std::isfinite(range.lowest)) {
        if (range.is_open) {
          this->ExpectRefused(set(range.lowest), field.key);
        } else {
          this->ExpectAccepted(set(range.lowest), field.key);
        }
        const double below = range.lowest - (range.also_allowed < 0 ? 2 : 1);
        this->ExpectRefused(set(below), field.key);
      }
      if (std::isfinite(range.highest)) {
        this->ExpectAccepted(set(range.highest), field.key);
        this->ExpectRefused(set(range.highest + 1), field.key);
      }
      if constexpr (std::is_floating_point_v<Value>) {
        this->ExpectRefused(set(std::nan("")), field.key);
        this->ExpectRefused(set(std::numeric_limits<double>::infinity()),
                            field.key);
      }
    }
  });
}

TYPED_TEST(SettingsLaws, ChoicesAreThoseOfTheList) {
  this->VisitEach([&](const auto& field, TypeParam* settings, auto* value) {
    if constexpr (std::is_same_v<std::decay_t<decltype(*value)>, std::string>) {
      const Choices choices = ChoicesOf(field.choices);
      if (choices.words.empty()) return;
      const std::string as_default = *value;
      bool has_default = false;
      for (const std::string& choice : choices.words) {
        has_default = has_default || choice == as_default;
        *value = choice;
        // bones=once is for formats other than the default, and vtp for
        // builds with VTK.
        if (std::string(field.key) != "bones" && choice != "vtp") {
          this->ExpectAccepted(*settings, field.key);
        }
      }
      EXPECT_TRUE(has_default) << field.key;
      for (const std::string other : {"", "rubber", "auto,", field.choices}) {
        *value = other;
        this->ExpectRefused(*settings, field.key);
      }
    }
  });
}

// A length that follows the size of the body can be given in mm.
TYPED_TEST(SettingsLaws, LengthsCanBeGivenInMillimetres) {
  if constexpr (std::is_base_of_v<RestSettings, TypeParam>) {
    this->VisitEach([&](const auto& field, TypeParam* settings, auto* value) {
      const std::string unit = field.unit;
      if (unit != "mm" && unit != "mm2") return;
      settings->given = {field.key};
      EXPECT_EQ(LengthsInMillimetres(*settings),
                (std::set<std::string>{field.key}));
      if constexpr (std::is_floating_point_v<std::decay_t<decltype(*value)>>) {
        settings->given = {};
        *value = 0.3;
        EXPECT_EQ(LengthsInMillimetres(*settings).count(field.key), 1U);
      }
      PrepareOptions prepare;
      CertifiedContactOptions contact;
      FrameRequirements requirements;
      AskInMillimetres({field.key}, 2, &prepare, &contact, &requirements);
    });
  }
}

}  // namespace
}  // namespace musclewarp
