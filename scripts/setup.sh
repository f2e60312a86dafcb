#!/bin/sh
# Copyright 2026 The musclewarp authors
# SPDX-License-Identifier: Apache-2.0
#
# Installs the Debian packages that musclewarp needs, on Debian 12 and 13 (and
# any system with apt and these package names). Run it as often as you like:
# with nothing missing it changes nothing and returns at once.
#
# usage: scripts/setup.sh [--list | --check] [GROUP...]
#   GROUP    what to install for, "build" if none is named:
#              build   to build the programs (demo.sh)
#              python  to build the Python package; includes build
#              test    to build and run the tests (test.sh); includes python
#              checks  clang-format, clang-tidy and sanitizers (.ci/run)
#            Packages of "checks" that this release does not have are left out,
#            with a line that says so; so are then the checks that need them.
#   --list   print the packages, one per line, and stop
#   --check  say what is missing and exit 1 if anything is; install nothing
set -eu

build_packages="
  g++ cmake ninja-build ccache git
  libeigen3-dev libgoogle-glog-dev libgflags-dev libceres-dev
  libopenmesh-dev libcgal-dev nlohmann-json3-dev libpugixml-dev
  libcereal-dev libnanoflann-dev
  libvtk9-dev libegl-dev libgl1-mesa-dri
  python3
"
# A source package brings the page that Node.js makes. Elsewhere Node.js may have
# come another way than from Debian, which its npm would not go with.
if [ ! -f "$(dirname "$0")/../tools/report/packaged/page.html" ]; then
  command -v node >/dev/null && command -v npm >/dev/null ||
    build_packages="$build_packages nodejs npm"
fi

python_packages="
  python3-dev pybind11-dev python3-numpy
  python3-build python3-pip python3-venv
"
test_packages="
  libgtest-dev libgmock-dev libbenchmark-dev
  chromium tetgen calculix-ccx
  python3-vtk9 python3-tqdm python3-pytest python3-meshio python3-mypy
"
check_packages="
  clang-format-14 clang-tidy-14
  clang-14 libclang-rt-14-dev libomp-14-dev lld-14
"

die() {
  echo "setup: $*" >&2
  exit 1
}

missing_of() {
  # shellcheck disable=SC2086 # one word per package is wanted
  installed=$(dpkg-query -W -f='${Package}=${db:Status-Status}\n' $1 \
    2>/dev/null) || true
  for package in $1; do
    echo "$installed" | grep -qxF "$package=installed" || echo "$package"
  done
}

mode=install
packages=""
optional=""
for argument in "$@"; do
  case "$argument" in
    --list) mode=list ;;
    --check) mode=check ;;
    build) packages="$packages $build_packages" ;;
    python) packages="$packages $build_packages $python_packages" ;;
    test)
      packages="$packages $build_packages $python_packages $test_packages"
      ;;
    checks) optional="$check_packages" ;;
    *) die "unknown argument '$argument'; known: --list, --check, build," \
      "python, test, checks" ;;
  esac
done
[ -n "$packages$optional" ] || packages=$build_packages

if [ "$mode" = list ]; then
  # shellcheck disable=SC2086
  printf '%s\n' $packages $optional | awk '!seen[$0]++'
  exit 0
fi

command -v dpkg-query >/dev/null && command -v apt-get >/dev/null ||
  die "no apt here. musclewarp is built on Debian 12 and 13; elsewhere install" \
    "the counterparts of these packages yourself:" $packages $optional \
    "and build with CMake (CONTRIBUTING.md)"

missing=$(missing_of "$packages" | awk '!seen[$0]++' | tr '\n' ' ')
missing_checks=$(missing_of "$optional" | tr '\n' ' ')
[ -n "$missing$missing_checks" ] || exit 0
if [ "$mode" = check ]; then
  echo "setup: missing: $missing$missing_checks"
  exit 1
fi

if [ "$(id -u)" -eq 0 ]; then
  as_root=""
elif command -v sudo >/dev/null; then
  as_root="sudo"
else
  die "these packages are missing and can be installed only by root (there is" \
    "no sudo here). As root, run: apt-get install $missing$missing_checks"
fi

export DEBIAN_FRONTEND=noninteractive
# A fresh machine has no package lists, an old one may have stale lists.
$as_root apt-get -qq update || die "apt-get update failed (see above)"
for package in $missing_checks; do
  if apt-cache show "$package" >/dev/null 2>&1; then
    missing="$missing$package "
  else
    echo "setup: this release has no $package; what needs it is left out"
  fi
done
[ -n "$missing" ] || exit 0
echo "setup: installing $missing"
# shellcheck disable=SC2086
$as_root env DEBIAN_FRONTEND=noninteractive apt-get -qq install -y \
  --no-install-recommends -o Dpkg::Use-Pty=0 $missing >/dev/null ||
  die "apt-get install failed (see above)"
missing=$(missing_of "$missing" | tr '\n' ' ')
[ -z "$missing" ] || die "still missing after the install: $missing"
echo "setup: done"
