// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "musclewarp/page/page_contents.h"

namespace musclewarp {

// Returns the report page of one or more runs as a single HTML text that needs
// no server and no other file: the bundle of tools/report with the data of the
// runs in it. Names of muscles and bones are escaped, so they cannot end the
// script that holds them. The text is the same for the same runs. Throws
// InputError that names --axes or --side. Precondition: there is a run.
std::string PageHtml(const std::vector<RecordedRun>& runs,
                     const PageOptions& options);

// The bundle: HTML with a comment at the place of the data, and its size in
// bytes. The build makes it from tools/report.
extern const char kPageBundle[];
extern const unsigned long kPageBundleSize;

}  // namespace musclewarp
