#!/usr/bin/env bash
# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
#
# Makes the pictures of the README from the LHDL data set, with the programs in
# build/release. Needs Chromium, and img2webp (Debian: webp).
#
# usage: scripts/pictures.sh DATA
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

data=${1:?usage: scripts/pictures.sh DATA}
bin=build/release/tools
out=out/pictures
MUSCLEWARP_CHROMIUM=$(command -v chromium || command -v google-chrome)
export MUSCLEWARP_CHROMIUM

for contact in none paper; do
  "$bin/musclewarp-deform" --scene=data/scenes/lhdl_hip_motion.json \
    --data_root="$data" --contact=$contact --fibres=100 \
    --out="$out/flexion_$contact"
done
"$bin/musclewarp-report" --in="$out/flexion_none" \
  --compare="$out/flexion_paper" --out="$out/both.html"
"$bin/musclewarp-report" --in="$out/flexion_paper" --out="$out/flexion.html"

node scripts/pictures.mjs page "$out/both.html" docs/pictures/report.png
node scripts/pictures.mjs frames "$out/flexion.html" "$out/frames"
# At 15 frames a second, with a rest at the end.
frames=("$out"/frames/*.png)
img2webp -loop 0 -lossy -q 75 -m 6 -d 66 "${frames[@]::${#frames[@]}-1}" \
  -d 1000 "${frames[-1]}" -o docs/pictures/flexion.webp
