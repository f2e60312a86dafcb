// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace musclewarp {

// Checks the fields of an option struct one after another and keeps a message
// about the first one that is not allowed: its name, its value and the rule.
//
//   bool RelaxationOptions::IsValid(std::string* error) const {
//     return OptionCheck("RelaxationOptions", error)
//         .IsAbove("smoothing_length", smoothing_length, 0)
//         .IsWithin("room_decay", room_decay, 0, 1)
//         .is_valid();
//   }
//
// gives "RelaxationOptions::room_decay is 2, allowed: 0 to 1". A value that is
// not a number breaks every rule.
class OptionCheck {
 public:
  // `options` is the name of the struct. `error` must not be null; it is
  // written only if a field breaks its rule.
  OptionCheck(const std::string& options, std::string* error)
      : options_(options), error_(error) {}

  // value > limit
  OptionCheck& IsAbove(const std::string& field, double value, double limit);

  // value >= limit
  OptionCheck& IsAtLeast(const std::string& field, double value, double limit);

  // lowest <= value <= highest
  OptionCheck& IsWithin(const std::string& field,
                        double value,
                        double lowest,
                        double highest);

  // True if no field so far broke its rule.
  bool is_valid() const { return is_valid_; }

 private:
  OptionCheck& Require(bool holds,
                       const std::string& field,
                       double value,
                       const std::string& rule);

  std::string options_;
  std::string* error_;
  bool is_valid_ = true;
};

}  // namespace musclewarp
