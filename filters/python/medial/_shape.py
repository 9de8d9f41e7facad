"""Thickness of meshes; what medial axes describe, and the curves in them."""

from typing import Any, Literal, NamedTuple, Optional, Union

import numpy as np
from numpy.typing import NDArray
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkPolyData

from ._arrays import add_point_data, cells_of_size, point_coordinates, point_data, ragged_rows
from ._axis import MedialAxis
from ._errors import InvalidInputError
from ._mesh import Surface, to_polydata
from ._options import SIDES, Side, assign, assign_numbers, choice
from ._update import Progress, run
from .vtkMedialFilters import vtkMedialCurves, vtkMedialReconstruction, vtkMedialThickness

Axis = Union[MedialAxis, vtkPolyData]
"""A medial axis as medial_axis() or vtkMedialAxis makes it."""

CurveKind = Literal["rim", "seam", "curve"]
_KINDS: dict[int, CurveKind] = {1: "rim", 2: "seam", 4: "curve"}
_POINT_INDEX = "MedialPointIndex"


def thickness(vertices: Any, faces: Any = None, *, angle: float = 60.0, side: Side = "interior",
              threads: int = 0, progress: Optional[Progress] = None) -> NDArray[np.float32]:
    """Wall thickness at the vertices of a mesh, exact and without a grid.

    vertices, faces: the mesh, as for distance_field(). Inside is behind the faces, also of an open
        mesh.
    angle: minimum separation angle of the balls that count, in degrees, in (0, 180): places whose
        two closest points are seen under less, as between the facets of a curved surface, are
        passed over.
    side: "interior", how thick the solid is, "exterior", how wide the gap is (clearance), or
        "both", the smaller of the two.
    threads: number of CPU threads to use, in [0, 1024]; 0 for all cores.
    progress: as for distance_field().

    Returns the (n,) diameters of the largest medial balls that touch the vertices, in world units;
    0 on convex edges that bend by angle or more, NaN where there is no ball. Raises what
    distance_field() raises, but needs no OpenGL.

    >>> vertices = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, -0.5], [0, 1, -0.5], [1, 0, -0.5]]
    >>> thickness(vertices, [[0, 1, 2], [3, 4, 5]])  # two plates that face away from each other
    array([0.5, 0.5, 0.5, 0.5, 0.5, 0.5], dtype=float32)
    """
    algorithm = vtkMedialThickness()
    algorithm.SetInputData(to_polydata(vertices, faces))
    assign_numbers(algorithm, angle=angle, threads=threads)
    assign(algorithm, Side=choice("side", side, SIDES))
    run(algorithm, progress)
    return point_data(algorithm.GetOutput(), "Thickness")


def reconstruction(axis: Axis, *, resolution: int = 128, interpolate: bool = True,
                   progress: Optional[Progress] = None) -> Surface:
    """The surface of the solid that a medial axis describes: the union of its balls.

    axis: points, radii and cells count; of a vtkPolyData the point data array Radius.
    resolution: number of grid points along the longest axis of the balls' padded bounds, in
        [2, 8192].
    interpolate: whether cones between balls joined by a line or an edge, and wedges between those
        joined by a triangle, belong to the solid.
    progress: as for distance_field().

    Returns a closed triangle mesh whose faces point outwards. Raises InvalidInputError where the
    axis has no points or its radii are missing, negative or not finite.
    """
    algorithm = vtkMedialReconstruction()
    algorithm.SetInputData(_polydata_of(axis))
    assign_numbers(algorithm, resolution=resolution)
    assign(algorithm, Interpolate=bool(interpolate))
    run(algorithm, progress)
    output = algorithm.GetOutput()
    return Surface(point_coordinates(output), cells_of_size(output.GetPolys(), 3))


class Curve(NamedTuple):
    """A polyline of a medial axis, from junction to junction, or a loop."""

    kind: CurveKind
    """"rim": where a sheet ends; "seam": where sheets meet; "curve": where there is no sheet."""
    indices: NDArray[np.int64]
    """(k,) indices of points of the axis; the last of a loop is the first."""


def curves(axis: Axis, *, rims: bool = True, seams: bool = True, other: bool = True,
           progress: Optional[Progress] = None) -> list[Curve]:
    """The rims, seams and other curves of a medial axis.

    axis: points and cells count; not a MedialAxis with representation "points".
    rims, seams, other: which kinds are wanted.
    progress: as for distance_field().

    Returns them in no particular order. Raises InvalidInputError where arrays of the axis do not
    fit each other, and where it is one of points.

    >>> import medial
    >>> corners = [[x, y, z] for x in (0, 4) for y in (0, 2) for z in (0, 1)]
    >>> quads = [[0, 1, 3, 2], [4, 6, 7, 5], [0, 4, 5, 1], [2, 3, 7, 6], [0, 2, 6, 4], [1, 5, 7, 3]]
    >>> axis = medial.medial_axis(corners, quads, resolution=64, angle=100)
    >>> [curve.kind for curve in curves(axis)]  # the axis is a rectangle
    ['rim']
    """
    if isinstance(axis, MedialAxis) and axis.representation == "points":
        raise InvalidInputError("an axis with representation 'points' has no cells that meet in "
                                "curves: 'surface' or 'faces' is needed")
    mesh = _polydata_of(axis)
    add_point_data(mesh, _POINT_INDEX, np.arange(mesh.GetNumberOfPoints(), dtype=np.int64))
    algorithm = vtkMedialCurves()
    algorithm.SetInputData(mesh)
    assign(algorithm, Rims=bool(rims), Seams=bool(seams), Curves=bool(other))
    run(algorithm, progress)
    output = algorithm.GetOutput()
    if output.GetNumberOfLines() == 0:
        return []
    origin = point_data(output, _POINT_INDEX)
    kinds = vtk_to_numpy(output.GetCellData().GetArray("AxisFeature"))
    return [Curve(_KINDS[kind], origin[line])
            for kind, line in zip(kinds, ragged_rows(output.GetLines()))]


def _polydata_of(axis: Axis) -> vtkPolyData:
    """The axis as VTK's mesh; never the caller's own object."""
    if isinstance(axis, MedialAxis):
        return axis.to_vtk()
    if isinstance(axis, vtkPolyData):
        return to_polydata(axis)
    raise TypeError(f"a MedialAxis or a vtkPolyData is needed, not {type(axis).__name__}")
