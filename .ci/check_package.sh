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
bundle=src/musclewarp/page/page_bundle.cc
cmake --build build --target "$bundle" >/dev/null
grep -qa "Licences of what this page is made of" "build/$bundle"
echo "package: configures and embeds its page without Node.js"
