"""Run by redistributed_test.py in pvbatch: field, axis, its reconstruction and thickness of a surface that
RedistributeDataSet shares out.

usage: pvbatch redistributed_field.py FOLDER
"""

import json
import os
import sys

from paraview.simple import *

MODES = ("Assign to one region", "Assign to all regions", "Split cells")


def bunny():
    """With ids of points and cells, so that no order of pieces decides between features that are equally near."""
    return GenerateGlobalIds(Input=WavefrontOBJReader(FileName="/usr/share/glmark2/models/bunny.obj"))


def field_of(source, mode):
    """Cells that are split have ends that differ in their last bits, so the surface is not closed."""
    return MeshDistanceField(Input=source, Resolution=72, Engine="Processor", DistributedInput=int(mode is not None),
                             SignMethod="None" if mode == MODES[2] else "Pseudonormal")


def axis_of(source, mode):
    return MedialAxis(Input=source, Resolution=40, Engine="Processor", DistributedInput=int(mode is not None))


def reconstruction_of(axis, mode):
    return MedialReconstruction(Input=axis, Resolution=40, DistributedInput=int(mode is not None))


def thickness_of(source, mode):
    return MedialThickness(Input=source, CellValues=1, DistributedInput=int(mode is not None))


def integrals(proxy, name):
    """The length, area or volume of data in pieces."""
    sums = IntegrateVariables(Input=proxy)
    sums.UpdatePipeline()
    return sums.CellData[name].GetRange()[0]


def clipped(proxy):
    clip = Clip(Input=proxy)
    clip.ClipType = "Plane"
    clip.ClipType.Origin = [0.1, 0.05, 0.0]
    clip.ClipType.Normal = [1.0, 0.5, 0.25]
    return clip


def figures(field):
    """What filters behind it, which want ghosts, make of it."""
    contour = Contour(Input=field, ContourBy="Distance", Isosurfaces=[0.02])
    return {"clip": integrals(clipped(field), "Volume"), "contour": integrals(contour, "Area"),
            "bounds": contour.GetDataInformation().GetBounds()}


def sizes(proxy):
    """What all processes have of it."""
    proxy.UpdatePipeline()
    data = proxy.GetDataInformation()
    return [data.GetNumberOfPoints(), data.GetNumberOfCells(), *data.GetBounds()]


def axis_figures(axis):
    """What filters behind it make of it: of its pieces, and of the whole."""
    contour = Contour(Input=axis, ContourBy="Radius", Isosurfaces=[0.2])
    return {"area": integrals(axis, "Area"), "clip": integrals(clipped(axis), "Area"),
            "contour": integrals(contour, "Length"), "curves": sizes(MedialCurves(Input=axis)),
            "reconstruction": sizes(MedialReconstruction(Input=axis, Resolution=24))}


folder = sys.argv[1]
result = {}
for mode in (None, *MODES):
    name = (mode or "whole").replace(" ", "_")
    source = RedistributeDataSet(Input=bunny(), BoundaryMode=mode) if mode else bunny()
    field = field_of(source, mode)
    SaveData(os.path.join(folder, f"{name}.pvti"), proxy=field)
    axis = axis_of(source, mode)
    SaveData(os.path.join(folder, f"{name}.pvtp"), proxy=axis)
    SaveData(os.path.join(folder, f"{name}_reconstruction.pvtp"), proxy=reconstruction_of(axis, mode))
    thickness = thickness_of(source, mode)
    SaveData(os.path.join(folder, f"{name}_thickness.pvtp"), proxy=thickness)
    result[name] = {**figures(field), "axis": axis_figures(axis),
                    "thickness": {"area": integrals(thickness, "Area"),
                                  "median": thickness.FieldData["MedianThickness"].GetRange()},
                    "held": field.FieldData["HeldTriangles"].GetRange() if mode else None}
with open(os.path.join(folder, "result.json"), "w") as file:
    json.dump(result, file)
