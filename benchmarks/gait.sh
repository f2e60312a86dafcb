#!/usr/bin/env bash
# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
#
# Takes the thigh and the shank of BodyParts3D through a gait cycle of 100 frames,
# with certified contact, and writes the chapter of docs/performance.md about it and
# its plots (docs/performance/gait_*.svg). Needs python3-numpy of Debian.
#
# usage: benchmarks/gait.sh DATA [OUT] [options]
#
#   DATA             the folder with bodyparts3d and bodyparts3d_shank
#   OUT              where scenes, runs and figures are kept; without it they are
#                    removed
#   --only=NAME      thigh or shank; the page is written if OUT has the other one
#   --frames=A:B     these frames only; prints the table and writes no page
#   --programs=DIR   the programs; build/release/tools, built if need be
#   --page=FILE      another page; its plots are in the folder of its name
set -euo pipefail

usage() {
  sed -n '/^# usage/,/^set/{/^set/d;s/^# \{0,1\}//;p}' "$0" >&2
  exit 2
}

refuse() {
  echo "gait: $*" >&2
  exit 2
}

data='' out='' frames='' programs='' page='' names=(thigh shank)
for word in "$@"; do
  case $word in
    --only=thigh | --only=shank) names=("${word#*=}") ;;
    --frames=*) frames=${word#*=} ;;
    --programs=*) programs=$(realpath -m "${word#*=}") ;;
    --page=*) page=$(realpath -m "${word#*=}") ;;
    -*) usage ;;
    *) if [[ -z $data ]]; then data=$word; elif [[ -z $out ]]; then out=$word; else usage; fi ;;
  esac
done
[[ -n $data ]] || usage
for folder in bodyparts3d bodyparts3d_shank; do
  [[ -d $data/$folder ]] || refuse "$data has no folder $folder"
done
/usr/bin/python3 -c 'import numpy' 2>/dev/null ||
  refuse "/usr/bin/python3 has no numpy: apt-get install python3-numpy"
[[ -z $programs || -x $programs/musclewarp-deform ]] ||
  refuse "$programs has no musclewarp-deform"
data=$(realpath "$data")
if [[ -n $out ]]; then
  mkdir -p "$out"
  out=$(realpath "$out")
else
  out=$(mktemp -d)
  trap 'rm -rf "$out"' EXIT
fi
cd "$(dirname "${BASH_SOURCE[0]}")/.."
if [[ -z $programs ]]; then
  programs=build/release/tools
  [[ -x $programs/musclewarp-deform ]] || scripts/build.sh release
fi
[[ -n $page ]] || page=docs/performance.md

# NAME FIGURES FLAG...: a measured run of the scene of this name. Frames that are not
# usable (exit code 1) are for the table to tell.
deform() {
  local name=$1 figures=$2 code=0
  shift 2
  /usr/bin/python3 -B benchmarks/gait/measured.py "$out/$name/$figures.json" \
    "$programs/musclewarp-deform" --scene="$out/$name/scene.json" --data_root="$data" \
    --cache="$out/$name/cache" --bones=once "$@" >"$out/$name/log" 2>&1 || code=$?
  if ((code > 1)); then
    tail -n 20 "$out/$name/log" >&2
    echo "gait: musclewarp-deform failed with exit code $code" >&2
    exit 1
  fi
}

for name in "${names[@]}"; do
  rm -rf "${out:?}/$name"
  mkdir "$out/$name"
  /usr/bin/python3 -B benchmarks/gait/gait_scene.py "$data" "$name" "$out/$name/scene.json"
  deform "$name" preparation --frames=0:0 --out="$out/$name/first"
  mv "$out/$name/first/report.json" "$out/$name/prepared.json"
  rm -rf "$out/$name/first"
  echo "gait: $name prepared after $SECONDS s"
  deform "$name" motion --frames="${frames:-all}" --out="$out/$name/run"
  echo "gait: $name done after $SECONDS s"
done

if [[ -z $frames && -e $out/thigh/motion.json && -e $out/shank/motion.json ]]; then
  /usr/bin/python3 -B benchmarks/gait/gait_page.py "$out" "$page"
  echo "gait: wrote $page after $SECONDS s"
else
  /usr/bin/python3 -B benchmarks/gait/gait_page.py "$out"
  echo "gait: no page, which needs all frames of thigh and shank in OUT"
fi
