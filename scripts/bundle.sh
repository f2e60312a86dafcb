#!/usr/bin/env bash
# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
#
# Packs the programs of the preset release with the shared libraries that they
# need, so that they run from any folder of systems other than Debian 12.
#
# usage: scripts/bundle.sh [FOLDER]
#        writes FOLDER/musclewarp-VERSION-linux-x86_64.tar.xz (out/bundle)
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

out=${1:-out/bundle}
if ! command -v patchelf >/dev/null || ! command -v xz >/dev/null; then
  as_root=()
  ((EUID == 0)) || as_root=(sudo)
  "${as_root[@]}" apt-get -qq update
  "${as_root[@]}" apt-get -qq install -y --no-install-recommends patchelf \
    xz-utils >/dev/null
fi
scripts/build.sh packages musclewarp_programs musclewarp_python
# The entries have the date of the commit; a source package has none.
SOURCE_DATE_EPOCH=$(git -c safe.directory='*' log -1 --format=%ct 2>/dev/null ||
  date +%s)
version=$(sed -n 's/^project(musclewarp VERSION \([0-9.]*\).*/\1/p' CMakeLists.txt)
name=musclewarp-$version-linux-$(uname -m)

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
umask 022
stage=$work/$name
log=build/bundle.log
: >"$log"
quietly() {
  if ! "$@" >>"$log" 2>&1; then
    echo "bundle: this failed: $*" >&2
    tail -n 40 "$log" >&2
    exit 1
  fi
}
for component in programs cohort; do
  quietly cmake --install build/release --strip --prefix "$stage" \
    --component "$component"
done
quietly cmake -DSTAGE="$stage" -DLIBRARIES=lib -DLICENCES=licences \
  -P packaging/bundle_libraries.cmake
mkdir -p "$stage/data"
cp -r data/phantom "$stage/data"
cp LICENSE CHANGELOG.md "$stage"
sed "s/@VERSION@/$version/" packaging/bundle_readme.txt >"$stage/README"

mkdir -p "$out"
# Blocks of a size of their own, so that they do not depend on the processor.
tar --create --directory="$work" --sort=name --format=gnu --owner=0 --group=0 \
  --numeric-owner --mode=u+rw,go+r,go-w --mtime="@$SOURCE_DATE_EPOCH" "$name" |
  xz --threads=2 --block-size=32MiB >"$work/packed"
mv "$work/packed" "$out/$name.tar.xz"
ls "$out/$name.tar.xz"
