#!/usr/bin/env bash
# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
#
# Makes the Debian packages musclewarp, musclewarp-cohort, libmusclewarp-dev and
# python3-musclewarp of the preset release.
#
# usage: scripts/deb.sh [FOLDER]    writes FOLDER/*.deb (out/deb)
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

out=${1:-out/deb}
# CPack calls both.
if ! command -v file >/dev/null || ! command -v dpkg-shlibdeps >/dev/null; then
  as_root=()
  ((EUID == 0)) || as_root=(sudo)
  "${as_root[@]}" apt-get -qq update
  "${as_root[@]}" apt-get -qq install -y --no-install-recommends file dpkg-dev \
    >/dev/null
fi
mkdir -p "$out"
scripts/build.sh packages musclewarp_programs musclewarp_python
# The changelog has the date of the commit; a source package has none.
SOURCE_DATE_EPOCH=$(git -c safe.directory='*' log -1 --format=%ct 2>/dev/null ||
  date +%s)
export SOURCE_DATE_EPOCH
rm -f "$out"/{musclewarp,musclewarp-cohort,libmusclewarp-dev,python3-musclewarp}_*.deb
umask 022
cpack --config build/release/CPackConfig.cmake -G DEB -B "$out" >build/deb.log 2>&1 || {
  tail -n 40 build/deb.log >&2
  exit 1
}
rm -rf "$out/_CPack_Packages"
ls "$out"/*.deb
