# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
"""Settings as keywords: their names, defaults and texts are the library's."""
from typing import Any, Callable, Dict, TypeVar

from musclewarp import _core

_T = TypeVar("_T")


def documented(kind: str) -> Callable[[_T], _T]:
    """Puts the texts of a struct of settings in place of {settings}."""

    def with_texts(described: _T) -> _T:
        described.__doc__ = (described.__doc__ or "").replace(
            "        {settings}", _core.settings_texts[kind])
        return described

    return with_texts


def settings_among(kind: str, values: Dict[str, Any]) -> Dict[str, Any]:
    """Returns the settings of a struct among the locals of a function."""
    return {name: values[name] for name in _core.default_settings[kind]
            if name in values}
