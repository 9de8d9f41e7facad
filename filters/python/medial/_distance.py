"""Distances of points from a mesh."""

from typing import Any, NamedTuple, Optional

import numpy as np
from numpy.typing import NDArray
from vtkmodules.vtkCommonDataModel import vtkPolyData

from ._arrays import figure, float_rows, point_data, points_with, rows_to_cells, to_points
from ._mesh import is_whole, to_polydata
from ._options import SIGNS, Sign, assign, assign_numbers, choice
from ._update import Progress, run
from .vtkMedialFilters import vtkMeshPointDistance

# Attributes of PointDistances, and the point data arrays of vtkMeshPointDistance with their
# components.
_ARRAYS = {
    "distance": ("Distance", 1),
    "closest_point": ("ClosestPoint", 3),
    "cell": ("ClosestCell", 1),
    "feature": ("ClosestFeature", 1),
    "direction": ("Direction", 3),
}


class PointDistances(NamedTuple):
    """What the surface of a mesh is like from each of n points."""

    distance: NDArray[np.float64]
    """(n,) distances to the closest points of the surface, in world units; negative inside, unless
    sign is "none"."""
    closest_point: NDArray[np.float64]
    """(n, 3) those closest points."""
    cell: NDArray[np.int64]
    """(n,) indices of faces that contain them; cell ids of a vtkPolyData."""
    feature: NDArray[np.uint8]
    """(n,) what they lie on: 0 a vertex, 1 an edge, 2 a face."""
    direction: NDArray[np.float64]
    """(n, 3) unit vectors from the points to their closest points; 0 on the surface."""
    sign: Sign
    """How inside was told from outside: "none", "pseudonormal" or "winding"."""
    points: NDArray[np.floating[Any]]
    """(n, 3) the points themselves, float32 or float64; the caller's array where it is one in C
    order."""

    def to_vtk(self) -> vtkPolyData:
        """As VTK's mesh of the points, a vertex each, with the point data arrays of
        vtkMeshPointDistance. Shares the memory of all arrays.

        Raises InvalidInputError where arrays do not fit each other.
        """
        mesh = points_with(_ARRAYS, self, "Distance")
        mesh.SetVerts(rows_to_cells(np.arange(len(self.points))[:, np.newaxis]))
        return mesh


def distance(vertices: Any, faces: Any = None, points: Any = None, *, sign: Sign = "auto",
             threads: int = 0, progress: Optional[Progress] = None) -> PointDistances:
    """Signed distances of points from a mesh, exact in double precision and without a grid.

    vertices, faces: the mesh, as for distance_field(). After a whole mesh come the points:
        distance(mesh, points).
    points: (n, 3) coordinates in world units, float32 or float64.
    sign: how inside, where distances are negative, is told from outside, as for distance_field().
    threads: number of CPU threads to use, in [0, 1024]; 0 for all cores.
    progress: as for distance_field().

    The result depends neither on threads nor on which points are asked for together. For many
    batches of points and one mesh keep a vtkMeshPointDistance: it keeps what it has prepared.
    Raises what distance_field() raises, but needs no OpenGL.

    >>> cube = [[x, y, z] for x in (0, 1) for y in (0, 1) for z in (0, 1)]
    >>> quads = [[0, 1, 3, 2], [4, 6, 7, 5], [0, 4, 5, 1], [2, 3, 7, 6], [0, 2, 6, 4], [1, 5, 7, 3]]
    >>> distance(cube, quads, [[0.5, 0.5, 0.75], [0.5, 4, 5]]).distance
    array([-0.25,  5.  ])
    """
    if points is None and is_whole(vertices):
        faces, points = None, faces
    if points is None:
        raise TypeError("points are missing: an (n, 3) array of coordinates is needed after the mesh")
    rows = float_rows(points, "points", 3)
    targets = vtkPolyData()
    targets.SetPoints(to_points(rows))
    algorithm = vtkMeshPointDistance()
    algorithm.SetInputDataObject(targets)
    algorithm.SetSurfaceData(to_polydata(vertices, faces))
    assign_numbers(algorithm, threads=threads)
    assign(algorithm, SignMethod=choice("sign", sign, SIGNS))
    run(algorithm, progress)
    output = algorithm.GetOutput()
    return PointDistances(
        **{attribute: point_data(output, name) for attribute, (name, _) in _ARRAYS.items()},
        sign=figure(output, "SignMethod").lower(), points=rows)
