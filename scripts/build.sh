#!/usr/bin/env bash
# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
#
# Configures a preset of CMakePresets.json and builds it. The output goes to
# build/<preset>.log, of which the end is shown if something fails; on the screen
# stands how far the build is.
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

# Says every ten seconds which share of its steps Ninja has done, from the
# "[12/345]" in the log, until it is stopped.
say_progress() {
  local said="" now
  # What reads our output would wait for a sleep that holds it open.
  while sleep 10 >/dev/null 2>&1; do
    now=$(tail -c 4000 "$log" | tr '\r' '\n' |
      sed -n 's/^\[\([0-9]*\)\/\([0-9]*\)\].*/\1 \2/p' |
      awk '{share = int(100 * $1 / $2)} END {print share}')
    [[ -z $now || $now == "$said" ]] && continue
    echo "build: $now % after $((SECONDS - started)) s"
    said=$now
  done
}

started=$SECONDS
echo "build: preset $preset (log: $log)"
quietly cmake --preset "$preset"
say_progress &
progress=$!
trap 'kill "$progress" 2>/dev/null' EXIT
# As many as there are processors: Ninja's own choice, two more, costs more
# processor time and saves none.
quietly cmake --build --preset "$preset" --parallel "$(nproc)" ${1:+--target "$@"}
echo "build: done in $((SECONDS - started)) s"
