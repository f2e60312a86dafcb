#!/usr/bin/env bash
# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
#
# Fails when a tracked C++ file is not as clang-format 14 would write it;
# with --fix writes it so.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

mode=(--dry-run -Werror)
if [[ ${1:-} == --fix ]]; then mode=(-i); fi

# A checkout made by another user is read all the same.
mapfile -t files < <(git -c safe.directory='*' ls-files '*.h' '*.cc')
if ((${#files[@]} == 0)); then
  echo "format: git lists no C++ files here" >&2
  exit 1
fi
if ! clang-format-14 "${mode[@]}" "${files[@]}"; then
  echo "format: to mend this, run .ci/check_format.sh --fix and commit" >&2
  exit 1
fi
echo "format: ${#files[@]} files, all well"
