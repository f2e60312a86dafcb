// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "musclewarp/subject/subject.h"

namespace musclewarp::python {

// Subjects of Python do not change.
using SharedSubject = std::shared_ptr<Subject>;

}  // namespace musclewarp::python
