# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
"""Scenes: muscles, bones and poses."""
import os
import tempfile
from typing import Iterable, List, Mapping, Optional, Sequence, Tuple, Union

from musclewarp import _core


class Scene:
    """Muscles, bones and poses, in one frame, mm, in the rest pose.

    The lists may be changed until a Deformer is made, which copies them.

    Attributes:
        muscles: list of Muscle.
        bones: list of Bone. A bone moves with its body.
        poses: list of Pose, the poses to compute. A Deformer takes others, too.
        name: of the scene, for reports.
        is_motion: True if the poses follow each other in time, so that each
            frame starts from the one before.
        axes: where +x, +y and +z point, such as "LPS"; for pictures only.
        side: "right" or "left"; for pictures only.
    """

    def __init__(self,
                 muscles: Iterable[_core.Muscle] = (),
                 bones: Iterable[_core.Bone] = (),
                 poses: Iterable[_core.Pose] = (),
                 *,
                 name: str = "scene",
                 is_motion: bool = False,
                 axes: str = "LPS",
                 side: str = "right") -> None:
        self.muscles: List[_core.Muscle] = list(muscles)
        self.bones: List[_core.Bone] = list(bones)
        self.poses: List[_core.Pose] = list(poses)
        self.name = name
        self.is_motion = is_motion
        self.axes = axes
        self.side = side
        self._source = _core.SceneSource()

    @property
    def path(self) -> str:
        """The scene file, or "" of a scene that was made in memory."""
        return self._source.path

    @property
    def design(self) -> str:
        """The design of postures of the scene file, "latin_hypercube" or
        "grid"; "" of other poses. `run()` reaches its poses along a tree as
        long as `poses` are those of the file."""
        return self._source.design

    @property
    def warnings(self) -> List[str]:
        """What was passed over while the scene was read."""
        return self._source.warnings

    @property
    def notes(self) -> List[str]:
        """What was found while the scene was read."""
        return self._source.notes

    def rest_pose(self) -> _core.Pose:
        """Returns the pose in which the meshes were made."""
        return self._assembled().rest_pose()

    def pose_of_model(self,
                      coordinates: Mapping[str, float],
                      *,
                      name: str = "",
                      time: float = 0.0) -> _core.Pose:
        """Returns the pose of the scene at values of its model's coordinates.

        Args:
            coordinates: rad, or m of translations. Those that are not given are
                as in the rest pose.
            name: of the pose.
            time: s.
        Raises:
            InputError: the scene has no model, or the model no such coordinate.
        """
        return self._source.pose_of_model(dict(coordinates), name, time)

    def pose_between(self, first: _core.Pose, last: _core.Pose,
                     part: float) -> _core.Pose:
        """Returns the pose at a part (0 to 1) of the way between two poses.

        With a model its coordinates are interpolated, otherwise bodies move
        along their screw motions.
        """
        return _core.pose_between(self._assembled(), first, last, part)

    def _assembled(self) -> _core.SceneSource:
        return self._source.assemble(self.name, self.muscles, self.bones,
                                     self.poses, self.is_motion, self.axes,
                                     self.side)

    def __repr__(self) -> str:
        return (f"<musclewarp.Scene {self.name!r}: {len(self.muscles)} muscles, "
                f"{len(self.bones)} bones, {len(self.poses)} poses>")


def read_scene(path: Union[str, "os.PathLike[str]"],
               data_root: Union[str, "os.PathLike[str]"] = "",
               motion: Union[str, "os.PathLike[str]"] = "",
               geometry: Sequence[Union[str, "os.PathLike[str]"]] = (),
               motion_in_degrees: Optional[bool] = None) -> Scene:
    """Reads a scene file (docs/scene.md), its model and its motion.

    Args:
        path: of the scene file.
        data_root: the folder that paths in the file are relative to; without it
            the folder of the file.
        motion: an OpenSim motion (.mot, .sto) in place of the scene's.
        geometry: folders with meshes of the model, beside its own and the
            folder Geometry there.
        motion_in_degrees: whether angles of the motion are in degrees,
            whatever its header says.
    Raises:
        InputError: names the file and the field.
    """
    source = _core.read_scene(os.fspath(path), os.fspath(data_root),
                              os.fspath(motion),
                              [os.fspath(folder) for folder in geometry],
                              motion_in_degrees)
    return scene_of(source)


def scene_of(source: _core.SceneSource) -> Scene:
    """Returns the scene for users that a scene of the library is."""
    scene = Scene(source.muscles, source.bones, source.poses, name=source.name,
                  is_motion=source.is_motion, axes=source.axes,
                  side=source.side)
    scene._source = source
    return scene


def demo_scene(folder: Union[str, "os.PathLike[str]", None] = None) -> Scene:
    """Returns the scene that is inside the package: a hip that is nobody's.

    Args:
        folder: if given, FOLDER/scene keeps the files of the scene (meshes, an
            OpenSim model, a motion), as an example for files of one's own.
    Raises:
        InputError: the folder cannot be written.
    """
    if folder is not None:
        return read_scene(_core.write_demo_scene(os.fspath(folder)))
    with tempfile.TemporaryDirectory(prefix="musclewarp-") as work:
        scene = read_scene(_core.write_demo_scene(work))
        scene.muscles = [
            _core.Muscle(m.name, m.mesh.points, m.mesh.triangles,
                         lines=m.lines, attachments=m.attachments,
                         ends_on=m.ends_on, end_bodies=m.end_bodies)
            for m in scene.muscles
        ]
        scene.bones = [
            _core.Bone(b.name, b.mesh.points, b.mesh.triangles, body=b.body)
            for b in scene.bones
        ]
        return scene
