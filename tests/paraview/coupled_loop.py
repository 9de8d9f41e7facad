"""Run by redistributed_test.py in pvbatch --sym, where every rank runs it: as a simulation with Catalyst does,
each rank hands over its piece of a ball that grows, step after step.

usage: pvbatch --sym coupled_loop.py FOLDER
"""

import json
import os
import sys

import numpy
from paraview import servermanager
from paraview.simple import *
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData

ROWS, COLUMNS, STEPS = 24, 36, 10


def ball(radius):
    """Points and triangles between circles of latitude."""
    polar = numpy.linspace(0.0, numpy.pi, ROWS + 1)[1:-1, None]
    around = numpy.linspace(0.0, 2 * numpy.pi, COLUMNS, endpoint=False)
    rings = numpy.stack([numpy.sin(polar) * numpy.cos(around), numpy.sin(polar) * numpy.sin(around),
                         numpy.cos(polar) * numpy.ones(COLUMNS)], axis=2)
    points = radius * numpy.concatenate([rings.reshape(-1, 3), [[0, 0, 1], [0, 0, -1]]])
    top, bottom = len(points) - 2, len(points) - 1
    triangles = []
    for j in range(COLUMNS):
        k = (j + 1) % COLUMNS
        triangles.append((top, j, k))
        for i in range(0, (ROWS - 2) * COLUMNS, COLUMNS):
            triangles += [(i + j, i + COLUMNS + j, i + COLUMNS + k), (i + j, i + COLUMNS + k, i + k)]
        triangles.append((bottom, (ROWS - 2) * COLUMNS + k, (ROWS - 2) * COLUMNS + j))
    return points, numpy.array(triangles)


def piece(radius, rank, ranks):
    """A rank's triangles; of three ranks the last has none."""
    points, triangles = ball(radius)
    owners = max(1, min(ranks, 2))
    own = triangles[rank::owners] if rank < owners else triangles[:0]
    data = vtkPolyData()
    places = vtkPoints()
    places.SetDataTypeToDouble()
    places.SetData(numpy_to_vtk(points, deep=1))
    cells = vtkCellArray()
    cells.SetData(3, numpy_to_vtkIdTypeArray(numpy.ascontiguousarray(own, dtype=numpy.int64).ravel(), deep=1))
    data.SetPoints(places)
    data.SetPolys(cells)
    return data


processes = servermanager.vtkProcessModule.GetProcessModule()
rank, ranks = processes.GetPartitionId(), processes.GetNumberOfLocalPartitions()
producer = PVTrivialProducer()
producer.GetClientSideObject().SetOutput(piece(1.0, rank, ranks), -1.0)
field = MeshDistanceField(Input=producer, Resolution=40, SignMethod="Pseudonormal", DistributedInput=1)
contour = Contour(Input=field, ContourBy="Distance", Isosurfaces=[-0.25])
steps = []
for step in range(STEPS):
    radius = 1.0 + 0.05 * step
    producer.GetClientSideObject().SetOutput(piece(radius, rank, ranks), float(step))
    producer.MarkModified(producer)
    producer.UpdatePipeline(float(step))
    contour.UpdatePipeline(float(step))
    steps.append({"radius": radius, "distances": field.PointData["Distance"].GetRange(),
                  "bounds": contour.GetDataInformation().GetBounds()})
with open(os.path.join(sys.argv[1], f"steps_{rank}.json"), "w") as file:  # each knows its own part
    json.dump(steps, file)
