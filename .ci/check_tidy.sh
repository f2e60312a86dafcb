#!/usr/bin/env bash
# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
#
# Runs clang-tidy 14 with the checks of .clang-tidy over the C++ files that
# changed since BASE, committed or not; over the source beside it for a header.
#
# usage: .ci/check_tidy.sh [BASE | --all]
#   BASE   a commit; by default where this branch left main, and on main itself
#          that of twenty commits ago, or none if there are fewer: all is new
#   --all  checks all C++ files, which takes a quarter of an hour on two cores
#
# Configures build/tidy, for a compile_commands.json that lists every file: that
# of build/release lists what is compiled together. Without --all no more than
# MUSCLEWARP_TIDY_FILES files are checked (30 by default), those that changed
# last, so that the time is bounded.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

if ! command -v clang-tidy-14 >/dev/null; then
  echo "tidy: left out: clang-tidy-14 is not here"
  exit 0
fi

build=build/tidy
max_files=${MUSCLEWARP_TIDY_FILES:-30}
base=${1:-}
if (($# > 1)) || [[ $base == -* && $base != --all ]]; then
  sed -n '/^# usage/,/^# last/s/^# \{0,1\}//p' "${BASH_SOURCE[0]}" >&2
  exit 2
fi

# A checkout made by another user is read all the same.
git() { command git -c safe.directory='*' "$@"; }

# The commit to compare with when none is given; nothing if all is new.
default_base() {
  local main found
  for main in origin/main main; do
    if found=$(git merge-base "$main" HEAD 2>/dev/null) &&
      [[ $found != "$(git rev-parse HEAD)" ]]; then
      echo "$found"
      return
    fi
  done
  git rev-parse --quiet --verify HEAD~20 || true
}

# The C++ files that changed since $1, those that changed last first.
changed_files() {
  git diff --name-only HEAD
  git log --format= --name-only ${1:+"$1..HEAD"}
}

if [[ $base == --all ]]; then
  listed=$(git ls-files)
  max_files=1000000
else
  if [[ -z $base ]]; then
    base=$(default_base)
  elif ! git rev-parse --quiet --verify "$base^{commit}" >/dev/null; then
    echo "tidy: git knows no commit '$base'" >&2
    exit 2
  fi
  listed=$(changed_files "$base")
fi

# Benchmarks and the project that uses an installed library have other builds.
files=()
declare -A seen
while read -r file; do
  [[ $file =~ ^(src|problems|tools|tests|python)/.*\.(cc|h)$ ]] || continue
  [[ $file != tests/install/* ]] || continue
  if [[ $file == *.h && -f ${file%.h}.cc ]]; then file=${file%.h}.cc; fi
  # What includes a header without a source checks it.
  if [[ $file == *.h && $base == --all ]]; then continue; fi
  [[ -f $file && -z ${seen[$file]:-} ]] || continue
  seen[$file]=1
  files+=("$file")
done <<<"$listed"
if ((${#files[@]} == 0)); then
  echo "tidy: no C++ file changed since ${base:-the first commit}"
  exit 0
fi

mkdir -p build
if ! cmake --preset release -B "$build" -DMUSCLEWARP_UNITY_BUILD=OFF \
  >"$build.log" 2>&1; then
  tail -n 60 "$build.log" >&2
  echo "tidy: cmake cannot configure $build" >&2
  exit 2
fi

found=${#files[@]}
if ((found > max_files)); then files=("${files[@]:0:max_files}"); fi
# The flags are those of g++, and warnings of the compiler are not what is
# checked here. Clang counts on stderr what it does not show.
if ! printf '%s\0' "${files[@]}" |
  xargs -0 -n 4 -P "$(nproc)" clang-tidy-14 -p "$build" --quiet \
    --extra-arg=-Wno-error --extra-arg=-Wno-unknown-warning-option \
    2> >(grep -v 'warnings\? generated\.$' >&2); then
  echo "tidy: mend what is named above, or say NOLINT(check) there and why" >&2
  exit 1
fi
echo "tidy: ${#files[@]} of $found files checked, all well"
