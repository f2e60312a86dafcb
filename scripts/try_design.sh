#!/usr/bin/env bash
# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
#
# Tries a design of postures that musclewarp-cohort divides: a phantom with three
# coordinates of the hip, in PARTS jobs of which some are killed, then the engine,
# and once more in OTHER_PARTS jobs undisturbed. Frames and functions have to be the
# same. Needs Snakemake. Takes about half an hour on two cores; no part of .ci/run.
#
# usage: scripts/try_design.sh [BIN] [FOLDER]
#   BIN     the programs [build/release/tools]
#   FOLDER  to work in, which is kept [a temporary one, which is not]
# POSTURES=4000 PARTS=40 OTHER_PARTS=7 CORES=2 KILLS=5: other numbers
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

bin=$(realpath "${1:-build/release/tools}")
postures=${POSTURES:-4000} parts=${PARTS:-40} other_parts=${OTHER_PARTS:-7}
cores=${CORES:-2} kills=${KILLS:-5}
export OMP_WAIT_POLICY=passive PYTHONDONTWRITEBYTECODE=1
if [[ -n ${2:-} ]]; then
  work=$(realpath -m "$2")
else
  work=$(mktemp -d)
  trap 'rm -rf "$work"' EXIT
fi

fail() {
  echo "try_design: $*" >&2
  exit 1
}

# Makes $work/$1 with a table of one run in $2 parts.
subject() {
  local in=$work/$1
  rm -rf "$in" "$in.out"
  "$bin/musclewarp-phantom" --out="$in" --scene=hip --seed=1 >/dev/null
  python3 - "$in" "$postures" <<'PYTHON'
import json, sys
folder, postures = sys.argv[1:]
with open(f"{folder}/motion.json") as file:
    scene = json.load(file)
scene["muscles"] = [muscle for muscle in scene["muscles"]
                    if muscle["name"] == "gluteus_minimus_r"]
scene["motion"] = {"design": "latin_hypercube", "postures": int(postures),
                   "coordinates": {"hip_flexion_r": [-10, 50],
                                   "hip_adduction_r": [-20, 20],
                                   "hip_rotation_r": [-15, 15]}}
with open(f"{folder}/design.json", "w") as file:
    json.dump(scene, file, indent=2)
PYTHON
  printf 'participant_id\tscene\tmodel\tmotion\tside\tflags\tparts\n' \
    >"$in/subjects.tsv"
  printf 'sub-01\tdesign.json\tn/a\tn/a\tn/a\t--nohtml --bones=once\t%s\n' "$2" \
    >>"$in/subjects.tsv"
}

cohort() {
  cohort/musclewarp-cohort "$work/$1" "$work/$1.out" group --cores "$cores" \
    --deform "$bin/musclewarp-deform"
}

# A line for each frame: its number and a hash of its files but for bones, which
# are written once for each part.
frames() {
  find "$work/$1.out/sub-01/scene" -path '*/frame_*' -type f \
    \( -name 'gluteus*' -o -name lines.json \) -exec sha256sum {} + |
    sed 's,  .*/\(frame_[0-9]*/.*\)$, \1,' | sort
}

subject disturbed "$parts"
echo "try_design: $postures postures in $parts parts, $kills of which are killed"
setsid cohort/musclewarp-cohort "$work/disturbed" "$work/disturbed.out" group \
  --cores "$cores" --deform "$bin/musclewarp-deform" >"$work/killed.log" 2>&1 &
command=$!
killed=0
while ((killed < kills)) && kill -0 "$command" 2>/dev/null; do
  sleep $((4 + RANDOM % 8))
  victim=$(pgrep -f -- "^$bin/musclewarp-deform .*--out=$work/disturbed.out/" |
    shuf -n 1) || true
  [[ -z $victim ]] || { kill -9 "$victim" && killed=$((killed + 1)); } || true
done
engine=$(pgrep -P "$command" || true)
# shellcheck disable=SC2086 # one word per process
kill -9 "$command" $engine 2>/dev/null || true
wait "$command" 2>/dev/null || true
echo "try_design: killed $killed jobs and the engine;" \
  "$(find "$work/disturbed.out" -name 'frame_*' | wc -l) frames are there"
time cohort disturbed | tail -n 3

subject undisturbed "$other_parts"
echo "try_design: the same in $other_parts parts, undisturbed"
time cohort undisturbed | tail -n 3

frames disturbed >"$work/disturbed.frames"
frames undisturbed >"$work/undisturbed.frames"
cmp "$work/disturbed.frames" "$work/undisturbed.frames" || fail "frames differ"
(($(wc -l <"$work/disturbed.frames") == 2 * postures)) || fail "frames are missing"
python3 - "$work"/{,un}disturbed.out/sub-01/scene/fit.json <<'PYTHON' || fail "functions differ"
import json, sys
one, other = ({path: function["coefficients_mm"] for path, function in
               json.load(open(file))["muscles"].items()} for file in sys.argv[1:])
sys.exit(one != other)
PYTHON
echo "try_design: all well: $postures frames and their functions are the same"
