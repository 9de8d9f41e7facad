"""Mesh files that the library itself does not read: .vtp."""

import os
import tempfile

from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkIOLegacy import vtkPolyDataWriter
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader

from ._mesh_file import read
from ._update import run

_VTP_END = b"</VTKFile>"


def read_vtp(path: str) -> tuple[bytes, bytes]:
    """As read() of _mesh_file, which also does what is the same for all files: it welds points and
    makes triangles. Raises ValueError, or Error where VTK's reader fails."""
    mesh = _polydata_of(path)
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


def _polydata_of(path: str) -> vtkPolyData:
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
