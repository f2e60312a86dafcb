#!/usr/bin/env bash
# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
#
# Builds the image of packaging/Containerfile from the committed sources, and
# runs the demo in it. The images of Debian that it begins with are made by
# debootstrap, so that no registry is needed. Needs root and half an hour;
# therefore no part of .ci/run.
#
# usage: .ci/check_container.sh
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

name=container
# shellcheck source=.ci/debian_root.sh
. .ci/debian_root.sh
command -v buildah >/dev/null || {
  apt-get -qq update
  apt-get -qq install -y --no-install-recommends buildah >/dev/null
}
make_debian bookworm

# All of buildah's files go with the check.
buildah() {
  BUILDAH_ISOLATION=chroot command buildah --storage-driver vfs \
    --root "$work/images" --runroot "$work/run" "$@"
}

bare=$(buildah from scratch)
quietly buildah add --quiet "$bare" "$root" /
while read -r _ base _; do
  quietly buildah commit --quiet "$bare" "$base"
done < <(grep '^FROM' packaging/Containerfile)
quietly buildah rm "$bare"

scripts/package.sh "$work" >/dev/null
mkdir "$work/source"
tar -x -C "$work/source" --strip-components=1 -f "$work"/musclewarp-*.tar.gz
began=$SECONDS
cache=${CCACHE_DIR:-$HOME/.cache/ccache} # serves where the compiler is the same
mkdir -p "$cache"
quietly buildah build --pull-never -t musclewarp \
  -v "$cache:/root/.cache/ccache" \
  -f "$work/source/packaging/Containerfile" "$work/source"
echo "$name: built after $((SECONDS - began)) s"

mkdir "$work/data"
made=$(buildah from --pull-never musclewarp)
began=$SECONDS
quietly buildah run -v "$work/data:/data" "$made" -- \
  musclewarp-deform --demo --out=demo
grep -q '"finished": true' "$work/data/demo/report.json"
echo "$name: the demo took $((SECONDS - began)) s in it"
if buildah run "$made" -- sh -c 'command -v g++ cmake node'; then
  echo "$name: the image holds what only a build needs" >&2
  exit 1
fi
