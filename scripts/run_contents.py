# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
"""What is in the folder of a run, for scripts that compare runs byte by byte."""

import base64
import hashlib
import json
import pathlib
import re
import zlib

# What a report says of the run rather than of its results: how it was called,
# by what build, on what machine, and whether a part of it had been computed
# before.
OF_THE_RUN = {"code", "command", "options", "machine", "cached", "threads"}

# The reports in a page, which are compressed, as bytes of its text.
REPORTS_OF_PAGE = re.compile(rb'(?<=id="runs">)[^<]+')


def _of_results(value):
    """Returns a report without times and without what is OF_THE_RUN."""
    if isinstance(value, dict):
        return {key: _of_results(inner) for key, inner in value.items()
                if key not in OF_THE_RUN and not key.endswith("_ms")
                and "_ms_" not in key}
    if isinstance(value, list):
        return [_of_results(inner) for inner in value]
    return value


def _bytes_of_results(text):
    return json.dumps(_of_results(json.loads(text))).encode()


def _results(path):
    """Returns the bytes of a file, or the results if it is a report or a page."""
    data = path.read_bytes()
    if path.name == "report.json":
        return _bytes_of_results(data)
    if path.suffix == ".html":
        return REPORTS_OF_PAGE.sub(
            lambda found: _bytes_of_results(
                zlib.decompress(base64.b64decode(found[0]))), data)
    return data


def _digest(path):
    try:
        data = _results(path)
    except (ValueError, zlib.error):  # of a damaged file
        data = path.read_bytes()
    return hashlib.sha256(data).hexdigest()


def contents(folder):
    """Returns a digest of each file below a folder by its name, with reports, and
    those in pages, as far as they are results."""
    folder = pathlib.Path(folder)
    return {str(path.relative_to(folder)): _digest(path)
            for path in sorted(folder.rglob("*")) if path.is_file()}


def difference(one, other):
    """Returns in a few words how two contents differ, or "" if they do not."""
    missing = sorted(one.keys() - other.keys())
    added = sorted(other.keys() - one.keys())
    changed = sorted(name for name in one.keys() & other.keys()
                     if one[name] != other[name])
    parts = [f"{len(names)} {kind}: {', '.join(names[:3])}"
             for kind, names in (("missing", missing), ("added", added),
                                 ("changed", changed)) if names]
    return "; ".join(parts)
