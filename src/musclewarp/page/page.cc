// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/page/page.h"

#include "musclewarp/page/page_parts.h"

namespace musclewarp {

std::string PageHtml(const std::vector<RecordedRun>& runs,
                     const PageOptions& options) {
  const PageContents contents = PageContentsOf(runs, options);
  return PageText(
      {kPageBundle, kPageBundleSize}, "runs", contents.json, contents.numbers);
}

}  // namespace musclewarp
