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

if ((EUID != 0)); then
  echo "deb: debootstrap and chroot need root" >&2
  exit 2
fi
export DEBIAN_FRONTEND=noninteractive LC_ALL=C.UTF-8
command -v debootstrap >/dev/null && command -v lintian >/dev/null || {
  apt-get -qq update
  apt-get -qq install -y --no-install-recommends debootstrap lintian dpkg-dev \
    >/dev/null
}

work=$(mktemp -d)
trap 'rm -rf --one-file-system "$work"' EXIT
root=$work/root
log=$work/log

quietly() {
  if ! "$@" >"$log" 2>&1; then
    echo "deb: this failed: $*" >&2
    tail -n 40 "$log" >&2
    exit 1
  fi
}

# Runs a command in the root; what it mounts is gone with it.
inside() {
  # shellcheck disable=SC2016 # $0 and $@ are those of the inner shell
  env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/root LC_ALL=C.UTF-8 \
    DEBIAN_FRONTEND=noninteractive unshare --mount sh -c \
    'mount -t proc proc "$0/proc" && exec chroot "$0" "$@"' "$root" "$@"
}

# What this machine's apt reads of Debian's main section, as lines of a list.
sources() {
  # shellcheck disable=SC2016 # apt-get replaces these
  apt-get indextargets --format '$(SITE) $(RELEASE) $(COMPONENT)' \
    'Created-By: Packages' | sort -u | awk '$3 == "main" &&
      $2 ~ /^bookworm(-updates|-security)?$/ { print "deb", $1, $2, $3 }'
}

install() {
  quietly inside apt-get -qq install -y --no-install-recommends \
    -o Dpkg::Use-Pty=0 "$@"
}

debs=${1:-}
if [[ -z $debs ]]; then
  debs=$work/debs
  scripts/deb.sh "$debs"
fi
# No bug of Debian asks for these packages.
lintian --allow-root --fail-on error,warning \
  --suppress-tags initial-upload-closes-no-bugs "$debs"/*.deb

echo "deb: makes a bare Debian 12"
mirror=$(sources | awk '$3 == "bookworm" { print $2; exit }')
quietly debootstrap --variant=minbase bookworm "$root" "$mirror"
sources >"$root/etc/apt/sources.list"
apt-config dump | grep -iE '^Acquire::https?::Proxy' \
  >"$root/etc/apt/apt.conf.d/proxy" || true
cp /etc/resolv.conf /etc/hosts "$root/etc/"
echo force-unsafe-io >"$root/etc/dpkg/dpkg.cfg.d/unsafe-io" # it is thrown away
cp "$debs"/*.deb "$root/root/"
quietly inside apt-get -qq update

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
  echo "${COMPREPLY[@]}"')
[[ $offered == "--contact_level= --contact=" ]] || {
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
