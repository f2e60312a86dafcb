#!/usr/bin/env bash
# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
#
# Makes a source package and checks that it is configured without Node.js, and
# embeds the pages it brings along.
#
# usage: .ci/check_package.sh [FOLDER]    FOLDER has one already (scripts/package.sh)
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
packages=${1:-}
if [[ -z $packages ]]; then
  packages=$work
  scripts/package.sh "$packages"
fi
tar -x -C "$work" -f "$packages"/musclewarp-*.tar.gz
cd "$work"/musclewarp-*/
said=$(cmake -S . -B build -G Ninja -DMUSCLEWARP_WITH_NODE=OFF)
for page in page joints; do
  file=$page.html
  grep "Report page $file: the one that came with this package" <<<"$said"
  # Building it all again would show no more than this.
  grep -q "tools/report/packaged/$file" build/build.ninja
  cmake -DPAGE="$PWD/tools/report/packaged/$file" -DHEADER="$page.h" \
    -DNAME=kBundle -DOUTPUT="build/$page.cc" -P cmake/EmbedPage.cmake
  grep -q "Licences of what this page is made of" "build/$page.cc"
done
echo "package: configures and embeds its pages without Node.js"
