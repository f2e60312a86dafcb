#!/bin/sh
# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
#
# Fuzzes the readers of files with libFuzzer (tests/fuzz), from the seeds in
# tests/fuzz/seeds/READER, and prints what was found:
#
#   scripts/fuzz.sh [SECONDS [READER...]]
#
# SECONDS: for each reader, 20 by default. Limits: 10 s and 2 GiB for a file of
# at most 64 KiB. What a reader fails on is kept as build/fuzz/found/READER-*.
# Exit code: 0 if nothing was found, else 1.
set -eu
cd "$(dirname "$0")/.."
seconds=${1:-20}
[ $# -gt 0 ] && shift
readers=${*:-$(sed -n '/^  READER$/,/)/p' tests/fuzz/CMakeLists.txt | sed '1d; s/[ )]//g')}
cmake --preset fuzz > build/fuzz_configure.log 2>&1 || {
  cat build/fuzz_configure.log
  exit 1
}
targets=
for reader in $readers; do targets="$targets fuzz_$reader"; done
# shellcheck disable=SC2086
cmake --build build/fuzz --target $targets
mkdir -p build/fuzz/found
failed=0
for reader in $readers; do
  corpus=build/fuzz/corpus/$reader
  mkdir -p "$corpus"
  if build/fuzz/tests/fuzz/fuzz_"$reader" -max_total_time="$seconds" -timeout=10 \
      -rss_limit_mb=2048 -max_len=65536 -close_fd_mask=1 \
      -artifact_prefix=build/fuzz/found/"$reader"- \
      "$corpus" tests/fuzz/seeds/"$reader" > build/fuzz/"$reader".log 2>&1; then
    echo "$reader: $(grep -c . build/fuzz/"$reader".log) lines, $(sed -n \
      's/.*Done \([0-9]*\) runs.*/\1/p' build/fuzz/"$reader".log) files, nothing found"
  else
    failed=1
    echo "$reader: FOUND something, see build/fuzz/$reader.log"
    grep -m3 -E "ERROR|SUMMARY|what\(\)" build/fuzz/"$reader".log || true
  fi
  rm -rf /dev/shm/musclewarp_fuzz_"$reader"_*
done
exit $failed
