# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
"""Settings as keywords: their names, defaults and texts are the library's."""
import textwrap
from typing import Any, Callable, Dict, Iterator, List, TypeVar

from musclewarp import _core

_T = TypeVar("_T")
# How texts of keywords stand in docstrings.
_WIDTH, _FIRST, _NEXT = 79, " " * 8, " " * 12


def _entries(texts: str) -> Iterator[List[str]]:
    """The lines of each keyword among the texts of a struct."""
    entry: List[str] = []
    for line in texts.split("\n"):
        if entry and not line.startswith(_NEXT):
            yield entry
            entry = []
        entry.append(line)
    yield entry


def _with_defaults(texts: str, defaults: Dict[str, Any]) -> str:
    """The texts of a struct with the default of every keyword that has one."""
    lines: List[str] = []
    for entry in _entries(texts):
        text = " ".join(line.strip() for line in entry)
        name = text.partition(":")[0]
        if name in defaults:
            text += f" Default: {defaults[name]!r}."
        lines += textwrap.wrap(text, _WIDTH, initial_indent=_FIRST,
                               subsequent_indent=_NEXT, break_on_hyphens=False,
                               break_long_words=False)
    return "\n".join(lines)


def documented(kind: str) -> Callable[[_T], _T]:
    """Puts the texts of a struct of settings, which the library has, and the
    defaults of the keywords in place of {settings}."""

    def with_texts(described: _T) -> _T:
        function: Any = (described.__init__  # type: ignore[misc]
                         if isinstance(described, type) else described)
        texts = _with_defaults(_core.settings_texts[kind],
                               function.__kwdefaults__ or {})
        described.__doc__ = (described.__doc__ or "").replace(
            "        {settings}", texts)
        return described

    return with_texts


def settings_among(kind: str, values: Dict[str, Any]) -> Dict[str, Any]:
    """Returns the settings of a struct among the locals of a function."""
    return {name: values[name] for name in _core.default_settings[kind]
            if name in values}
