"""Parameters of the functions, and how they are passed to filters."""

from collections.abc import Collection, Mapping, Sequence
from operator import index
from typing import Any, Literal, Optional, Union

from ._errors import InvalidInputError
from .vtkMedialFilters import (vtkMedialAxis, vtkMedialSkeleton, vtkMedialThickness,
                               vtkMeshFieldAlgorithm)

Side = Literal["interior", "exterior", "both"]
Sign = Literal["auto", "none", "pseudonormal", "winding"]
Engine = Literal["auto", "device", "rasteriser", "processor"]
Representation = Literal["surface", "faces", "points"]
Topology = Literal["selected", "preserve"]
ThicknessMethod = Literal["ball", "ray", "wall"]
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
ENGINES: dict[str, int] = {
    "auto": vtkMeshFieldAlgorithm.ENGINE_AUTO,
    "device": vtkMeshFieldAlgorithm.ENGINE_DEVICE,
    "rasteriser": vtkMeshFieldAlgorithm.ENGINE_RASTERISER,
    "processor": vtkMeshFieldAlgorithm.ENGINE_PROCESSOR,
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
THICKNESS_METHODS: dict[str, int] = {
    "ball": vtkMedialThickness.BALL,
    "ray": vtkMedialThickness.RAY,
    "wall": vtkMedialThickness.WALL,
}
ARRAYS: dict[str, str] = {
    "closest_point": "ClosestPoint",
    "closest_cell": "ClosestCell",
    "closest_feature": "ClosestFeature",
    "closest_site": "ClosestSite",
}

# Parameters that are numbers: what the filters call them, and the values that they may have.
_INTEGERS: dict[str, tuple[str, int, int]] = {
    "resolution": ("Resolution", 2, 8192),
    "dimensions": ("Dimensions", 1, 8192),
    "max_spheres": ("MaximumNumberOfSpheres", 0, 2147483647),
    "bins": ("NumberOfBins", 1, 65536),
    "max_contacts": ("MaximumNumberOfContacts", 0, 2147483647),
    "threads": ("NumberOfThreads", 0, 1024),
    "memory": ("MemoryLimit", 0, 2147483647),  # but not 1 to 63
}
_MIN_MEMORY = 64  # MiB
_REALS: dict[str, tuple[str, str]] = {
    "spacing": ("Spacing", "(0, inf)"),
    "origin": ("Origin", "(-inf, inf)"),
    "padding": ("Padding", "[0, 10]"),
    "angle": ("Angle", "(0, 180)"),
    "min_lambda": ("MinimumLambda", "[0, inf)"),
    "min_radius": ("MinimumRadius", "[0, inf)"),
    "min_branch": ("MinimumBranch", "[0, inf)"),
    "depth_tolerance": ("DepthTolerance", "(0, 1)"),
    "max_edge": ("MaximumEdgeLength", "[0, inf)"),
    "min_thickness": ("MinimumThickness", "[0, inf)"),
    "max_thickness": ("MaximumThickness", "[0, inf)"),
    "max_separation": ("MaximumSeparation", "[0, inf]"),
}

_TRIPLES = ("spacing", "origin", "dimensions")


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
    """Sets parameters of a filter, such as Side, to values that it accepts."""
    for name, value in parameters.items():
        getattr(algorithm, "Set" + name)(value)


def assign_numbers(algorithm: Any, **parameters: Any) -> None:
    """Sets parameters that are numbers, or tuples of them; the filter checks the range of reals.

    Raises TypeError where a value is no number, or no integer where one is needed, and
    InvalidInputError where it is outside its range.
    """
    for name, value in parameters.items():
        convert = _integer if name in _INTEGERS else _real
        several = name in _TRIPLES and isinstance(value, tuple)
        values = [convert(name, item) for item in (value if several else (value,))]
        getattr(algorithm, "Set" + (_INTEGERS.get(name) or _REALS[name])[0])(*values)


def _integer(name: str, value: Any) -> int:
    _, lowest, highest = _INTEGERS[name]
    return as_integer(name, value, lowest, highest)


def _real(name: str, value: Any) -> float:
    _, allowed = _REALS[name]
    return as_real(name, value, allowed)


def as_integer(name: str, value: Any, lowest: int, highest: int) -> int:
    """A parameter as an integer in [lowest, highest]; raises as assign_numbers()."""
    try:
        number = index(value)
    except TypeError:
        raise TypeError(f"{name} {value!r} is not an integer in [{lowest}, {highest}]") from None
    if not lowest <= number <= highest:
        raise InvalidInputError(f"{name} {number} is outside [{lowest}, {highest}]")
    return number


def as_real(name: str, value: Any, allowed: str) -> float:
    """A parameter as a float; raises as assign_numbers(), but the range is left to the caller.

    allowed: the range as messages say it."""
    try:
        if isinstance(value, (str, bytes)):
            raise TypeError
        return float(value)
    except (TypeError, ValueError):
        raise TypeError(f"{name} {value!r} is not a number in {allowed}") from None
    except OverflowError:
        raise InvalidInputError(f"{name} {value!r} is outside {allowed}") from None


def assign_grid(algorithm: vtkMeshFieldAlgorithm, *, resolution: Union[int, str, None],
                spacing: Optional[Lengths], origin: Optional[Sequence[float]],
                dimensions: Optional[Sequence[int]], padding: Optional[float]) -> None:
    """The grid, see distance_field() and skeleton()."""
    given = {name: value for name, value in (
        ("resolution", resolution), ("padding", padding), ("spacing", spacing), ("origin", origin),
        ("dimensions", dimensions)) if value is not None}
    explicit = "origin" in given or "dimensions" in given
    if explicit and not {"origin", "spacing", "dimensions"} <= given.keys():
        raise InvalidInputError("an explicit grid needs origin, spacing and dimensions")
    for one, other in (("resolution", "spacing"), ("padding", "origin")):
        if one in given and other in given:
            raise InvalidInputError(
                f"{one} {given[one]!r} and {other} {given[other]!r} exclude each other")
    if isinstance(given.get("resolution"), str) and isinstance(algorithm, vtkMedialSkeleton):
        word = given.pop("resolution")
        if word != "auto":
            raise TypeError(f"resolution {word!r} is not an integer in [2, 8192] or 'auto'")
        assign(algorithm, AutomaticResolution=True)
    assign_numbers(algorithm, **{
        name: value if name in ("resolution", "padding") else _triple(name, value)
        for name, value in given.items()})
    if explicit:
        algorithm.SetGridModeToExplicit()
    elif "spacing" in given:
        algorithm.SetGridModeToSpacing()


def assign_run(algorithm: vtkMeshFieldAlgorithm, *, sign: Sign, threads: int, memory: int,
               engine: Engine, device: Union[str, int], require_gpu: bool) -> None:
    """How the field is computed, see distance_field()."""
    assign_numbers(algorithm, threads=threads, memory=memory)
    if 0 < memory < _MIN_MEMORY:
        raise InvalidInputError(f"memory {memory} is outside [{_MIN_MEMORY}, 2147483647] and not 0")
    assign(algorithm, SignMethod=choice("sign", sign, SIGNS),
           Engine=choice("engine", engine, ENGINES), Device=str(device), RequireHardware=bool(require_gpu))


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
        values = (value,) * 3 if isinstance(value, (str, bytes)) else tuple(value)
    except TypeError:
        values = (value,) * 3
    if len(values) != 3:
        raise InvalidInputError(f"{name} {value!r} is not of three numbers")
    return values
