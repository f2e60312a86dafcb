# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
#
# A bare Debian in a folder, for checks that source this file: debootstrap makes
# it from the mirror of this machine. Needs root. $name says who speaks.
#
#   name=deb
#   make_debian bookworm     sets $root and $work, which go when the check ends
#   install g++ cmake        packages in it
#   inside musclewarp-deform --version

export DEBIAN_FRONTEND=noninteractive LC_ALL=C.UTF-8

if ((EUID != 0)); then
  echo "$name: debootstrap and chroot need root" >&2
  exit 2
fi

work=$(mktemp -d)
trap 'rm -rf --one-file-system "$work"' EXIT
root=$work/root
log=$work/log

quietly() {
  if ! "$@" >"$log" 2>&1; then
    echo "$name: this failed: $*" >&2
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

install() {
  quietly inside apt-get -qq install -y --no-install-recommends \
    -o Dpkg::Use-Pty=0 "$@"
}

# What this machine's apt reads of Debian's main section, as lines of a list, for
# another release.
sources_of() {
  local here
  here=$(. /etc/os-release && echo "$VERSION_CODENAME")
  # shellcheck disable=SC2016 # apt-get replaces these
  apt-get indextargets --format '$(SITE) $(RELEASE) $(COMPONENT)' \
    'Created-By: Packages' | sort -u | awk -v here="$here" -v there="$1" '
      $3 == "main" && $2 ~ "^" here "(-updates|-security)?$" {
        sub(here, there, $2)
        print "deb", $1, $2, $3
      }'
}

make_debian() {
  local release=$1 mirror
  command -v debootstrap >/dev/null || {
    apt-get -qq update
    apt-get -qq install -y --no-install-recommends debootstrap >/dev/null
  }
  echo "$name: makes a bare Debian ($release)"
  mirror=$(sources_of "$release" |
    awk -v release="$release" '$3 == release { print $2; exit }')
  quietly debootstrap --variant=minbase "$release" "$root" "$mirror"
  sources_of "$release" >"$root/etc/apt/sources.list"
  apt-config dump | grep -iE '^Acquire::https?::Proxy' \
    >"$root/etc/apt/apt.conf.d/proxy" || true
  cp /etc/resolv.conf /etc/hosts "$root/etc/"
  echo force-unsafe-io >"$root/etc/dpkg/dpkg.cfg.d/unsafe-io" # it is thrown away
  quietly inside apt-get -qq update
}
