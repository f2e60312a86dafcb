// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/skeleton/line_supports.h"

namespace musclewarp {

void ScaleLengths(double factor, LineSupports* supports) {
  supports->stiffness /= factor;
  supports->plane_stiffness /= factor;
  supports->hold /= factor;
  supports->onset *= factor;
  supports->plane_onset *= factor;
  for (LineTie& tie : supports->ties) tie.stiffness /= factor;
}

}  // namespace musclewarp
