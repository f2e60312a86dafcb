#!/usr/bin/env bash
# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
#
# Runs README's two commands, ./demo.sh and ./test.sh, on the committed sources in
# a bare Debian, which debootstrap makes, and says how long they take and by how
# much the meshes of the demo differ from those that this machine makes. Needs
# root and half an hour; therefore no part of .ci/run.
#
# usage: .ci/check_debian.sh [RELEASE]    trixie (Debian 13) if none is named
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

release=${1:-trixie}
name="debian ($release)"
# shellcheck source=.ci/debian_root.sh
. .ci/debian_root.sh
make_debian "$release"

scripts/package.sh "$work" >/dev/null
mkdir "$root/source"
tar -x -C "$root/source" --strip-components=1 -f "$work"/musclewarp-*.tar.gz
if [[ -n ${CCACHE_DIR:-} ]]; then cp -r "$CCACHE_DIR" "$root/root/.ccache"; fi

began=$SECONDS
quietly inside /source/demo.sh --threads="$(nproc)"
echo "$name: ./demo.sh took $((SECONDS - began)) s, of which" \
  "$(sed -n 's/^build: done in/the build/p' "$log")"
# shellcheck disable=SC2016 # dpkg-query replaces these
inside dpkg-query -W -f='${Package} ${Version}\n' g++ cmake libceres-dev \
  libcgal-dev libeigen3-dev libopenmesh-dev libvtk9-dev | sed "s/^/$name: /"

scripts/build.sh programs musclewarp-deform >/dev/null
quietly build/release/tools/musclewarp-deform \
  --scene=data/phantom/motion.json --out="$work/here" --fibres=30
.ci/compare_runs.py "$work/here" "$root/source/out/demo"

began=$SECONDS
if ! inside /source/test.sh >"$log" 2>&1; then
  tail -n 60 "$log" >&2
  exit 1
fi
echo "$name: ./test.sh took $((SECONDS - began)) s:" \
  "$(grep 'tests passed' "$log")"
