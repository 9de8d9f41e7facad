"""Parameters of the functions, and how filters are told of them."""

from collections.abc import Collection, Mapping, Sequence
from typing import Any, Literal, Optional, Union

from ._errors import InvalidInputError
from .vtkMedialFilters import vtkMedialAxis, vtkMeshFieldAlgorithm

Side = Literal["interior", "exterior", "both"]
Sign = Literal["auto", "none", "pseudonormal", "winding"]
Evaluator = Literal["auto", "rasteriser", "processor"]
Representation = Literal["surface", "faces", "points"]
Topology = Literal["selected", "preserve"]
FieldArray = Literal["closest_point", "closest_cell", "closest_feature", "closest_site"]
Lengths = Union[float, Sequence[float]]
"""One length for all three axes, or one for each."""

SIDES: dict[str, int] = {
    "interior": vtkMedialAxis.INTERIOR,
    "exterior": vtkMedialAxis.EXTERIOR,
    "both": vtkMedialAxis.BOTH,
}
SIGNS: dict[str, int] = {
    "auto": vtkMeshFieldAlgorithm.SIGN_AUTO,
    "none": vtkMeshFieldAlgorithm.SIGN_NONE,
    "pseudonormal": vtkMeshFieldAlgorithm.SIGN_PSEUDONORMAL,
    "winding": vtkMeshFieldAlgorithm.SIGN_WINDING,
}
EVALUATORS: dict[str, int] = {
    "auto": vtkMeshFieldAlgorithm.EVALUATOR_AUTO,
    "rasteriser": vtkMeshFieldAlgorithm.EVALUATOR_RASTERISER,
    "processor": vtkMeshFieldAlgorithm.EVALUATOR_PROCESSOR,
}
REPRESENTATIONS: dict[str, int] = {
    "surface": vtkMedialAxis.SURFACE,
    "faces": vtkMedialAxis.FACES,
    "points": vtkMedialAxis.POINTS,
}
TOPOLOGIES: dict[str, int] = {
    "selected": vtkMedialAxis.SELECTED,
    "preserve": vtkMedialAxis.PRESERVE,
}
ARRAYS: dict[str, str] = {
    "closest_point": "ClosestPoint",
    "closest_cell": "ClosestCell",
    "closest_feature": "ClosestFeature",
    "closest_site": "ClosestSite",
}


def choice(name: str, value: str, choices: Mapping[str, int]) -> int:
    """The filter's constant for a word; raises InvalidInputError for any other."""
    try:
        return choices[value]
    except (KeyError, TypeError):
        raise InvalidInputError(f"{name} {value!r} is none of {', '.join(choices)}") from None


def word(value: int, choices: Mapping[str, int]) -> Any:
    """The word for a constant of the filter."""
    return next(name for name, constant in choices.items() if constant == value)


def assign(algorithm: Any, **parameters: Any) -> None:
    """Sets parameters of a filter, such as Angle; an error of type or range names the parameter."""
    for name, value in parameters.items():
        values = value if isinstance(value, tuple) else (value,)
        try:
            getattr(algorithm, "Set" + name)(*values)
        except TypeError as error:
            raise TypeError(f"{name} {value!r}: {error}") from None
        except (OverflowError, ValueError) as error:
            raise InvalidInputError(f"{name} {value!r}: {error}") from None


def assign_grid(algorithm: vtkMeshFieldAlgorithm, *, resolution: int, spacing: Optional[Lengths],
                origin: Optional[Sequence[float]], dimensions: Optional[Sequence[int]],
                padding: float) -> None:
    """The grid of sample points, see distance_field()."""
    assign(algorithm, Resolution=resolution, Padding=padding)
    if spacing is not None:
        assign(algorithm, Spacing=_triple("spacing", spacing))
        algorithm.SetGridModeToSpacing()
    if (origin is None) != (dimensions is None) or (origin is not None and spacing is None):
        raise InvalidInputError("an explicit grid needs origin, spacing and dimensions")
    if origin is not None:
        assign(algorithm, Origin=_triple("origin", origin),
               Dimensions=_triple("dimensions", dimensions))
        algorithm.SetGridModeToExplicit()


def assign_run(algorithm: vtkMeshFieldAlgorithm, *, sign: Sign, threads: int, memory: int,
               evaluator: Evaluator, require_gpu: bool) -> None:
    """How the field is computed, see distance_field()."""
    assign(algorithm, SignMethod=choice("sign", sign, SIGNS), NumberOfThreads=threads,
           MemoryLimit=memory, Evaluator=choice("evaluator", evaluator, EVALUATORS),
           RequireHardware=bool(require_gpu))


def assign_arrays(algorithm: vtkMeshFieldAlgorithm, arrays: Collection[str]) -> None:
    """The arrays beside the distance, see distance_field()."""
    arrays = [arrays] if isinstance(arrays, str) else arrays
    for name in arrays:
        if name not in ARRAYS:
            raise InvalidInputError(f"array {name!r} is none of {', '.join(ARRAYS)}")
    assign(algorithm, **{"Generate" + ARRAYS[name]: name in arrays for name in ARRAYS})


def _triple(name: str, value: Any) -> tuple[Any, ...]:
    """Three values, from one or from three."""
    try:
        values = tuple(value)
    except TypeError:
        values = (value,) * 3
    if len(values) != 3 or isinstance(value, str):
        raise InvalidInputError(f"{name} {value!r} is not of three numbers")
    return values
