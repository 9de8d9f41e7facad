"""Distance fields."""

from collections.abc import Collection, Sequence
from dataclasses import dataclass
from typing import Any, Optional, Union

import numpy as np
from numpy.typing import NDArray
from vtkmodules.vtkCommonDataModel import vtkImageData

from ._arrays import add_point_data, figure, grid_image, of_shape, point_data
from ._mesh import to_polydata
from ._options import (ARRAYS, Engine, FieldArray, Lengths, Sign, assign_arrays, assign_grid,
                       assign_run)
from ._update import Progress, run
from .vtkMedialFilters import vtkMeshDistanceField


@dataclass(frozen=True, eq=False, repr=False)
class DistanceField:
    """The distance field of a mesh on a regular grid of nx x ny x nz points.

    The value [i, j, k] of every array is at origin + (i, j, k) * spacing. The arrays share VTK's
    memory, where x runs fastest: they are Fortran-ordered views of one component after the other.
    """

    distance: NDArray[np.float32]
    """(nx, ny, nz) distances to the closest point of the mesh in world units, negative inside where
    sign is not "none"."""
    origin: NDArray[np.float64]
    """(3,) world coordinates of the grid point [0, 0, 0]."""
    spacing: NDArray[np.float64]
    """(3,) distances between neighbouring grid points along x, y and z in world units."""
    sign: str
    """How inside was told from outside: "none" (unsigned), "pseudonormal" or "winding"."""
    engine: str
    """What found the closest sites: "processor", "device" or "rasteriser"."""
    renderer: str
    """The OpenGL implementation (GL_RENDERER); empty where OpenGL was not used."""
    closest_point: Optional[NDArray[np.float32]] = None
    """(nx, ny, nz, 3) world coordinates of the closest point of the mesh."""
    closest_cell: Optional[NDArray[np.int64]] = None
    """(nx, ny, nz) indices of a face that holds that point; cell ids of a vtkPolyData."""
    closest_feature: Optional[NDArray[np.uint8]] = None
    """(nx, ny, nz) what that point lies on: 0 a vertex, 1 an edge, 2 a face."""
    closest_site: Optional[NDArray[np.int32]] = None
    """(nx, ny, nz) labels of the Voronoi diagram of faces, edges and vertices, in this order."""

    def __repr__(self) -> str:
        size = " x ".join(str(count) for count in self.distance.shape)
        return f"<DistanceField of {size} grid points, sign {self.sign}>"

    def axes(self) -> tuple[NDArray[np.float64], NDArray[np.float64], NDArray[np.float64]]:
        """World coordinates of the grid points along x, along y and along z."""
        x, y, z = (first + step * np.arange(count) for first, step, count
                   in zip(self.origin, self.spacing, self.distance.shape))
        return x, y, z

    def to_vtk(self) -> vtkImageData:
        """As VTK's image, with the point data arrays of vtkMeshDistanceField.

        Arrays that come from this package are not copied. Raises InvalidInputError where arrays do
        not fit each other.
        """
        image = grid_image(self.origin, self.spacing, self.distance, "distance")
        for attribute, name in {"distance": "Distance", **ARRAYS}.items():
            values = getattr(self, attribute)
            if values is not None:
                shape = image.GetDimensions() + ((3,) if attribute == "closest_point" else ())
                add_point_data(image, name, _samples_first(of_shape(shape, values, attribute)))
        image.GetPointData().SetActiveScalars("Distance")
        return image


def distance_field(
    vertices: Any, faces: Any = None, *,
    resolution: Optional[int] = None, spacing: Optional[Lengths] = None,
    origin: Optional[Sequence[float]] = None, dimensions: Optional[Sequence[int]] = None,
    padding: Optional[float] = None, sign: Sign = "auto", arrays: Collection[FieldArray] = (),
    threads: int = 0, memory: int = 0, engine: Engine = "auto",
    device: Union[str, int] = "", require_gpu: bool = False, progress: Optional[Progress] = None,
) -> DistanceField:
    """The exact distance from the points of a regular grid to a mesh.

    The mesh need be neither closed nor manifold nor welded.

    vertices: (n, 3) coordinates in world units; float32 and float64 arrays in C order are not
        copied. Or, without faces, a whole mesh: a vtkPolyData (as pyvista's meshes are), or any
        object with attributes vertices and faces.
    faces: (m, k) indices of vertices: triangles, quads or polygons of k vertices, segments for k =
        2, points for k = 1; or a sequence of m sequences of at least 3 indices.
    resolution: number of grid points along the longest axis of the padded bounds, in [2, 8192];
        default 256.
    spacing: distance between neighbouring grid points in world units, > 0, one number or one for
        each axis; instead of resolution.
    origin, dimensions: with spacing an explicit grid: world coordinates of its first point, and
        its numbers of points along x, y and z, each in [1, 8192].
    padding: margin around the mesh as a fraction of the diagonal of its bounds, in [0, 10];
        default 0.05. Not with an explicit grid.
    sign: how inside, where distances are negative, is told from outside: "winding" (winding
        numbers, for any mesh of triangles), "auto" ("winding", but "none" if the mesh does not
        define an inside), "none", or "pseudonormal" (an error for meshes that are not closed
        and consistently oriented).
    arrays: what to return besides the distance: names of attributes of DistanceField, at 12, 8, 1
        and 4 bytes per grid point for "closest_point", "closest_cell", "closest_feature" and
        "closest_site". The distance takes 4.
    threads: number of CPU threads to use, in [0, 1024]; 0 for all cores.
    memory: upper bound on the memory for slabs, in MiB, >= 64; 0 chooses one. The result is not
        counted.
    engine: what finds the closest sites: "processor" (CPU, without OpenGL), "device" (compute
        shaders of OpenGL), "rasteriser" (OpenGL) or "auto": the processor, and the device for
        large work on graphics hardware that works. The distances do not depend on it.
    device: what an engine that uses OpenGL computes on: its number, or a part of its name, as
        `medial-axis --list-devices` prints them; by default the first GPU, else a software
        renderer. If there is no such device, or it fails, "auto" leaves the work to the processor,
        with a warning. A process has one device, that of its first such engine.
    require_gpu: whether to fail unless there is OpenGL 4.5 on a GPU.
    progress: called with the share of the work that is done, in [0, 1], and its name. An exception
        that it raises stops the work and is raised here.

    Raises InvalidInputError, a ValueError, if the mesh, a value or a combination is unusable,
    NoGpuError, OutOfMemoryError, TypeError, or KeyboardInterrupt after Ctrl-C. Warns (UserWarning)
    if a device fails and the engine "auto" leaves its work to the processor, once per process for
    each cause. Other Python threads run meanwhile; they must not change the arrays.

    >>> cube = [[x, y, z] for x in (0, 1) for y in (0, 1) for z in (0, 1)]
    >>> quads = [[0, 1, 3, 2], [4, 6, 7, 5], [0, 4, 5, 1], [2, 3, 7, 6], [0, 2, 6, 4], [1, 5, 7, 3]]
    >>> field = distance_field(cube, quads, spacing=0.25, origin=(0, 0, 0), dimensions=(5, 5, 9))
    >>> float(field.distance[2, 2, 2])  # the middle of the cube
    -0.5
    >>> round(float(field.distance[2, 2, 8]), 6)  # (0.5, 0.5, 2)
    1.0
    """
    field = vtkMeshDistanceField()
    field.SetInputData(to_polydata(vertices, faces))
    assign_grid(field, resolution=resolution, spacing=spacing, origin=origin,
                dimensions=dimensions, padding=padding)
    assign_run(field, sign=sign, threads=threads, memory=memory, engine=engine,
               device=device, require_gpu=require_gpu)
    assign_arrays(field, arrays)
    run(field, progress)
    return field_of(field.GetOutput())


def field_of(image: vtkImageData) -> DistanceField:
    """The image of a filter that was executed; shares its memory."""
    shape = image.GetDimensions()
    present = {attribute: _grid_first(point_data(image, name), shape)
               for attribute, name in ARRAYS.items() if image.GetPointData().HasArray(name)}
    return DistanceField(
        distance=_grid_first(point_data(image, "Distance"), shape),
        origin=np.array(image.GetOrigin()),
        spacing=np.array(image.GetSpacing()),
        sign=figure(image, "SignMethod").lower(),
        engine=figure(image, "Engine").lower(),
        renderer=figure(image, "Renderer", ""),
        **present)


def _grid_first(values: NDArray[Any], shape: tuple[int, int, int]) -> NDArray[Any]:
    """From VTK's order of grid points to [x, y, z] or [x, y, z, component], as a view."""
    cube = values.reshape(shape[::-1] + values.shape[1:])
    return cube.transpose((2, 1, 0) + ((3,) if values.ndim == 2 else ()))


def _samples_first(values: NDArray[Any]) -> NDArray[Any]:
    """The inverse: a view of arrays that _grid_first() made, a copy of others."""
    cube = values.transpose((2, 1, 0) + ((3,) if values.ndim == 4 else ()))
    return np.ascontiguousarray(cube).reshape((-1,) + values.shape[3:])
