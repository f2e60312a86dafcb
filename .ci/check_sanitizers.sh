#!/usr/bin/env bash
# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
#
# Builds the unit tests with the address and undefined behaviour sanitizers, in
# build/asan, and runs them; the preset asan says how. Whole random anatomies
# would take minutes; their parts have tests of their own.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

if ! command -v clang++-14 >/dev/null; then
  echo "sanitizers: left out: clang++-14 is not here"
  exit 0
fi
scripts/build.sh asan musclewarp_unit_tests
export OMP_WAIT_POLICY=${OMP_WAIT_POLICY:-passive}
GTEST_FILTER='-RandomScene.*:*RandomSceneOfSeed.*' \
  ctest --preset asan -L unit -j2
