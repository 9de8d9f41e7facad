"""Run by redistributed_test.py in pvbatch: field and axis of a surface that RedistributeDataSet shares out.

usage: pvbatch redistributed_field.py FOLDER
"""

import json
import os
import sys

from paraview.simple import *

MODES = ("Assign to one region", "Assign to all regions", "Split cells")


def bunny():
    return WavefrontOBJReader(FileName="/usr/share/glmark2/models/bunny.obj")


def field_of(source, mode):
    """Cells that are split have ends that differ in their last bits, so the surface is not closed."""
    return MeshDistanceField(Input=source, Resolution=72, Engine="Processor", DistributedInput=int(mode is not None),
                             SignMethod="None" if mode == MODES[2] else "Pseudonormal")


def axis_of(source, mode):
    return MedialAxis(Input=source, Resolution=72, Engine="Processor", DistributedInput=int(mode is not None),
                      SignMethod="Pseudonormal")


def integrals(proxy, name):
    """The area or volume of a surface or solid in pieces."""
    sums = IntegrateVariables(Input=proxy)
    sums.UpdatePipeline()
    return sums.CellData[name].GetRange()[0]


def figures(field):
    """What filters behind it, which want ghosts, make of it."""
    contour = Contour(Input=field, ContourBy="Distance", Isosurfaces=[0.02])
    clip = Clip(Input=field)
    clip.ClipType = "Plane"
    clip.ClipType.Origin = [0.1, 0.05, 0.0]
    clip.ClipType.Normal = [1.0, 0.5, 0.25]
    return {"clip": integrals(clip, "Volume"), "contour": integrals(contour, "Area"),
            "bounds": contour.GetDataInformation().GetBounds()}


folder = sys.argv[1]
result = {}
for mode in (None, *MODES):
    name = (mode or "whole").replace(" ", "_")
    source = RedistributeDataSet(Input=bunny(), BoundaryMode=mode) if mode else bunny()
    field = field_of(source, mode)
    SaveData(os.path.join(folder, f"{name}.pvti"), proxy=field)
    result[name] = figures(field)
    if mode != MODES[2]:
        result[name]["axis"] = integrals(axis_of(source, mode), "Area")
    arrays = field.FieldData
    result[name]["held"] = arrays["HeldTriangles"].GetRange() if mode else None
with open(os.path.join(folder, "result.json"), "w") as file:
    json.dump(result, file)
