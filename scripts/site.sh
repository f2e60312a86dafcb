#!/usr/bin/env bash
# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
#
# Makes the site: the pages of docs/, the reference of C++, Python and programs,
# and the page of a run. A warning of Sphinx, of a link that leads nowhere too,
# is an error.
#
# usage: scripts/site.sh [FOLDER]    writes FOLDER/index.html (out/site)
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

out=${1:-out/site}
packages=(doxygen furo python3-breathe python3-myst-parser python3-sphinx)
if ! dpkg -s "${packages[@]}" >/dev/null 2>&1; then
  as_root=()
  ((EUID == 0)) || as_root=(sudo)
  "${as_root[@]}" apt-get -qq update
  "${as_root[@]}" apt-get -qq install -y --no-install-recommends \
    "${packages[@]}" >/dev/null
fi
scripts/build.sh packages musclewarp_programs musclewarp_python

# The pages where they are in the sources, so that their links hold.
work=build/site
rm -rf "$work"
mkdir -p "$work"/{doxygen,live}
git -c safe.directory='*' ls-files -z -- '*.md' CITATION.cff docs examples |
  grep -zvE '^(docs/site|tests)/' | xargs -0 cp --parents -t "$work"
cp docs/site/* "$work"
# A folder is shown by a list of what is in it; sources are named, and not there.
sed -i -E -e 's,\]\(((\.\./)*)examples/?\),](\1examples/index.md),' \
  -e 's,\[([^]]+)\]\((\.\./)*(cmake|src|tests)/[^)]*\),\1,g' \
  "$work"/*.md "$work"/docs/*.md

scripts/site_pages.py "$work" build/release/tools/musclewarp-*[a-z] \
  cohort/musclewarp-cohort
(cat docs/site/Doxyfile
  echo "INPUT = $(tr '\n' ' ' <"$work/headers.txt")"
  echo "OUTPUT_DIRECTORY = $work/doxygen") | doxygen - >/dev/null

export OMP_WAIT_POLICY=passive
build/release/tools/musclewarp-deform --demo --out="$work/demo" --fibres=30 \
  >"$work/demo.log"
cp "$work/demo/report.html" "$work/live/live.html"

# The Python of the system, as the module is built for it.
PYTHONPATH=$PWD/build/release/python PYTHONDONTWRITEBYTECODE=1 \
  /usr/bin/python3 -m sphinx -q -W --keep-going -b html "$work" "$out"
echo "site: wrote $out/index.html"
