from os import PathLike
from typing import Optional, Union

from vtkmodules.vtkCommonDataModel import vtkImageData

MAX_SMOOTHING: int
VERSION: str

_Wanted = tuple[Optional[float], Optional[int], Optional[int]]

def read_mesh(path: Union[str, PathLike[str]]) -> tuple[bytes, bytes]: ...
def read_scan(path: Union[str, PathLike[str]], wanted: _Wanted) -> tuple[bytes, bytes]: ...
def scan_surface(
    image: vtkImageData, frame: tuple[float, ...], wanted: _Wanted
) -> tuple[bytes, bytes]: ...
