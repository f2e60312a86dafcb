#!/usr/bin/env bash
# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
#
# Uses what carries its libraries, the bundle and the wheel, in a bare Debian 12
# and a bare Debian 13, which have none of ours: what is loaded from where, the
# demo, pictures with and without a driver, the commands of the wheel, a frame in
# Python. Needs root and some minutes; therefore no part of .ci/run.
#
# Debian 13 has no Python 3.11, which the wheel is for: pip refuses it there.
# There the module is loaded by the Python of Debian 12, copied as it is.
#
# usage: .ci/check_bundle.sh [FOLDER]
#        FOLDER has both already (scripts/bundle.sh, scripts/wheel.sh)
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

name=bundle
# shellcheck source=.ci/debian_root.sh
. .ci/debian_root.sh
began=$SECONDS

say() {
  echo "$name ($release): $* ($((SECONDS - began)) s)"
  began=$SECONDS
}
fail() {
  echo "$name ($release): $*" >&2
  exit 1
}
# What a command says and its exit code: expect CODE TEXT COMMAND...
expect() {
  local code=0
  inside "${@:3}" >"$log" 2>&1 || code=$?
  if ((code != $1)) || ! grep -q -- "$2" "$log"; then
    tail -n 20 "$log" >&2
    fail "${*:3} exits with $code; $1 and '$2' are wanted"
  fi
}

# Every program, library and module of a folder finds what it needs, and takes
# nothing from the system but what is left to it.
left='linux-vdso|ld-linux-x86-64|libc|libm|libpthread|libdl|librt|libgcc_s|libstdc\+\+'
check_loaded() {
  local strangers
  # shellcheck disable=SC2016 # for the shell in the root
  inside sh -c 'find "$1" -type f | while read -r file; do
      if [ "$(head -c 4 "$file" | tail -c 3)" = ELF ]; then ldd "$file"; fi
    done' sh "$1" >"$log"
  [[ -s $log ]] || fail "there is nothing in $1"
  strangers=$(grep -v " => $1/" "$log" |
    grep -vE "^\s*(/lib64/)?($left)\.so\.[0-9]+ " || true)
  [[ -z $strangers ]] || fail "$1 needs more than is left to the system:
$strangers"
  say "all in $1 is found, $(grep -oE "/($left)\.so\.[0-9]+ " "$log" |
    sort -u | sed 's,.*/,,' | tr -d '\n')come from the system"
}

use_bundle() {
  local bundle
  bundle=/opt/$(basename "$folder"/musclewarp-*-linux-*.tar.xz .tar.xz)
  # By tar and xz from outside: a bare Debian has no xz.
  tar -x -C "$root/opt" -f "$folder/${bundle#/opt/}.tar.xz"
  say "is unpacked"
  check_loaded "$bundle"
  for program in deform render; do
    expect 0 "musclewarp-$program [0-9]" "$bundle/bin/musclewarp-$program" --version
  done
  # Neither root nor its folder, nor a name by which it was called.
  expect 0 "wrote /tmp/demo/report.html" chroot --userspec=65534:65534 / \
    "$bundle/bin/musclewarp-deform" --demo --out=/tmp/demo
  say "the demo has run as nobody"
  expect 0 "frames" "$bundle/bin/musclewarp-deform" --out=/tmp/data \
    --scene="$bundle/data/phantom/scene.json"
  say "the scene that it brings along has run"

  local render=("$bundle/bin/musclewarp-render" --in=/tmp/demo --out=/tmp/a.png)
  expect 2 "install Mesa's software renderer" "${render[@]}"
  install libegl1 libgl1-mesa-dri
  began=$SECONDS
  expect 0 "wrote /tmp/a.png" "${render[@]}"
  say "a picture is drawn with the driver of this system, and none without"
}

frame="
import musclewarp as mw
scene = mw.demo_scene()
frame = mw.Deformer(scene, gap=0.1).move_to(scene.poses[1])
assert frame.usable and frame.crossing_pairs == 0, frame.shortcomings
print('moved', frame[scene.muscles[0].name].points.shape, mw.__file__)
"

use_wheel() {
  cp "$folder"/musclewarp-*.whl "$root/root"
  local wheel
  wheel=/root/$(basename "$folder"/musclewarp-*.whl)
  install python3-venv python3-numpy
  quietly inside python3 -m venv --system-site-packages /opt/venv
  say "Python and numpy are installed"
  local pip=(/opt/venv/bin/pip install --no-index "$wheel")
  if [[ $release != bookworm ]]; then
    expect 1 "is not a supported wheel on this platform" "${pip[@]}"
    say "its Python $(inside python3 -c 'import platform as p
print(p.python_version())') refuses the wheel, as it should"
    return
  fi
  expect 0 "Successfully installed musclewarp" "${pip[@]}"
  say "pip has installed the wheel"
  check_loaded /opt/venv/lib/python3.11/site-packages
  local program=/opt/venv/bin/musclewarp-deform
  expect 0 "^musclewarp-deform [0-9]" "$program" --version
  expect 2 "no_such_flag" "$program" --no_such_flag
  expect 0 "wrote /tmp/wheel/report.html" "$program" --demo --out=/tmp/wheel
  expect 0 "^moved .*/opt/venv/" /opt/venv/bin/python -c "$frame"
  say "its commands and its module work"
  # Ctrl-C reaches the program itself, which stops in its own way.
  expect 1 "^interrupted by SIGINT" timeout --preserve-status --signal=INT 4 \
    "$program" --demo --out=/tmp/interrupted
  say "Ctrl-C interrupts a command"
  quietly inside /opt/venv/bin/pip uninstall -y musclewarp
  [[ -z $(find "$root/opt/venv" -name 'musclewarp*' -print -quit) ]] ||
    fail "pip leaves something of the wheel"
}

# The module under a newer glibc and libstdc++, by the Python of $1.
use_module_by_python_of() {
  local files=(usr/bin/python3.11 usr/lib/python3.11
    usr/lib/python3/dist-packages/numpy)
  mkdir "$root/opt/python"
  tar -c -C "$1" "${files[@]}" | tar -x -C "$root/opt/python"
  install libblas3 liblapack3
  quietly inside python3 -m zipfile -e \
    "/root/$(basename "$folder"/musclewarp-*.whl)" /opt/wheel
  chmod a+x "$root"/opt/wheel/musclewarp/bin/*
  check_loaded /opt/wheel
  expect 0 "musclewarp-deform [0-9]" /opt/wheel/musclewarp/bin/musclewarp-deform \
    --version
  expect 0 "^moved .*/opt/wheel/" env PYTHONHOME=/opt/python/usr \
    PYTHONPATH=/opt/wheel:/opt/python/usr/lib/python3/dist-packages \
    /opt/python/usr/bin/python3.11 -c "$frame"
  say "the module moves a frame by the Python of Debian 12"
}

folder=${1:-}
if [[ -z $folder ]]; then
  folder=$work/made
  scripts/bundle.sh "$folder"
  scripts/wheel.sh "$folder"
fi
for release in bookworm trixie; do
  root=$work/$release
  make_debian "$release"
  say "is there"
  use_bundle
  use_wheel
done
use_module_by_python_of "$work/bookworm"
echo "$name: the bundle and the wheel work on both; $SECONDS s in all"
