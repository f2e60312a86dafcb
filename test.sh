#!/usr/bin/env bash
# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
#
# Installs what is missing, builds everything and runs the tests.
#
# usage: ./test.sh [arguments for ctest]    e.g. ./test.sh -R geometry/
#
# With CI set, warnings are errors. Tests on real data are skipped unless
# MUSCLEWARP_DATA_ROOT names the folder that holds the data sets.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")"

preset=release
if [[ -n ${CI:-} ]]; then preset=ci; fi

scripts/setup.sh test
scripts/build.sh "$preset"
# Two tests at a time share the processor, where waiting threads had better sleep.
export OMP_WAIT_POLICY=${OMP_WAIT_POLICY:-passive}
ctest --preset "$preset" --output-on-failure --no-tests=error -j2 "$@"
