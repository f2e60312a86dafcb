// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "musclewarp/page/page_data.h"

namespace musclewarp {

// The page as one self-contained HTML text: the bundle of tools/report with the
// data in it.
std::string PageHtml(const std::vector<RecordedRun>& runs,
                     const PageOptions& options);

// The bundle: HTML with a comment where the data belong. Made from tools/report
// by the build.
extern const char kPageBundle[];
extern const unsigned long kPageBundleSize;

}  // namespace musclewarp
