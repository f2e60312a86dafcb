# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
"""Joints, found on the shapes of bones."""
import json
import os
import pathlib
import tempfile
from typing import (Any, Dict, Iterable, List, Mapping, Optional, Sequence,
                    Tuple, Union)

from musclewarp import _core
from musclewarp._errors import InputError
from musclewarp._labels import Labels
from musclewarp._scene import Scene, scene_of
from musclewarp._settings import documented, settings_among

_Path = Union[str, "os.PathLike[str]"]


class Articulation:
    """A skeleton with joints, as articulate() finds them. It does not change.

    Attributes:
        joints: list of Joint, those that failed too, from the trunk outwards.
        notes: what has to be known beside the reasons of the joints, such as
            names that are not known as those of bones; sentences.
    """

    def __init__(self,
                 source: _core.ArticulationSource,
                 units: str,
                 labels: Optional[Labels] = None) -> None:
        self._source = source
        self._units = units
        self._labels = labels

    @property
    def joints(self) -> List[_core.Joint]:
        return self._source.joints

    @property
    def notes(self) -> List[str]:
        return self._source.notes

    def report(self) -> Dict[str, Any]:
        """Returns what musclewarp-articulate writes to joints.json.

        Lengths are in mm, angles in degrees. Corrected or not, it may be given
        to articulate() as `given`.
        """
        return self._source.report()

    def model(self, path: _Path, *, name: Optional[str] = None) -> None:
        """Writes an OpenSim model of the skeleton, with the meshes of its bones.

        Args:
            path: of the .osim file. The meshes go to Geometry/<bone>.obj beside
                it. Folders are made.
            name: of the model; None: that of the file, without ".osim".
        Raises:
            InputError: a file cannot be written.
        """
        self._source.write_model(
            os.fspath(path),
            pathlib.Path(path).stem if name is None else name)

    def scene(self,
              muscles: Union[Iterable[_core.Muscle], Mapping[str, Any],
                             None] = None,
              motion: Optional[Mapping[str, Sequence[float]]] = None,
              frames: int = 15,
              *,
              name: str = "scene") -> Scene:
        """Returns a scene in which the joints move the bones, for a Deformer.

            scene = articulation.scene(muscles, {"hip_flexion_r": (-10, 60)})

        The rest pose is that of the scan. Scene.pose_of_model() gives other
        poses of the same joints (in rad). The scene is in memory: it depends on
        no file but those that muscles name by their `path`.

        Args:
            muscles: list of Muscle, or dict of meshes by name, each in a form
                and in the units that articulate() was given. Those without
                lines get them from the meshes. None: those of the labels that
                articulate() was given.
            motion: for each coordinate that moves from where to where, in
                degrees, as in scene files (docs/scene.md). They move together;
                the others stay as they are in the scan, or follow. None: the
                first coordinate moves by 30 degrees from the pose of the scan.
            frames: the number of poses, at equal distances; with 1 the first.
            name: of the scene, for reports.
        Raises:
            InputError: a coordinate that no joint has that was found, two
                muscles or bones of one name, no muscle.
        """
        if muscles is None:
            muscles = self._labels.muscles.values() if self._labels else ()
        with tempfile.TemporaryDirectory(prefix="musclewarp-") as folder:
            return scene_of(
                self._source.scene(_muscles(muscles, self._units),
                                   _sweeps(motion or {}), frames, name,
                                   folder))

    def __repr__(self) -> str:
        joints = ", ".join(f"{joint.name} {joint.quality}"
                           for joint in self.joints)
        return f"<musclewarp.Articulation: {joints}>"


@documented("ArticulationSettings")
def articulate(bones: Union[Mapping[str, Any], Labels],
               *,
               units: str = "mm",
               # Settings of ArticulationSettings.
               side: str = "both",
               joints: Union[str, Sequence[str]] = (),
               zero: str = "anatomy",
               axes: Optional[str] = "LPS",
               given: Union[_Path, Mapping[str, Any], None] = None,
               # End of settings.
               ) -> Articulation:
    """Finds the joints of a skeleton on the shapes of its bones.

        leg = mw.articulate({"hip_right": hip, "femur_r": "femur.ply"})
        for joint in leg.joints:
            print(joint.name, joint.quality, joint.reasons, joint.center)

    This is what musclewarp-articulate does (docs/joints.md), with the same
    results.

    Args:
        bones: dict of meshes by name, in one frame. Names tell what bones
            are: "femur_r", "hip_left", "calcn_r", "os coxae". Bones of other
            names belong to no joint. A mesh is a Mesh, a pair (points,
            triangles), anything that has points and triangles, or the path of a
            mesh file. Or Labels (read_labels), whose muscles are then those of
            Articulation.scene(); `units` and `axes` are those of the image.
        units: of the meshes: "mm", "cm" or "m". All results are in mm.
        {settings}

    `joints` may be a list of names, `axes` None, and `given` also what a file
    has, as a dict, such as a corrected Articulation.report().

    Raises:
        InputError: a mesh is bad, a joint that was asked for lacks its bones,
            no joint has any, or the shape of a femur contradicts its side, as
            in a mirrored image; names the bone.
    """
    if not isinstance(bones, (Mapping, Labels)):
        raise InputError("bones", f"is no dict, but {type(bones).__name__}",
                         "give meshes by the names of bones")
    settings = settings_among("ArticulationSettings", locals())
    if axes is None:
        settings["axes"] = "none"
    text = json.dumps(given) if isinstance(given, Mapping) else ""
    if given is None or text:
        settings["given"] = ""
    if isinstance(bones, Labels):
        return Articulation(
            _core.articulate([], bones._subject, settings, "mm", text), "mm",
            bones)
    return Articulation(
        _core.articulate(list(bones.items()), None, settings, units, text),
        units)


def _sweeps(
    motion: Mapping[str, Sequence[float]]) -> List[Tuple[str, float, float]]:
    sweeps = []
    for coordinate, values in motion.items():
        try:
            first, last = (float(value) for value in values)
        except (TypeError, ValueError):
            raise InputError("motion",
                             f"has {values!r} for {coordinate!r}",
                             "give two numbers, from and to, degrees") from None
        sweeps.append((coordinate, first, last))
    return sweeps


def _muscles(
    muscles: Union[Iterable[_core.Muscle], Mapping[str, Any]],
    units: str) -> List[_core.Muscle]:
    if isinstance(muscles, Mapping):
        return [_muscle(name, mesh, units) for name, mesh in muscles.items()]
    return list(muscles)


def _muscle(name: str, mesh: Any, units: str) -> _core.Muscle:
    if isinstance(mesh, (str, os.PathLike)):
        return _core.Muscle(name, path=mesh, units=units)
    if isinstance(mesh, tuple) and len(mesh) == 2:
        return _core.Muscle(name, *mesh, units=units)
    if not hasattr(mesh, "points"):
        mesh = getattr(mesh, "mesh", mesh)
    return _core.Muscle(name, getattr(mesh, "points", None),
                        getattr(mesh, "triangles", None), units=units)
