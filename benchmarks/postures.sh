#!/usr/bin/env bash
# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
#
# Functions and models for MuJoCo over designs of 300 postures of the thigh (hip
# and knee, 15 muscles) and the shank (knee, ankle and subtalar joint, 12 muscles),
# with joints that are found on the bones and lines that are made: the figures of
# docs/export.md. Takes two hours on two cores; runs are gone on with.
#
# usage: benchmarks/postures.sh DATA OUT [PROGRAMS]
#   DATA      the folder with bodyparts3d and bodyparts3d_shank
#   PROGRAMS  [build/release/tools]
set -euo pipefail
data=$(realpath -e "$1")
mkdir -p "$2"
out=$(realpath "$2")
cd "$(dirname "${BASH_SOURCE[0]}")/.."
programs=$(realpath -e "${3:-build/release/tools}")

# design NAME COORDINATES "SOFT PART..." BONE...: paths are in DATA
design() {
  local name=$1 coordinates=$2 part muscles=() bones=()
  for part in $3; do muscles+=("$data/$part.obj"); done
  shift 3
  for part in "$@"; do bones+=("$data/$part.obj"); done
  if [[ ! -e $out/${name}_scene/postures.json ]]; then
    "$programs/musclewarp-articulate" --out="$out/${name}_scene" --side=right \
      --muscles="$(IFS=,; echo "${muscles[*]}")" "${bones[@]}"
    python3 - "$out/${name}_scene" "$coordinates" <<'PYTHON'
import json, sys
folder, coordinates = sys.argv[1:]
with open(f"{folder}/scene.json") as file:
    scene = json.load(file)
scene["motion"] = {"design": "latin_hypercube", "postures": 300,
                   "coordinates": json.loads(coordinates)}
with open(f"{folder}/postures.json", "w") as file:
    json.dump(scene, file, indent=1)
PYTHON
  fi
  # Exit code 1: postures that are not usable, or functions beyond their bounds.
  "$programs/musclewarp-deform" --scene="$out/${name}_scene/postures.json" \
    --bones=once --fibres=40 --resume --out="$out/$name" || (($? == 1))
  "$programs/musclewarp-export" --in="$out/$name" --format=fit \
    --out="$out/$name.fit.json" || (($? == 1))
  "$programs/musclewarp-export" --in="$out/$name" --format=mjcf \
    --out="$out/${name}_mujoco" || (($? == 1))
}

# parts FOLDER NAME...: paths in DATA
parts() {
  local folder=$1
  shift
  printf "$folder/%s " "$@"
}

design thigh '{"hip_flexion_r": [-10, 60], "hip_adduction_r": [-20, 15],
  "hip_rotation_r": [-20, 20], "knee_angle_r": [0, 90]}' \
  "$(parts bodyparts3d/uniform adductor_brevis adductor_magnus biceps_femoris_long \
    biceps_femoris_short gluteus_maximus gluteus_medius gluteus_minimus gracilis iliacus \
    pectineus piriformis psoas_major semimembranosus semitendinosus tensor_fasciae_latae)" \
  bodyparts3d/uniform/hip_bone bodyparts3d/uniform/femur bodyparts3d/tibia bodyparts3d/fibula

calf=(calcaneal_tendon extensor_digitorum_longus extensor_hallucis_longus fibularis_tertius
  flexor_hallucis_longus gastrocnemius_lateral gastrocnemius_medial plantaris popliteus soleus
  tibialis_anterior tibialis_posterior)
foot=()
for file in "$data"/bodyparts3d_shank/uniform/*.obj; do
  part=$(basename "$file" .obj)
  [[ " ${calf[*]} " == *" $part "* ]] || foot+=("bodyparts3d_shank/uniform/$part")
done
design shank '{"knee_angle_r": [0, 90], "ankle_angle_r": [-30, 15],
  "subtalar_angle_r": [-15, 15]}' "$(parts bodyparts3d_shank/uniform "${calf[@]}")" "${foot[@]}"
