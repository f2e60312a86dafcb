#!/usr/bin/env bash
# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
#
# Runs the tests on real data with the programs of build/release, if the data
# are there: in MUSCLEWARP_DATA_ROOT or, without it, in ../shared/data. Three of
# them take minutes each and are left out, unless --all is given: run it before a
# change to contact or to the page is handed in.
#
# usage: .ci/check_data.sh [--all]
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

case "${1-}" in
  "") choice=(-E 'OriginalHamstrings|report_page/(Lhdl|PicturesOfData)') ;;
  --all) choice=() ;;
  *)
    echo "check_data: unknown argument '$1'; known: --all" >&2
    exit 2
    ;;
esac

data_root=${MUSCLEWARP_DATA_ROOT:-../shared/data}
if [[ ! -d $data_root ]]; then
  echo "skipped: no folder $data_root"
  exit 0
fi
MUSCLEWARP_DATA_ROOT=$(cd "$data_root" && pwd)
export MUSCLEWARP_DATA_ROOT
# Two tests at a time are quicker than one with two threads. The results are the
# same.
OMP_NUM_THREADS=1 ctest --preset ci --output-on-failure -j2 -L data \
  "${choice[@]}"
