#!/usr/bin/env bash
# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
#
# Makes the pictures of docs/pictures that show thigh, shank and shoulder at
# rest and in their farthest pose, as they come (what crosses in red) and with
# certified contact. Takes a quarter of an hour on two cores. Needs what
# scripts/pictures.sh needs.
#
# usage: scripts/pictures_anatomies.sh DATA [PROGRAMS]
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

data=${1:?usage: scripts/pictures_anatomies.sh DATA [PROGRAMS]}
bin=${2:-build/release/tools}
out=out/pictures
MUSCLEWARP_CHROMIUM=$(command -v chromium || command -v google-chrome)
export MUSCLEWARP_CHROMIUM
mkdir -p docs/pictures

# NAME SCENE FRAME VIEW: the frame is that of the farthest pose.
picture() {
  local name=$1 scene=$2 frame=$3 view=$4
  for contact in none certified; do
    "$bin/musclewarp-deform" --scene="$scene" --data_root="$data" \
      --contact=$contact --out="$out/${name}_$contact"
  done
  "$bin/musclewarp-report" --in="$out/${name}_none" \
    --compare="$out/${name}_certified" --out="$out/$name.html"
  for at in 0 "$frame"; do
    node scripts/pictures.mjs contact "$out/$name.html" \
      "docs/pictures/${name}_$at.png" "$out/${name}_none" \
      "$out/${name}_certified" "$at" "$view"
  done
}

picture thigh data/scenes/bodyparts3d_thigh.json 2 lateral
picture shank "$data/bodyparts3d_shank/scene_uniform.json" 5 lateral
picture shoulder "$data/bodyparts3d_shoulder/scene_uniform.json" 2 posterior
