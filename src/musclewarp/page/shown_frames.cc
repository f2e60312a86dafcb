// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/page/shown_frames.h"

#include "musclewarp/figures/figures_json.h"

namespace musclewarp {

nlohmann::ordered_json ShownFrames(const std::vector<FrameFigures>& figures) {
  using OrderedJson = nlohmann::ordered_json;
  OrderedJson frames = JsonOf(figures);
  for (OrderedJson& frame : frames) {
    for (const char* key : {"gaps", "bone_overlaps", "delivered_crossings"}) {
      frame.erase(key);
    }
    for (OrderedJson& muscle : frame["muscles"]) {
      for (const char* key : {"fibre_lengths_mm",
                              "fibre_stretch_by_fifths",
                              "fibre_moment_arms_mm",
                              "path_lengths_mm",
                              "pushed_by",
                              "torn_patch_place_mm",
                              "initial_energy_mm2",
                              "final_energy_mm2"}) {
        muscle.erase(key);
      }
      OrderedJson& shape = muscle["shape"];
      shape = {{"max_stretch", shape["max_stretch"]},
               {"max_change_mm", shape["max_change_mm"]},
               {"triangle_stretch",
                {{"quantile_999", shape["triangle_stretch"]["quantile_999"]},
                 {"largest_patch_mm2",
                  shape["triangle_stretch"]["largest_patch_mm2"]}}}};
      for (OrderedJson& area : muscle["attachments"]) {
        area = {{"body", area["body"]}, {"max_drift_mm", area["max_drift_mm"]}};
      }
    }
  }
  return frames;
}

}  // namespace musclewarp
