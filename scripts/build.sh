#!/usr/bin/env bash
# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
#
# Configures a preset of CMakePresets.json and builds it, quietly: the output
# goes to build/<preset>.log, of which the end is shown if something fails.
#
# usage: scripts/build.sh PRESET [TARGET...]
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

preset=${1:?usage: scripts/build.sh PRESET [TARGET...]}
shift
log=build/$preset.log
mkdir -p build
: >"$log"

quietly() {
  if ! "$@" >>"$log" 2>&1; then
    echo "build: this failed: $*" >&2
    tail -n 60 "$log" >&2
    echo "build: the whole log is $PWD/$log" >&2
    exit 1
  fi
}

started=$SECONDS
echo "build: preset $preset (log: $log; the first build takes some minutes)"
quietly cmake --preset "$preset"
quietly cmake --build --preset "$preset" ${1:+--target "$@"}
echo "build: done in $((SECONDS - started)) s"
