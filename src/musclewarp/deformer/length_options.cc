// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/deformer/length_options.h"

#include <glog/logging.h>

#include <cmath>

#include "musclewarp/base/input_error.h"
#include "musclewarp/base/text.h"

namespace musclewarp {

void AskInMillimetres(const std::set<std::string>& names,
                      double body_size,
                      PrepareOptions* prepare,
                      CertifiedContactOptions* contact,
                      FrameRequirements* requirements) {
  std::set<std::string> left = names;
  const auto convert = [&](const char* name, int power, double* value) {
    if (left.erase(name) > 0) *value /= std::pow(body_size, power);
  };
  convert("gap", 1, &contact->step.gap);
  convert("laplacian_length", 1, &prepare->muscle.laplacian.length_scale);
  convert("max_hole", 1, &prepare->repair.holes.max_perimeter);
  convert("max_lost_area", 2, &requirements->max_lost_area);
  convert("max_lost_extent", 1, &requirements->max_lost_extent);
  convert("max_move", 1, &requirements->displacement_allowance);
  convert("max_step_move", 1, &contact->limits.max_move);
  convert("max_torn_patch", 2, &requirements->max_torn_patch);
  convert("sample_spacing", 1, &prepare->muscle.sample_spacing);
  CHECK(left.empty()) << *left.begin() << " is no length among the options";
  if (contact->step.gap > kLargestGap) {
    throw InputError(
        "{gap}",
        "is " + LengthText(contact->step.gap, body_size) +
            ", and the body is " + BodySizeText(body_size) + " human size",
        "allowed: above 0, at most " + MeasureText(kLargestGap * body_size));
  }
}

}  // namespace musclewarp
