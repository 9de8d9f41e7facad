from typing import Callable, Optional

def update(
    algorithm: object, progress: Optional[Callable[[float, str], object]] = None
) -> tuple[bool, list[str], list[str]]: ...
