# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
"""The deformer, and runs of many frames."""
import json
import os
import tempfile
from typing import Any, Dict, Iterable, Optional, Union

from musclewarp import _core
from musclewarp._page import Page, page
from musclewarp._progress import Progress, as_function
from musclewarp._scene import Scene
from musclewarp._settings import documented, settings_among


@documented("DeformerSettings")
class Deformer(_core.Deformer):
    """Deforms the muscles of a scene: the whole of musclewarp in one class.

        deformer = mw.Deformer(scene, gap=0.1)
        for pose in scene.poses:
            frame = deformer.move_to(pose)

    Making one repairs the meshes and separates those that overlap, which takes
    seconds; a frame takes a fraction of one. The interpreter is free meanwhile,
    and Ctrl-C stops either within a second. Several threads may use a deformer:
    each waits for its turn.

    Args:
        scene: a Scene; it is copied.
        progress: a function of (stage, done, total), which may raise to stop
            the computation, or a bar of tqdm.
        {settings}

    The settings are the flags of musclewarp-deform (docs/settings.md).

    Raises:
        InputError: the scene contradicts itself, a mesh cannot be repaired, the
            rest pose cannot be made free of crossings, or a keyword has a value
            that is not allowed.
    """

    def __init__(self,
                 scene: Scene,
                 *,
                 progress: Progress = None,
                 # Settings of DeformerSettings.
                 contact: str = "certified",
                 gap: float = 0.1,
                 remake: str = "auto",
                 max_hole: float = 30.0,
                 max_loss: float = 0.06,
                 max_lost_area: float = 100.0,
                 max_lost_extent: float = 5.0,
                 max_torn_patch: float = 0.0,
                 solver: str = "ceres",
                 attachments: str = "auto",
                 auto_lines: int = 3,
                 made_lines: str = "taut",
                 fibres: int = 0,
                 coarse_vertices: int = 200,
                 laplacian: str = "area",
                 laplacian_length: float = 0.0,
                 lines: str = "tendon",
                 sample_spacing: float = 10.0,
                 skeleton_weight: float = 1.0,
                 attachment_weight: float = 8.0,
                 bending_weight: float = 2.0,
                 body_twist: bool = True,
                 bone_push: bool = True,
                 max_rounds: int = 6,
                 max_step_turn: float = 20.0,
                 max_step_move: float = 80.0,
                 frame_timeout_s: float = -1.0,
                 max_iterations: int = 500,
                 contact_level: str = "coarse",
                 bone_coarse_vertices: int = 1000,
                 seed: int = 1,
                 cache: Union[str, "os.PathLike[str]"] = "none",
                 max_memory_gib: float = 0.0,
                 # End of settings.
                 ) -> None:
        settings = settings_among("DeformerSettings", locals())
        super().__init__(scene._assembled(), settings, as_function(progress))


class Run(_core.Run):
    """Frames of one deformer, and what musclewarp-deform makes of them.

        run = mw.Run(deformer)
        for pose in scene.poses:
            run.append(deformer.move_to(pose))
        run.write("out")

    `lengths`, `volumes`, `moment_arms`, `fibre_lengths` and
    `fibre_moment_arms` are Tables (docs/motion.md).
    """

    def __init__(self, deformer: Deformer) -> None:
        super().__init__(deformer)

    def write(self,
              out: Union[str, "os.PathLike[str]"],
              format: str = "ply",
              overwrite: bool = False,
              bones: str = "every") -> None:
        """Writes the frames, tables and report.json as musclewarp-deform does.

        Frames of an earlier run in the folder are removed.

        Args:
            out: the folder; it is made.
            format: of the meshes: "ply", "obj", "vtp", or several with commas.
            overwrite: whether to remove frames, too, that belong to no run
                that report.json there names.
            bones: which folders have the meshes of bones: "every" (those of
                all frames) or "once" (the rest folder only; frames have
                the motions of the bones in bones.json. "vtp" has them in
                every frame all the same).
        Raises:
            InputError: the folder cannot be written, or has such frames; or
                there is no frame.
        """
        super().write(os.fspath(out), format, overwrite, bones)

    def fit_paths(self, paths_per_muscle: int = 0) -> _core.PathFunctions:
        """Returns lengths and moment arms as functions of the coordinates.

        They hold between the postures of the run; best is one of a design of
        postures (docs/motion.md).

        Args:
            paths_per_muscle: 0 for the lines of the muscles; n for at most n
                bands of the fibres of each (fibres=40 of the Deformer).
        Raises:
            InputError: the scene has no model, or the frames no moment arms.
        """
        return _core.fit_run(self, paths_per_muscle)

    def page(self) -> Page:
        """Returns the page of the run (docs/page.md), for a notebook or a file.

        The frames are written to a folder of their own for a moment, as what
        the page shows is read back and counted anew.
        """
        with tempfile.TemporaryDirectory(prefix="musclewarp-") as folder:
            out = os.path.join(folder, "run")
            self.write(out)
            return page(out)


def run(scene: Scene,
        poses: Optional[Iterable[_core.Pose]] = None,
        *,
        progress: Progress = None,
        **settings: Any) -> Run:
    """Deforms a scene in all its poses, as musclewarp-deform does.

    Args:
        scene: a Scene.
        poses: in place of those of the scene.
        progress: as of Deformer; also called with "frames", how many are done
            and how many there are.
        settings: the other keywords of Deformer.
    """
    function = as_function(progress)
    deformer = Deformer(scene, progress=function, **settings)
    result = Run(deformer)
    given = None if poses is None else list(poses)
    count = len(scene.poses if given is None else given)
    for number in range(count):
        if given is None:
            frame = deformer.solve(number)
        elif scene.is_motion:
            frame = deformer.move_to(given[number])
        else:
            frame = deformer.solve_alone(given[number])
        result.append(frame)
        if function is not None:
            function("frames", number + 1, count)
    return result
