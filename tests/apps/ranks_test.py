"""medial-axis as several processes: fields, axes and thickness with the bits of one process, and failures in one line.

usage: ranks_test.py MPIRUN MEDIAL-AXIS FAILING-ALLOCATIONS
"""

import json
import math
import os
import re
import signal
import struct
import subprocess
import sys
import tempfile
import time
import unittest
from pathlib import Path

from vtkmodules.vtkIOXML import vtkXMLPolyDataReader, vtkXMLPPolyDataReader

MPIRUN, PROGRAM, FAULTS = (os.path.abspath(path) for path in sys.argv[1:4])
# mpirun's own words about failures would get into the middle of the program's line.
LAUNCHER = (MPIRUN, "--quiet", "--oversubscribe")
# Both are for the tests' containers, where everything runs as root and there are few cores.
ENVIRONMENT = {**os.environ, "OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1"}
SINGLE = ("--engine", "processor", "--threads", "1")
BYTES = {"Distance": 4, "ClosestPoint": 12, "ClosestCell": 8, "ClosestFeature": 1, "ClosestSite": 4}


def torus(u=40, v=20, turned=False):
    """An OFF file of a torus, of quadrangles and triangles."""
    points, faces = [], []
    for i in range(u):
        for j in range(v):
            a, b = 2 * math.pi * i / u, 2 * math.pi * j / v
            points.append(((1 + 0.4 * math.cos(b)) * math.cos(a), (1 + 0.4 * math.cos(b)) * math.sin(a),
                           0.4 * math.sin(b)))
            p, q = i * v + j, (i + 1) % u * v + j
            r, s = (i + 1) % u * v + (j + 1) % v, i * v + (j + 1) % v
            faces += [(p, q, r, s)] if i % 3 == 0 else [(p, q, r), (p, r, s)]
    lines = ["OFF", f"{len(points)} {len(faces)} 0"]
    lines += [" ".join(repr(x) for x in point) for point in points]
    lines += [" ".join(map(str, (len(face), *(reversed(face) if turned else face)))) for face in faces]
    return "\n".join(lines) + "\n"


def boxes(*placed):
    """An OFF file of boxes, each by its middle and its half sides."""
    points, faces = [], []
    for middle, half in placed:
        first = len(points)
        for i in range(8):
            points.append([middle[axis] + (half[axis] if i >> axis & 1 else -half[axis]) for axis in range(3)])
        for face in ((0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5)):
            faces.append([first + i for i in face])
    lines = ["OFF", f"{len(points)} {len(faces)} 0"]
    lines += [" ".join(map(repr, point)) for point in points] + [f"4 {' '.join(map(str, face))}" for face in faces]
    return "\n".join(lines) + "\n"


def children_of(parent):
    """The numbers of processes that another one has started."""
    children = []
    for path in Path("/proc").glob("[0-9]*/stat"):
        try:
            stat = path.read_text()
        except OSError:  # it has ended meanwhile
            continue
        if int(stat.rpartition(")")[2].split()[1]) == parent:
            children.append(int(path.parent.name))
    return sorted(children)


class Image:
    """A .vti file of a field."""

    def __init__(self, path):
        data = path.read_bytes()
        start = data.index(b'encoding="raw">\n   _') + len(b'encoding="raw">\n   _')
        header = data[:start].decode()
        self.extent = [int(x) for x in re.search(r'<Piece Extent="([^"]*)"', header).group(1).split()]
        self.arrays = {}
        for name, offset in re.findall(r'Name="(\w+)"[^>]*offset="(\d+)"', header):
            first = start + int(offset)
            size = struct.unpack_from("<Q", data, first)[0]
            self.arrays[name] = data[first + 8:first + 8 + size]

    def rows(self):
        """Points of rows along x, by where they begin, and their values of all arrays."""
        x0, x1, y0, y1, z0, z1 = self.extent
        count, at = x1 - x0 + 1, 0
        for z in range(z0, z1 + 1):
            for y in range(y0, y1 + 1):
                yield (x0, y, z), count, {name: values[at * BYTES[name]:(at + count) * BYTES[name]]
                                          for name, values in self.arrays.items()}
                at += count


def read_axis(path, kind):
    """An axis from a file. It must be complete."""
    reader = kind()
    reader.SetFileName(str(path))
    reader.Update()
    if reader.GetErrorCode() != 0:
        raise OSError(f"{path}: error {reader.GetErrorCode()}")
    return reader.GetOutput()


def points_of(axis):
    """What is known of each point."""
    data = axis.GetPointData()
    names = ("Radius", "SeparationAngle", "Lambda", "ClosestPointA", "ClosestPointB", "AxisFeature")
    return [(axis.GetPoint(i), *(data.GetArray(name).GetTuple(i) for name in names))
            for i in range(axis.GetNumberOfPoints())]


def cells_of(axis):
    """The points of each cell."""
    return [tuple(axis.GetCell(i).GetPointId(k) for k in range(axis.GetCell(i).GetNumberOfPoints()))
            for i in range(axis.GetNumberOfCells())]


class Ranks(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)
        (self.folder / "torus.off").write_text(torus())

    def run_ranks(self, count, *arguments):
        return self.run_command(*LAUNCHER, "-np", str(count), PROGRAM, *arguments)

    def run_command(self, *command):
        return subprocess.run(command, cwd=self.folder, env=ENVIRONMENT, text=True, capture_output=True,
                              timeout=300, check=False)

    def files(self):
        return sorted(path.name for path in self.folder.iterdir())

    def expect_same_bits(self, ranks, *options):
        one = self.run_command(PROGRAM, "torus.off", "--field", "one.vti", "-q", *SINGLE, *options)
        self.assertEqual((one.returncode, one.stderr), (0, ""))
        whole = {begin: values for begin, _, values in Image(self.folder / "one.vti").rows()}
        several = self.run_ranks(ranks, "torus.off", "--field", "many.pvti", *SINGLE, *options)
        self.assertEqual((several.returncode, several.stderr), (0, ""))
        self.assertIn(f"on {ranks} processes", several.stdout)
        index = (self.folder / "many.pvti").read_text()
        pieces = re.findall(r'<Piece Extent="([^"]*)" Source="([^"]*)"', index)
        seen = set()
        for extent, source in pieces:
            image = Image(self.folder / source)
            self.assertEqual(" ".join(map(str, image.extent)), extent)
            for (x, y, z), count, values in image.rows():
                for name, part in values.items():
                    size = BYTES[name]
                    self.assertEqual(part, whole[0, y, z][name][x * size:(x + count) * size], (source, name))
                seen.update((i, y, z) for i in range(x, x + count))
        self.assertEqual(len(seen), sum(len(values["ClosestFeature"]) for values in whole.values()))
        return len(pieces)

    def expect_same_axis(self, ranks, *options):
        """Pieces with all points and cells of one process, by their global ids; each cell once."""
        one = self.run_command(PROGRAM, "torus.off", "-o", "one.vtp", "-q", *SINGLE, *options)
        self.assertEqual((one.returncode, one.stderr), (0, ""))
        whole = read_axis(self.folder / "one.vtp", vtkXMLPolyDataReader)
        points, cells = points_of(whole), cells_of(whole)
        self.assertGreater(len(cells), 20)
        several = self.run_ranks(ranks, "torus.off", "-o", "many.pvtp", *SINGLE, *options)
        self.assertEqual(several.returncode, 0, several.stderr)
        for line in several.stderr.splitlines():
            self.assertTrue(line.startswith("medial-axis: note: "), line)
        self.assertIn(f"axis      {len(points)} points, {len(cells)} cells", several.stdout)
        axis = read_axis(self.folder / "many.pvtp", vtkXMLPPolyDataReader)
        ids = axis.GetPointData().GetGlobalIds()
        self.assertEqual(ids.GetName(), "vtkGlobalPointIds")
        ids = [ids.GetValue(i) for i in range(axis.GetNumberOfPoints())]
        self.assertEqual(set(ids), set(range(len(points))))
        if "points" not in options:  # those on cuts are in several pieces
            self.assertGreater(len(ids), len(points))
        for point, number in zip(points_of(axis), ids):
            self.assertEqual(point, points[number])
        numbers = axis.GetCellData().GetGlobalIds()
        self.assertEqual(numbers.GetName(), "vtkGlobalCellIds")
        numbers = [numbers.GetValue(i) for i in range(axis.GetNumberOfCells())]
        self.assertEqual(sorted(numbers), list(range(len(cells))))
        for cell, number in zip(cells_of(axis), numbers):
            self.assertEqual(tuple(ids[i] for i in cell), cells[number])
        return len(re.findall("<Piece", (self.folder / "many.pvtp").read_text()))

    def expect_failure(self, run, code, text):
        """One line, and no file but the mesh."""
        self.assertEqual(run.returncode, code, run.stderr)
        lines = [line for line in run.stderr.splitlines() if line.startswith("medial-axis")]
        self.assertEqual(len(lines), 1, run.stderr)
        self.assertRegex(lines[0], text)
        self.assertEqual(self.files(), ["torus.off"])

    def test_two_ranks_write_the_field_of_one(self):
        self.assertEqual(self.expect_same_bits(2, "--resolution", "45", "--sign", "pseudonormal"), 2)

    def test_seven_ranks_write_the_field_of_one(self):
        self.assertEqual(self.expect_same_bits(7, "--resolution", "60", "--sign", "none"), 7)

    def test_more_ranks_than_parts_of_the_grid(self):
        self.assertLess(self.expect_same_bits(7, "--resolution", "14", "--sign", "pseudonormal"), 7)

    def test_a_surface_inside_out(self):
        (self.folder / "torus.off").write_text(torus(turned=True))
        self.expect_same_bits(3, "--resolution", "33", "--sign", "pseudonormal")

    def test_three_ranks_write_the_axis_of_one(self):
        self.assertGreater(self.expect_same_axis(3, "--resolution", "50", "--sign", "pseudonormal"), 1)

    def test_a_mesh_with_holes_by_winding_numbers(self):
        text = (self.folder / "torus.off").read_text().splitlines()
        counts = text[1].split()
        text[1] = f"{counts[0]} {int(counts[1]) - 3} 0"
        del text[-40], text[-30], text[-1]
        (self.folder / "torus.off").write_text("\n".join(text) + "\n")
        self.expect_same_axis(3, "--resolution", "40", "--sign", "winding")
        self.expect_same_bits(2, "--resolution", "33")  # auto finds the same
        run = self.run_ranks(2, "torus.off", "-o", "many.vtp", "--resolution", "30")
        self.assertIn("note: torus.off: 3 holes with 10 edges closed in thought", run.stderr)

    def test_an_axis_of_points_without_a_sign(self):
        self.assertEqual(self.expect_same_axis(2, "--resolution", "60", "--sign", "none", "--representation", "points",
                                               "--angle", "50"), 2)

    def test_more_ranks_than_parts_of_the_grid_with_an_axis(self):
        self.assertLess(self.expect_same_axis(7, "--resolution", "30", "--sign", "pseudonormal"), 7)

    def test_field_and_axis_at_once(self):
        options = ("--resolution", "40", "--sign", "pseudonormal", "-q")
        for count, field, axis in ((1, "one.vti", "one.ply"), (3, "many.pvti", "many.ply")):
            arguments = ("torus.off", "--field", field, "-o", axis, *SINGLE, *options)
            run = self.run_ranks(count, *arguments) if count > 1 else self.run_command(PROGRAM, *arguments)
            self.assertEqual((run.returncode, run.stderr), (0, ""))
        self.assertEqual((self.folder / "many.ply").read_bytes(), (self.folder / "one.ply").read_bytes())
        whole = {begin: values for begin, _, values in Image(self.folder / "one.vti").rows()}
        for piece in self.folder.glob("many_*.vti"):
            for (x, y, z), count, values in Image(piece).rows():
                for name, part in values.items():
                    size = BYTES[name]
                    self.assertEqual(part, whole[0, y, z][name][x * size:(x + count) * size], name)

    def test_what_the_first_rank_computes_alone(self):
        for options, name in ((("--topology", "preserve"), "--topology preserve"),
                              (("--max-spheres", "50"), "--max-spheres")):
            options = ("--resolution", "30", "--sign", "pseudonormal", *SINGLE, *options)
            one = self.run_command(PROGRAM, "torus.off", "-o", "one.ply", "-q", *options)
            self.assertEqual((one.returncode, one.stderr), (0, ""))
            several = self.run_ranks(2, "torus.off", "-o", "many.ply", *options)
            self.assertEqual(several.returncode, 0)
            self.assertIn(f"note: torus.off: {name} looks at the whole axis", several.stderr)
            self.assertEqual((self.folder / "many.ply").read_bytes(), (self.folder / "one.ply").read_bytes())

    def expect_same_report(self, ranks, *options):
        """The figures and notes of one process, but for times and what ranks count."""
        one = self.run_command(PROGRAM, "torus.off", "--report", "one.json", *SINGLE, *options)
        several = self.run_ranks(ranks, "torus.off", "--report", "many.json", *SINGLE, *options)
        self.assertEqual((one.returncode, several.returncode), (0, 0), several.stderr)
        own = " looks at the whole axis: the first process"
        self.assertEqual([line for line in several.stderr.splitlines() if own not in line], one.stderr.splitlines())
        expected, found = (json.loads((self.folder / name).read_text()) for name in ("one.json", "many.json"))
        self.assertIsNone(expected.pop("ranks"))
        per_rank = found.pop("ranks")
        self.assertEqual(len(per_rank), ranks)
        self.assertEqual(max(rank["peak_memory_mib"] for rank in per_rank), found["peak_memory_mib"])
        self.assertEqual(sum(rank["medial_cells"] for rank in per_rank), expected["counts"]["medial_cells"])
        for report in (expected, found):
            for key in ("seconds", "peak_memory_mib", "fragments_per_voxel"):
                del report[key]
            for key in ("fragments", "group_tests", "site_tests", "candidate_pairs"):  # where parts meet, tiles count twice
                del report["counts"][key]
            for key in ("coverage", "simplification"):
                (report[key] or {}).pop("seconds", None)
        self.assertEqual(found, expected)
        return found

    def test_a_report_has_the_figures_of_one(self):
        report = self.expect_same_report(3, "--resolution", "40")
        self.assertEqual(report["topology"]["axis"]["genus"], 1)

    def test_a_report_of_what_the_axis_leaves_out(self):
        # The grid misses a thin plate.
        (self.folder / "torus.off").write_text(boxes(((0, 0, 0), (1, 0.9, 0.8)), ((2, 0, 0), (0.01, 0.9, 0.8))))
        report = self.expect_same_report(3, "--resolution", "41", "--sign", "pseudonormal")
        self.assertGreater(report["coverage"]["uncovered_share"], 0.1)
        self.assertGreater(len(report["coverage"]["places"]), 0)
        self.assertLess(report["coverage"]["spacing"], 0.01)

    def test_a_report_of_what_the_first_rank_computes_alone(self):
        report = self.expect_same_report(2, "--resolution", "30", "--topology", "preserve")
        self.assertEqual(report["topology"]["solid"]["genus"], 1)

    def test_a_report_of_thickness(self):
        one = self.run_command(PROGRAM, "torus.off", "--thickness", "a.vtp", "--report", "one.json", *SINGLE)
        several = self.run_ranks(3, "torus.off", "--thickness", "a.pvtp", "--report", "many.json", *SINGLE)
        self.assertEqual((one.returncode, several.returncode, several.stderr), (0, 0, ""))
        expected, found = (json.loads((self.folder / name).read_text()) for name in ("one.json", "many.json"))
        for report in (expected, found):
            report["thickness"].pop("seconds")
        self.assertEqual(found["thickness"], expected["thickness"])
        self.assertGreater(found["thickness"]["median"], 0.7)
        self.assertIsNone(found["grid"])
        for rank in found["ranks"]:
            self.assertGreater(rank["bytes_sent"], 0)
            self.assertLess(rank["own_triangles"], expected["input"]["triangles"] / 2)

    def test_a_report_on_standard_output(self):
        run = self.run_ranks(2, "torus.off", "-o", "a.pvtp", "--report", "-", "--resolution", "30")
        self.assertEqual(run.returncode, 0, run.stderr)
        report = json.loads(run.stdout)
        self.assertEqual((report["topology"]["axis"]["components"], len(report["ranks"])), (1, 2))
        self.assertIn("a.pvtp", self.files())

    def test_a_report_in_a_folder_that_does_not_exist(self):
        run = self.run_ranks(2, "torus.off", "-o", "a.pvtp", "--report", "absent/a.json", "--sign", "none")
        self.expect_failure(run, 5, "^medial-axis: rank 0: absent/a.json")

    def test_pieces_need_several_processes(self):
        for option in ("--output", "--thickness"):
            self.expect_failure(self.run_command(PROGRAM, "torus.off", option, "a.pvtp"), 2,
                                f"{option} a.pvtp: .pvtp is for several processes, started by mpirun; use .vtp for one")

    def expect_same_thickness(self, ranks, *options):
        """One file of the same bytes, and pieces with the same values at the same points, each triangle once."""
        one = self.run_command(PROGRAM, "torus.off", "--thickness", "one.vtp", "-q", *SINGLE, *options)
        self.assertEqual((one.returncode, one.stderr), (0, ""))
        several = self.run_ranks(ranks, "torus.off", "--thickness", "many.vtp", "-q", *SINGLE, *options)
        self.assertEqual((several.returncode, several.stderr), (0, ""))
        self.assertEqual((self.folder / "many.vtp").read_bytes(), (self.folder / "one.vtp").read_bytes())
        several = self.run_ranks(ranks, "torus.off", "--thickness", "many.pvtp", *SINGLE, *options)
        self.assertEqual(several.returncode, 0, several.stderr)
        self.assertRegex(several.stdout, "thickness interior.*: min .*, median .*, max ")
        whole = read_axis(self.folder / "one.vtp", vtkXMLPolyDataReader)
        values = whole.GetPointData().GetArray("Thickness")
        pieces = read_axis(self.folder / "many.pvtp", vtkXMLPPolyDataReader)
        ids = pieces.GetPointData().GetGlobalIds()
        self.assertEqual({ids.GetValue(i) for i in range(pieces.GetNumberOfPoints())},
                         set(range(whole.GetNumberOfPoints())))
        thickness = pieces.GetPointData().GetScalars()
        self.assertEqual(thickness.GetName(), "Thickness")
        for i in range(pieces.GetNumberOfPoints()):
            number = ids.GetValue(i)
            self.assertEqual(pieces.GetPoint(i), whole.GetPoint(number))
            self.assertEqual(repr(thickness.GetValue(i)), repr(values.GetValue(number)))
        numbers = pieces.GetCellData().GetGlobalIds()
        numbers = [numbers.GetValue(i) for i in range(pieces.GetNumberOfCells())]
        self.assertEqual(numbers, list(range(len(numbers))))
        # The value of a cell is the least of its triangles'.
        cells = pieces.GetCellData().GetArray("InputCell")
        least = {}
        for i in range(pieces.GetNumberOfCells()):
            value = pieces.GetCellData().GetArray("Thickness").GetValue(i)
            least.setdefault(cells.GetValue(i), []).append(value)
        if "--max-edge" not in options:
            expected = whole.GetCellData().GetArray("Thickness")
            self.assertEqual({cell: min(found) for cell, found in least.items()},
                             {i: expected.GetValue(i) for i in range(whole.GetNumberOfCells())})
        return len(re.findall("<Piece", (self.folder / "many.pvtp").read_text()))

    def test_two_ranks_write_the_thickness_of_one(self):
        self.assertEqual(self.expect_same_thickness(2), 2)

    def test_seven_ranks_write_the_thickness_along_rays(self):
        self.assertEqual(self.expect_same_thickness(7, "--thickness-method", "ray"), 7)

    def test_the_thickness_of_walls_of_a_divided_surface(self):
        (self.folder / "torus.off").write_text(boxes(((0, 0, 0), (1, 0.9, 0.8)), ((0, 0, 1.3), (0.1, 0.7, 0.5))))
        self.assertEqual(self.expect_same_thickness(3, "--thickness-method", "wall", "--max-edge", "0.4"), 3)

    def test_thickness_together_with_an_axis(self):
        options = ("--resolution", "40", "--sign", "pseudonormal", "-q", *SINGLE)
        self.run_command(PROGRAM, "torus.off", "--thickness", "one.vtp", "-o", "one.ply", *options)
        several = self.run_ranks(3, "torus.off", "--thickness", "many.vtp", "-o", "many.ply", *options)
        self.assertEqual((several.returncode, several.stderr), (0, ""))
        for name in ("one.vtp", "one.ply"):
            self.assertEqual((self.folder / name.replace("one", "many")).read_bytes(),
                             (self.folder / name).read_bytes())

    def test_limits_of_thickness(self):
        (self.folder / "torus.off").write_text(boxes(((0, 0, 0), (1, 0.9, 0.8)), ((3, 0, 0), (0.1, 0.9, 0.8))))
        files = {}
        lines = {}
        for ranks in (1, 3):
            arguments = ("torus.off", "--min-thickness", "0.5", "--thin-regions", "thin.vtp", "--report", "a.json",
                         "--max-edge", "0.5", *SINGLE)
            run = self.run_ranks(ranks, *arguments) if ranks > 1 else self.run_command(PROGRAM, *arguments)
            self.assertEqual(run.returncode, 1, run.stderr)
            lines[ranks] = [line for line in run.stderr.splitlines() if " looks at the whole " not in line]
            self.assertIn("       1  thin         0.2 ", run.stdout)
            report = json.loads((self.folder / "a.json").read_text())["thickness"]
            report.pop("seconds")
            files[ranks] = ((self.folder / "thin.vtp").read_bytes(), report)
        self.assertEqual(files[3], files[1])
        self.assertEqual(lines[3], lines[1])
        kept = self.run_ranks(2, "torus.off", "--min-thickness", "0.1", "-q")
        self.assertEqual((kept.returncode, kept.stderr), (0, ""))

    def test_limits_of_thickness_that_are_refused(self):
        for options, code, text in ((("--min-thickness", "2", "--max-thickness", "1"), 2, "minimum thickness 2"),
                                    (("--min-thickness", "1", "--max-edge", "1e-9"), 3, "need more than")):
            self.expect_failure(self.run_ranks(2, "torus.off", *options), code, text)
        text = (self.folder / "torus.off").read_text().splitlines()
        text[1] = f"{text[1].split()[0]} 300 0"
        (self.folder / "torus.off").write_text("\n".join(text[:1102]) + "\n")
        self.expect_failure(self.run_ranks(2, "torus.off", "--min-thickness", "1"), 3,
                            "^medial-axis: rank 0: torus.off: limits of the thickness of one side need")

    def test_a_rank_without_memory_for_thickness(self):
        options = ("torus.off", "--thickness", "a.pvtp", *SINGLE)
        fault = ("-x", f"LD_PRELOAD={FAULTS}", "-x", "MEDIAL_FAIL_ALLOCATION=15000",
                 "-x", "ASAN_OPTIONS=verify_asan_link_order=0")
        command = (*LAUNCHER, "-np", "2", PROGRAM, *options, ":", "-np", "1", *fault, PROGRAM, *options)
        self.expect_failure(self.run_command(*command), 5, "^medial-axis: (torus.off: )?rank 2: .*memory")

    def test_an_axis_in_a_folder_that_does_not_exist(self):
        run = self.run_ranks(2, "torus.off", "-o", "absent/a.pvtp", "--sign", "none")
        self.expect_failure(run, 5, "^medial-axis: rank 0: absent/a.pvtp")

    def test_a_missing_mesh(self):
        self.expect_failure(self.run_ranks(2, "absent.off", "--field", "a.pvti", "--sign", "none"), 3,
                            "^medial-axis: rank 0: absent.off: no such file$")

    def test_a_mesh_that_is_open(self):
        text = (self.folder / "torus.off").read_text().splitlines()
        text[1] = text[1].replace(text[1].split()[1], str(int(text[1].split()[1]) - 1))
        (self.folder / "torus.off").write_text("\n".join(text[:-1]) + "\n")
        run = self.run_ranks(2, "torus.off", "--field", "a.pvti", "--sign", "pseudonormal")
        self.expect_failure(run, 3, "^medial-axis: torus.off: sign method pseudonormal needs a closed")

    def test_a_folder_that_does_not_exist(self):
        run = self.run_ranks(2, "torus.off", "--field", "absent/a.pvti", "--sign", "none")
        self.expect_failure(run, 5, "^medial-axis: rank 0: absent/a.pvti")

    def test_what_several_processes_do_not_compute(self):
        for options, text in ((("--field", "a.vti"), "--field FILE.pvti"),
                              (("--thickness-image", "a.png"), "--thickness-image needs a single one"),
                              (("-o", "a.vtp", "--curves", "b.vtp"), "--curves needs a single one"),
                              (("--skeleton", "a.vtp"), "--skeleton needs a single one"),
                              (("--field", "a.pvti", "--sign", "none", "--engine", "rasteriser"), "--engine processor"),
                              (("--field", "a.pvti", "--resolution", "1"), "--resolution")):
            self.expect_failure(self.run_ranks(2, "torus.off", *options), 2, text)

    def test_ranks_with_different_options(self):
        options = ("torus.off", "--field", "a.pvti", "--sign", "none", "--resolution")
        run = self.run_command(*LAUNCHER, "-np", "1", PROGRAM, *options, "20", ":",
                               "-np", "1", PROGRAM, *options, "21")
        self.expect_failure(run, 2, "^medial-axis: rank 1 has other options than rank 0$")

    def test_a_rank_that_is_killed(self):
        # On a busy machine the others may need more than the second that mpirun gives them to end.
        command = [*LAUNCHER, "--mca", "odls_base_sigkill_timeout", "4", "-np", "3", PROGRAM, "torus.off",
                   "--field", "a.pvti", "--sign", "none", "--resolution", "500", "--threads", "1", "-q"]
        with subprocess.Popen(command, cwd=self.folder, env=ENVIRONMENT, stderr=subprocess.PIPE) as run:
            while len(list(self.folder.glob(".a*"))) < 4:  # the pieces and the index
                self.assertIsNone(run.poll())
                time.sleep(0.01)
            os.kill(children_of(run.pid)[1], signal.SIGKILL)
            run.communicate(timeout=60)
        self.assertNotEqual(run.returncode, 0)
        # Of the one that was killed a file without its name may stay; the others leave nothing.
        left = [name for name in self.files() if name != "torus.off"]
        self.assertLessEqual(len(left), 1, left)
        self.assertTrue(all(name.startswith(".") for name in left), left)

    def interrupt(self, rank, number):
        """Sends a signal to a rank, or to mpirun for None, while all of them compute."""
        command = [*LAUNCHER, "-np", "3", PROGRAM, "torus.off", "--field", "a.pvti", "-o", "a.pvtp", "--sign",
                   "none", "--resolution", "500", "--threads", "1", "-q"]
        with subprocess.Popen(command, cwd=self.folder, env=ENVIRONMENT, stderr=subprocess.PIPE, text=True) as run:
            while len(list(self.folder.glob(".a*"))) < 4:
                self.assertIsNone(run.poll())
                time.sleep(0.01)
            os.kill(run.pid if rank is None else children_of(run.pid)[rank], number)
            errors = run.communicate(timeout=60)[1]
        return subprocess.CompletedProcess(command, run.returncode, "", errors)

    def test_a_rank_that_is_interrupted(self):
        self.expect_failure(self.interrupt(2, signal.SIGINT), 130,
                            "^medial-axis: (torus.off: )?rank 2: interrupted; nothing was written$")

    def test_mpirun_that_is_interrupted(self):
        run = self.interrupt(None, signal.SIGINT)
        self.assertEqual(run.returncode, 1)  # mpirun's own
        self.assertLessEqual(len([line for line in run.stderr.splitlines() if "medial-axis" in line]), 1, run.stderr)
        self.assertEqual(self.files(), ["torus.off"])

    def test_a_rank_without_memory(self):
        options = ("torus.off", "--field", "a.pvti", "-o", "a.pvtp", "--sign", "none", "--resolution", "100", *SINGLE)
        # AddressSanitizer wants to be the first library.
        fault = ("-x", f"LD_PRELOAD={FAULTS}", "-x", "MEDIAL_FAIL_ALLOCATION=15000",
                 "-x", "ASAN_OPTIONS=verify_asan_link_order=0")
        command = (*LAUNCHER, "-np", "2", PROGRAM, *options, ":", "-np", "1", *fault, PROGRAM, *options)
        self.expect_failure(self.run_command(*command), 5, "^medial-axis: rank 2: not enough memory$")

    def test_a_rank_with_a_full_disk(self):
        options = f"{PROGRAM} torus.off --field a.pvti -o a.pvtp --sign none --resolution 60 {' '.join(SINGLE)}"
        command = (*LAUNCHER, "-np", "1", *options.split(), ":", "-np", "1", "sh", "-c", f"ulimit -f 60; exec {options}")
        self.expect_failure(self.run_command(*command), 5, "^medial-axis: rank 1: a_1.vti: cannot be written")

    def test_the_version_is_printed_once(self):
        run = self.run_ranks(3, "--version")
        self.assertEqual((run.returncode, len(run.stdout.splitlines())), (0, 1))


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
