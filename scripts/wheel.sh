#!/usr/bin/env bash
# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
#
# Makes a wheel of the preset release that carries its shared libraries, and so
# runs on other systems than Debian 12. "pip install ." makes one that does not.
#
# usage: scripts/wheel.sh [FOLDER]    writes FOLDER/musclewarp-*.whl (out/wheel)
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

out=${1:-out/wheel}
if ! command -v patchelf >/dev/null; then
  as_root=()
  ((EUID == 0)) || as_root=(sudo)
  "${as_root[@]}" apt-get -qq update
  "${as_root[@]}" apt-get -qq install -y --no-install-recommends patchelf >/dev/null
fi
scripts/build.sh packages musclewarp_programs musclewarp_python
# The entries have the date of the commit; a source package has none.
SOURCE_DATE_EPOCH=$(git -c safe.directory='*' log -1 --format=%ct 2>/dev/null ||
  date +%s)
export SOURCE_DATE_EPOCH

rm -f "$out"/musclewarp-*.whl
umask 022
# The Python of the system, as the module is built for it.
PYTHONDONTWRITEBYTECODE=1 /usr/bin/python3 python/backend/portable_wheel.py \
  build/release "$out" >build/wheel.log 2>&1 || {
  tail -n 40 build/wheel.log >&2
  exit 1
}
ls "$out"/*.whl
