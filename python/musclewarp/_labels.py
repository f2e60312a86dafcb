# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
"""Meshes of the labels of an image."""
import numbers
import os
from typing import Any, Dict, List, Mapping, Optional, Union

from musclewarp import _core
from musclewarp._errors import InputError
from musclewarp._settings import documented, settings_among

_Path = Union[str, "os.PathLike[str]"]


class Labels:
    """The meshes of a label image, as read_labels() returns them.

        labels = mw.read_labels("seg.nii.gz", "labels.csv")
        frame = mw.separate(labels)
        leg = mw.articulate(labels)
        deformer = mw.Deformer(leg.scene())

    Attributes:
        bones: dict of Mesh by name.
        muscles: dict of Muscle by name.
        volumes: dict of the volumes of the labels by name, mm^3, before their
            surfaces were made.
        notes: what was left out, filled or not known, sentences.
        axes: "LPS", or None if the image does not say where left, back and
            head are.
    """

    def __init__(self, subject: _core.Subject) -> None:
        self._subject = subject
        self.bones: Dict[str, _core.Mesh] = subject.bones
        self.muscles: Dict[str, _core.Muscle] = subject.muscles
        self.volumes: Dict[str, float] = subject.volumes
        self.notes: List[str] = subject.notes
        self.axes: Optional[str] = "LPS" if subject.is_oriented else None

    def __repr__(self) -> str:
        return (f"<musclewarp.Labels: {len(self.bones)} bones, "
                f"{len(self.muscles)} muscles>")


@documented("LabelSettings")
def read_labels(image: Any,
                table: Optional[_Path] = None,
                *,
                affine: Any = None,
                space: Optional[str] = "RAS",
                names: Optional[Mapping[int, Union[str, Mapping[str, str]]]] = None,
                # Settings of LabelSettings.
                labels: Union[str, "os.PathLike[str]"] = "",
                edge: float = 0.0,
                pieces: str = "largest",
                units: str = "mm",
                bone: str = "",
                # End of settings.
                ) -> Labels:
    """Makes a mesh of each label of an image, in mm and in LPS.

        labels = mw.read_labels("seg.nii.gz", "labels.csv")
        labels = mw.read_labels(nibabel.load("seg.nii.gz"), names={1: "femur"})
        labels = mw.read_labels(array, affine=affine, names={1: "femur"})

    A label is a bone if the table or `bone` says so, or if its name is that of
    a bone (docs/joints.md); a bone that exists on both sides of the body
    becomes a mesh on each. This is what musclewarp-articulate reads.

    Args:
        image: the path of a label image, an image of nibabel, or an array
            (i, j, k) of whole numbers, 0 for the background.
        table: the table of the labels, a file as docs/joints.md has it; short
            for `labels`.
        affine: of an array, (4, 4): takes indices (i, j, k, 1) to places, mm.
        space: of `affine`: "RAS" (as nibabel has it), "LPS", or None if it is
            not known where its axes point.
        names: dict of the labels in place of a table: of each its name, or a
            dict with the columns of the table, such as {"name": "nail",
            "kind": "bone", "body": "femur_r"}. Other labels are left out.
        {settings}
    Raises:
        InputError: the image cannot be read, or a label becomes no surface.
    """
    settings = settings_among("LabelSettings", locals())
    if table is not None:
        settings["labels"] = table
    if names is not None and os.fspath(settings["labels"]):
        raise InputError("names", "are given beside a table",
                         "give one of them")
    rows = _rows(names or {})
    if isinstance(image, (str, os.PathLike)):
        if affine is not None:
            raise InputError("affine", "is given with a file",
                             "leave it out: the file has its own")
        return Labels(_core.read_label_file(os.fspath(image), settings, rows))
    if hasattr(image, "dataobj") and hasattr(image, "affine"):
        image, affine = image.dataobj, image.affine
    if space not in ("RAS", "LPS", None):
        raise InputError("space", f"is {space!r}",
                         'allowed: "RAS", "LPS", None')
    # Here, as numpy takes longer to load than all of this package.
    from musclewarp._label_array import affine_rows, label_array
    array = label_array(image)
    return Labels(
        _core.read_label_array(array.ravel(order="F"), list(array.shape),
                               affine_rows(affine), space or "", settings, rows))


def _rows(
    names: Mapping[int, Union[str, Mapping[str, str]]]
) -> Dict[int, Dict[str, str]]:
    rows: Dict[int, Dict[str, str]] = {}
    for label, row in names.items():
        if isinstance(label, bool) or not isinstance(label, numbers.Integral):
            raise InputError("names", f"has the label {label!r}",
                             "allowed: whole numbers above 0")
        columns = {"name": row} if isinstance(row, str) else dict(row)
        rows[int(label)] = {str(key): str(value)
                            for key, value in columns.items()}
    return rows
