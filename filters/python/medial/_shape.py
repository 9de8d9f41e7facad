"""Thickness of meshes; what medial axes describe, and the curves in them."""

from typing import Any, Literal, NamedTuple, Optional, Union, overload

import numpy as np
from numpy.typing import NDArray
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkPolyData

from ._arrays import (add_cell_data, add_point_data, cells_of_size, of_shape, point_coordinates,
                      point_data, ragged_rows)
from ._axis import MedialAxis
from ._errors import InvalidInputError
from ._mesh import Surface, length, to_polydata
from ._options import (SIDES, THICKNESS_METHODS, Side, ThicknessMethod, assign, assign_numbers,
                       choice)
from ._update import Progress, run
from .vtkMedialFilters import vtkMedialCurves, vtkMedialReconstruction, vtkMedialThickness

Axis = Union[MedialAxis, vtkPolyData]
"""A medial axis as medial_axis() or vtkMedialAxis makes it."""

CurveKind = Literal["rim", "seam", "curve"]
_KINDS: dict[int, CurveKind] = {1: "rim", 2: "seam", 4: "curve"}
_POINT_INDEX = "MedialPointIndex"

_NO_EDGE_IS_LONGER = 4e18  # since no coordinate is beyond 1e18


class DividedThickness(NamedTuple):
    """Wall thickness of a mesh whose triangles were divided into m triangles with n vertices."""

    vertices: NDArray[np.float64]
    """(n, 3) coordinates in world units."""
    faces: NDArray[np.int64]
    """(m, 3) indices of vertices."""
    thickness: NDArray[np.float32]
    """(n,) values at the vertices, or with at_faces (m,) values at the faces, in world units."""
    cell: NDArray[np.int64]
    """(m,) indices of the faces that these are parts of; cell ids of a vtkPolyData."""
    at_faces: bool
    """Whether the values are those at the faces."""

    def to_vtk(self) -> vtkPolyData:
        """As VTK's mesh, with the arrays Thickness and InputCell of vtkMedialThickness. Shares the
        memory of all arrays but the faces.

        Raises InvalidInputError where arrays do not fit each other.
        """
        mesh = to_polydata(self.vertices, self.faces)
        cells = mesh.GetNumberOfCells()
        add_cell_data(mesh, "InputCell", of_shape((cells,), self.cell, "cell"))
        places = cells if self.at_faces else mesh.GetNumberOfPoints()
        add = add_cell_data if self.at_faces else add_point_data
        add(mesh, "Thickness", of_shape((places,), self.thickness, "thickness"))
        data = mesh.GetCellData() if self.at_faces else mesh.GetPointData()
        data.SetActiveScalars("Thickness")
        return mesh


@overload
def thickness(vertices: Any, faces: Any = None, *, max_edge: None = None,
              method: ThicknessMethod = "ball", angle: float = 60.0, side: Side = "interior",
              at_faces: bool = False, threads: int = 0,
              progress: Optional[Progress] = None) -> NDArray[np.float32]: ...


@overload
def thickness(vertices: Any, faces: Any = None, *, max_edge: Union[float, str],
              method: ThicknessMethod = "ball", angle: float = 60.0, side: Side = "interior",
              at_faces: bool = False, threads: int = 0,
              progress: Optional[Progress] = None) -> DividedThickness: ...


def thickness(vertices: Any, faces: Any = None, *, max_edge: Union[float, str, None] = None,
              method: ThicknessMethod = "ball", angle: float = 60.0, side: Side = "interior",
              at_faces: bool = False, threads: int = 0, progress: Optional[Progress] = None,
              ) -> Union[NDArray[np.float32], DividedThickness]:
    """Wall thickness at the vertices of a mesh, exact and without a grid.

    vertices, faces: the mesh, as for distance_field(). Inside is behind the faces, also of an open
        mesh.
    max_edge: divide triangles until no edge is longer than this, in world units or as "L%" of the
        diagonal of the mesh's bounds; smaller thin places may be missed. 0 divides none. With
        any value but None the result is a DividedThickness, since it belongs to the divided mesh.
    method: "ball", twice the radius of the medial ball that touches the place, 0 on convex edges;
        "ray", the distance along the inward normal to the opposite surface; "wall", the diameter of
        the ball that also touches the opposite wall, with a separation angle of at least 120; near
        edges, that of the nearest place with such a ball.
    angle: minimum separation angle of the balls that count, in degrees, in (0, 180): places whose
        two closest points are seen under less, as between the facets of a curved surface, are
        passed over.
    side: "interior", how thick the solid is, "exterior", how wide the gap is (clearance), or
        "both", the smaller of the two.
    at_faces: whether to return the values at the faces, not the vertices: those at the centres of
        their triangles, the least where a face has several.
    threads: number of CPU threads to use, in [0, 1024]; 0 for all cores.
    progress: as for distance_field().

    Returns the (n,) diameters of the largest medial balls that touch the vertices, in world units;
    0 on convex edges that bend by angle or more, NaN where there is no ball; or what method,
    at_faces and max_edge say instead. Raises what distance_field() raises, but needs no OpenGL.

    >>> vertices = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, -0.5], [0, 1, -0.5], [1, 0, -0.5]]
    >>> thickness(vertices, [[0, 1, 2], [3, 4, 5]])  # two plates that face away from each other
    array([0.5, 0.5, 0.5, 0.5, 0.5, 0.5], dtype=float32)
    >>> thickness(vertices, [[0, 1, 2], [3, 4, 5]], max_edge=1.2).cell  # each is halved
    array([0, 0, 1, 1])
    """
    algorithm = vtkMedialThickness()
    mesh = to_polydata(vertices, faces)
    algorithm.SetInputData(mesh)
    assign_numbers(algorithm, angle=angle, threads=threads)
    if max_edge is not None:
        longest = length("max_edge", max_edge, mesh)
        assign_numbers(algorithm, max_edge=_NO_EDGE_IS_LONGER if longest == 0 else longest)
    assign(algorithm, Side=choice("side", side, SIDES), CellValues=bool(at_faces),
           Method=choice("method", method, THICKNESS_METHODS))
    run(algorithm, progress)
    output = algorithm.GetOutput()
    cells = output.GetCellData()
    values: NDArray[np.float32] = (
        vtk_to_numpy(cells.GetArray("Thickness")) if at_faces else point_data(output, "Thickness"))
    if max_edge is None:
        return values
    triangles = cells_of_size(output.GetPolys(), 3)
    first = output.GetNumberOfCells() - len(triangles)  # after vertices and lines
    return DividedThickness(
        point_coordinates(output), triangles, values[first:] if at_faces else values,
        vtk_to_numpy(cells.GetArray("InputCell"))[first:], bool(at_faces))


class ThicknessRegion(NamedTuple):
    """Neighbouring places whose thickness is beyond the same limit."""

    thin: bool
    """Whether it is too thin; otherwise it is too thick."""

    value: float
    """The least thickness of a thin region, the largest of a thick one, in world units."""

    place: NDArray[np.float64]
    """(3,): where that is."""

    area: float
    """Area of the region, world units squared."""

    faces: NDArray[np.int64]
    """Ids of the faces that the region has a part of, ascending."""


def thickness_regions(vertices: Any, faces: Any = None, *,
                      min_thickness: Union[float, str] = 0.0,
                      max_thickness: Union[float, str] = 0.0,
                      max_edge: Union[float, str, None] = None,
                      method: ThicknessMethod = "wall", angle: float = 60.0,
                      side: Side = "interior", threads: int = 0,
                      progress: Optional[Progress] = None) -> list[ThicknessRegion]:
    """Where a solid is too thin or too thick. Convex edges and corners do not count.

    vertices, faces: the mesh, as for distance_field(). It needs an inside, unless side is "both".
    min_thickness: find regions that are thinner than this, in world units or as "T%" of the
        diagonal of the mesh's bounds; 0 for no such limit.
    max_thickness: the same for regions that are thicker than this, above min_thickness; 0 for no
        such limit.
    max_edge: divide triangles until no edge is longer than this, in world units or as "L%" of the
        diagonal; smaller regions may be missed. 0 divides none; None stands for "2%".
    method, angle, side: as for thickness().
    threads: number of CPU threads to use, in [0, 1024]; 0 for all cores.
    progress: as for distance_field().

    Returns the thin regions, the thinnest first, then the thick ones, the thickest first. Raises
    InvalidInputError for limits that contradict each other, and what thickness() raises.

    >>> vertices = [[x, y, z] for z in (0, 0.5) for y in (0, 3) for x in (0, 4)]
    >>> faces = [[2, 3, 1, 0], [4, 5, 7, 6], [0, 1, 5, 4], [1, 3, 7, 5], [3, 2, 6, 7], [2, 0, 4, 6]]
    >>> region, = thickness_regions(vertices, faces, min_thickness=1)
    >>> round(region.value, 6), round(region.area, 3), region.faces
    (0.5, 31.0, array([0, 1, 2, 3, 4, 5]))
    """
    algorithm = vtkMedialThickness()
    mesh = to_polydata(vertices, faces)
    algorithm.SetInputData(mesh)
    lengths = {"max_edge": "2%" if max_edge is None else max_edge,
               "min_thickness": min_thickness, "max_thickness": max_thickness}
    assign_numbers(algorithm, angle=angle, threads=threads, **{
        name: length(name, value, mesh) for name, value in lengths.items()})
    assign(algorithm, Side=choice("side", side, SIDES),
           Method=choice("method", method, THICKNESS_METHODS))
    if algorithm.GetMinimumThickness() == 0 == algorithm.GetMaximumThickness():
        raise InvalidInputError("there is neither a minimum nor a maximum thickness")
    run(algorithm, progress)
    return _regions_of(algorithm.GetOutput())


def _regions_of(output: vtkPolyData) -> list[ThicknessRegion]:
    cells = output.GetCellData()
    numbers = vtk_to_numpy(cells.GetArray("Region"))
    divided = cells.GetArray("InputCell")
    ids = vtk_to_numpy(divided) if divided else np.arange(len(numbers))
    thin, value, place, area = (
        vtk_to_numpy(output.GetFieldData().GetArray("Region" + name))
        for name in ("Thin", "Value", "Place", "Area"))
    return [ThicknessRegion(bool(thin[i]), float(value[i]), place[i].copy(), float(area[i]),
                            np.unique(ids[numbers == i + 1]))
            for i in range(len(value))]


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
