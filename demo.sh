#!/usr/bin/env bash
# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
#
# From a bare checkout to deformed muscles: installs what is missing, builds
# musclewarp-deform and runs the scene that comes with the sources.
#
# usage: ./demo.sh [more flags for musclewarp-deform]
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")"

bin=build/release/tools
out=out/demo

echo "demo: 1 of 3: packages that are missing (one to three minutes the first time)"
scripts/setup.sh build
echo "demo: 2 of 3: the build (six minutes on two cores the first time, seconds later)"
scripts/build.sh programs musclewarp-deform

formats=ply,vtp
# There is no .vtp without VTK.
if grep -q '^MUSCLEWARP_WITH_VTK:BOOL=OFF$' build/release/CMakeCache.txt; then
  formats=ply
fi
flags=(--scene=data/phantom/motion.json --out="$out" --format="$formats"
  --fibres=30 --html)
echo "demo: 3 of 3: 15 frames of a hip flexion (some seconds)"
echo "demo: $bin/musclewarp-deform ${flags[*]}"
status=0
"$bin/musclewarp-deform" "${flags[@]}" "$@" || status=$?
if ((status > 1)); then exit "$status"; fi

echo
echo "To look at it, open $PWD/$out/report.html in a browser."
echo "The meshes of every frame are in $PWD/$out/frame_*/;"
echo "lengths and moment arms in $PWD/$out/*.sto, all figures in report.json."
if [[ -f $out/motion.pvd ]]; then
  echo "ParaView plays $PWD/$out/motion.pvd."
fi
exit "$status"
