# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
"""Meshes of bones and what scanners, programs and people do to them. Needs vtk."""

from __future__ import annotations

import dataclasses
import pathlib

import numpy as np
import vtk
from vtkmodules.util.numpy_support import (
    numpy_to_vtk,
    numpy_to_vtkIdTypeArray,
    vtk_to_numpy,
)

MIRROR = np.diag([-1.0, 1.0, 1.0, 1.0])  # at x = 0


@dataclasses.dataclass(frozen=True)
class Mesh:
    points: np.ndarray  # n x 3, mm
    triangles: np.ndarray  # m x 3


def _to_vtk(mesh: Mesh) -> vtk.vtkPolyData:
    points = vtk.vtkPoints()
    points.SetDataTypeToDouble()
    points.SetData(numpy_to_vtk(np.ascontiguousarray(mesh.points, float), deep=True))
    corners = np.ascontiguousarray(mesh.triangles.ravel(), np.int64)
    starts = np.arange(0, len(corners) + 1, 3, dtype=np.int64)
    cells = vtk.vtkCellArray()
    cells.SetData(
        numpy_to_vtkIdTypeArray(starts, deep=True),
        numpy_to_vtkIdTypeArray(corners, deep=True),
    )
    poly = vtk.vtkPolyData()
    poly.SetPoints(points)
    poly.SetPolys(cells)
    return poly


def _from_vtk(poly: vtk.vtkPolyData) -> Mesh:
    triangulate = vtk.vtkTriangleFilter()
    triangulate.SetInputData(poly)
    triangulate.PassLinesOff()
    triangulate.PassVertsOff()
    triangulate.Update()
    poly = triangulate.GetOutput()
    corners = vtk_to_numpy(poly.GetPolys().GetConnectivityArray())
    return Mesh(
        vtk_to_numpy(poly.GetPoints().GetData()).astype(float),
        corners.reshape(-1, 3).astype(np.int64),
    )


def _applied(algorithm: vtk.vtkPolyDataAlgorithm, mesh: Mesh) -> Mesh:
    algorithm.SetInputData(_to_vtk(mesh))
    algorithm.Update()
    return _from_vtk(algorithm.GetOutput())


def read_mesh(path: pathlib.Path) -> Mesh:
    readers = {".ply": vtk.vtkPLYReader, ".obj": vtk.vtkOBJReader}
    reader = readers[path.suffix]()
    reader.SetFileName(str(path))
    reader.Update()
    return _applied(vtk.vtkCleanPolyData(), _from_vtk(reader.GetOutput()))


def write_mesh(mesh: Mesh, path: pathlib.Path) -> None:
    writer = vtk.vtkPLYWriter()
    writer.SetFileName(str(path))
    writer.SetInputData(_to_vtk(mesh))
    writer.Write()


def moved(mesh: Mesh, matrix: np.ndarray) -> Mesh:
    """Moved by a 4 x 4 matrix; triangles keep their outside if it mirrors."""
    points = mesh.points @ matrix[:3, :3].T + matrix[:3, 3]
    mirrors = np.linalg.det(matrix[:3, :3]) < 0
    return Mesh(points, mesh.triangles[:, ::-1] if mirrors else mesh.triangles)


def random_motion(seed: int) -> np.ndarray:
    """Any turn with the same chance, and a shift of up to 300 mm."""
    random = np.random.default_rng(seed)
    q = random.normal(size=4)
    w, x, y, z = q / np.linalg.norm(q)
    matrix = np.eye(4)
    matrix[:3, :3] = [
        [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
        [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
        [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
    ]
    matrix[:3, 3] = random.uniform(-300, 300, size=3)
    return matrix


def decimated(mesh: Mesh, triangles: int) -> Mesh:
    if len(mesh.triangles) <= triangles:
        return mesh
    decimation = vtk.vtkQuadricDecimation()
    decimation.SetTargetReduction(1 - triangles / len(mesh.triangles))
    return _applied(decimation, mesh)


def _is_open(mesh: Mesh) -> bool:
    edges = np.sort(mesh.triangles[:, [[0, 1], [1, 2], [2, 0]]].reshape(-1, 2), axis=1)
    return bool((np.unique(edges, axis=0, return_counts=True)[1] == 1).any())


def _closed(mesh: Mesh) -> Mesh:
    if not _is_open(mesh):
        return mesh
    fill = vtk.vtkFillHolesFilter()
    fill.SetHoleSize(1e6)
    return _applied(fill, mesh)


def _image_of(mesh: Mesh, spacing: float) -> vtk.vtkImageData:
    low = np.floor(mesh.points.min(axis=0) / spacing).astype(int) - 2
    high = np.ceil(mesh.points.max(axis=0) / spacing).astype(int) + 2
    image = vtk.vtkImageData()
    image.SetSpacing(spacing, spacing, spacing)
    image.SetOrigin(*(low * spacing))
    image.SetDimensions(*(int(size) for size in high - low + 1))
    image.AllocateScalars(vtk.VTK_UNSIGNED_CHAR, 1)
    image.GetPointData().GetScalars().Fill(1)
    to_stencil = vtk.vtkPolyDataToImageStencil()
    to_stencil.SetInputData(_to_vtk(_closed(mesh)))
    to_stencil.SetOutputOrigin(image.GetOrigin())
    to_stencil.SetOutputSpacing(image.GetSpacing())
    to_stencil.SetOutputWholeExtent(image.GetExtent())
    stencil = vtk.vtkImageStencil()
    stencil.SetInputData(image)
    stencil.SetStencilConnection(to_stencil.GetOutputPort())
    stencil.SetBackgroundValue(0)
    stencil.Update()
    return stencil.GetOutput()


def from_voxels(mesh: Mesh, spacing: float) -> Mesh:
    """The faces between voxels (mm) with the middle in the bone and others."""
    contour = vtk.vtkDiscreteFlyingEdges3D()
    contour.SetInputData(_image_of(mesh, spacing))
    contour.SetValue(0, 1)
    contour.ComputeNormalsOff()
    contour.ComputeScalarsOff()
    contour.Update()
    return _from_vtk(contour.GetOutput())


def smoothed(mesh: Mesh) -> Mesh:
    smooth = vtk.vtkWindowedSincPolyDataFilter()
    smooth.SetNumberOfIterations(15)
    smooth.SetPassBand(0.1)
    smooth.NormalizeCoordinatesOn()
    smooth.NonManifoldSmoothingOn()
    smooth.BoundarySmoothingOff()
    return _applied(smooth, mesh)


def noisy(mesh: Mesh, deviation: float, seed: int) -> Mesh:
    """Vertices moved along their normals by normal noise (mm)."""
    a, b, c = (mesh.points[mesh.triangles[:, i]] for i in range(3))
    normals = np.zeros_like(mesh.points)
    for i in range(3):
        np.add.at(normals, mesh.triangles[:, i], np.cross(b - a, c - a))
    normals /= np.maximum(np.linalg.norm(normals, axis=1, keepdims=True), 1e-12)
    noise = np.random.default_rng(seed).normal(0, deviation, (len(mesh.points), 1))
    return Mesh(mesh.points + noise * normals, mesh.triangles)


def inverted(mesh: Mesh) -> Mesh:
    return Mesh(mesh.points, mesh.triangles[:, ::-1])


def with_holes(mesh: Mesh, share: float, seed: int) -> Mesh:
    keeps = np.random.default_rng(seed).random(len(mesh.triangles)) >= share
    return Mesh(mesh.points, mesh.triangles[keeps])


def cut(mesh: Mesh, point: np.ndarray, normal: np.ndarray, closed: bool = True) -> Mesh:
    """The part behind a plane; the cut is closed as in the mesh of a label image."""
    plane = vtk.vtkPlane()
    plane.SetOrigin(*point)
    plane.SetNormal(*(-np.asarray(normal)))
    if not closed:
        clip = vtk.vtkClipPolyData()
        clip.SetClipFunction(plane)
        return _applied(clip, mesh)
    planes = vtk.vtkPlaneCollection()
    planes.AddItem(plane)
    clip_closed = vtk.vtkClipClosedSurface()
    clip_closed.SetClippingPlanes(planes)
    return _applied(clip_closed, mesh)


def sphere(center: np.ndarray, radius: float) -> Mesh:
    source = vtk.vtkSphereSource()
    source.SetCenter(*center)
    source.SetRadius(radius)
    source.SetThetaResolution(60)
    source.SetPhiResolution(40)
    source.Update()
    return _from_vtk(source.GetOutput())


def box(low: np.ndarray, high: np.ndarray) -> Mesh:
    source = vtk.vtkCubeSource()
    source.SetBounds(*np.column_stack([low, high]).ravel())
    source.Update()
    return _applied(vtk.vtkCleanPolyData(), _from_vtk(source.GetOutput()))
