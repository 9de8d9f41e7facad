"""Proximity of two meshes."""

from dataclasses import dataclass
from typing import Any, NamedTuple, Optional

import numpy as np
from numpy.typing import NDArray
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkCommonTransforms import vtkTransform

from ._arrays import figure, point_coordinates, point_data
from ._errors import InvalidInputError
from ._mesh import to_polydata
from ._options import assign, assign_numbers
from ._update import Progress, update
from .vtkMedialFilters import vtkMeshProximity

_WITNESS, _CONTACT = 0, 1  # of the point data array Kind


class Contacts(NamedTuple):
    """The n places where two meshes, A and B, touch or overlap."""

    points: NDArray[np.float64]
    """(n, 3) places on the surface that is inside the other mesh, world coordinates."""
    normals: NDArray[np.float64]
    """(n, 3) unit vectors from A to B: moving B along one separates the meshes there."""
    depths: NDArray[np.float64]
    """(n,) how deep each is, in world units, >= 0."""
    manifolds: NDArray[np.int32]
    """(n,) numbers from 0 on, the same for the contacts of one connected overlap."""
    cells_a: NDArray[np.int64]
    """(n,) indices of faces of A; cell ids of a vtkPolyData."""
    cells_b: NDArray[np.int64]
    """(n,) indices of faces of B; cell ids of a vtkPolyData."""


@dataclass(frozen=True, eq=False, repr=False)
class Proximity:
    """Proximity of two meshes, A and B. All lengths are in world units."""

    separation: float
    """Smallest distance between the surfaces; 0 if and only if they intersect, infinite beyond
    max_separation, NaN if not asked for."""
    witness_a: Optional[NDArray[np.float64]]
    """(3,) the closest point of A; if they intersect, a common point. World coordinates. None if
    the separation was not computed."""
    witness_b: Optional[NDArray[np.float64]]
    """(3,) the closest point of B, likewise."""
    cell_a: int
    """Index of the face of A that has its witness; cell id of a vtkPolyData. -1 for none."""
    cell_b: int
    """Index of the face of B that has its witness; cell id of a vtkPolyData. -1 for none."""
    intersect: bool
    """Whether the surfaces intersect, touching included."""
    collide: bool
    """Whether they intersect, or one solid contains a part of the other mesh."""
    inside_undefined: bool
    """Whether an open mesh does not define its inside."""
    depth: Optional[float]
    """Penetration depth: largest distance of a surface point of one mesh inside the other to the
    other's surface; 0 if they do not collide, NaN if inside is undefined, None if not asked for."""
    depth_at_most: Optional[float]
    """No surface point of one mesh inside the other is deeper; otherwise as depth."""
    deepest_point: Optional[NDArray[np.float64]]
    """(3,) where depth is, world coordinates; NaN if there is no such point."""
    depths_a: Optional[NDArray[np.float64]]
    """(n,) for each vertex of A its distance to the surface of B if it is inside, else 0; NaN where
    inside is undefined and at vertices of no face."""
    depths_b: Optional[NDArray[np.float64]]
    """(m,) the same for each vertex of B."""
    contacts: Contacts
    """Where they are in contact, the deepest of each overlap first."""
    translational_depth: Optional[tuple[float, float]]
    """Lower and upper bound on the length of the shortest translation that separates the solids; 0
    if they do not collide, None if not asked for. The upper one is infinite where the translation
    is unknown: inside is undefined, or the meshes collide and depths were not asked for."""
    separating_translation: Optional[NDArray[np.float64]]
    """(3,) a translation of A that separates them, as long as the upper bound; NaN where that is
    infinite."""
    seconds: float
    """The wall-clock time that it took, without conversions."""

    def __repr__(self) -> str:
        state = "collide" if self.collide else "do not collide"
        return (f"<Proximity: the meshes {state}, separation {self.separation:g}, "
                f"{len(self.contacts.points)} contacts>")


def proximity(
    vertices_a: Any, faces_a: Any, vertices_b: Any, faces_b: Any = None, *,
    transform_a: Any = None, transform_b: Any = None, separation: bool = True,
    max_separation: float = np.inf, depths: bool = True, translational_depth: bool = True,
    max_contacts: int = 4, depth_tolerance: float = 1e-3, threads: int = 0,
    progress: Optional[Progress] = None,
) -> Proximity:
    """Proximity of two meshes: separation, collision, contacts and penetration depth.

    Exact for the meshes as they are, without a grid. For frames of moving meshes, keep one
    vtkMeshProximity: it reuses what it has built.

    vertices_a, faces_a: mesh A, as for distance_field(); faces_a is None where vertices_a is a
        whole mesh.
    vertices_b, faces_b: mesh B, in the same way.
    transform_a, transform_b: (4, 4) matrices by which the meshes are moved first, with the last row
        (0, 0, 0, 1) and a determinant that is not 0.
    separation: whether to compute the separation of meshes that do not intersect, and witnesses.
    max_separation: meshes whose bounding boxes are farther apart are not compared; >= 0.
    depths: whether to compute how deep the meshes are inside each other, and what needs it:
        contacts and the translational depth.
    translational_depth: whether to bound the length of the shortest translation that separates
        them.
    max_contacts: largest number of contacts of one connected overlap, in [0, 2147483647].
    depth_tolerance: how far Proximity.depth may be below the true maximum, as a fraction of it, in
        (0, 1).
    threads: number of CPU threads to use, in [0, 1024]; 0 for all cores.
    progress: as for distance_field().

    Raises what distance_field() raises, but needs no OpenGL. Messages call the meshes A and B.

    >>> cube = [[x, y, z] for x in (0, 1) for y in (0, 1) for z in (0, 1)]
    >>> quads = [[0, 1, 3, 2], [4, 6, 7, 5], [0, 4, 5, 1], [2, 3, 7, 6], [0, 2, 6, 4], [1, 5, 7, 3]]
    >>> shift = np.eye(4)
    >>> shift[0, 3] = 3
    >>> proximity(cube, quads, cube, quads, transform_b=shift).separation
    2.0
    """
    algorithm = vtkMeshProximity()
    for port, mesh in enumerate((to_polydata(vertices_a, faces_a),
                                 to_polydata(vertices_b, faces_b))):
        algorithm.SetInputData(port, mesh)
    assign_numbers(algorithm, max_separation=max_separation, max_contacts=max_contacts,
                   depth_tolerance=depth_tolerance, threads=threads)
    assign(algorithm, Separation=bool(separation), Depths=bool(depths),
           TranslationalDepth=bool(translational_depth),
           TransformA=_transform("transform_a", transform_a),
           TransformB=_transform("transform_b", transform_b))
    update(algorithm, progress)
    return _proximity_of(algorithm)


def _transform(name: str, matrix: Any) -> Optional[vtkTransform]:
    """VTK's transform of a matrix."""
    if matrix is None:
        return None
    try:
        values = np.asarray(matrix, dtype=np.float64)
    except (TypeError, ValueError) as error:
        raise InvalidInputError(f"{name} is not of numbers: {error}") from None
    if values.shape != (4, 4):
        raise InvalidInputError(f"{name} has the shape {values.shape}, not (4, 4)")
    if not np.array_equal(values[3], (0, 0, 0, 1)):
        raise InvalidInputError(f"{name} has the last row {values[3]}, not (0, 0, 0, 1)")
    transform = vtkTransform()
    transform.SetMatrix(values.ravel())
    return transform


def _tuple(data: vtkPolyData, name: str) -> Optional[NDArray[np.float64]]:
    """The components of a field data array of one tuple; None where there is none."""
    array = data.GetFieldData().GetArray(name)
    return vtk_to_numpy(array)[0] if array else None


def _proximity_of(algorithm: vtkMeshProximity) -> Proximity:
    """The results of a filter that was executed."""
    output = algorithm.GetOutput()
    bounds = _tuple(output, "TranslationalDepth")
    points = point_coordinates(output)
    cells = [point_data(output, name) for name in ("CellA", "CellB")]
    witnesses = np.flatnonzero(point_data(output, "Kind") == _WITNESS)
    contacts = point_data(output, "Kind") == _CONTACT
    of_contacts = (point_data(output, name)[contacts] for name in ("Normal", "Depth", "Manifold"))
    of_points = (point_data(mesh, "PenetrationDepth") if algorithm.GetDepths() else None
                 for mesh in (algorithm.GetMovedA(), algorithm.GetMovedB()))
    depths_a, depths_b = of_points
    return Proximity(
        separation=figure(output, "Separation"),
        witness_a=points[witnesses[0]] if len(witnesses) else None,
        witness_b=points[witnesses[-1]] if len(witnesses) else None,
        cell_a=int(cells[0][witnesses[0]]) if len(witnesses) else -1,
        cell_b=int(cells[1][witnesses[0]]) if len(witnesses) else -1,
        intersect=bool(figure(output, "Intersect")),
        collide=bool(figure(output, "Collide")),
        inside_undefined=bool(figure(output, "InsideUndefined")),
        depth=figure(output, "PenetrationDepth"),
        depth_at_most=figure(output, "PenetrationDepthAtMost"),
        deepest_point=_tuple(output, "DeepestPoint"),
        depths_a=depths_a,
        depths_b=depths_b,
        contacts=Contacts(points[contacts], *of_contacts, *(ids[contacts] for ids in cells)),
        translational_depth=None if bounds is None else (float(bounds[0]), float(bounds[1])),
        separating_translation=_tuple(output, "SeparatingTranslation"),
        seconds=figure(output, "Seconds"))
