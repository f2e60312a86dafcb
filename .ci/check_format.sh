#!/usr/bin/env bash
# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
#
# Fails when a tracked C++ file is not as clang-format 14 would write it, or a
# source of the report page or its tests not as prettier would (once the build
# has installed that); with --fix writes them so.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

mode=(--dry-run -Werror)
page_mode=(--check --log-level=warn)
if [[ ${1:-} == --fix ]]; then
  mode=(-i)
  page_mode=(--write --log-level=warn)
fi

# A checkout made by another user is read all the same.
mapfile -t files < <(git -c safe.directory='*' ls-files '*.h' '*.cc')
if ((${#files[@]} == 0)); then
  echo "format: git lists no C++ files here" >&2
  exit 1
fi
# Other versions of clang-format write other files.
if ! command -v clang-format-14 >/dev/null; then
  echo "format: C++ left out: clang-format-14 is not here"
  files=()
elif ! clang-format-14 "${mode[@]}" "${files[@]}"; then
  echo "format: to mend this, run .ci/check_format.sh --fix and commit" >&2
  exit 1
fi
prettier=tools/report/node_modules/.bin/prettier
if [[ -x $prettier ]]; then
  mapfile -t page_files < <(git -c safe.directory='*' ls-files \
    'tools/report/*.ts' 'tools/report/*.css' '*.mjs')
  if ! "$prettier" "${page_mode[@]}" "${page_files[@]}"; then
    echo "format: to mend this, run .ci/check_format.sh --fix and commit" >&2
    exit 1
  fi
  files+=("${page_files[@]}")
fi
echo "format: ${#files[@]} files, all well"
