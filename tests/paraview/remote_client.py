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
pieces = RedistributeDataSet(Input=WavefrontOBJReader(FileName="/usr/share/glmark2/models/bunny.obj"))
apart = MeshDistanceField(Input=pieces, Resolution=48, SignMethod="Pseudonormal", DistributedInput=1)
Show(Contour(Input=apart, ContourBy="Distance", Isosurfaces=[0.02]), view)
Render(view)
result["distance of pieces"] = apart.PointData["Distance"].GetRange()
apart.Resolution = 40
Render(view)
result["points of pieces"] = apart.GetDataInformation().GetNumberOfPoints()
axis.Resolution = 1
axis.UpdatePipeline()
result["axis after an error"] = axis.GetDataInformation().GetNumberOfPoints()
print(json.dumps(result))
