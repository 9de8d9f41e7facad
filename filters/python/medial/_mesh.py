"""Meshes as they come in and go out."""

import math
import os
from collections.abc import Callable
from os import PathLike
from typing import Any, NamedTuple, Union

import numpy as np
from numpy.typing import NDArray
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData

from . import _files
from ._arrays import float_rows, index_rows, rows_to_cells, to_cells, to_points
from ._errors import InvalidInputError, OutOfMemoryError

_WHOLE_MESH = "pass a mesh of pyvista or VTK itself, in place of vertices and faces"


class Surface(NamedTuple):
    """A mesh: what the functions of this package take as vertices and faces."""

    vertices: NDArray[np.float64]
    """(n, 3) coordinates in world units."""
    faces: NDArray[np.int64]
    """(m, k) indices of vertices; triangles (k = 3) where this package makes them."""

    def to_vtk(self) -> vtkPolyData:
        """As VTK's mesh, which shares the memory of the vertices."""
        return to_polydata(self.vertices, self.faces)


def read_mesh(path: Union[str, PathLike[str]]) -> Surface:
    """Reads a mesh from a file: .stl, .obj, .ply, .off, .vtp or .vtk (VTK's legacy format).

    A file that was cut short, or contradicts itself, is refused; it is never read in part. Points
    at the same place become one, polygons become triangles, and points and lines between them are
    left out.

    path: name of the file.

    Raises InvalidInputError where the file cannot be read, or has no faces.
    """
    name = os.fsdecode(path)
    surface = surface_of(_files.read_mesh, name)
    if len(surface.faces) == 0:
        raise InvalidInputError(f"{name}: the mesh has no faces")
    return surface


def surface_of(read: Callable[..., tuple[bytes, bytes]], *arguments: Any) -> Surface:
    """What a function of _files reads; its errors become those of this package."""
    try:
        points, triangles = read(*arguments)
    except MemoryError as error:
        raise OutOfMemoryError(str(error)) from None
    except ValueError as error:
        raise InvalidInputError(str(error)) from None
    return Surface(np.frombuffer(points).reshape(-1, 3).copy(),
                   np.frombuffer(triangles, np.int32).reshape(-1, 3).astype(np.int64))


def length(name: str, value: Any, mesh: vtkPolyData) -> Any:
    """A length as a function takes it: a number, or text such as "2%", of the diagonal of the bounds
    of the mesh's cells. The number is left to the caller to check."""
    if not isinstance(value, str) or not value.endswith("%"):
        return value
    try:
        share = float(value[:-1])
    except ValueError:
        raise InvalidInputError(f"{name} {value!r} is not a length, such as 0.5 or '2%'") from None
    bounds = [0.0] * 6
    mesh.GetCellsBounds(bounds)
    diagonal = math.dist(bounds[0::2], bounds[1::2])
    # Whatever the length, the filter says what is wrong with a mesh that is infinite or a point.
    return 0.01 * share * (diagonal if 0 < diagonal < math.inf else 1.0)


def is_whole(mesh: Any) -> bool:
    """Whether an object is a mesh with vertices and faces of its own."""
    return isinstance(mesh, vtkPolyData) or (hasattr(mesh, "vertices") and hasattr(mesh, "faces"))


def to_polydata(vertices: Any, faces: Any = None) -> vtkPolyData:
    """The mesh that a function of this package was called with; never the caller's own object.

    Vertices are not copied where they are a C-contiguous array of float32 or float64.
    """
    if isinstance(vertices, vtkPolyData):
        if faces is not None:
            raise TypeError("a vtkPolyData has its own faces: leave out the second argument")
        mesh = vtkPolyData()
        mesh.ShallowCopy(vertices)
        return mesh
    if faces is None:
        vertices, faces = _parts_of(vertices)
    points = float_rows(vertices, "vertices", 3)
    mesh = vtkPolyData()
    mesh.SetPoints(to_points(points))
    _set_faces(mesh, faces, len(points))
    return mesh


def _parts_of(mesh: Any) -> tuple[Any, Any]:
    """Vertices and faces of an object that has both, as the meshes of trimesh and Surface do."""
    try:
        return mesh.vertices, mesh.faces
    except AttributeError:
        raise TypeError(
            f"a mesh is given as vertices and faces, as a vtkPolyData, or as an object with the "
            f"attributes vertices and faces, not as {type(mesh).__name__} alone; files are read by "
            f"read_mesh() and VTK's readers, such as vtkSTLReader") from None


def _set_faces(mesh: vtkPolyData, faces: Any, points: int) -> None:
    """Sets the cells, by the number of their corners."""
    if isinstance(faces, np.ndarray) and faces.ndim == 1 and faces.size > 0:
        raise InvalidInputError(f"faces have the shape {faces.shape}, not (m, k); {_WHOLE_MESH}")
    sizes = _sizes_of(faces)
    if len(set(sizes)) > 1:
        mesh.SetPolys(_polygons(faces, sizes, points))
        return
    rows = index_rows(faces if sizes else np.empty((0, 3), dtype=np.int64), "faces", points)
    cells = rows_to_cells(rows)
    if rows.shape[1] == 1:
        mesh.SetVerts(cells)
    elif rows.shape[1] == 2:
        mesh.SetLines(cells)
    else:
        mesh.SetPolys(cells)


def _sizes_of(faces: Any) -> list[int]:
    """Numbers of corners, of an array only that of the first face."""
    if isinstance(faces, np.ndarray):
        return [faces.shape[-1]] if faces.size > 0 else []
    try:
        return [len(face) for face in faces]
    except TypeError:
        raise InvalidInputError(
            "faces are neither an array nor a sequence of sequences of vertex indices; "
            + _WHOLE_MESH) from None


def _polygons(faces: Any, sizes: list[int], points: int) -> vtkCellArray:
    """Faces with different numbers of corners."""
    if min(sizes) < 3:
        raise InvalidInputError(
            f"face {sizes.index(min(sizes))} has {min(sizes)} vertices; where their number differs "
            f"from face to face at least 3 are needed")
    joined = index_rows([[index] for face in faces for index in face], "faces", points)
    return to_cells(np.array(sizes), joined[:, 0])
