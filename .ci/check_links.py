#!/usr/bin/env python3
# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
"""Fails when a link of a Markdown page to a file or heading of this repository
leads nowhere.

Pages of docs/site are laid out elsewhere; scripts/site.sh checks their links.
"""
import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
LINK = re.compile(r"\]\(([^)\s]+)\)")


def tracked_pages():
    said = subprocess.run(
        ["git", "-c", "safe.directory=*", "ls-files", "*.md"], cwd=ROOT,
        check=True, text=True, stdout=subprocess.PIPE).stdout
    return [ROOT / name for name in said.splitlines()
            if not name.startswith("docs/site/")]


def without_samples(text):
    """The text without code blocks, which may hold what looks like a link."""
    text = re.sub(r"^```.*?^```$", "", text, flags=re.M | re.S)
    return re.sub(r"^    .*$", "", text, flags=re.M)


def anchors(page):
    """The anchors of the headings, as Markdown viewers make them."""
    found = []
    text = re.sub(r"^```.*?^```$", "", page.read_text(), flags=re.M | re.S)
    for heading in re.findall(r"^#+ (.*)$", text, re.M):
        heading = re.sub(r"\[(.*?)\]\(.*?\)", r"\1", heading).strip().lower()
        anchor = re.sub(r"[^\w\- ]", "", heading).replace(" ", "-")
        times = found.count(anchor)
        found.append(f"{anchor}-{times}" if times else anchor)
    return found


def problem_of(page, link):
    path, _, anchor = link.partition("#")
    target = (page.parent / path).resolve() if path else page
    if not target.exists():
        return "there is no such file"
    if anchor and anchor not in anchors(target):
        return "there is no such heading"
    return None


def main():
    count, bad = 0, 0
    for page in tracked_pages():
        for link in LINK.findall(without_samples(page.read_text())):
            if re.match(r"\w+:", link):
                continue
            count += 1
            problem = problem_of(page, link)
            if problem:
                bad += 1
                print(f"links: {page.relative_to(ROOT)}: ({link}): {problem}",
                      file=sys.stderr)
    if bad:
        return 1
    print(f"links: {count} links, all well")
    return 0


if __name__ == "__main__":
    sys.exit(main())
