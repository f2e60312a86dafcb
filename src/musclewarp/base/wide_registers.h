// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Before a function: the compiler also makes a version of it for processors
// with wide registers, which is chosen when the program starts.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && \
    !defined(__SANITIZE_ADDRESS__)
#define MUSCLEWARP_WIDE __attribute__((target_clones("avx2,fma", "default")))
#else
#define MUSCLEWARP_WIDE
#endif
