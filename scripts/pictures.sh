#!/usr/bin/env bash
# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
#
# Makes all pictures of docs/pictures from the LHDL data set: hip flexion
# without contact and with certified contact. Needs the programs, by default
# those in build/release/tools, the modules that their build installs into
# tools/report, Chromium, and img2webp (Debian: webp).
#
# usage: scripts/pictures.sh DATA [PROGRAMS]
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

data=${1:?usage: scripts/pictures.sh DATA [PROGRAMS]}
bin=${2:-build/release/tools}
out=out/pictures
MUSCLEWARP_CHROMIUM=$(command -v chromium || command -v google-chrome)
export MUSCLEWARP_CHROMIUM

for contact in none certified; do
  "$bin/musclewarp-deform" --scene=data/scenes/lhdl_hip_motion.json \
    --data_root="$data" --contact=$contact --fibres=100 \
    --out="$out/flexion_$contact"
done
"$bin/musclewarp-report" --in="$out/flexion_none" \
  --compare="$out/flexion_certified" --out="$out/both.html"
"$bin/musclewarp-report" --in="$out/flexion_certified" --out="$out/flexion.html"

mkdir -p docs/pictures
node scripts/pictures.mjs contact "$out/both.html" docs/pictures/contact.png \
  "$out/flexion_none" "$out/flexion_certified"
node scripts/pictures.mjs page "$out/both.html" docs/pictures/report.png
node scripts/pictures.mjs frames "$out/flexion.html" "$out/frames"
# The film has 15 frames a second and rests at the end.
frames=("$out"/frames/*.png)
img2webp -loop 0 -lossy -q 75 -m 6 -d 66 "${frames[@]::${#frames[@]}-1}" \
  -d 1000 "${frames[-1]}" -o docs/pictures/flexion.webp
