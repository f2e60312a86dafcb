#!/usr/bin/env bash
# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
#
# Makes the Debian packages and uses them in a bare Debian 12, which debootstrap
# makes from the mirror of this machine: the demo, without a compiler and without
# Node.js; the Python package; a C++ project. Needs root, and some minutes, most
# of them to fetch and unpack packages; therefore no part of .ci/run.
#
# usage: .ci/check_deb.sh [FOLDER]    FOLDER has packages already (scripts/deb.sh)
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

name=deb
# shellcheck source=.ci/debian_root.sh
. .ci/debian_root.sh
command -v lintian >/dev/null || {
  apt-get -qq update
  apt-get -qq install -y --no-install-recommends lintian dpkg-dev >/dev/null
}

debs=${1:-}
if [[ -z $debs ]]; then
  debs=$work/debs
  scripts/deb.sh "$debs"
fi
# No bug of Debian asks for these packages.
lintian --allow-root --fail-on error,warning \
  --suppress-tags initial-upload-closes-no-bugs "$debs"/*.deb

make_debian bookworm
cp "$debs"/*.deb "$root/root/"

install_ours() {
  local package
  package=$(cd "$root/root" && ls "$1"_*.deb)
  install "/root/$package"
}

began=$SECONDS
install_ours musclewarp
echo "deb: musclewarp installed after $((SECONDS - began)) s"
for program in g++ gcc cc clang cmake node nodejs python3; do
  if inside sh -c "command -v $program" >/dev/null; then
    echo "deb: $program came with musclewarp, which should not need it" >&2
    exit 1
  fi
done
began=$SECONDS
quietly inside musclewarp-deform --demo --out=/root/demo
took=$((SECONDS - began))
grep -q "Licences of what this page is made of" "$root/root/demo/report.html"
((took < 60)) || {
  echo "deb: the demo took $took s; less than a minute is wanted" >&2
  exit 1
}
echo "deb: musclewarp-deform --demo took $took s and wrote its page"

install bash-completion man-db
# shellcheck disable=SC2016 # for the shell in the root
offered=$(inside bash -c '. /usr/share/bash-completion/bash_completion
  _completion_loader musclewarp-deform
  COMP_LINE="musclewarp-deform --cont" COMP_POINT=24 COMP_CWORD=1
  COMP_WORDS=(musclewarp-deform --cont)
  _musclewarp_deform 2>/dev/null
  printf "%s\n" "${COMPREPLY[@]}" | sort | xargs')
[[ $offered == "--contact= --contact_level=" ]] || {
  echo "deb: completion of --cont offers '$offered'" >&2
  exit 1
}
man=$(inside man --warnings musclewarp-deform)
grep -q "contact_level=TEXT" <<<"$man"
echo "deb: man shows the flags, bash completes them"

install_ours python3-musclewarp
quietly inside python3 -c '
import musclewarp as mw
scene = mw.demo_scene()
frame = mw.Deformer(scene, gap=0.1).move_to(scene.poses[1])
assert frame.usable and frame.crossing_pairs == 0, frame.shortcomings
'
echo "deb: python3-musclewarp moves a pose"

install_ours libmusclewarp-dev
install g++ cmake make
echo "deb: libmusclewarp-dev and a compiler installed after $SECONDS s"
cp -r tests/install "$root/root/consumer"
quietly inside cmake -S /root/consumer -B /root/consumer/build \
  -DCMAKE_BUILD_TYPE=Release
quietly inside cmake --build /root/consumer/build
quietly inside /root/consumer/build/consumer
echo "deb: libmusclewarp-dev builds a project, which runs"

began=$SECONDS
install_ours musclewarp-cohort
mkdir -p "$root/root/in"
quietly inside musclewarp-phantom --scene=random --num_muscles=2 --seed=1 \
  --out=/root/in/one
printf '%s\t%s\t%s\t%s\t%s\t%s\n' participant_id scene model motion side flags \
  sub-1 one/scene.json n/a n/a n/a n/a >"$root/root/in/subjects.tsv"
quietly inside musclewarp-cohort /root/in /root/group group
grep -q "1 of 1 runs usable" "$root/root/group/group.html"
echo "deb: musclewarp-cohort runs a subject, $((SECONDS - began)) s with Snakemake"

quietly inside apt-get -qq purge -y musclewarp musclewarp-cohort \
  python3-musclewarp libmusclewarp-dev
left=$(find "$root/usr" -path '*musclewarp*' -print -quit)
if [[ -n $left ]]; then
  echo "deb: purging the packages leaves $left" >&2
  exit 1
fi
echo "deb: the packages are removed without a trace; $SECONDS s in all"
