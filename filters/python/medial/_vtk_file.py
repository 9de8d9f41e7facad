"""Mesh files that the library itself does not read: .stl and .vtp."""

import os
import re
import tempfile
from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import NDArray
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkIOLegacy import vtkPolyDataWriter
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader

from ._arrays import rows_to_cells, to_points
from ._mesh_file import read
from ._update import run

# A binary STL file: a header, the number of triangles, and the triangles.
_HEADER = 84
_TRIANGLE = np.dtype([("normal", "<f4", 3), ("corners", "<f4", 9), ("unused", "<u2")])

# Words of a text STL file; names and normals may be anything up to the end of the line.
_BEGIN = re.compile(rb"\s*solid(?!\S)[^\n]*", re.IGNORECASE)
_END = re.compile(rb"\s*endsolid(?!\S)[^\n]*", re.IGNORECASE)
_FACET = re.compile(
    rb"\s*facet(?!\S)[^\n]*\n\s*outer\s+loop"
    + 3 * rb"\s+vertex\s+(\S+)\s+(\S+)\s+(\S+)" + rb"\s+endloop\s+endfacet(?!\S)", re.IGNORECASE)

_VTP_END = b"</VTKFile>"


def read_by_vtk(path: str) -> tuple[bytes, bytes]:
    """As read() of _mesh_file, which also does what is the same for all files: it welds points and
    makes triangles. Raises ValueError, or Error where VTK's reader fails."""
    mesh = READERS[extension_of(path)](path)
    with tempfile.TemporaryDirectory() as folder:
        writer = vtkPolyDataWriter()
        writer.SetInputData(mesh)
        writer.SetFileTypeToBinary()
        writer.SetFileName(os.path.join(folder, "mesh.vtk"))
        run(writer, None)
        try:
            return read(writer.GetFileName())
        except ValueError as error:
            raise ValueError(str(error).replace(writer.GetFileName(), path)) from None


def extension_of(path: str) -> str:
    """In lower case, with its point."""
    return os.path.splitext(path)[1].lower()


def _read_stl(path: str) -> vtkPolyData:
    with open(path, "rb") as file:
        content = file.read()
    try:
        corners = _corners_in(content)
    except ValueError as error:
        raise ValueError(f"{path}: {error}") from None
    points = corners.reshape(-1, 3)
    mesh = vtkPolyData()
    mesh.SetPoints(to_points(points))
    mesh.SetPolys(rows_to_cells(np.arange(len(points)).reshape(-1, 3)))
    return mesh


def _corners_in(content: bytes) -> NDArray[np.float32]:
    """(m, 9) coordinates of the triangles of an STL file."""
    triangles = int.from_bytes(content[_HEADER - 4:_HEADER], "little")
    expected = _HEADER + _TRIANGLE.itemsize * triangles
    if len(content) == expected:
        return np.ascontiguousarray(np.frombuffer(content, _TRIANGLE, offset=_HEADER)["corners"])
    if not content.startswith(b"solid") or b"\0" in content[:_HEADER]:
        raise ValueError(
            f"not a complete STL file: it is not text that starts with 'solid', and the "
            f"{triangles} triangles of a binary one would take {expected} bytes, "
            f"not {len(content)}")
    return _corners_in_text(content)


def _corners_in_text(content: bytes) -> NDArray[np.float32]:
    words: list[bytes] = []
    position = 0
    is_open = False  # between solid and endsolid
    while True:
        facet = _FACET.match(content, position) if is_open else None
        found = facet or (_END if is_open else _BEGIN).match(content, position)
        if not found:
            break
        position = found.end()
        words += facet.groups() if facet else ()
        is_open = is_open if facet else not is_open
    rest = content[position:].lstrip()
    if rest:
        line = content.count(b"\n", 0, len(content) - len(rest)) + 1
        word = rest.split(None, 1)[0][:40].decode(errors="replace")
        wanted = "a whole facet or endsolid" if is_open else "solid"
        raise ValueError(f"line {line}: '{word}' does not begin {wanted}")
    if is_open:
        raise ValueError("ends early: its last solid has no 'endsolid'")
    with np.errstate(over="ignore"):  # infinite coordinates are refused where they are used
        return np.array([_coordinate(word) for word in words]).astype(np.float32).reshape(-1, 9)


def _coordinate(word: bytes) -> float:
    try:
        return float(word)
    except ValueError:
        text = word[:40].decode(errors="replace")
        raise ValueError(f"'{text}' in place of a coordinate") from None


def _read_vtp(path: str) -> vtkPolyData:
    """Refuses what was cut short; the rest is left to VTK's reader, which misses some damage."""
    with open(path, "rb") as file:
        file.seek(max(0, os.path.getsize(path) - 4096))
        end = file.read().rstrip()
    if not end.endswith(_VTP_END):
        raise ValueError(f"{path}: not a complete .vtp file: it does not end with "
                         f"{_VTP_END.decode()}")
    reader = vtkXMLPolyDataReader()
    reader.SetFileName(path)
    run(reader, None)
    mesh: vtkPolyData = reader.GetOutput()
    return mesh


READERS: dict[str, Callable[[str], Any]] = {".stl": _read_stl, ".vtp": _read_vtp}
"""By extension."""
