#!/usr/bin/env bash
# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
#
# Makes a source package and checks that it is configured without Node.js, and
# embeds the page it brings along.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
scripts/package.sh "$work"
tar -x -C "$work" -f "$work"/musclewarp-*.tar.gz
cd "$work"/musclewarp-*/
said=$(cmake -S . -B build -G Ninja -DMUSCLEWARP_WITH_NODE=OFF)
grep "Report page: the one that came with this package" <<<"$said"
# Building it all again would show no more than this.
grep -q "tools/report/packaged/page.html" build/build.ninja
cmake -DPAGE="$PWD/tools/report/packaged/page.html" -DOUTPUT=build/page.cc \
  -P cmake/EmbedPage.cmake
grep -q "Licences of what this page is made of" build/page.cc
echo "package: configures and embeds its page without Node.js"
