#!/usr/bin/env bash
# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
#
# Makes all files of a release from a clean clone of HEAD, on Debian 12: the
# source archive, Debian packages, the wheel, the bundle, the site, and
# SHA256SUMS. Then installs and uses them in bare systems, which needs root.
# CONTRIBUTING.md ("Releasing") says what comes before and after.
#
# usage: scripts/release.sh [--skip-checks] [FOLDER]    FOLDER: out/release
#
# The exit code is 1 if something cannot be made or a check fails, and 2 if the
# tree, the versions or the folder are not ready; nothing is made then.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

refuse() {
  echo "release: $*" >&2
  exit 2
}

checks=(package deb bundle) # of which the last checks the wheel, too
out=out/release
for argument in "$@"; do
  case "$argument" in
    --skip-checks) checks=() ;;
    -*) refuse "unknown flag '$argument'; known: --skip-checks" ;;
    *) out=$argument ;;
  esac
done

git() { command git -c safe.directory='*' "$@"; }

changed=$(git status --porcelain)
[[ -z $changed ]] || refuse "these files are not committed; commit them, or" \
  "take them away:"$'\n'"$changed"
.ci/check_versions.py --release || exit 2
version=$(sed -n 's/^project(musclewarp VERSION \([0-9.]*\).*/\1/p' CMakeLists.txt)
tags=$(git tag --points-at HEAD 'v*')
[[ -z $tags ]] || grep -qxF "v$version" <<<"$tags" || refuse "HEAD has the tag" \
  "$tags, and its version is $version; the tag should be v$version"
mkdir -p "$out"
out=$(cd "$out" && pwd)
[[ -z $(ls -A "$out") ]] ||
  refuse "$out is not empty; remove what is in it, or name another folder"
((EUID == 0 || ${#checks[@]} == 0)) || refuse "the checks make bare systems," \
  "which needs root; become root, or leave them out with --skip-checks"

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
git clone -q . "$work/source"
cd "$work/source"
git checkout -q "$(git -C "$OLDPWD" rev-parse HEAD)"
echo "release: makes $version of $(git log -1 --format='%h, %cs') in $out"

scripts/setup.sh python
scripts/package.sh "$out"
scripts/deb.sh "$out"
scripts/wheel.sh "$out"
scripts/bundle.sh "$out"
scripts/site.sh "$work/musclewarp-$version-site"
tar -C "$work" --sort=name --owner=0 --group=0 --numeric-owner \
  --mtime="@$(git log -1 --format=%ct)" \
  -cJf "$out/musclewarp-$version-site.tar.xz" "musclewarp-$version-site"
(cd "$out" && sha256sum -- * >"$work/SHA256SUMS" && mv "$work/SHA256SUMS" .)

for check in "${checks[@]}"; do
  echo "release: .ci/check_$check.sh"
  ".ci/check_$check.sh" "$out"
done
echo "release: wrote to $out"
(cd "$out" && du -h -- * | sed 's/^/release: /')
if ((${#checks[@]} == 0)); then echo "release: nothing of it was checked"; fi
