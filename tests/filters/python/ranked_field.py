"""Run by ranks_test.py under mpirun: fields, axes and thickness of a surface in pieces, surfaces of an axis in pieces.

One case comes after the other.

usage: ranked_field.py FOLDER
FOLDER/cases.json has the cases; each rank writes what it computed of case C to FOLDER/C.RANK.npz.
"""

import ctypes
import ctypes.util
import functools
import json
import sys
from pathlib import Path

import medial
import numpy as np
from shapes import ball
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray, vtk_to_numpy
from vtkmodules.vtkCommonCore import VTK_STRING, vtkPoints
from vtkmodules.vtkCommonDataModel import (VTK_TRIANGLE, vtkCellArray, vtkMultiBlockDataSet,
                                           vtkPartitionedDataSet, vtkPartitionedDataSetCollection, vtkPolyData,
                                           vtkUnstructuredGrid)
from vtkmodules.vtkFiltersCore import vtkAppendFilter

ARRAYS = ("Distance", "ClosestPoint", "ClosestCell", "ClosestFeature", "ClosestSite")


def surface():
    """An uneven ball: no two distances are equal by symmetry."""
    points, triangles = ball(3)
    x, y, z = points.T
    points *= (1.0 + 0.3 * np.sin(3 * x + y) * np.cos(2 * z))[:, None]
    return points, triangles


def owners(case, count, ranks):
    """The rank of every triangle."""
    if case["pieces"] == "one":
        return np.full(count, case.get("owner", 0) % ranks)
    if case["pieces"] == "none":
        return np.full(count, ranks)
    if case["pieces"] == "runs":
        return np.arange(count) * ranks // count
    return np.random.default_rng(case.get("seed", 1)).integers(0, max(1, ranks - case.get("empty", 0)), count)


def polydata(points, triangles):
    data = vtkPolyData()
    places = vtkPoints()
    places.SetDataTypeToDouble()
    places.SetData(numpy_to_vtk(np.ascontiguousarray(points), deep=1))
    cells = vtkCellArray()
    cells.SetData(3, numpy_to_vtkIdTypeArray(np.ascontiguousarray(triangles, dtype=np.int64).ravel(), deep=1))
    data.SetPoints(places)
    data.SetPolys(cells)
    return data


def add_array(attributes, name, values, is_global=False):
    array = (numpy_to_vtk(values.astype(np.uint8), deep=1) if name == "vtkGhostType"
             else numpy_to_vtkIdTypeArray(values.astype(np.int64), deep=1))
    array.SetName(name)
    (attributes.SetGlobalIds if is_global else attributes.AddArray)(array)


def block(case, cells, ghosts):
    """Some triangles as a data set, with ids and ghosts as the case has them."""
    points, triangles = surface()
    chosen = triangles[np.concatenate([cells, ghosts])]
    used, corners = np.unique(chosen, return_inverse=True)
    data = polydata(points[used], corners.reshape(-1, 3))
    if case.get("grid"):
        grid = vtkUnstructuredGrid()
        grid.SetPoints(data.GetPoints())
        grid.SetCells(VTK_TRIANGLE, data.GetPolys())
        data = grid
    if "cells" in case.get("ids", ""):
        add_array(data.GetCellData(), "vtkGlobalCellIds", np.concatenate([cells, ghosts]), "marked" in case["ids"])
    if "points" in case.get("ids", ""):
        add_array(data.GetPointData(), "vtkGlobalPointIds", used, "marked" in case["ids"])
    if case.get("ghosts"):
        add_array(data.GetCellData(), "vtkGhostType", np.arange(len(chosen)) >= len(cells))
    return data


@functools.cache
def whole_axis():
    """The axis of the surface, which one process has made."""
    axis = field_filter({"axis": True, "options": {"Resolution": 32, "Angle": 20}})
    axis.SetInputData(polydata(*surface()))
    axis.Update()
    return axis.GetOutput()


def axis_block(cells):
    """Some cells of the axis with the points that they use."""
    axis = whole_axis()
    corners = [[axis.GetCell(cell).GetPointId(i) for i in range(axis.GetCell(cell).GetNumberOfPoints())] for cell in cells]
    used = sorted({point for ids in corners for point in ids})
    number = {point: i for i, point in enumerate(used)}
    places = vtk_to_numpy(axis.GetPoints().GetData())[used]
    lists = {size: vtkCellArray() for size in (1, 2, 3)}
    for ids in corners:
        lists[min(len(ids), 3)].InsertNextCell(len(ids), [number[point] for point in ids])
    data = vtkPolyData()
    data.SetPoints(vtkPoints())
    data.GetPoints().SetData(numpy_to_vtk(np.ascontiguousarray(places), deep=1))
    data.SetVerts(lists[1])
    data.SetLines(lists[2])
    data.SetPolys(lists[3])
    radius = numpy_to_vtk(vtk_to_numpy(axis.GetPointData().GetArray("Radius"))[used], deep=1)
    radius.SetName("Radius")
    data.GetPointData().AddArray(radius)
    return data


def axis_piece(case, rank, ranks):
    """What a rank has of the axis."""
    cells = np.flatnonzero(owners(case, whole_axis().GetNumberOfCells(), ranks) == rank)
    if case.get("copies"):  # of what others have
        cells = np.union1d(cells, np.arange(50 * rank, 100 + 70 * rank))
    if len(cells) == 0:
        return vtkPolyData()
    if case.get("blocks"):
        blocks = vtkMultiBlockDataSet()
        for i, part in enumerate((axis_block(cells[::2]), vtkPolyData(), axis_block(cells[1::2]))):
            blocks.SetBlock(i, part)
        return blocks
    data = axis_block(cells)
    if case.get("grid"):
        to_grid = vtkAppendFilter()
        to_grid.SetInputData(data)
        to_grid.Update()
        return to_grid.GetOutput()
    return data


def piece(case, rank, ranks):
    """What a rank has of the surface, or of its axis."""
    if case.get("reconstruction"):
        return axis_piece(case, rank, ranks)
    points, triangles = surface()
    owner = owners(case, len(triangles), ranks)
    cells = np.flatnonzero(owner == rank)
    if case.get("copies"):  # of what others have, without a mark
        cells = np.concatenate([np.union1d(cells, np.arange(50 * rank, 100 + 70 * rank)), cells[:20]])
    ghosts = np.empty(0, dtype=int)
    if case.get("ghosts"):
        mine = np.isin(triangles, triangles[cells]).any(axis=1)
        ghosts = np.flatnonzero(mine & (owner != rank))
    blocks = case.get("blocks")
    if not blocks:
        return block(case, cells, ghosts)
    half = len(cells) // 2
    parts = [block(case, cells[:half], ghosts), vtkPolyData(), block(case, cells[half:], ghosts[:0])]
    composite = {"multiblock": vtkMultiBlockDataSet, "partitioned": vtkPartitionedDataSet,
                 "collection": vtkPartitionedDataSetCollection}[blocks]()
    for i, part in enumerate(parts):
        if blocks == "collection":
            composite.SetPartition(0, i, part)
        elif blocks == "partitioned":
            composite.SetPartition(i, part)
        else:
            composite.SetBlock(i, part)
    return composite


def blocks_of(data):
    """The blocks of a piece that have cells."""
    if not data.IsA("vtkCompositeDataSet"):
        return [data] if data.GetNumberOfCells() else []
    blocks, found = data.NewIterator(), []
    while not blocks.IsDoneWithTraversal():
        found.extend(blocks_of(blocks.GetCurrentDataObject()))
        blocks.GoToNextItem()
    return found


def field_filter(case):
    field = (medial.vtkMedialThickness() if case.get("thickness") else medial.vtkMedialAxis() if case.get("axis")
             else medial.vtkMedialReconstruction() if case.get("reconstruction") else medial.vtkMeshDistanceField())
    if not case.get("thickness") and not case.get("reconstruction"):
        field.SetSignMethodToPseudonormal()
        field.SetEngineToProcessor()
    if not case.get("reconstruction"):
        field.SetNumberOfThreads(1)
    for name, value in case.get("options", {}).items():
        getattr(field, "Set" + name)(*value if isinstance(value, list) else (value,))
    return field


def axis_arrays_of(axis):
    """Points with their attributes, and the points of each cell, as one process numbers them."""
    points = axis.GetPointData()
    arrays = {points.GetArrayName(i): vtk_to_numpy(points.GetArray(i)) for i in range(points.GetNumberOfArrays())}
    arrays["points"] = (vtk_to_numpy(axis.GetPoints().GetData()) if axis.GetNumberOfPoints() else np.empty((0, 3)))
    numbers = arrays.get("vtkGlobalPointIds", np.arange(axis.GetNumberOfPoints()))
    cells = np.full((axis.GetNumberOfCells(), 4), -1)
    for i, cell in enumerate(cells):
        corners = axis.GetCell(i).GetPointIds()
        count = corners.GetNumberOfIds()
        cell[:count] = [numbers[corners.GetId(j)] for j in range(count)]
    arrays["cells"] = cells
    if axis.GetCellData().GetGlobalIds():
        arrays["vtkGlobalCellIds"] = vtk_to_numpy(axis.GetCellData().GetGlobalIds())
    return arrays


def corners_of(data):
    """The places of the corners of triangles, with those of ghosts."""
    cells = data.GetPolys() if data.IsA("vtkPolyData") else data.GetCells()
    places = vtk_to_numpy(data.GetPoints().GetData())
    return places[vtk_to_numpy(cells.GetConnectivityArray()).reshape(-1, 3)]


def thickness_arrays_of(surface):
    """Arrays by their association and name, and the places of points and of the corners of cells."""
    arrays = {}
    for kind, attributes in (("point", surface.GetPointData()), ("cell", surface.GetCellData()),
                             ("field", surface.GetFieldData())):
        for i in range(attributes.GetNumberOfArrays()):
            arrays[f"{kind} {attributes.GetArrayName(i)}"] = vtk_to_numpy(attributes.GetArray(i))
    empty = surface.GetNumberOfPoints() == 0
    arrays["points"] = np.empty((0, 3)) if empty else vtk_to_numpy(surface.GetPoints().GetData())
    arrays["corners"] = np.empty((0, 3, 3)) if empty else corners_of(surface)
    return arrays


def reconstruction_arrays_of(surface):
    """The places of the corners of triangles, and their normals."""
    triangles = vtk_to_numpy(surface.GetPolys().GetConnectivityArray()).reshape(-1, 3)
    normals = vtk_to_numpy(surface.GetPointData().GetNormals())
    return {"corners": corners_of(surface), "normals": normals[triangles],
            "unused": np.setdiff1d(np.arange(surface.GetNumberOfPoints()), triangles)}


def arrays_of(image):
    if image.IsA("vtkPolyData") and image.GetPointData().GetNormals():
        return reconstruction_arrays_of(image)
    if image.GetFieldData().HasArray("MinThickness"):
        return thickness_arrays_of(image)
    if image.IsA("vtkPolyData"):
        return axis_arrays_of(image)
    data = image.GetPointData()
    return {name: vtk_to_numpy(data.GetArray(name)) for name in ARRAYS if data.GetArray(name)}


def damage(case, data, rank):
    """What makes the case fail, on one rank."""
    fault = case.get("fault")
    if fault is None or case["rank"] != rank:
        return data
    if fault == "NaN":
        data.GetPoints().GetData().SetComponent(0, 1, float("nan"))
    elif fault == "overlap":  # other triangles with the ids of a third of the surface
        for i in range(data.GetNumberOfCells()):
            data.GetCellData().GetArray("vtkGlobalCellIds").SetValue(i, i)
    elif fault == "copies":  # of what others have, instead of its own
        return block(case, np.arange(300), np.empty(0, dtype=int))
    elif fault == "Radius":
        data.GetPointData().RemoveArray("Radius")
    elif fault == "hole":
        return block(case, np.arange(0), np.empty(0, dtype=int))
    elif fault == "short":
        add_array(data.GetCellData(), case["array"], np.zeros(1))
    elif fault == "type":
        grid = vtkUnstructuredGrid()
        grid.SetPoints(data.GetPoints())
        grid.InsertNextCell(10, 4, (0, 1, 2, 3))  # a tetrahedron
        return grid
    return data


def compute(case, controller, folder, number):
    rank, ranks = controller.GetLocalProcessId(), controller.GetNumberOfProcesses()
    own = {**case, "options": {**case.get("options", {}), **case.get("options of ranks", {}).get(str(rank), {})}}
    field = field_filter(own)
    messages = []

    def record(_caller, _event, text):
        messages.append(text)

    record.CallDataType = VTK_STRING
    field.AddObserver("ErrorEvent", record)
    field.GetExecutive().AddObserver("ErrorEvent", lambda *_: None)  # VTK 9.1 reports them once more
    field.SetController(controller)
    field.DistributedInputOn()
    if case.get("pipeline"):
        axis = field_filter({"axis": True, "options": {"Resolution": 32, "Angle": 20}})
        axis.SetController(controller)
        axis.DistributedInputOn()
        axis.SetInputData(piece({**case, "reconstruction": False}, rank, ranks))
        field.SetInputConnection(axis.GetOutputPort())
    else:
        field.SetInputDataObject(damage(case, piece(case, rank, ranks), rank))
    if case.get("asks again") == rank:
        field.UpdateInformation()
        field.Modified()
    results = {}
    for ghosts in case.get("ghost levels", [0]):
        field.UpdatePiece(*((0, 1) if case.get("whole") else (rank, ranks)), ghosts)
        results = arrays_of(field.GetOutput())
        results["extent"] = np.array(field.GetOutput().GetExtent() if field.GetOutput().IsA("vtkImageData") else [])
        results["held"] = np.array([row.GetValue(0) if row else -1 for row in (
            field.GetOutput().GetFieldData().GetAbstractArray(name)
            for name in ("OwnTriangles", "HeldTriangles", "BytesSent"))])
    np.savez(folder / f"{number}.{rank}.npz", messages=messages, error=field.GetErrorCode(), **results)


def main():
    from vtkmodules.vtkParallelMPI import vtkMPIController
    folder = Path(sys.argv[1])
    mpi = ctypes.CDLL(ctypes.util.find_library("mpi"), ctypes.RTLD_GLOBAL)  # VTK's Python cannot start it
    mpi.MPI_Init(None, None)
    controller = vtkMPIController()
    controller.Initialize()
    for number, case in enumerate(json.loads((folder / "cases.json").read_text())):
        compute(case, controller, folder, number)
    mpi.MPI_Finalize()


if __name__ == "__main__":
    main()
