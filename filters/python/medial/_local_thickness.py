"""Local thickness of solids."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, Optional, Union

import numpy as np
from numpy.typing import NDArray
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkImageData

from ._arrays import add_point_data, grid_image, point_data
from ._mesh import to_polydata
from ._options import (SIDES, Engine, Lengths, Side, Sign, assign, assign_grid, assign_numbers,
                       assign_run, choice)
from ._update import Progress, run
from .vtkMedialFilters import vtkMedialLocalThickness

_ARRAY = "LocalThickness"


@dataclass(frozen=True, eq=False, repr=False)
class Distribution:
    """How a local thickness, or a separation, is distributed over the grid points of its side."""

    points: int
    """Number of grid points on this side. Without any, the others are NaN."""
    min: float
    """Smallest value, in world units."""
    mean: float
    """Mean over the grid points, in world units."""
    standard_deviation: float
    """Root of the mean square difference from the mean, in world units."""
    max: float
    """Largest value, in world units."""
    histogram: NDArray[np.int64]
    """(bins,) numbers of grid points in equally wide bins."""
    edges: NDArray[np.float64]
    """(bins + 1,) ends of the bins, from 0 on, in world units."""

    def __repr__(self) -> str:
        return (f"<Distribution of {self.points} grid points, mean {self.mean:.4g}, "
                f"standard deviation {self.standard_deviation:.4g}>")


@dataclass(frozen=True, eq=False, repr=False)
class LocalThickness:
    """The local thickness of a solid on a regular grid of nx x ny x nz points.

    The value [i, j, k] is at origin + (i, j, k) * spacing. The array shares VTK's memory, where x
    runs fastest: it is a Fortran-ordered view.
    """

    values: NDArray[np.float32]
    """(nx, ny, nz) diameters in world units; 0 on a side that is not wanted, and with side "both"
    negative outside."""
    origin: NDArray[np.float64]
    """(3,) world coordinates of the grid point [0, 0, 0]."""
    spacing: NDArray[np.float64]
    """(3,) distances between neighbouring grid points along x, y and z in world units."""
    thickness: Optional[Distribution] = None
    """Of the points inside, with side "interior" and "both"."""
    separation: Optional[Distribution] = None
    """Of the points outside, with side "exterior" and "both"."""

    def to_vtk(self) -> vtkImageData:
        """As VTK's image, with the point data array LocalThickness of vtkMedialLocalThickness.

        An array that comes from this package is not copied. Raises InvalidInputError where arrays
        do not fit each other.
        """
        image = grid_image(self.origin, self.spacing, self.values, "values")
        add_point_data(image, _ARRAY, np.ravel(self.values, order="F"))
        image.GetPointData().SetActiveScalars(_ARRAY)
        return image

    def __repr__(self) -> str:
        size = " x ".join(str(count) for count in self.values.shape)
        return f"<LocalThickness of {size} grid points>"


def local_thickness(
    vertices: Any, faces: Any = None, *, side: Side = "interior", bins: int = 64,
    resolution: Optional[int] = None, spacing: Optional[Lengths] = None,
    origin: Optional[Sequence[float]] = None, dimensions: Optional[Sequence[int]] = None,
    padding: Optional[float] = None, sign: Sign = "auto", threads: int = 0, memory: int = 0,
    engine: Engine = "auto", device: Union[str, int] = "", require_gpu: bool = False,
    progress: Optional[Progress] = None,
) -> LocalThickness:
    """The diameter of the largest ball inside a solid that contains a grid point, at all of them.

    vertices, faces: the mesh, as for distance_field(). It needs an inside: large holes must be
        closed.
    side: "interior", the thickness of the solid; "exterior", the separation, which is the same of
        the space outside; or "both", the separation as negative numbers.
    bins: number of bins of the histograms, in [1, 65536].
    resolution, spacing, origin, dimensions, padding, sign, threads, memory, engine, device,
        require_gpu, progress: as for distance_field().

    Raises what distance_field() raises, and InvalidInputError for a mesh without an inside.

    >>> corners = [[x, y, z] for x in (0, 4) for y in (0, 4) for z in (0, 1)]
    >>> quads = [[0, 1, 3, 2], [4, 6, 7, 5], [0, 4, 5, 1], [2, 3, 7, 6], [0, 2, 6, 4], [1, 5, 7, 3]]
    >>> plate = local_thickness(corners, quads, resolution=48)
    >>> round(plate.thickness.max, 2)
    1.0
    """
    algorithm = vtkMedialLocalThickness()
    algorithm.SetInputData(to_polydata(vertices, faces))
    assign(algorithm, Side=choice("side", side, SIDES))
    assign_numbers(algorithm, bins=bins)
    assign_grid(algorithm, resolution=resolution, spacing=spacing, origin=origin,
                dimensions=dimensions, padding=padding)
    assign_run(algorithm, sign=sign, threads=threads, memory=memory, engine=engine,
               device=device, require_gpu=require_gpu)
    run(algorithm, progress)
    image = algorithm.GetOutput()
    return LocalThickness(
        values=point_data(image, _ARRAY).reshape(image.GetDimensions(), order="F"),
        origin=np.array(image.GetOrigin()), spacing=np.array(image.GetSpacing()),
        thickness=_distribution(image, "Thickness"), separation=_distribution(image, "Separation"))


def _distribution(image: Any, name: str) -> Optional[Distribution]:
    data = image.GetFieldData()
    figures = data.GetArray(name + "Distribution")
    if figures is None:
        return None
    points, low, mean, deviation, high, end = figures.GetTuple(0)
    histogram = vtk_to_numpy(data.GetArray(name + "Histogram")).astype(np.int64)
    return Distribution(int(points), low, mean, deviation, high, histogram,
                        np.linspace(0.0, end, len(histogram) + 1))
