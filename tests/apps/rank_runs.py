"""Runs of medial-axis as several processes, for ranks_*_test.py.

usage of these: ranks_X_test.py MPIRUN MEDIAL-AXIS FAILING-ALLOCATIONS
"""

import json
import math
import os
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

from vtkmodules.vtkCommonCore import vtkIdTypeArray, vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader, vtkXMLPolyDataWriter, vtkXMLPPolyDataReader

MPIRUN, PROGRAM, FAULTS = (os.path.abspath(path) for path in sys.argv[1:4])
# mpirun's own words about failures would get into the middle of the program's line.
LAUNCHER = (MPIRUN, "--quiet", "--oversubscribe")
# For the tests' containers, where everything runs as root. hwloc would ask the X display of another test for
# graphics cards, and end mpirun when that display goes.
ENVIRONMENT = {**os.environ, "OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1",
               "HWLOC_COMPONENTS": "-gl"}
SINGLE = ("--engine", "processor", "--threads", "1")


def torus(u=40, v=20):
    """Points and faces of a torus, of quadrangles and triangles."""
    points, faces = [], []
    for i in range(u):
        for j in range(v):
            a, b = 2 * math.pi * i / u, 2 * math.pi * j / v
            points.append(((1 + 0.4 * math.cos(b)) * math.cos(a), (1 + 0.4 * math.cos(b)) * math.sin(a),
                           0.4 * math.sin(b)))
            p, q = i * v + j, (i + 1) % u * v + j
            r, s = (i + 1) % u * v + (j + 1) % v, i * v + (j + 1) % v
            faces += [(p, q, r, s)] if i % 3 == 0 else [(p, q, r), (p, r, s)]
    return points, faces


def torn_torus():
    """The same with three holes."""
    points, faces = torus()
    del faces[-40], faces[-30], faces[-1]
    return points, faces


def boxes(*placed):
    """Points and faces of boxes, each by its middle and its half sides."""
    points, faces = [], []
    for middle, half in placed:
        first = len(points)
        for i in range(8):
            points.append([middle[axis] + (half[axis] if i >> axis & 1 else -half[axis]) for axis in range(3)])
        for face in ((0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5)):
            faces.append([first + i for i in face])
    return points, faces


def read_polydata(path):
    """What a .vtp or .pvtp file holds. It must be complete."""
    reader = vtkXMLPPolyDataReader() if path.suffix == ".pvtp" else vtkXMLPolyDataReader()
    reader.SetFileName(str(path))
    reader.Update()
    if reader.GetErrorCode() != 0:
        raise OSError(f"{path}: error {reader.GetErrorCode()}")
    return reader.GetOutput()


class RankTest(unittest.TestCase):
    """A folder with torus.off, and runs of medial-axis there."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)
        self.write(*torus())

    def write(self, points, faces):
        """Another mesh in place of the torus."""
        lines = ["OFF", f"{len(points)} {len(faces)} 0"]
        lines += [" ".join(map(repr, point)) for point in points]
        lines += [" ".join(map(str, (len(face), *face))) for face in faces]
        (self.folder / "torus.off").write_text("\n".join(lines) + "\n")

    def write_pieces(self, count, with_ids=True):
        """The torus once more, as torus.pvtp in so many pieces, maybe with global ids."""
        points, faces = torus()
        for rank in range(count):
            own = range(rank, len(faces), count)
            used = sorted({p for i in own for p in faces[i]})
            places, cells = vtkPoints(), vtkCellArray()
            places.SetDataTypeToDouble()
            for p in used:
                places.InsertNextPoint(points[p])
            for i in own:
                cells.InsertNextCell(len(faces[i]), [used.index(p) for p in faces[i]])
            piece = vtkPolyData()
            piece.SetPoints(places)
            piece.SetPolys(cells)
            for data, kind, numbers in ((piece.GetPointData(), "Point", used), (piece.GetCellData(), "Cell", own)):
                ids = vtkIdTypeArray()
                ids.SetName(f"vtkGlobal{kind}Ids")
                for number in numbers:
                    ids.InsertNextValue(number)
                if with_ids:
                    data.SetGlobalIds(ids)
            writer = vtkXMLPolyDataWriter()
            writer.SetInputData(piece)
            writer.SetFileName(str(self.folder / f"torus_{rank}.vtp"))
            writer.Write()
        pieces = "".join(f'<Piece Source="torus_{rank}.vtp"/>' for rank in range(count))
        (self.folder / "torus.pvtp").write_text(f'<VTKFile type="PPolyData"><PPolyData>{pieces}</PPolyData></VTKFile>')

    def files(self):
        return sorted(path.name for path in self.folder.iterdir())

    def run_command(self, *command):
        return subprocess.run(command, cwd=self.folder, env=ENVIRONMENT, text=True, capture_output=True,
                              timeout=300, check=False)

    def run_ranks(self, count, *arguments):
        """medial-axis as so many processes; as one without mpirun."""
        launcher = (*LAUNCHER, "-np", str(count)) if count > 1 else ()
        return self.run_command(*launcher, PROGRAM, *arguments)

    def run_well(self, count, *arguments):
        """The same, which must end well and without a note."""
        run = self.run_ranks(count, *arguments)
        self.assertEqual((run.returncode, run.stderr), (0, ""))
        return run

    def run_short_of_memory(self, *arguments):
        """medial-axis as three processes, the last of which gets no memory after a while."""
        fault = ("-x", f"LD_PRELOAD={FAULTS}", "-x", "MEDIAL_FAIL_ALLOCATION=15000")
        program = (PROGRAM, *arguments)
        return self.run_command(*LAUNCHER, "-np", "2", *program, ":", "-np", "1", *fault, *program)

    def report(self, name):
        return json.loads((self.folder / name).read_text())

    def expect_same_file(self, many, one):
        self.assertEqual((self.folder / many).read_bytes(), (self.folder / one).read_bytes(), many)

    def count_pieces(self, index):
        return (self.folder / index).read_text().count("<Piece")

    def global_ids(self, data, kind):
        """Those of its points or cells: kind is Point or Cell."""
        ids = (data.GetPointData() if kind == "Point" else data.GetCellData()).GetGlobalIds()
        self.assertEqual(ids.GetName(), f"vtkGlobal{kind}Ids")
        return [ids.GetValue(i) for i in range(ids.GetNumberOfTuples())]

    def expect_failure(self, run, code, text):
        """One line, and no file but the mesh."""
        self.expect_line(run, code, text)
        self.assertEqual(self.files(), ["torus.off"])

    def expect_line(self, run, code, text):
        self.assertEqual(run.returncode, code, run.stderr)
        lines = [line for line in run.stderr.splitlines() if line.startswith("medial-axis")]
        self.assertEqual(len(lines), 1, run.stderr)
        self.assertRegex(lines[0], text)
