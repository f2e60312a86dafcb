#!/usr/bin/env bash
# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
#
# Builds the unit tests with the address and undefined behaviour sanitizers, in
# build/asan, and runs them. The preset asan says how, for ctest; the last
# program is started here.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

scripts/build.sh asan musclewarp_unit_tests
ctest --preset asan -L unit -j2 -E '^phantom/'
# In one process, which makes its scene once. Whole random anatomies take
# minutes under the sanitizers; their parts have tests of their own.
LSAN_OPTIONS="suppressions=$PWD/.ci/leaks_of_libraries.txt" \
  build/asan/tests/phantom/phantom_test --gtest_brief=1 \
  --gtest_filter='-RandomScene.*:*RandomSceneOfSeed.*'
