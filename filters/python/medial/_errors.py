"""What goes wrong, as exceptions."""

from .vtkMedialFilters import vtkMeshFieldAlgorithm


class Error(RuntimeError):
    """A filter failed; the text is the cause. Superclass of what follows."""


class InvalidInputError(Error, ValueError):
    """A mesh that cannot be used, or a parameter outside its range; the text names the value."""


class NoGpuError(Error):
    """There is no usable OpenGL 4.5, or only a software renderer where hardware is required."""


class OutOfMemoryError(Error, MemoryError):
    """There is not enough memory for the result."""


for _class in (Error, InvalidInputError, NoGpuError, OutOfMemoryError):
    _class.__module__ = "medial"  # where users find it, in tracebacks

_CLASSES: dict[int, type[Error]] = {
    vtkMeshFieldAlgorithm.InvalidInputError: InvalidInputError,
    vtkMeshFieldAlgorithm.NoGpuError: NoGpuError,
    vtkMeshFieldAlgorithm.OutOfMemoryError: OutOfMemoryError,
}


def error_class(code: int) -> type[Error]:
    """The class for a value of GetErrorCode() of the filters."""
    return _CLASSES.get(code, Error)
