"""Executing filters."""

import re
import warnings
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Any, Optional

from vtkmodules.vtkCommonCore import vtkObject
from vtkmodules.vtkCommonExecutionModel import vtkAlgorithm, vtkExecutive
from vtkmodules.vtkCommonMisc import vtkErrorCode

from ._errors import error_class
from ._execution import update as execute
from .vtkMedialFilters import vtkMeshFieldAlgorithm

Progress = Callable[[float, str], object]

# VTK's message where a filter fails without one: the request follows, with addresses and times.
_MUTE_FAILURE = re.compile(r"Algorithm (\w+)\(\w+\) returned failure for request: .*", re.DOTALL)
_MUTE = "failed without an error message"


def update(algorithm: Any, progress: Optional[Progress] = None) -> None:
    """Brings the outputs of a filter up to date, as its Update() does, but with exceptions.

    Other Python threads run meanwhile, unless part of the pipeline is written in Python. Ctrl-C
    stops the filter.

    algorithm: any vtkAlgorithm, with the pipeline before it.
    progress: called with the share of the work that is done, in [0, 1], and the name of what is
        being done. An exception that it raises stops the filter and is raised here.

    Raises Error or a subclass with the messages of all filters that failed, or of one that an
    observer aborted, KeyboardInterrupt after Ctrl-C (in the main thread), and TypeError where
    algorithm is no vtkAlgorithm. Warns (UserWarning) with the warnings of the filters.

    After vtkObject.GlobalWarningDisplayOff() exceptions are the same where filters of this package
    fail, but there are no warnings. VTK then keeps the messages of its own filters to itself: what
    failed is known by its error code or by the end of the update alone.

    What failed or was stopped is executed again by the next update, even if nothing was changed,
    and raises the same again until its cause is gone. This also holds for VTK's readers, which by
    themselves would then pass on what they have of an output. A failure in VTK's own Update() is
    not known here: VTK may crash in the next update of that pipeline, by whichever function, unless
    Modified() of what failed is called before.
    """
    run(algorithm, progress)


def run(algorithm: Any, progress: Optional[Progress]) -> None:
    """As update(), for functions of this package: warnings name the line that called them."""
    messages: list[str] = []
    sources = _pipeline_of(algorithm)
    with _failures_executed_again(sources, messages):
        done, errors, notes = execute(algorithm, progress)
        messages += _causes(sources, done, errors)
    for note in notes:
        warnings.warn(note, stacklevel=3)
    if messages:
        raise error_class(algorithm.GetErrorCode())("; ".join(messages))


def _causes(sources: list[vtkAlgorithm], done: bool, errors: list[str]) -> list[str]:
    """What has failed and why: the messages, or what is known without one; empty if nothing has.
    VTK passes on no messages of its own while vtkObject.GlobalWarningDisplay is off."""
    told = [text for text in errors if not _MUTE_FAILURE.match(text)]
    known = [_failure_by_code(one) for one in reversed(sources)
             if one.GetErrorCode() and not (told and _tells(one))]
    if told:
        return known + told
    if known or (done and not errors):
        return known
    if errors:
        return [_MUTE_FAILURE.sub(rf"\1 {_MUTE}", text) for text in errors]
    missing = [f"input port {port} of {one.GetClassName()} has 0 connections"
               for one in sources for port in range(one.GetNumberOfInputPorts())
               if one.GetNumberOfInputConnections(port) == 0 and not
               one.GetInputPortInformation(port).Has(vtkAlgorithm.INPUT_IS_OPTIONAL())]
    return missing or [" or ".join(one.GetClassName() for one in reversed(sources)) + f" {_MUTE}"]


def _tells(algorithm: vtkAlgorithm) -> bool:
    """Whether it passes on the messages of its errors: filters of this package always do."""
    own = algorithm.GetErrorCode() > vtkErrorCode.UserError
    return own or bool(vtkObject.GetGlobalWarningDisplay())


def _failure_by_code(algorithm: vtkAlgorithm) -> str:
    code = algorithm.GetErrorCode()
    if code == vtkMeshFieldAlgorithm.CancelledError:
        return f"{algorithm.GetClassName()} was aborted"
    return f"{algorithm.GetClassName()} {_MUTE} ({vtkErrorCode.GetStringFromErrorCode(code)})"


@contextmanager
def _failures_executed_again(sources: list[vtkAlgorithm], messages: list[str]) -> Iterator[None]:
    """Lets algorithms that fail meanwhile, if there are messages, or are stopped by an exception,
    not count as up to date. To VTK they are, with whatever their outputs have by then."""
    failed: dict[Any, str] = {}
    # Built in, so that no Ctrl-C arrives within it: VTK would end the process.
    observer = failed.setdefault
    observed = [(source, source.AddObserver("ErrorEvent", observer))
                for one in sources for source in (one, one.GetExecutive())]
    stopped: list[Any] = []
    try:
        yield
    except BaseException:
        stopped = [one for one in sources if one.GetAbortExecute()] or sources
        raise
    finally:
        for source, tag in observed:
            source.RemoveObserver(tag)
        if messages:
            stopped = [source.GetAlgorithm() if isinstance(source, vtkExecutive) else source
                       for source in failed]
            # Some have told nobody: those that threw an exception, and VTK's without warnings.
            stopped = stopped + [one for one in sources if one.GetErrorCode()] or sources
        for one in stopped:
            one.Modified()


def _pipeline_of(algorithm: Any) -> list[vtkAlgorithm]:
    """The algorithm and all before it; none if it is no algorithm."""
    found: list[vtkAlgorithm] = []
    waiting = [algorithm]
    while waiting:
        one = waiting.pop()
        if isinstance(one, vtkAlgorithm) and one not in found:
            found.append(one)
            waiting += [one.GetInputAlgorithm(port, i)
                        for port in range(one.GetNumberOfInputPorts())
                        for i in range(one.GetNumberOfInputConnections(port))]
    return found
