"""The surfaces of solids in images."""

import math
import os
from os import PathLike
from typing import Any, Optional, Union

import numpy as np
from numpy.typing import ArrayLike, NDArray
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonDataModel import vtkImageData

from . import _files
from ._errors import InvalidInputError
from ._mesh import Surface, surface_of
from ._options import as_integer, as_real


def read_scan(path: Union[str, PathLike[str]], *, isovalue: Optional[float] = None,
              label: Optional[int] = None, smoothing: Optional[int] = None) -> Surface:
    """Reads an image of a solid from a file, and extracts its surface: .nrrd, .mha, .mhd, .nii,
    .nii.gz or .vti.

    The surface is in the physical space of the file, whose axis directions, spacing and origin
    count; NIfTI's is not turned from RAS to LPS. A file that was cut short, or contradicts itself,
    is refused; it is never read in part.

    path: name of the file.
    isovalue, label, smoothing: see scan_surface().

    Raises InvalidInputError where the file cannot be read, or has no such surface.
    """
    return surface_of(_files.read_scan, os.fsdecode(path), _wanted(isovalue, label, smoothing))


def scan_surface(values: ArrayLike, affine: Optional[ArrayLike] = None, *,
                 isovalue: Optional[float] = None, label: Optional[int] = None,
                 smoothing: Optional[int] = None) -> Surface:
    """Extracts the surface of a solid in an image.

    A surface that reaches the border of the image is closed there: outside is what most of the
    border is. Values that are NaN are outside; if the border has no others, most of the voxels next
    to them decide what outside is. Normals lead outwards.

    values: (nx, ny, nz) one number for each voxel, grey values or labels.
    affine: (4, 4) or (3, 4) matrix that takes the index [i, j, k] of a voxel, with a 1 behind it, to
        its centre in world units, as nibabel has it; default the index itself.
    isovalue: the surface where the values are this, interpolated.
    label: the boundary of the voxels with this value; exactly one of isovalue and label is needed.
    smoothing: iterations of the windowed sinc filter that smooths the surface, in [0, 1000]; default
        20 for a label, whose surface has steps, and 0 for an isovalue. Parts of a label that are one
        voxel wide keep their steps.

    Raises InvalidInputError where the image has no such surface. The message names the labels, or
    the range of the values, that it has.
    """
    wanted = _wanted(isovalue, label, smoothing)
    return surface_of(_files.scan_surface, _image(values), _frame(affine), wanted)


def _wanted(isovalue: Optional[float], label: Optional[int],
            smoothing: Optional[int]) -> tuple[Optional[float], Optional[int], Optional[int]]:
    if (isovalue is None) == (label is None):
        raise InvalidInputError("choose the surface of a scan with either an isovalue or a label")
    if isovalue is not None:
        isovalue = as_real("isovalue", isovalue, "(-inf, inf)")
        if not math.isfinite(isovalue):
            raise InvalidInputError(f"isovalue {isovalue} is outside (-inf, inf)")
    if label is not None:
        label = as_integer("label", label, -2**63, 2**63 - 1)
    if smoothing is not None:
        smoothing = as_integer("smoothing", smoothing, 0, _files.MAX_SMOOTHING)
    return isovalue, label, smoothing


def _image(values: ArrayLike) -> vtkImageData:
    """A copy of the values: NaN will be replaced there."""
    array = np.asarray(values)
    if array.ndim != 3 or array.size == 0:
        raise InvalidInputError(f"values have the shape {array.shape}, not (nx, ny, nz)")
    if array.dtype.kind not in "biuf":
        raise InvalidInputError(f"values are of type {array.dtype}, not numbers")
    kept = {"bool": np.uint8, "float16": np.float32, "float128": np.float64}
    native = kept.get(array.dtype.name, array.dtype.newbyteorder("="))
    image = vtkImageData()
    image.SetDimensions(array.shape)
    flat = array.astype(native, order="F").ravel(order="F")
    image.GetPointData().SetScalars(numpy_to_vtk(flat))
    return image


def _frame(affine: Optional[ArrayLike]) -> tuple[float, ...]:
    """The first three rows, one after the other."""
    try:
        matrix: NDArray[Any] = np.asarray(np.eye(4) if affine is None else affine, dtype=np.float64)
    except (TypeError, ValueError) as error:
        raise InvalidInputError(f"affine is no matrix of numbers: {error}") from None
    if matrix.shape not in ((3, 4), (4, 4)):
        raise InvalidInputError(f"affine has the shape {matrix.shape}, not (4, 4)")
    if len(matrix) == 4 and matrix[3].tolist() != [0, 0, 0, 1]:
        raise InvalidInputError(f"the last row of affine is {matrix[3].tolist()}, not [0, 0, 0, 1]")
    volume = np.linalg.det(matrix[:3, :3])
    if volume == 0 or not np.isfinite(matrix).all() or not np.isfinite(volume):
        raise InvalidInputError("the axes of affine span no volume, or it has a number that is not finite")
    return tuple(matrix[:3].ravel().tolist())
