"""What the tests inside of pvpython share: meshes, values of outputs, and messages."""

import os
from contextlib import contextmanager
from pathlib import Path

from paraview import servermanager
from paraview.simple import Box, PLYReader, Show, STLReader, WavefrontOBJReader
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkOutputWindow, vtkStringOutputWindow

BUNNY = "/usr/share/glmark2/models/bunny.obj"  # of Debian's package glmark2-data
HALF_SIDES = (1.0, 0.7, 0.4)


def box():
    """A closed box about the origin, brought up to date, as defaults follow from its bounds."""
    source = Box(**{f"{axis}Length": 2 * half for axis, half in zip("XYZ", HALF_SIDES)})
    source.UpdatePipeline()
    return source


def bunny():
    return WavefrontOBJReader(registrationName="bunny.obj", FileName=BUNNY)


def real_meshes():
    """The bunny and, where the environment variable MEDIAL_MODELS names their folder, others."""
    yield "bunny", bunny()
    if "MEDIAL_MODELS" in os.environ:
        models = Path(os.environ["MEDIAL_MODELS"])
        yield "fandisk", WavefrontOBJReader(FileName=str(models / "cad/fandisk_13k.obj"))
        yield "gears", STLReader(FileNames=[str(models / "cad/gears_7comp_19k.stl")])
        yield "small bunny", PLYReader(FileNames=[str(models / "paper/bunny_2k.ply")])


def output(proxy, port=0):
    """The data of an output, brought up to date and here."""
    proxy.UpdatePipeline()
    return servermanager.Fetch(proxy, idx=port)


def points(data):
    return vtk_to_numpy(data.GetPoints().GetData())


def values(data, name):
    return vtk_to_numpy(data.GetPointData().GetArray(name))


def figure(proxy, name):
    """The first value of a field data array of the output: what the filter tells of itself."""
    return output(proxy).GetFieldData().GetAbstractArray(name).GetValue(0)


def default_colouring(proxy, view):
    """The array that ParaView colours an output by unless told otherwise."""
    return Show(proxy, view).ColorArrayName[1]


@contextmanager
def messages():
    """Collects what ParaView's output window would show."""
    window, before = vtkStringOutputWindow(), vtkOutputWindow.GetInstance()
    vtkOutputWindow.SetInstance(window)
    try:
        yield window.GetOutput
    finally:
        vtkOutputWindow.SetInstance(before)
