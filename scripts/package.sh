#!/usr/bin/env bash
# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
#
# Packs the committed sources together with the report pages, so that they can
# be built where there is no Node.js.
#
# usage: scripts/package.sh [FOLDER]    writes FOLDER/musclewarp-VERSION.tar.gz
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

out=${1:-out}
mkdir -p "$out" build
version=$(sed -n 's/^project(musclewarp VERSION \([0-9.]*\).*/\1/p' CMakeLists.txt)
name=musclewarp-$version

# From the sources that are packed, not those that lie here.
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
git -c safe.directory='*' archive HEAD tools/report | tar -x -C "$work"
(cd "$work/tools/report" && npm ci --ignore-scripts --no-progress >/dev/null)
node "$work/tools/report/build.mjs" run "$work/page.html"
node "$work/tools/report/build.mjs" joints "$work/joints.html"

git -c safe.directory='*' archive --format=tar.gz \
  --prefix="$name/tools/report/packaged/" --add-file="$work/page.html" \
  --add-file="$work/joints.html" \
  --prefix="$name/" --output="$out/$name.tar.gz" HEAD
echo "package: wrote $out/$name.tar.gz"
