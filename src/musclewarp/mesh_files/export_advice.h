// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace musclewarp {

// What the messages of the readers advise to do about a file.

// It is damaged: bytes are missing, or there are too many.
constexpr char kCopyAgain[] = "copy or export it again";

// Whatever wrote it got it wrong.
constexpr char kExportAgain[] = "export the mesh again";

}  // namespace musclewarp
