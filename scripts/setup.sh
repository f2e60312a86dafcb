#!/bin/sh
# Copyright 2026 The musclewarp authors
# SPDX-License-Identifier: Apache-2.0
#
# Installs what musclewarp needs to be built and tested on Debian 12 (any
# system with apt and these package names will do). Run it as often as you
# like: with nothing missing it changes nothing and returns at once.
#
# usage: scripts/setup.sh [--list | --check]
#   --list   print the packages, one per line, and stop
#   --check  say what is missing and exit 1 if anything is; install nothing
set -eu

packages="
  g++ cmake ninja-build ccache git
  libeigen3-dev libgoogle-glog-dev libgflags-dev libceres-dev
  libopenmesh-dev libcgal-dev nlohmann-json3-dev libpugixml-dev
  libcereal-dev
  libvtk9-dev libegl-dev libgl1-mesa-dri
  libgtest-dev libgmock-dev libbenchmark-dev
  clang-format-14 clang-tidy-14 python3 chromium tetgen
  python3-dev pybind11-dev python3-numpy python3-vtk9 python3-tqdm
  python3-pytest python3-mypy python3-build python3-pip python3-venv
  clang-14 libclang-rt-14-dev libomp-14-dev lld-14
"
# Node.js may have come another way than from Debian, which its npm would not
# go with.
command -v node >/dev/null && command -v npm >/dev/null ||
  packages="$packages nodejs npm"

die() {
  echo "setup: $*" >&2
  exit 1
}

missing_packages() {
  # shellcheck disable=SC2086 # one word per package is wanted
  installed=$(dpkg-query -W -f='${Package}=${db:Status-Status}\n' $packages \
    2>/dev/null) || true
  for package in $packages; do
    echo "$installed" | grep -qxF "$package=installed" || echo "$package"
  done
}

mode=install
case "${1:-}" in
  "") ;;
  --list)
    # shellcheck disable=SC2086
    printf '%s\n' $packages
    exit 0
    ;;
  --check) mode=check ;;
  *) die "unknown argument '$1'; known: --list, --check" ;;
esac

command -v dpkg-query >/dev/null && command -v apt-get >/dev/null ||
  die "no apt here. musclewarp is built on Debian 12; elsewhere install the" \
    "counterparts of these packages yourself:" $packages

missing=$(missing_packages | tr '\n' ' ')
[ -n "$missing" ] || exit 0
if [ "$mode" = check ]; then
  echo "setup: missing: $missing"
  exit 1
fi

if [ "$(id -u)" -eq 0 ]; then
  as_root=""
elif command -v sudo >/dev/null; then
  as_root="sudo"
else
  die "these packages are missing and can be installed only by root (there is" \
    "no sudo here). As root, run: apt-get install $missing"
fi

echo "setup: installing $missing"
export DEBIAN_FRONTEND=noninteractive
# A fresh machine has no package lists, an old one may have stale lists.
$as_root apt-get -qq update || die "apt-get update failed (see above)"
# shellcheck disable=SC2086
$as_root env DEBIAN_FRONTEND=noninteractive apt-get -qq install -y \
  --no-install-recommends -o Dpkg::Use-Pty=0 $missing >/dev/null ||
  die "apt-get install failed (see above)"
missing=$(missing_packages | tr '\n' ' ')
[ -z "$missing" ] || die "still missing after the install: $missing"
echo "setup: done"
