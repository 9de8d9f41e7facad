"""Executing filters."""

import warnings
from collections.abc import Callable
from typing import Any, Optional

from ._errors import error_class
from ._execution import update as execute

Progress = Callable[[float, str], object]


def update(algorithm: Any, progress: Optional[Progress] = None) -> None:
    """Brings the outputs of a filter up to date, as its Update() does, but with exceptions.

    Other Python threads run meanwhile, unless part of the pipeline is written in Python. Ctrl-C
    stops the filter.

    algorithm: any vtkAlgorithm, with the pipeline before it.
    progress: called with the share of the work that is done, in [0, 1], and the name of what is
        being done. An exception that it raises stops the filter and is raised here.

    Raises Error or a subclass with the messages of all filters that failed, KeyboardInterrupt after
    Ctrl-C (in the main thread), and TypeError where algorithm is no vtkAlgorithm. Warns
    (UserWarning) with the warnings of the filters.
    """
    run(algorithm, progress)


def run(algorithm: Any, progress: Optional[Progress]) -> None:
    """As update(), for functions of this package: warnings name the line that called them."""
    messages, notes = execute(algorithm, progress)
    for note in notes:
        warnings.warn(note, stacklevel=3)
    if messages:
        raise error_class(algorithm.GetErrorCode())("; ".join(messages))
