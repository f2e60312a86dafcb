#!/usr/bin/env bash
# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
#
# Studies of convergence on public data (musclewarp-compare --convergence): the
# LHDL hip flexed by 60 degrees and adducted by -30 and 30 degrees, and the hip
# and the thigh of BodyParts3D in their poses. Each is a folder of OUT; those
# that are there already are not made again. scripts/convergence_page.py makes
# tables and plots of them.
#
# Without contact this takes minutes, with certified contact an hour or more, as
# motions are solved from their start with every discretisation; hulls have at
# most 1200 vertices there.
#
# usage: scripts/convergence.sh DATA OUT [none|certified|all] [PROGRAMS]
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

usage='usage: scripts/convergence.sh DATA OUT [none|certified|all] [PROGRAMS]'
data=${1:?$usage}
out=${2:?$usage}
contacts=${3:-all}
bin=${4:-build/release/tools}
if [[ $contacts == all ]]; then contacts='none certified'; fi

# study NAME CONTACT SCENE [flags]: runs one study, unless it is there.
study() {
  local folder="$out/$1_$2" contact=$2 scene=$3
  shift 3
  if [[ -e $folder/convergence.json ]]; then return; fi
  if [[ $contact == certified ]]; then
    set -- "$@" --convergence_vertices=100,200,300,600,1200 \
      --convergence_spacing=5,10,20
  fi
  echo "== $folder"
  "$bin/musclewarp-compare" --convergence --scene="data/scenes/$scene.json" \
    --data_root="$data" --contact="$contact" \
    --out="$folder" "$@"
}

for contact in $contacts; do
  study lhdl_flexion "$contact" lhdl_hip_motion \
    --motion=lhdl_hip/motions/hip_flexion.mot --frames=last
  study lhdl_adduction "$contact" lhdl_hip_motion \
    --motion=lhdl_hip/motions/hip_adduction.mot --frames=5:35:30
  study bodyparts3d_hip "$contact" bodyparts3d_hip --frames=1:4
  study bodyparts3d_thigh "$contact" bodyparts3d_thigh --frames=1:4
done
