# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
"""Functions of the library with defaults and conveniences of Python."""
from typing import Any, Dict, Iterable, List, Mapping, Tuple, Union

from musclewarp import _core
from musclewarp._labels import Labels
from musclewarp._progress import Progress, as_function
from musclewarp._settings import documented, settings_among

NamedMeshes = Union[Labels, Mapping[str, Any], Iterable[Any]]


def repair(mesh: Any,
           *,
           max_hole: float = 30.0,
           stitch_tolerance: float = 0.3,
           name: str = "mesh") -> Tuple[_core.Mesh, Dict[str, Any]]:
    """Makes one closed, outward oriented 2-manifold of a mesh.

    Points are merged, triangles oriented, cracks stitched, small holes filled,
    stray pieces dropped (src/musclewarp/mesh_repair/repair.h has the steps). A
    clean mesh stays as it is, bit by bit.

    Args:
        mesh: a Mesh, or anything with points (n, 3), mm, and triangles (m, 3).
        max_hole: holes with a border of at most this length are filled, mm.
        stitch_tolerance: the widest crack that is stitched, mm.
        name: of the mesh, for messages.
    Returns:
        The mesh, and what was done, as "repairs" in docs/report.md.
    Raises:
        InputError: what remains is no closed manifold; says where.
    """
    return _core.repair(mesh, max_hole, stitch_tolerance, name)


@documented("SeparationSettings")
def separate(meshes: NamedMeshes,
             bones: NamedMeshes = (),
             *,
             # Settings of SeparationSettings.
             gap: float = 0.1,
             remake: str = "auto",
             max_hole: float = 30.0,
             max_loss: float = 0.06,
             max_lost_area: float = 100.0,
             max_lost_extent: float = 5.0,
             max_move: float = 5.0,
             # End of settings.
             units: str = "mm",
             progress: Progress = None) -> _core.Frame:
    """Moves vertices as little as it takes for no two meshes to cross.

    Each mesh keeps its volume. This is what musclewarp-separate does
    (docs/separate.md).

    Args:
        meshes: dict of meshes by name, or meshes without names, which are then
            called mesh_1, mesh_2, ...; or Labels, whose muscles move and whose
            bones do not. What labels lost before counts in `max_loss`.
        bones: the same; they do not move, and are not tested with each other.
            Without names they are called bone_1, bone_2, ...
        {settings}
        units: of the points that are given: "mm", "cm" or "m".
        progress: a function of (stage, done, total), or a bar of tqdm.
    Returns:
        A frame, in mm: frame["mesh_1"].points, frame.usable, frame.smallest_gap.
    Raises:
        InputError: a mesh is bad, or the meshes cannot be separated.
    """
    settings = settings_among("SeparationSettings", locals())
    volumes: Dict[str, float] = {}
    named = _named(bones, "bone")
    if isinstance(meshes, Labels):
        volumes, units = meshes.volumes, "mm"
        named = list(meshes.bones.items()) + named
        meshes = meshes.muscles
    return _core.separate(_named(meshes, "mesh"), named, volumes, settings,
                          units, as_function(progress))


def _named(meshes: NamedMeshes, kind: str) -> List[Tuple[str, Any]]:
    if isinstance(meshes, Mapping):
        return list(meshes.items())
    if isinstance(meshes, Labels):
        return list(meshes.bones.items())
    return [(f"{kind}_{i}", mesh) for i, mesh in enumerate(meshes, start=1)]
