"""Medial axes."""

import warnings
from collections.abc import Collection, Iterator, Sequence
from dataclasses import dataclass
from typing import Any, Optional, Union

import numpy as np
from numpy.typing import NDArray
from vtkmodules.vtkCommonDataModel import vtkPolyData

from ._arrays import (cells_of_size, figure, index_rows, point_coordinates, point_data, points_with,
                      rows_to_cells)
from ._errors import InvalidInputError
from ._field import DistanceField, field_of
from ._mesh import length, to_polydata
from ._options import (REPRESENTATIONS, SIDES, TOPOLOGIES, Engine, FieldArray, Lengths,
                       Representation, Side, Sign, Topology, assign, assign_arrays, assign_grid,
                       assign_numbers, assign_run, choice, word)
from ._update import Progress, run
from .vtkMedialFilters import vtkMedialAxis

# Attributes of MedialAxis, and the point data arrays of vtkMedialAxis with their components.
_ARRAYS = {
    "radius": ("Radius", 1),
    "separation_angle": ("SeparationAngle", 1),
    "lambda_": ("Lambda", 1),
    "closest_a": ("ClosestPointA", 3),
    "closest_b": ("ClosestPointB", 3),
    "feature": ("AxisFeature", 1),
}
_CELLS = ("vertices", "lines", "triangles", "quads")


@dataclass(frozen=True, eq=False, repr=False)
class MedialAxis:
    """A medial axis: balls, given by points and radii, and cells that join them.

    For n points, p vertices, l lines, t triangles and q quads. Points and their attributes share
    VTK's memory.
    """

    points: NDArray[np.float64]
    """(n, 3) centres of the medial balls, world coordinates."""
    radius: NDArray[np.float32]
    """(n,) distances to the mesh in world units."""
    separation_angle: NDArray[np.float32]
    """(n,) angles between the directions to the two closest points, in degrees, in [0, 180]."""
    lambda_: NDArray[np.float32]
    """(n,) radius times the sine of half the separation angle, in world units. That is half
    the distance between the two closest points."""
    closest_a: NDArray[np.float32]
    """(n, 3) one of the two closest points of the mesh, world coordinates."""
    closest_b: NDArray[np.float32]
    """(n, 3) the other one, world coordinates."""
    feature: NDArray[np.uint8]
    """(n,) where the point lies: 0 in a sheet, 1 on a rim, 2 on a seam, 3 at a junction, 4 on a
    curve, 5 alone."""
    triangles: NDArray[np.int64]
    """(t, 3) indices of points."""
    quads: NDArray[np.int64]
    """(q, 4) indices of points, in turn around the quad."""
    lines: NDArray[np.int64]
    """(l, 2) indices of points, where the axis is a curve."""
    vertices: NDArray[np.int64]
    """(p, 1) indices of points that are cells by themselves."""
    representation: str
    """What it is made of: "surface", "faces" or "points"."""
    side: str
    """What it is the axis of: "interior", "exterior" or "both"."""
    sign: str
    """How inside was told from outside: "none", "pseudonormal" or "winding"."""
    engine: str
    """What found the closest sites: "processor", "device" or "rasteriser"."""
    renderer: str
    """The OpenGL implementation (GL_RENDERER); empty where OpenGL was not used."""
    field: Optional[DistanceField] = None
    """The distance field, if asked for."""

    def __repr__(self) -> str:
        counts = (f"{len(getattr(self, name))} {name}" for name in ("points", *_CELLS))
        return f"<MedialAxis of {', '.join(counts)}; {self.side}>"

    @property
    def faces(self) -> NDArray[np.int64]:
        """(2 q + t, 3) all sheets as triangles: the halves of each quad, then the triangles."""
        halves = self.quads[:, [0, 1, 2, 0, 2, 3]].reshape(-1, 3)
        return np.concatenate([halves, self.triangles])

    def to_vtk(self) -> vtkPolyData:
        """As VTK's mesh, with the point data arrays of vtkMedialAxis. Shares the memory of points
        and their attributes; copies cells.

        Raises InvalidInputError where arrays do not fit each other.
        """
        axis = points_with(_ARRAYS, self, "Radius")
        cells = {name: index_rows(getattr(self, name), name, len(self.points)) for name in _CELLS}
        axis.SetVerts(rows_to_cells(cells["vertices"]))
        axis.SetLines(rows_to_cells(cells["lines"]))
        axis.SetPolys(rows_to_cells(cells["quads"], cells["triangles"]))
        return axis


def medial_axis(
    vertices: Any, faces: Any = None, *,
    angle: float = 60.0, min_lambda: Union[float, str] = 0.0, min_radius: Union[float, str] = 0.0,
    side: Optional[Side] = None, representation: Representation = "surface",
    max_spheres: int = 0, topology: Topology = "selected", field: bool = False,
    resolution: Optional[int] = None, spacing: Optional[Lengths] = None,
    origin: Optional[Sequence[float]] = None, dimensions: Optional[Sequence[int]] = None,
    padding: Optional[float] = None, sign: Sign = "auto", arrays: Collection[FieldArray] = (),
    threads: int = 0, memory: int = 0, engine: Engine = "auto",
    device: Union[str, int] = "", require_gpu: bool = False, progress: Optional[Progress] = None,
) -> MedialAxis:
    """The medial axis of a mesh, simplified by separation angle.

    The points halfway between two or more places of the mesh. Points lie where the axis is, not at
    grid points; their radii are exact.

    vertices, faces: the mesh, as for distance_field().
    angle: minimum separation angle theta between the directions to the two closest points, in
        degrees, in (0, 180); smaller values keep more of the axis and more noise.
    min_lambda: minimum lambda, half the distance between the two closest points, in world units
        or as "L%" of the diagonal of the mesh's bounds, >= 0; removes the sheets that noise of this
        size causes, and those of walls thinner than twice this.
    min_radius: minimum radius of the medial balls, in world units or as "R%" of the diagonal, >= 0.
    side: which side of the surface: "interior", "exterior" or "both"; default interior. An open
        mesh has no sides: its axis is that of both, and MedialAxis.side says so.
    representation: "surface" (dual mesh), "faces" (voxel faces) or "points".
    max_spheres: compact connected axis: at most so many balls, joined by lines and triangles, that
        describe the shape best, in [0, 2147483647]; not for "points"; 0 for no limit.
    topology: "selected": what theta selects, in as many components as that gives; "preserve": with
        the components, tunnels and cavities of the solid at this resolution, whatever theta is;
        needs "surface" or "faces", and 10 bytes per grid point.
    field: whether MedialAxis.field is the distance field, from the same run.
    resolution, spacing, origin, dimensions, padding, sign, arrays, threads, memory, engine,
        device, require_gpu, progress: as for distance_field(); arrays are those of the field, which
        they need.

    Raises what distance_field() raises, and warns as it does. Also warns (UserWarning) if the
    axis is empty, or if it is that of both sides although side is "interior" or "exterior".

    >>> corners = [[x, y, z] for x in (0, 4) for y in (0, 4) for z in (0, 1)]
    >>> quads = [[0, 1, 3, 2], [4, 6, 7, 5], [0, 4, 5, 1], [2, 3, 7, 6], [0, 2, 6, 4], [1, 5, 7, 3]]
    >>> axis = medial_axis(corners, quads, resolution=64, angle=120)  # the middle of a plate
    >>> float(abs(axis.points[:, 2] - 0.5).max()) < 1e-6
    True
    >>> float(axis.radius.max())
    0.5
    """
    if len(arrays) > 0 and not field:
        raise InvalidInputError(f"arrays {arrays!r} belong to the field: they need field=True")
    algorithm = vtkMedialAxis()
    mesh = to_polydata(vertices, faces)
    algorithm.SetInputData(mesh)
    assign_numbers(algorithm, angle=angle, min_lambda=length("min_lambda", min_lambda, mesh),
                   min_radius=length("min_radius", min_radius, mesh), max_spheres=max_spheres)
    assign(algorithm, Side=choice("side", "interior" if side is None else side, SIDES),
           Representation=choice("representation", representation, REPRESENTATIONS),
           Topology=choice("topology", topology, TOPOLOGIES), GenerateDistanceField=bool(field))
    assign_grid(algorithm, resolution=resolution, spacing=spacing, origin=origin,
                dimensions=dimensions, padding=padding)
    assign_run(algorithm, sign=sign, threads=threads, memory=memory, engine=engine,
               device=device, require_gpu=require_gpu)
    assign_arrays(algorithm, arrays)
    run(algorithm, progress)
    for note in _notes(algorithm, side):
        warnings.warn(note, stacklevel=2)
    return _axis_of(algorithm)


def _notes(algorithm: vtkMedialAxis, side: Optional[Side]) -> Iterator[str]:
    """Notes on what the caller may not expect."""
    output = algorithm.GetOutput()
    if side is not None and figure(output, "Side").lower() != side:
        yield (f"the axis is that of both sides, not of side {side!r}: "
               f"inside is not known ({figure(output, 'SignReason')})")
    if output.GetNumberOfPoints() == 0:
        minimums = "".join(
            f" and a {name} of {value:g}" for name, value in (
                ("lambda", algorithm.GetMinimumLambda()), ("radius", algorithm.GetMinimumRadius()))
            if value > 0)
        yield (f"the axis is empty: no point of the grid has a separation angle of "
               f"{algorithm.GetAngle():g} degrees{minimums} or more")


def _axis_of(algorithm: vtkMedialAxis) -> MedialAxis:
    """The output of a filter that was executed."""
    output = algorithm.GetOutput()
    field = None
    if algorithm.GetGenerateDistanceField():
        field = field_of(algorithm.GetDistanceField())
    return MedialAxis(
        **{attribute: point_data(output, name) for attribute, (name, _) in _ARRAYS.items()},
        points=point_coordinates(output),
        triangles=cells_of_size(output.GetPolys(), 3),
        quads=cells_of_size(output.GetPolys(), 4),
        lines=cells_of_size(output.GetLines(), 2),
        vertices=cells_of_size(output.GetVerts(), 1),
        representation=word(algorithm.GetRepresentation(), REPRESENTATIONS),
        side=figure(output, "Side").lower(),
        sign=figure(output, "SignMethod").lower(),
        engine=figure(output, "Engine").lower(),
        renderer=figure(output, "Renderer", ""),
        field=field)
