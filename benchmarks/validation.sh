#!/usr/bin/env bash
# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
#
# Makes the runs that docs/validation.md reports, and writes that page and its
# plots (docs/validation/*.svg). Takes some minutes on two cores. Needs
# python3-numpy of Debian.
#
# usage: benchmarks/validation.sh DATA [OUT] [options]
#
#   DATA             the folder with lhdl_hip, bodyparts3d, bodyparts3d_shank,
#                    bodyparts3d_shoulder and literature
#   OUT              where the runs are kept; without it they are removed
#   --all            also the thigh of BodyParts3D, which takes minutes more
#   --pictures       also pictures of the ends of the motions, before and after;
#                    needs musclewarp-render
#   --reuse          keep the finished runs of OUT
#   --programs=DIR   the programs; build/release/tools, built if need be
#   --opensim=TABLE  compare straight moment arms with a table of OpenSim:
#                    a_MSK_model/c_MSK_results/LHDL_hip_flexion.mot of
#                    modenaxe/3d-muscles
#   --page=FILE      another page; its plots are in the folder of its name
set -euo pipefail

usage() {
  sed -n '/^# usage/,/^set/{/^set/d;s/^# \{0,1\}//;p}' "$0" >&2
  exit 2
}

data='' out='' all='' pictures='' reuse='' programs='' table='' page=()
for word in "$@"; do
  case $word in
    --all) all=yes ;;
    --pictures) pictures=yes ;;
    --reuse) reuse=yes ;;
    --programs=*) programs=$(realpath -e "${word#*=}") ;;
    --opensim=*) table=$(realpath -e "${word#*=}") ;;
    --page=*) page=("--page=$(realpath -m "${word#*=}")") ;;
    -*) usage ;;
    *) if [[ -z $data ]]; then data=$word; elif [[ -z $out ]]; then out=$word; else usage; fi ;;
  esac
done
[[ -n $data ]] || usage
for part in lhdl_hip bodyparts3d bodyparts3d_shank bodyparts3d_shoulder literature; do
  if [[ ! -d $data/$part ]]; then
    echo "validation: $data has no folder $part" >&2
    exit 2
  fi
done
if ! /usr/bin/python3 -c 'import numpy' 2>/dev/null; then
  echo "validation: /usr/bin/python3 has no numpy: apt-get install python3-numpy" >&2
  exit 2
fi
data=$(realpath "$data")
if [[ -n $out ]]; then
  mkdir -p "$out"
  out=$(realpath "$out")
else
  [[ -z $reuse ]] || usage
  out=$(mktemp -d)
  trap 'rm -rf "$out"' EXIT
fi
cd "$(dirname "${BASH_SOURCE[0]}")/.."
if [[ -z $programs ]]; then
  programs=build/release/tools
  [[ -x $programs/musclewarp-deform ]] || scripts/build.sh release
fi

if [[ -z $reuse ]]; then # what other options left is not for this page
  rm -rf "${out:?}/bodyparts3d_thigh" "$out/opensim.txt"
fi

# NAME SCENE FLAG...: a run in OUT/NAME. Frames that are not usable (exit code
# 1) are for the page to report.
deform() {
  local name=$1 scene=$2 code=0 started=$SECONDS
  shift 2
  local words=("--scene=$scene" "$@")
  # Scenes in OUT name their files themselves.
  [[ $scene == "$out"/* ]] || words+=("--data_root=$data")
  if [[ -n $reuse && -e $out/$name/command.txt ]] &&
    grep -q '"finished": *true' "$out/$name/report.json"; then
    echo "validation: $name is there"
    return
  fi
  rm -rf "${out:?}/$name"
  "$programs/musclewarp-deform" "${words[@]}" \
    --out="$out/$name" >"$out/$name.log" 2>&1 || code=$?
  if ((code > 1)); then
    tail -n 20 "$out/$name.log" >&2
    echo "validation: musclewarp-deform failed with exit code $code" >&2
    exit 1
  fi
  local command="musclewarp-deform ${words[*]} --out=$out/$name"
  command=${command//$out/OUT}
  echo "${command//$data/DATA}" >"$out/$name/command.txt"
  echo "validation: $name took $((SECONDS - started)) s"
}

hip=data/scenes/lhdl_hip_attached.json   # with published attachment areas
found=data/scenes/lhdl_hip_motion.json   # with areas found on the meshes
for motion in flexion adduction rotation; do
  deform hip_$motion $hip --motion=lhdl_hip/motions/hip_$motion.mot --fibres=100
done
deform hip_flexion_found $found \
  --motion=lhdl_hip/motions/hip_flexion.mot --fibres=100
if [[ -n $pictures ]]; then # as things were before, for the pictures
  for motion in flexion adduction rotation; do
    deform hip_${motion}_before $found --lines=fixed --bending_weight=0 \
      --motion=lhdl_hip/motions/hip_$motion.mot
  done
  page+=("--render=$programs/musclewarp-render")
fi
deform hip_postures data/scenes/lhdl_hip_postures.json --bones=once
# Exit code 1 is for functions beyond their bounds, which the page reports.
"$programs/musclewarp-export" --format=fit --in="$out/hip_postures" \
  --out="$out/hip_postures.fit.json" >"$out/hip_postures.fit.log" || (($? == 1))
deform bodyparts3d_hip data/scenes/bodyparts3d_hip.json
deform bodyparts3d_hamstrings data/scenes/bodyparts3d_hamstrings.json
[[ -z $all ]] || deform bodyparts3d_thigh data/scenes/bodyparts3d_thigh.json

# Lines that are made from the meshes, taut and guided, over joints that are
# found on the bones.
# articulate NAME MOTION FOLDER "SOFT PART..." BONE...: the scene in OUT/NAME_scene
# from meshes of a folder of DATA, of which each is FOLDER/PART.obj or a path in
# DATA or in the file system.
articulate() {
  local name=$1 motion=$2 folder=$3 part muscles=() bones=()
  for part in $4; do muscles+=("$(path_of "$folder" "$part")"); done
  shift 4
  for part in "$@"; do bones+=("$(path_of "$folder" "$part")"); done
  local words=("--muscles=$(IFS=,; echo "${muscles[*]}")" "--motion=$motion" --side=right
    "${bones[@]}")
  if [[ -z $reuse || ! -e $out/${name}_scene/scene.json ]]; then
    "$programs/musclewarp-articulate" --out="$out/${name}_scene" "${words[@]}" \
      >"$out/${name}_scene.log" 2>&1
  fi
  made "$name" "$out/${name}_scene/scene.json"
}
path_of() {
  case $2 in
    /*) echo "$2.obj" ;;
    */*) echo "$data/$2.obj" ;;
    *) echo "$data/$1/$2.obj" ;;
  esac
}
made() {
  deform "$1" "$2" --fibres=50
  deform "$1_guided" "$2" --fibres=50 --made_lines=guided
}
knee='semimembranosus semitendinosus biceps_femoris_long biceps_femoris_short gracilis'
thigh=(hip_bone femur bodyparts3d/tibia bodyparts3d/fibula)
articulate made_knee knee_angle_r:0:90:10 bodyparts3d/uniform "$knee" "${thigh[@]}"
articulate made_hamstrings hip_flexion_r:-10:100:12 bodyparts3d/uniform "$knee" "${thigh[@]}"
calf=(calcaneal_tendon extensor_digitorum_longus extensor_hallucis_longus fibularis_tertius
  flexor_hallucis_longus gastrocnemius_lateral gastrocnemius_medial plantaris popliteus soleus
  tibialis_anterior tibialis_posterior)
foot=()
for file in "$data"/bodyparts3d_shank/uniform/*.obj; do
  part=$(basename "$file" .obj)
  [[ " ${calf[*]} " == *" $part "* ]] || foot+=("$part")
done
articulate made_ankle ankle_angle_r:20:-30:11 bodyparts3d_shank/uniform "${calf[*]}" "${foot[@]}"
articulate made_gastrocnemii knee_angle_r:0:90:10 bodyparts3d_shank/uniform "${calf[*]}" "${foot[@]}"
# The same without tendons, as most segmentations are.
/usr/bin/python3 -B benchmarks/validation/bellies.py "$data" "$out/bellies"
bellies=()
for file in "$out"/bellies/*.obj; do bellies+=("${file%.obj}"); done
articulate made_bellies ankle_angle_r:20:-30:11 bodyparts3d_shank/uniform "${bellies[*]}" "${foot[@]}"
made made_hip data/scenes/lhdl_hip_made_lines.json
cuff='deltoid_clavicular deltoid_acromial deltoid_spinal supraspinatus infraspinatus subscapularis
  teres_major teres_minor'
articulate made_shoulder arm_add_r:0:-80:9 bodyparts3d_shoulder/uniform "$cuff" \
  scapula clavicle humerus
if [[ -n $table ]]; then
  scripts/compare_moment_arms.py motion "$table" hip_flexion_r "$out/opensim.mot"
  deform opensim $hip --motion="$out/opensim.mot" --contact=none
  scripts/compare_moment_arms.py compare "$table" hip_flexion_r \
    "$out/opensim/moment_arms.sto" >"$out/opensim.txt"
fi
/usr/bin/python3 -B benchmarks/validation/page.py "$data" "$out" "${page[@]}"
