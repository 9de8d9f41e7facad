"""Run by client_server_test.py in pvpython: outputs and a picture from a server; prints JSON.

usage: pvpython remote_client.py PORT PICTURE
"""

import json
import sys

from paraview.simple import *

Connect("127.0.0.1", int(sys.argv[1]))
mesh = WavefrontOBJReader(FileName="/usr/share/glmark2/models/bunny.obj")
field = MeshDistanceField(Input=mesh, Resolution=48)
axis = MedialAxis(Input=mesh, Resolution=64)
view = CreateView("RenderView", ViewSize=[240, 200])
Show(field, view)
Show(axis, view)
view.ResetCamera()
SaveScreenshot(sys.argv[2], view)
result = {"field": field.GetDataInformation().GetNumberOfPoints(),
          "samples of a process": field.FieldData["Samples"].GetRange(),
          "distance": field.PointData["Distance"].GetRange(),
          "axis": axis.GetDataInformation().GetNumberOfPoints()}
# A reader of its own: the axis asks for the whole surface.
numbered = GenerateGlobalIds(Input=WavefrontOBJReader(FileName="/usr/share/glmark2/models/bunny.obj"))
pieces = RedistributeDataSet(Input=numbered)
apart = MeshDistanceField(Input=pieces, Resolution=48, SignMethod="Pseudonormal", DistributedInput=1)
Show(Contour(Input=apart, ContourBy="Distance", Isosurfaces=[0.02]), view)
Render(view)
result["distance of pieces"] = apart.PointData["Distance"].GetRange()
apart.Resolution = 40
Render(view)
result["points of pieces"] = apart.GetDataInformation().GetNumberOfPoints()
parted = MedialAxis(Input=pieces, Resolution=40, Engine="Processor", DistributedInput=1)
clip = Clip(Input=parted)
clip.ClipType.Normal = [1.0, 0.5, 0.25]
for proxy in (clip, Contour(Input=parted, ContourBy="Radius", Isosurfaces=[0.2])):
    Show(proxy, view)
Render(view)
data = servermanager.Fetch(parted)
places = [data.GetPoint(i) for i in range(data.GetNumberOfPoints())]
cells = []
for i in range(data.GetNumberOfCells()):
    cell = data.GetCell(i)
    cells.append([places[cell.GetPointId(corner)] for corner in range(cell.GetNumberOfPoints())])
result["axis of pieces"] = {"points": sorted(set(places)), "cells": sorted(cells),
                            "clip": clip.GetDataInformation().GetNumberOfCells(),
                            "curves": servermanager.Fetch(MedialCurves(Input=parted)).GetNumberOfCells()}
axis.Resolution = 1
axis.UpdatePipeline()
result["axis after an error"] = axis.GetDataInformation().GetNumberOfPoints()
print(json.dumps(result))
