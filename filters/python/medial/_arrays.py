"""Numpy arrays over VTK's memory and the other way round."""

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkImageData, vtkPolyData

from ._errors import InvalidInputError


def point_data(data: Any, name: str) -> NDArray[Any]:
    """An array of a data set; shares VTK's memory and keeps it alive."""
    values: NDArray[Any] = vtk_to_numpy(data.GetPointData().GetArray(name))
    return values


def figure(data: Any, name: str, default: Any = None) -> Any:
    """The only value of a field data array, a number or a text; default where there is none."""
    array = data.GetFieldData().GetAbstractArray(name)
    return array.GetValue(0) if array else default


def point_coordinates(data: Any) -> NDArray[np.float64]:
    """The (n, 3) points of a data set whose points are float64; shares VTK's memory."""
    points = data.GetPoints()
    values: NDArray[np.float64] = vtk_to_numpy(points.GetData()) if points else np.empty((0, 3))
    return values


def add_point_data(data: Any, name: str, values: NDArray[Any]) -> None:
    """Adds an array to a data set; shares numpy's memory and keeps it alive."""
    data.GetPointData().AddArray(_named(name, values))


def add_cell_data(data: Any, name: str, values: NDArray[Any]) -> None:
    """The same for its cells."""
    data.GetCellData().AddArray(_named(name, values))


def add_attributes(data: Any, attributes: Mapping[str, tuple[str, int]], owner: Any) -> None:
    """Adds attributes of an object to a data set's points, by the names and numbers of components
    that they have there.

    Raises InvalidInputError where an array does not fit the points.
    """
    points = data.GetNumberOfPoints()
    for attribute, (name, components) in attributes.items():
        expected = (points,) if components == 1 else (points, components)
        add_point_data(data, name, of_shape(expected, getattr(owner, attribute), attribute))


def of_shape(expected: tuple[int, ...], values: Any, name: str) -> NDArray[Any]:
    """An array, where it has the shape; otherwise raises InvalidInputError."""
    array = np.asarray(values)
    if array.shape != expected:
        raise InvalidInputError(f"{name} has the shape {array.shape}, not {expected}")
    return array


def grid_image(origin: Any, spacing: Any, values: Any, name: str) -> vtkImageData:
    """An image of the grid of an array with a value for each point, (nx, ny, nz).

    Raises InvalidInputError where the array has another number of axes.
    """
    shape = np.shape(values)
    if len(shape) != 3:
        raise InvalidInputError(f"{name} has the shape {shape}, not (nx, ny, nz)")
    image = vtkImageData()
    image.SetOrigin(*of_shape((3,), origin, "origin"))
    image.SetSpacing(*of_shape((3,), spacing, "spacing"))
    image.SetDimensions(*shape)
    return image


def points_with(attributes: Mapping[str, tuple[str, int]], owner: Any, scalars: str) -> vtkPolyData:
    """The points of an object, shared, with attributes as for add_attributes(), but no cells.

    scalars: the array that colours them.
    """
    mesh = vtkPolyData()
    mesh.SetPoints(to_points(float_rows(owner.points, "points", 3)))
    add_attributes(mesh, attributes, owner)
    mesh.GetPointData().SetActiveScalars(scalars)
    return mesh


def _named(name: str, values: NDArray[Any]) -> Any:
    array = numpy_to_vtk(np.ascontiguousarray(values))
    array.SetName(name)
    return array


def float_rows(values: Any, name: str, columns: int) -> NDArray[np.floating[Any]]:
    """A C-contiguous (n, columns) array of float32 or float64; copies what is not one yet.

    Raises InvalidInputError where the values have another shape or are no numbers.
    """
    try:
        array = np.asarray(values)
        if array.dtype not in (np.float32, np.float64):
            array = array.astype(np.float64, casting="same_kind")
    except (TypeError, ValueError) as error:
        raise InvalidInputError(f"{name} are not numbers: {error}") from None
    if array.ndim != 2 or array.shape[1] != columns:
        raise InvalidInputError(f"{name} have the shape {array.shape}, not (n, {columns})")
    return np.ascontiguousarray(array)


def index_rows(values: Any, name: str, points: int) -> NDArray[np.int64]:
    """An (m, k) array of point indices; copies what is not one yet.

    Raises InvalidInputError where the values have another shape or are not in [0, points).
    """
    array = np.asarray(values)
    if array.ndim != 2 or array.shape[1] < 1:
        raise InvalidInputError(f"{name} have the shape {array.shape}, not (m, k) with k >= 1")
    if array.size == 0:
        array = array.astype(np.int64)
    if not np.issubdtype(array.dtype, np.integer):
        raise InvalidInputError(f"{name} are of type {array.dtype}, not integers")
    for index in (array.min(), array.max()) if array.size > 0 else ():
        if not 0 <= index < points:
            raise InvalidInputError(
                f"{name} name the vertex {index}, but there are {points}, from 0 on")
    return array.astype(np.int64, copy=False)


def to_points(values: NDArray[Any]) -> vtkPoints:
    """Points that share numpy's memory."""
    array = numpy_to_vtk(values)
    points = vtkPoints()
    points.SetDataType(array.GetDataType())
    points.SetData(array)
    return points


def to_cells(sizes: NDArray[Any], connectivity: NDArray[Any]) -> vtkCellArray:
    """Cells of the given sizes over the joined indices of their corners; copies both."""
    offsets = np.concatenate([[0], np.cumsum(sizes)]).astype(np.int64)
    cells = vtkCellArray()
    # A cell array takes over the memory but not the object that would keep numpy's alive.
    cells.SetData(numpy_to_vtk(offsets, deep=1), numpy_to_vtk(connectivity, deep=1))
    return cells


def rows_to_cells(*blocks: NDArray[Any]) -> vtkCellArray:
    """The cells of all blocks, one a row; copies them."""
    sizes = [np.full(len(block), block.shape[1]) for block in blocks]
    return to_cells(np.concatenate(sizes),
                    np.concatenate([np.ravel(block) for block in blocks]).astype(np.int64))


def joined_cells(rows: Sequence[NDArray[Any]]) -> vtkCellArray:
    """Cells over rows of corners, which may differ in length; copies them."""
    return to_cells(np.array([len(row) for row in rows], np.int64),
                    np.concatenate([np.empty(0, np.int64), *rows]))


def cells_of_size(cells: vtkCellArray, size: int) -> NDArray[np.int64]:
    """The (m, size) corners of the cells that have so many; a copy."""
    offsets = vtk_to_numpy(cells.GetOffsetsArray()).astype(np.int64)
    starts = offsets[:-1][np.diff(offsets) == size]
    connectivity: NDArray[np.int64] = vtk_to_numpy(cells.GetConnectivityArray())
    corners: NDArray[np.int64] = connectivity[starts[:, np.newaxis] + np.arange(size)]
    return corners.astype(np.int64, copy=False)


def ragged_rows(cells: vtkCellArray) -> list[NDArray[np.int64]]:
    """The corners of each cell."""
    offsets = vtk_to_numpy(cells.GetOffsetsArray())
    return np.split(vtk_to_numpy(cells.GetConnectivityArray()), offsets[1:-1])
