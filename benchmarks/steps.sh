#!/usr/bin/env bash
# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
#
# Records steps of certified contact, an easy one, a hard one and one of the
# rest pose of each scene, and takes them again to see where their time goes.
# The first run keeps its figures as a baseline; later ones take the same steps,
# say whether they end where they did, and compare their times with it. Takes
# half an hour on two cores at first, then some minutes.
#
# usage: benchmarks/steps.sh DATA OUT [--only=NAME[,NAME]] [--programs=DIR] [--anew]
#
#   DATA             the folder with lhdl_hip, bodyparts3d, bodyparts3d_shank, ...
#   OUT              where steps, preparations and figures are kept
#   --only=NAME      scenes: embedded lhdl hip thigh shank shoulder random
#   --programs=DIR   a build folder; build/release, built if need be
#   --anew           record the steps again, and make a new baseline
set -euo pipefail

usage() {
  sed -n '/^# usage/,/^set/{/^set/d;s/^# \{0,1\}//;p}' "$0" >&2
  exit 2
}

data='' out='' anew='' build='' only=(embedded lhdl hip thigh shank shoulder random)
for word in "$@"; do
  case $word in
    --only=*) IFS=, read -ra only <<<"${word#*=}" ;;
    --programs=*) build=$(realpath -e "${word#*=}") ;;
    --anew) anew=yes ;;
    -*) usage ;;
    *) if [[ -z $data ]]; then data=$(realpath -e "$word"); elif [[ -z $out ]]; then out=$word; else usage; fi ;;
  esac
done
[[ -n $data && -n $out ]] || usage
mkdir -p "$out"
out=$(realpath -e "$out")
root=$(dirname "$(dirname "$(realpath "$0")")")
if [[ -z $build ]]; then
  build=$root/build/release
  cmake -S "$root" --preset release -DMUSCLEWARP_BUILD_BENCHMARKS=ON >/dev/null
  cmake --build "$build" --target musclewarp-deform musclewarp-phantom step_benchmark >/dev/null
fi

# Prints the scene file and the frames of a scene.
scene_of() {
  local scenes=$root/data/scenes
  case $1 in
    embedded)
      "$build/tools/musclewarp-phantom" --scene=hip --out="$out/embedded_scene" >/dev/null
      echo "$out/embedded_scene/scene.json" 0:1 ;;
    random)
      "$build/tools/musclewarp-phantom" --scene=random --seed=3 --num_muscles=16 \
        --out="$out/random_scene" >/dev/null
      echo "$out/random_scene/scene.json" 0:1 ;;
    lhdl) echo "$scenes/lhdl_hip_motion.json" 0:12 ;;
    hip) echo "$scenes/bodyparts3d_hip.json" 1 ;;
    thigh) echo "$scenes/bodyparts3d_thigh.json" 1 ;;
    shank) echo "$data/bodyparts3d_shank/scene_uniform.json" 1 ;;
    shoulder) echo "$data/bodyparts3d_shoulder/scene_uniform.json" 1 ;;
    *) usage ;;
  esac
}

# Keeps of the recorded steps of a scene the quickest and the slowest of those
# of frames, and the last one of the rest pose.
keep_three() {
  local folder=$1
  "$build/benchmarks/step_benchmark" --flagfile="$folder/flags" --repeats=1 \
    --json="$folder/all.json" "$folder"/frame_*.step >/dev/null 2>&1 || true
  python3 - "$folder" <<'PYTHON'
import json
import pathlib
import sys

folder = pathlib.Path(sys.argv[1])
steps = json.loads((folder / "all.json").read_text())["steps"]
steps.sort(key=lambda step: step["times"][0]["processor_ms"])
rest = sorted(folder.glob("rest_*.step"))
kept = {pathlib.Path(steps[i]["step"]).name + ".step" for i in (0, -1)}
kept |= {path.name for path in rest[-1:]}
for path in folder.glob("*.step"):
    if path.name not in kept:
        path.unlink()
PYTHON
}

worst=0
for name in "${only[@]}"; do
  folder=$out/$name
  [[ -z $anew ]] || rm -rf "$folder"
  if [[ ! -e $folder/baseline.json ]]; then
    read -r scene frames <<<"$(scene_of "$name")"
    data_root=("--data_root=$data")
    [[ $scene != "$out"/* ]] || data_root=()
    # Exit code 1 says that a frame is not usable: its steps are steps all the same.
    "$build/tools/musclewarp-deform" --scene="$scene" "${data_root[@]}" --frames="$frames" \
      --record_steps="$folder" --out="$out/runs/$name" >"$out/$name.log" 2>&1 ||
      [[ $? == 1 ]] || { cat "$out/$name.log" >&2; exit 2; }
    keep_three "$folder"
    figures=baseline.json baseline=()
  else
    figures=latest.json baseline=("--baseline=$folder/baseline.json")
  fi
  code=0
  "$build/benchmarks/step_benchmark" --flagfile="$folder/flags" "${baseline[@]}" \
    --json="$folder/$figures" "$folder"/*.step 2>"$out/$name.err" || code=$?
  if ((code > 1)); then
    cat "$out/$name.err" >&2
    exit "$code"
  fi
  ((code <= worst)) || worst=$code
done
exit "$worst"
