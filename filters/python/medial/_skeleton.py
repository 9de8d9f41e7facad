"""Skeletons: networks of curves within solids."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, Literal, NamedTuple, Optional, Union

import numpy as np
from numpy.typing import NDArray
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkPolyData

from ._arrays import (add_cell_data, index_rows, joined_cells, point_coordinates, point_data,
                      points_with, ragged_rows)
from ._mesh import length, to_polydata
from ._options import (Engine, Lengths, Sign, assign, assign_grid, assign_numbers, assign_run)
from ._update import Progress, run
from .vtkMedialFilters import vtkMedialSkeleton

BranchKind = Literal["end-junction", "junction-junction", "closed", "isolated"]
_KINDS: tuple[BranchKind, ...] = ("end-junction", "junction-junction", "closed", "isolated")

# Attributes of Skeleton, and the point data arrays of vtkMedialSkeleton with their components.
_ARRAYS = {
    "radius": ("Radius", 1),
    "arc_length": ("ArcLength", 1),
    "degree": ("Degree", 1),
    "tangent": ("Tangent", 3),
}
# Attributes of Branch, and the cell data arrays.
_FIGURES = {
    "length": "Length",
    "mean_radius": "MeanRadius",
    "min_radius": "MinRadius",
    "max_radius": "MaxRadius",
}


class Branch(NamedTuple):
    """A curve of a skeleton, from junction to junction or free end."""

    kind: BranchKind
    """"end-junction", "junction-junction", "closed" (a loop), or "isolated": with two free ends, or
    a single point."""
    indices: NDArray[np.int64]
    """(k,) indices of points, from a junction if there is one; the last of a loop is the first."""
    length: float
    """In world units."""
    mean_radius: float
    """Mean along the branch, in world units."""
    min_radius: float
    """Smallest radius of its points, in world units."""
    max_radius: float
    """Largest radius of its points, in world units."""


@dataclass(frozen=True, eq=False, repr=False)
class Skeleton:
    """A network of curves within a solid. Points and their attributes share VTK's memory."""

    points: NDArray[np.float64]
    """(n, 3) world coordinates; branches that meet share a point."""
    radius: NDArray[np.float64]
    """(n,) exact distances to the mesh, in world units."""
    arc_length: NDArray[np.float64]
    """(n,) lengths from the start of the branch, in world units; 0 at junctions."""
    degree: NDArray[np.int32]
    """(n,) 1 at a free end, 2 within a branch, 3 and more at a junction, 0 for a single point."""
    tangent: NDArray[np.float64]
    """(n, 3) unit vectors along the branch; zero at junctions."""
    branches: list[Branch]
    """The longest first."""

    def to_vtk(self) -> vtkPolyData:
        """As VTK's mesh of polylines, with the point and cell data arrays of vtkMedialSkeleton;
        branches of a single point are vertices. Shares the memory of points and their attributes;
        copies branches.

        Raises InvalidInputError where arrays do not fit each other.
        """
        network = points_with(_ARRAYS, self, "Radius")
        # VTK numbers vertices before lines.
        order = sorted(range(len(self.branches)), key=lambda i: len(self.branches[i].indices) > 1)
        branches = [self.branches[i] for i in order]
        size = len(self.points)
        rows = [index_rows(np.reshape(branch.indices, (-1, 1)), "branches", size)[:, 0]
                for branch in branches]
        network.SetVerts(joined_cells([row for row in rows if len(row) == 1]))
        network.SetLines(joined_cells([row for row in rows if len(row) > 1]))
        add_cell_data(network, "BranchId", np.array(order, np.int32))
        add_cell_data(network, "Kind",
                      np.array([_KINDS.index(branch.kind) for branch in branches], np.uint8))
        for attribute, name in _FIGURES.items():
            add_cell_data(network, name, np.array(
                [getattr(branch, attribute) for branch in branches], np.float64))
        return network

    def __repr__(self) -> str:
        junctions = int((self.degree > 2).sum())
        return (f"<Skeleton of {len(self.points)} points, {len(self.branches)} branches, "
                f"{junctions} junctions>")


def skeleton(
    vertices: Any, faces: Any = None, *, min_branch: float = 1.0, smooth: bool = True,
    angle: float = 60.0, min_lambda: Union[float, str] = 0.0,
    resolution: Union[int, Literal["auto"], None] = None, spacing: Optional[Lengths] = None,
    origin: Optional[Sequence[float]] = None, dimensions: Optional[Sequence[int]] = None,
    padding: Optional[float] = None, sign: Sign = "auto", threads: int = 0, memory: int = 0,
    engine: Engine = "auto", device: Union[str, int] = "", require_gpu: bool = False,
    progress: Optional[Progress] = None,
) -> Skeleton:
    """The network of curves within a solid: centrelines, without seeds.

    One branch for every limb, with the components and loops of the solid at the resolution of the
    grid. Branches run through the middle; their radii are exact.

    vertices, faces: the mesh, as for distance_field(). It needs an inside: large holes must be
        closed.
    min_branch: minimum length of a branch with a free end, as a multiple of the radius where it
        leaves the others, >= 0; loops stay.
    smooth: whether branches are smooth curves; otherwise they run from point to point of the axis,
        and zigzag by a voxel.
    angle, min_lambda: of the axis whose curves these are, as for medial_axis().
    resolution: number of grid points along the longest axis of the padded bounds, in [2, 8192];
        default 256; or "auto", 128 to 512 of them, so that four lie in the radius of the thinnest
        branch, as found on coarser grids. A UserWarning says if it needs more.
    spacing, origin, dimensions, padding, sign, threads, memory, engine, device, require_gpu,
        progress: as for distance_field().

    Raises what distance_field() raises, and InvalidInputError for a mesh without an inside.

    >>> corners = [[x, y, z] for x in (0, 8) for y in (0, 1) for z in (0, 1)]
    >>> quads = [[0, 1, 3, 2], [4, 6, 7, 5], [0, 4, 5, 1], [2, 3, 7, 6], [0, 2, 6, 4], [1, 5, 7, 3]]
    >>> beam = skeleton(corners, quads, resolution=128)
    >>> [(branch.kind, round(branch.length, 1)) for branch in beam.branches]
    [('isolated', 7.0)]
    """
    algorithm = vtkMedialSkeleton()
    mesh = to_polydata(vertices, faces)
    algorithm.SetInputData(mesh)
    assign_numbers(algorithm, angle=angle, min_lambda=length("min_lambda", min_lambda, mesh),
                   min_branch=min_branch)
    assign(algorithm, Smooth=bool(smooth))
    assign_grid(algorithm, resolution=resolution, spacing=spacing, origin=origin,
                dimensions=dimensions, padding=padding)
    assign_run(algorithm, sign=sign, threads=threads, memory=memory, engine=engine,
               device=device, require_gpu=require_gpu)
    run(algorithm, progress)
    output = algorithm.GetOutput()
    return Skeleton(
        **{attribute: point_data(output, name) for attribute, (name, _) in _ARRAYS.items()},
        points=point_coordinates(output), branches=_branches_of(output))


def _branches_of(output: Any) -> list[Branch]:
    """The cells of the filter's output, by their ids."""
    rows = [row for cells in (output.GetVerts(), output.GetLines())
            if cells.GetNumberOfCells() > 0 for row in ragged_rows(cells)]
    data = output.GetCellData()
    ids, kinds, *figures = (vtk_to_numpy(data.GetArray(name)) for name in (
        "BranchId", "Kind", *_FIGURES.values()))
    return [Branch(_KINDS[kinds[cell]], rows[cell].astype(np.int64),
                   *(float(values[cell]) for values in figures))
            for cell in np.argsort(ids)]
