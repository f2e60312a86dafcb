#!/usr/bin/env bash
# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
#
# Builds the tests of the folders that compute on several threads with the thread
# sanitizer, in build/tsan, and runs them on four threads. What Ceres, VTK and
# CGAL do, which are built without it, is not looked at. The runtime of OpenMP
# has to tell the sanitizer where threads wait for each other: libarcher of
# LLVM, in Debian's libomp-14-dev.
#
# usage: scripts/thread_sanitizer.sh [ROOM...]
#   ROOM   a folder of src/musclewarp; by default all that have parallel loops
#
# Exit code: 0 no race was found, else 1.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

archer=/usr/lib/llvm-14/lib/libarcher.so
if [[ ! -e $archer ]] || ! command -v clang++-14 >/dev/null; then
  echo "thread_sanitizer: needs clang-14 and libomp-14-dev" >&2
  exit 1
fi
rooms=("$@")
if ((${#rooms[@]} == 0)); then
  mapfile -t rooms < <(grep -rlE 'pragma omp parallel|ParallelFor\(' \
    src/musclewarp --include='*.cc' | cut -d/ -f3 | sort -u)
fi
targets=()
for room in "${rooms[@]}"; do
  # A folder without tests of its own is tested by those that use it.
  [[ ! -e tests/$room/CMakeLists.txt ]] || targets+=("${room}_test")
done
scripts/build.sh tsan "${targets[@]}"

export OMP_NUM_THREADS=4 OMP_TOOL_LIBRARIES=$archer
export TSAN_OPTIONS="ignore_noninstrumented_modules=1 halt_on_error=1"
for target in "${targets[@]}"; do
  echo "== $target"
  (cd "build/tsan/tests/${target%_test}" && "./$target" --gtest_brief=1)
done
