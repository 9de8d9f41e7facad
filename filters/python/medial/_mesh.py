"""Meshes as they come in and go out."""

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray
from vtkmodules.vtkCommonDataModel import vtkPolyData

from ._arrays import check_indices, float_rows, index_rows, rows_to_cells, to_cells, to_points
from ._errors import InvalidInputError


class Surface(NamedTuple):
    """A triangle mesh: what the functions of this package take as vertices and faces."""

    vertices: NDArray[np.float64]
    """(n, 3) coordinates in world units."""
    faces: NDArray[np.int64]
    """(m, 3) indices of vertices."""

    def to_vtk(self) -> vtkPolyData:
        """As VTK's mesh, which shares the memory of the vertices."""
        return to_polydata(self.vertices, self.faces)


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
            f"VTK's readers, such as vtkSTLReader") from None


def _set_faces(mesh: vtkPolyData, faces: Any, points: int) -> None:
    """Cells by the number of their corners."""
    if isinstance(faces, np.ndarray) or len({len(face) for face in faces}) <= 1:
        rows = index_rows(faces if len(faces) > 0 else np.empty((0, 3), int), "faces", points)
        cells = rows_to_cells(rows)
        if rows.shape[1] == 1:
            mesh.SetVerts(cells)
        elif rows.shape[1] == 2:
            mesh.SetLines(cells)
        else:
            mesh.SetPolys(cells)
        return
    sizes = np.array([len(face) for face in faces])
    if sizes.min() < 3:
        raise InvalidInputError(
            f"face {sizes.argmin()} has {sizes.min()} vertices; where their number differs from "
            f"face to face at least 3 are needed")
    connectivity = np.concatenate([np.asarray(face, dtype=np.int64) for face in faces])
    check_indices(connectivity, "faces", points)
    mesh.SetPolys(to_cells(sizes, connectivity))
