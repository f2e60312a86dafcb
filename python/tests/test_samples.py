# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
"""The code samples of the documentation run, in their order.

Indented and fenced blocks that import or use `mw` are Python; those of a page
share their names. They run in a folder that has data/.
"""
import re
import textwrap

import pytest

from conftest import SOURCE


def samples_of(page):
    """The Python blocks of a Markdown page."""
    text = (SOURCE / page).read_text(encoding="utf-8")
    fence = re.compile(r"^```python\n(.*?)^```$", re.M | re.S)
    fenced = fence.findall(text)
    indented = re.findall(r"(?:^    .*\n(?:\n(?=    ))?)+",
                          fence.sub("", text), re.M)
    blocks = [textwrap.dedent(block) for block in fenced + indented]
    return [block for block in blocks if re.search(r"^import musclewarp as mw|"
                                                   r"\bmw\.[A-Z]?\w+\(", block)
            and "#include" not in block and "mw::" not in block]


@pytest.mark.parametrize("page, least", [("README.md", 1),
                                         ("docs/python.md", 6)])
def test_samples(page, least, tmp_path, monkeypatch):
    samples = samples_of(page)
    assert len(samples) >= least
    (tmp_path / "data").symlink_to(SOURCE / "data")
    monkeypatch.chdir(tmp_path)
    names = {}
    for sample in samples:
        exec(compile(sample, f"{page}: {sample[:40]!r}", "exec"), names)
