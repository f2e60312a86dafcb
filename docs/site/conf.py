# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
"""How Sphinx makes the site; scripts/site.sh lays out what it reads."""
import musclewarp

project = "musclewarp"
author = "the musclewarp authors"
copyright = "2026, the musclewarp authors"
version = release = musclewarp.__version__

extensions = ["breathe", "myst_parser", "sphinx.ext.autodoc",
              "sphinx.ext.napoleon"]
exclude_patterns = ["doxygen", "live"]
html_theme = "furo"
html_title = f"musclewarp {release}"
html_extra_path = ["live"]
html_show_sphinx = False

# Links point to headings as those of Markdown viewers do.
myst_heading_anchors = 5
myst_enable_extensions = ["html_image"]
suppress_warnings = ["myst.header"]  # pages may begin below level one

breathe_projects = {"musclewarp": "doxygen/xml"}
breathe_default_project = "musclewarp"
breathe_show_include = False

# Attributes are properties, which have entries of their own.
napoleon_use_ivar = True
autodoc_member_order = "groupwise"
autodoc_typehints = "signature"
default_role = "code"


def _as_restructured_text(_app, _what, _name, _obj, _options, lines):
    """Docstrings are plain text: samples are indented."""
    told, before = [], [""]
    for line in lines:
        if line.startswith("    ") and before[-1] == "" and not (
                told and told[-1].startswith(" ")):
            before += ["::", ""]
        # Bars are no substitutions, and "mm." numbers nothing in Roman.
        before.append(line.replace("|", r"\|").replace(": mm. ", r": mm\. "))
        if line.strip():
            told.append(line)
    lines[:] = before[1:]


def setup(app):
    # Before napoleon, which reads the sections.
    app.connect("autodoc-process-docstring", _as_restructured_text, 400)
