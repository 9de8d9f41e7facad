from os import PathLike
from typing import Union

VERSION: str

def read(path: Union[str, PathLike[str]]) -> tuple[bytes, bytes]: ...
