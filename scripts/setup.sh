#!/bin/sh
# Copyright 2026 The musclewarp authors
# SPDX-License-Identifier: Apache-2.0
#
# Installs the packages that musclewarp needs, on Debian, Ubuntu and any other
# system with apt. Run it as often as you like: with nothing missing it changes
# nothing and returns at once.
#
# usage: scripts/setup.sh [--list | --check] [GROUP...]
#   GROUP    what to install for, "build" if none is named:
#              build   to build the programs (demo.sh)
#              python  to build the Python package; includes build
#              test    to build and run the tests (test.sh); includes python
#              checks  clang-format, clang-tidy and sanitizers (.ci/run)
#   --list   print the packages, one per line, and stop
#   --check  say what is missing and exit 1 if anything is; install nothing
#
# A package that this release does not have, or has in too old a version, is
# named, with what it is for. If it is needed, nothing is installed and the exit
# code is 1; if it is merely useful, it is left out, and so is what it is for.
set -eu

here=$(dirname "$0")

# Group, whether it is needed or useful, package, least version, what it is for.
# A version that is a name is that of a package in MusclewarpDependencies.cmake.
catalogue() {
  cat <<'END'
build  needed g++                 -             the C++ compiler
build  needed cmake               CMake         configures the build
build  needed ninja-build         -             runs the build
build  useful ccache              -             makes later builds quick
build  needed git                 -             the scripts of a checkout
build  needed libeigen3-dev       Eigen3        matrices
build  needed libgoogle-glog-dev  -             messages
build  needed libgflags-dev       -             flags of the programs
build  needed libceres-dev        Ceres         the solver
build  needed libopenmesh-dev     -             meshes
build  needed libcgal-dev         CGAL          hulls and repair of meshes
build  needed nlohmann-json3-dev  nlohmann_json scenes and reports
build  needed libpugixml-dev      pugixml       OpenSim models
build  needed libcereal-dev       -             the cache of preparations
build  needed libnanoflann-dev    -             the search of points
build  useful libvtk9-dev         VTK           .vtp files, label images, pictures
build  useful libegl-dev          -             .vtp files, label images, pictures
build  useful libgl1-mesa-dri     -             pictures without a screen
build  needed python3             -             scripts that the build calls
build  needed nodejs              18            the page of a run
build  needed npm                 -             the page of a run
python needed python3-dev         3.11          the Python package
python needed pybind11-dev        2.10          the Python package
python needed python3-numpy       -             the Python package
python needed python3-build       -             wheels
python needed python3-pip         -             wheels
python needed python3-venv        -             wheels
test   needed libgtest-dev        -             the tests
test   needed libgmock-dev        -             the tests
test   useful libbenchmark-dev    -             the benchmarks
test   useful chromium            -             tests of the page
test   useful tetgen              -             tests of meshes for finite elements
test   useful calculix-ccx        -             tests of meshes for finite elements
test   useful python3-vtk9        -             tests of VTK in Python
test   useful python3-tqdm        -             tests of progress bars
test   needed python3-pytest      -             the tests of the Python package
test   useful python3-meshio      -             tests of meshes for finite elements
test   needed python3-mypy        -             the tests of the Python package
checks useful clang-format-14     -             the check of the format
checks useful clang-tidy-14       -             clang-tidy
checks useful clang-14            -             the sanitizers
checks useful libclang-rt-14-dev  -             the sanitizers
checks useful libomp-14-dev       -             the sanitizers
checks useful lld-14              -             the sanitizers
END
}

die() {
  echo "setup: $*" >&2
  exit 1
}

# The packages of groups. A source package brings the page that Node.js makes.
# Elsewhere Node.js may have come another way than from Debian, which its npm
# would not go with.
packages_of() {
  leave_out=none
  if [ -f "$here/../tools/report/packaged/page.html" ] ||
    { command -v node && command -v npm; } >/dev/null; then
    leave_out="the page of a run"
  fi
  for group in "$@"; do
    catalogue | awk -v group="$group" -v leave_out="$leave_out" '
      $1 == group && !index($0, leave_out) { print $3 }'
  done
}

# The packages of a list, one a line, that are not installed.
missing_of() {
  # shellcheck disable=SC2086 # one word per package is wanted
  installed=$(dpkg-query -W -f='${Package}=${db:Status-Status}\n' $1 \
    2>/dev/null) || true
  for package in $1; do
    case "
$installed
" in
      *"
$package=installed
"*) ;;
      *) echo "$package" ;;
    esac
  done
}

# The least version that a word of the catalogue means, nothing if any will do.
least_version_of() {
  case "$1" in
    -) ;;
    CMake)
      sed -n 's/^cmake_minimum_required(VERSION \([0-9.]*\).*/\1/p' \
        "$here/../CMakeLists.txt"
      ;;
    [A-Za-z]*)
      sed -n "s/.*\"$1 \([0-9.]*\).*/\1/p" \
        "$here/../cmake/MusclewarpDependencies.cmake"
      ;;
    *) echo "$1" ;;
  esac
}

# Sorts missing packages, given as words, by what apt offers: $installable, and
# lines about the others, $impossible if they are needed, else $left_out.
sort_out() {
  installable="" impossible="" left_out=""
  # shellcheck disable=SC2086
  offers=$(LC_ALL=C apt-cache policy $1 2>/dev/null | awk '
    /^[^ ]/ { sub(/:$/, ""); name = $1 }
    $1 == "Candidate:" && $2 != "(none)" { print name "=" $2 }') || true
  offers="
$offers"
  while read -r _ need package least purpose; do
    case " $1 " in *" $package "*) ;; *) continue ;; esac
    why="is not in this release"
    case "$offers" in
      *"
$package="*)
        offer=${offers##*"
$package="}
        offer=${offer%%
*}
        least=$(least_version_of "$least")
        if [ -z "$least" ] ||
          dpkg --compare-versions "${offer#*:}" ge "$least"; then
          installable="$installable$package "
          continue
        fi
        why="is $offer in this release, and $least is needed"
        ;;
    esac
    if [ "$need" = needed ]; then
      impossible="${impossible}setup: $package $why ($purpose)
"
    else
      left_out="${left_out}setup: $package $why ($purpose): left out
"
    fi
  done <<END
$(catalogue)
END
}

say_left_out() {
  printf '%s' "$left_out"
  case "$left_out" in
    *libvtk9-dev* | *libegl-dev*)
      echo "setup: once, to build without VTK, run: cmake --preset programs" \
        "-DMUSCLEWARP_WITH_VTK=OFF"
      ;;
  esac
}

mode=install
groups=""
for argument in "$@"; do
  case "$argument" in
    --list) mode=list ;;
    --check) mode=check ;;
    build | checks) groups="$groups $argument" ;;
    python) groups="$groups build python" ;;
    test) groups="$groups build python test" ;;
    *) die "unknown argument '$argument'; known: --list, --check, build," \
      "python, test, checks" ;;
  esac
done
# shellcheck disable=SC2086
packages=$(packages_of ${groups:-build} | awk '!seen[$0]++')

if [ "$mode" = list ]; then
  echo "$packages"
  exit 0
fi

if ! { command -v dpkg-query && command -v apt-get; } >/dev/null; then
  die "no apt here. docs/install.md says how to get musclewarp on other" \
    "systems, and how other distributions call the packages that it needs"
fi

missing=$(missing_of "$packages" | tr '\n' ' ')
[ -n "$missing" ] || exit 0
if [ "$mode" = check ]; then
  echo "setup: missing: $missing"
  exit 1
fi

# What is merely useful and cannot be had needs no root every time.
if [ -n "$(apt-get indextargets 'Created-By: Packages' 2>/dev/null)" ]; then
  sort_out "$missing"
  if [ -z "$installable$impossible" ]; then
    say_left_out
    exit 0
  fi
fi

if [ "$(id -u)" -eq 0 ]; then
  as_root=""
elif command -v sudo >/dev/null; then
  as_root="sudo"
else
  die "these packages are missing and can be installed only by root (there is" \
    "no sudo here). As root, run: apt-get install $missing"
fi

export DEBIAN_FRONTEND=noninteractive
# A fresh machine has no package lists, an old one may have stale lists.
$as_root apt-get -qq update || die "apt-get update failed (see above)"
sort_out "$missing"
if [ -n "$impossible" ]; then
  printf '%s' "$impossible" >&2
  system=$(sed -n 's/^PRETTY_NAME="\{0,1\}\([^"]*\).*/\1/p' /etc/os-release \
    2>/dev/null) || true
  die "${system:-this system} does not have what the build needs; nothing was" \
    "installed. docs/install.md has ways that need no build"
fi
say_left_out
[ -n "$installable" ] || exit 0
count=$(echo "$installable" | wc -w)
takes="one to three minutes"
[ "$count" -gt 5 ] || takes="less than a minute as a rule"
echo "setup: $count packages are missing; installing them and what they need" \
  "takes $takes: $installable"
# shellcheck disable=SC2086
$as_root env DEBIAN_FRONTEND=noninteractive apt-get -qq install -y \
  --no-install-recommends -o Dpkg::Use-Pty=0 $installable >/dev/null ||
  die "apt-get install failed (see above)"
missing=$(missing_of "$installable" | tr '\n' ' ')
[ -z "$missing" ] || die "still missing after the install: $missing"
echo "setup: done"
