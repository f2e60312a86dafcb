#!/usr/bin/env bash
# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
#
# Uses the committed sources in a bare Debian of another release, which
# debootstrap makes: runs ./demo.sh, builds and runs the unit tests, and says by
# how much the meshes of the demo differ from those that this machine makes.
# Needs root and half an hour; therefore no part of .ci/run.
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
quietly inside /source/scripts/setup.sh build
echo "$name: packages installed after $((SECONDS - began)) s"
began=$SECONDS
quietly inside /source/demo.sh --threads="$(nproc)"
echo "$name: ./demo.sh took $((SECONDS - began)) s once they were"
# shellcheck disable=SC2016 # dpkg-query replaces these
inside dpkg-query -W -f='${Package} ${Version}\n' g++ cmake libceres-dev \
  libcgal-dev libeigen3-dev libopenmesh-dev libvtk9-dev | sed "s/^/$name: /"

scripts/build.sh programs musclewarp-deform >/dev/null
quietly build/release/tools/musclewarp-deform \
  --scene=data/phantom/motion.json --out="$work/here" --fibres=30
.ci/compare_runs.py "$work/here" "$root/source/out/demo"

began=$SECONDS
quietly inside /source/scripts/setup.sh test
quietly inside /source/scripts/build.sh release musclewarp_unit_tests
echo "$name: the tests were built after $((SECONDS - began)) s"
inside sh -c 'cd /source && OMP_WAIT_POLICY=passive ctest --preset release -L unit -j2' |
  tail -n 30
echo "$name: $SECONDS s in all"
