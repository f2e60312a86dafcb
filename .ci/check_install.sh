#!/usr/bin/env bash
# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
#
# Installs a build into a staging folder, then configures, builds and runs
# tests/install against it, as a project of somebody else would.
#
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

work=$PWD/build/install-check
rm -rf "$work"
mkdir -p "$work"

run() {
  if ! "$@" >>"$work/log" 2>&1; then
    echo "install: this failed: $*" >&2
    tail -n 60 "$work/log" >&2
    exit 1
  fi
}

# README shows the lines of the example, as they are.
example=$(sed -n '/^#include <musclewarp/,$p' tests/install/main.cc)
shown=$(sed -n '/^    #include <musclewarp/,/^    }$/p' README.md)
shown+=$'\n'$(sed -n '/^    int main() {/,/^    }$/p' README.md)
while IFS= read -r line; do
  [[ -z $line ]] || grep -qxF -- "    $line" <<<"$shown" || {
    echo "install: README.md does not show this line of tests/install/main.cc:" >&2
    echo "$line" >&2
    exit 1
  }
done <<<"$example"

# Both presets of the release build share one folder.
run cmake --install build/release --prefix "$work/stage"
run cmake -S tests/install -B "$work/build" -G Ninja \
  -DCMAKE_BUILD_TYPE=Release -DCMAKE_PREFIX_PATH="$work/stage"
run cmake --build "$work/build"
"$work/build/consumer"
"$work/build/joints"
for program in "$work"/stage/bin/musclewarp-*; do
  [[ -x $program ]] || continue
  "$program" --version >/dev/null || {
    echo "install: $program --version failed" >&2
    exit 1
  }
done
echo "install: find_package(musclewarp) works from a staged install"
