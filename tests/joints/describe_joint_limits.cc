// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0

// Prints the signs of all joints (musclewarp/joints/joint_limits.h) as JSON, of
// which scripts/generated.py makes the table of docs/joints.md; it is not
// installed.

#include <iostream>
#include <nlohmann/json.hpp>

#include "musclewarp/base/setting_names.h"
#include "musclewarp/joints/joint_limits.h"

namespace musclewarp {
namespace {

using OrderedJson = nlohmann::ordered_json;

OrderedJson AllSigns() {
  OrderedJson all;
  VisitFields(kJointLimits, [&](const auto& joint, const auto& signs) {
    VisitFields(signs, [&](const auto& field, const JointSign& sign) {
      const auto limit = [&](const SignLimit& value) -> OrderedJson {
        return value ? OrderedJson(*value) : OrderedJson();
      };
      const char* sides[] = {"above", "below", "yes"};
      all[joint.key].push_back(
          {{"text", FilledText(field.text)},
           {"unit", field.unit},
           {"beyond", sides[static_cast<int>(sign.beyond)]},
           {"weak", limit(sign.weak)},
           {"failed", limit(sign.failed)},
           {"cause", WithFlags(sign.cause)},
           {"source", FilledText(sign.source)}});
    });
  });
  return all;
}

}  // namespace
}  // namespace musclewarp

int main() {
  std::cout << musclewarp::AllSigns().dump(1) << "\n";
  return 0;
}
