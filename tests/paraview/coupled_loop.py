"""Run by redistributed_test.py in pvbatch --sym, where every rank runs it: as a simulation with Catalyst does,
each rank hands over its pieces of a ball that grows and of a dumbbell that thickens, step after step. Then the
dumbbells of the first steps are read from a series of files.

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
from vtkmodules.vtkIOXML import vtkXMLPolyDataWriter

ROWS, COLUMNS, STEPS, FILES = 24, 36, 10, 3
TOPOLOGIES = ("Selected", "Preserve")


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


def dumbbell(step):
    """Two flat bodies of two sizes, joined by a round neck, along a diagonal of the grid."""
    points, triangles = ball(1.0)
    from_neck = numpy.minimum(1.0, 2.0 * (points[:, 2] - 0.3) ** 2)
    scale = [0.3 + 0.7 * from_neck, 0.3 + 0.02 * step * from_neck, numpy.full_like(from_neck, 2.0)]
    points *= numpy.stack(scale, axis=1)
    turn, _ = numpy.linalg.qr([[0.8, -1.3, 0.3], [0.9, 0.7, -1.0], [1.0, 0.6, 1.0]])
    return points[:, ::-1] @ turn.T, triangles


def piece(surface, rank, ranks, numbered):
    """A rank's triangles; of three ranks the last has none. Numbers as in the whole decide between triangles that
    are equally near, whatever the pieces are."""
    points, triangles = surface
    owners = max(1, min(ranks, 2))
    own = numpy.arange(rank, len(triangles), owners) if rank < owners else numpy.arange(0)
    data = vtkPolyData()
    places = vtkPoints()
    places.SetDataTypeToDouble()
    places.SetData(numpy_to_vtk(points, deep=1))
    cells = vtkCellArray()
    cells.SetData(3, numpy_to_vtkIdTypeArray(triangles[own].ravel(), deep=1))
    data.SetPoints(places)
    data.SetPolys(cells)
    if numbered:
        data.GetPointData().SetGlobalIds(named("vtkGlobalPointIds", numpy.arange(len(points))))
        data.GetCellData().SetGlobalIds(named("vtkGlobalCellIds", own))
    return data


def named(name, numbers):
    array = numpy_to_vtkIdTypeArray(numbers, deep=1)
    array.SetName(name)
    return array


def write(data, name):
    writer = vtkXMLPolyDataWriter()
    writer.SetFileName(os.path.join(folder, f"{name}.vtp"))
    writer.SetInputData(data)
    writer.Write()


def hand_over(producer, data, time):
    producer.GetClientSideObject().SetOutput(data, time)
    producer.MarkModified(producer)
    producer.UpdatePipeline(time)


def axes_of(source):
    """On a grid so fine that three processes have parts; Selected does not keep a round neck at this angle."""
    return {topology: MedialAxis(Input=source, Resolution=64, SignMethod="Pseudonormal", Topology=topology, Angle=120,
                                 DistributedInput=1) for topology in TOPOLOGIES}


def write_pieces(axes, name, time):
    """What this rank has of each axis."""
    for topology, axis in axes.items():
        axis.UpdatePipeline(time)
        write(axis.GetClientSideObject().GetOutputDataObject(0), f"{name}_{topology}_{time:g}_{rank}")


processes = servermanager.vtkProcessModule.GetProcessModule()
rank, ranks = processes.GetPartitionId(), processes.GetNumberOfLocalPartitions()
folder = sys.argv[1]
balls, dumbbells = PVTrivialProducer(), PVTrivialProducer()
balls.GetClientSideObject().SetOutput(piece(ball(1.0), rank, ranks, False), -1.0)
dumbbells.GetClientSideObject().SetOutput(piece(dumbbell(0), rank, ranks, True), -1.0)
field = MeshDistanceField(Input=balls, Resolution=40, SignMethod="Pseudonormal", DistributedInput=1)
contour = Contour(Input=field, ContourBy="Distance", Isosurfaces=[-0.25])
axes = axes_of(dumbbells)
steps = []
for step in range(STEPS):
    radius = 1.0 + 0.05 * step
    hand_over(balls, piece(ball(radius), rank, ranks, False), float(step))
    contour.UpdatePipeline(float(step))
    steps.append({"radius": radius, "distances": field.PointData["Distance"].GetRange(),
                  "bounds": contour.GetDataInformation().GetBounds()})
    hand_over(dumbbells, piece(dumbbell(step), rank, ranks, True), float(step))
    write_pieces(axes, "loop", step)
with open(os.path.join(folder, f"steps_{rank}.json"), "w") as file:  # each knows its own part
    json.dump(steps, file)

if rank == 0:
    for step in range(FILES):
        write(piece(dumbbell(step), 0, 1, True), f"dumbbell_{step}")
processes.GetGlobalController().Barrier()
series = XMLPolyDataReader(FileName=[os.path.join(folder, f"dumbbell_{step}.vtp") for step in range(FILES)])
axes = axes_of(RedistributeDataSet(Input=series, BoundaryMode="Assign to one region"))
for time in series.TimestepValues:
    write_pieces(axes, "series", time)
