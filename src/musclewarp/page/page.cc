// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/page/page.h"

#include <algorithm>

#include "musclewarp/page/page_parts.h"

namespace musclewarp {

namespace {

// Browsers open a page of this size within seconds.
constexpr std::size_t kLargestPage = std::size_t{12} << 20;

// Positions are not shown less exactly than this, mm in a human: a fifth of a
// pixel of a thigh.
constexpr double kCoarsest = 0.2;

}  // namespace

std::string PageHtml(const std::vector<RecordedRun>& runs,
                     const PageOptions& options) {
  PageOptions finest = options;
  while (true) {
    const PageContents contents = PageContentsOf(runs, finest);
    std::string html = PageText({kPageBundle, kPageBundleSize},
                                "runs",
                                contents.json,
                                contents.numbers);
    if (html.size() <= kLargestPage || finest.position_tolerance >= kCoarsest) {
      return html;
    }
    finest.position_tolerance =
        std::min(kCoarsest, 2 * finest.position_tolerance);
  }
}

}  // namespace musclewarp
