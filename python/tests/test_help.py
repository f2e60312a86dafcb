# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
"""help() explains every setting with the text of the library and its default."""
import inspect
import re

import pytest

import musclewarp as mw
from musclewarp import _core, _settings

DOCUMENTED = [(mw.Deformer, mw.Deformer.__init__, "DeformerSettings"),
              (mw.separate, mw.separate, "SeparationSettings"),
              (mw.articulate, mw.articulate, "ArticulationSettings"),
              (mw.read_labels, mw.read_labels, "LabelSettings")]


def arguments(described):
    """{name: text} of the part "Args" of a docstring."""
    lines = inspect.getdoc(described).partition("\nArgs:\n")[2].split("\n")
    found = {}
    for line in lines:
        if line and not line.startswith("    "):
            break
        begins = re.match(r"    (\w+): ", line)
        if begins:
            found[begins[1]] = []
        found[list(found)[-1]].append(line.strip())
    return {name: " ".join(text).strip() for name, text in found.items()}


@pytest.mark.parametrize("described, function, kind", DOCUMENTED,
                         ids=lambda value: getattr(value, "__name__", str(value)))
def test_each_setting_with_its_text_and_default(described, function, kind):
    said = arguments(described)
    texts = _core.settings_texts[kind]
    assert set(_core.default_settings[kind]) <= set(said)
    for name in _core.default_settings[kind]:
        default = inspect.signature(function).parameters[name].default
        text = said[name].removesuffix(f" Default: {default!r}.")
        assert text != said[name], f"{name} has no default"
        assert text in " ".join(texts.split()), name


def test_each_keyword_is_explained():
    for described, function, _ in DOCUMENTED:
        keywords = set(inspect.signature(function).parameters) - {"self"}
        assert keywords <= set(arguments(described))


def test_lines_stay_short():
    for texts in _core.settings_texts.values():
        defaults = dict.fromkeys(re.findall(r"^ {8}(\w+):", texts, re.M), 0.125)
        for line in _settings._with_defaults(texts, defaults).split("\n"):
            assert len(line) < 80, line


def test_texts_without_a_default_are_as_the_library_has_them():
    for texts in _core.settings_texts.values():
        assert " ".join(_settings._with_defaults(texts, {}).split()) == \
            " ".join(texts.split())
