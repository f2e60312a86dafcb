# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
"""What is in the folder of a run, for scripts that compare runs byte by byte."""

import hashlib
import json
import pathlib

# What a report says of the run rather than of its results: how it was called,
# on what machine, and whether a part of it had been computed before.
OF_THE_RUN = {"command", "options", "machine", "cached", "threads"}


def _of_results(value):
    """Returns a report without times and without what is OF_THE_RUN."""
    if isinstance(value, dict):
        return {key: _of_results(inner) for key, inner in value.items()
                if key not in OF_THE_RUN and not key.endswith("_ms")
                and "_ms_" not in key}
    if isinstance(value, list):
        return [_of_results(inner) for inner in value]
    return value


def _digest(path):
    if path.name == "report.json":
        data = json.dumps(_of_results(json.loads(path.read_text()))).encode()
    else:
        data = path.read_bytes()
    return hashlib.sha256(data).hexdigest()


def contents(folder):
    """Returns a digest of each file below a folder by its name, with reports as
    far as they are results."""
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
