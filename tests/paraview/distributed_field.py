"""Run by distributed_test.py in pvbatch: the field in parts, and figures of other outputs.

usage: pvbatch distributed_field.py FOLDER
"""

import json
import os
import sys

from paraview.simple import *

folder = sys.argv[1]
mesh = WavefrontOBJReader(FileName="/usr/share/glmark2/models/bunny.obj")
field = MeshDistanceField(Input=mesh, Resolution=72, GenerateClosestPoint=1,
                          GenerateClosestFeature=1)
SaveData(os.path.join(folder, "field.pvti"), proxy=field)
result = {"samples of a process": field.FieldData["Samples"].GetRange()}

# A downstream filter that wants ghost points.
contour = Contour(Input=field, ContourBy="Distance", Isosurfaces=[0.02])
contour.UpdatePipeline()
result["contour bounds"] = contour.GetDataInformation().GetBounds()

axis = MedialAxis(Input=mesh, Resolution=72)
for name, proxy in (("axis", axis), ("curves", MedialCurves(Input=axis)),
                    ("reconstruction", MedialReconstruction(Input=axis, Resolution=48)),
                    ("thickness", MedialThickness(Input=mesh))):
    proxy.UpdatePipeline()
    data = proxy.GetDataInformation()
    result[name] = [data.GetNumberOfPoints(), data.GetNumberOfCells(), *data.GetBounds()]
with open(os.path.join(folder, "result.json"), "w") as file:
    json.dump(result, file)
