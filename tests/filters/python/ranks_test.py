"""Surfaces and axes in pieces: the bits of one process, and failures on all ranks.

usage: ranks_test.py MPIRUN
"""

import json
import os
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import medial
import numpy as np
from ranked_field import (ARRAYS, arrays_of, blocks_of, corners_of, field_filter, piece, polydata, surface, whole_axis)
from vtkmodules.util.numpy_support import vtk_to_numpy

MPIRUN = os.path.abspath(sys.argv[1])
SCRIPT = Path(__file__).with_name("ranked_field.py")
# For the tests' containers, where everything runs as root. hwloc would ask the X display of another test for
# graphics cards, and end mpirun when that display goes.
ENVIRONMENT = {**os.environ, "OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1",
               "HWLOC_COMPONENTS": "-gl"}
# A collective that a rank does not enter would wait for ever.
PATIENCE = 240  # seconds


def run(ranks, cases):
    """What each rank has of each case."""
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        (folder / "cases.json").write_text(json.dumps(cases))
        subprocess.run([MPIRUN, "--quiet", "--oversubscribe", "--timeout", str(PATIENCE), "-np", str(ranks),
                        sys.executable, SCRIPT, folder], env=ENVIRONMENT, check=True, timeout=2 * PATIENCE)
        return [[dict(np.load(folder / f"{case}.{rank}.npz")) for rank in range(ranks)] for case in range(len(cases))]


def whole_surface(case, ranks):
    """The surface as one process has it, with the numbers of cells."""
    points, triangles = surface()
    if case.get("ids"):
        if "points" not in case["ids"]:  # as the triangles use them
            first = np.unique(triangles.ravel(), return_index=True)[1]
            order = np.argsort(first)
            points, triangles = points[order], np.argsort(order)[triangles]
        return points, triangles, np.arange(len(triangles))
    places, corners, numbers, first, last = [], [], [], 0, 0
    for data in (data for rank in range(ranks) for data in blocks_of(piece(case, rank, ranks))):
        cells = data.GetPolys() if data.IsA("vtkPolyData") else data.GetCells()
        cells = vtk_to_numpy(cells.GetConnectivityArray()).reshape(-1, 3)
        ghosts = data.GetCellData().GetArray("vtkGhostType")
        own = vtk_to_numpy(ghosts) == 0 if ghosts else np.ones(len(cells), bool)
        places.append(vtk_to_numpy(data.GetPoints().GetData()))
        corners.append(cells[own] + first)
        numbers.append(np.flatnonzero(own) + last)
        first, last = first + len(places[-1]), last + len(cells)
    return np.concatenate(places), np.concatenate(corners), np.concatenate(numbers)


def output_of_one(case, points, triangles):
    """What one process makes of the surface."""
    whole = field_filter(case)
    whole.SetInputData(polydata(points, triangles))
    whole.Update()
    return whole.GetOutput()


def field_of_one(case, ranks):
    """The arrays of the field that one process computes."""
    points, triangles, numbers = whole_surface(case, ranks)
    field = output_of_one(case, points, triangles)
    arrays = arrays_of(field)
    arrays["ClosestCell"] = numbers[arrays["ClosestCell"]]
    size = field.GetDimensions()[::-1]
    return {name: values.reshape(*size, -1) for name, values in arrays.items()}


class Ranks(unittest.TestCase):
    def expect_of_each(self, cases_of_ranks, expect):
        """Calls expect(case, parts) with what so many ranks have of cases."""
        for ranks, cases in cases_of_ranks.items():
            for case, parts in zip(cases, run(ranks, cases)):
                with self.subTest(ranks=ranks, case=case):
                    expect(case, parts)

    def expect_bits_of_one(self, case, parts):
        whole = field_of_one(case, len(parts))
        covered = np.zeros(whole["Distance"].shape[:3], bool)
        for part in parts:
            self.assertEqual(list(part["messages"]), [])
            x0, x1, y0, y1, z0, z1 = part["extent"]
            box = np.s_[z0:z1 + 1, y0:y1 + 1, x0:x1 + 1]
            covered[box] = True
            for name in ARRAYS if x0 <= x1 else ():
                expected = whole[name][box]
                self.assertEqual(part[name].dtype, expected.dtype)
                self.assertEqual(part[name].tobytes(), expected.tobytes(), name)
        self.assertTrue(covered.all())

    def test_fields_are_those_of_one_process(self):
        cases = [
            {"pieces": "random", "options": {"Resolution": 40}},
            {"pieces": "random", "options": {"Resolution": 40}, "ids": "marked cells points", "ghosts": True},
            {"pieces": "random", "options": {"Resolution": 30}, "ids": "cells points", "grid": True, "ghosts": True},
            {"pieces": "random", "options": {"Resolution": 30}, "ids": "cells", "seed": 2},
            {"pieces": "one", "owner": 1, "options": {"Resolution": 25, "SignMethod": 1}},
            {"pieces": "random", "options": {"Resolution": 25, "SignMethod": 0}},
            {"pieces": "runs", "options": {"Resolution": 30}, "blocks": "multiblock"},
            {"pieces": "runs", "options": {"Resolution": 30}, "blocks": "partitioned", "grid": True, "ghosts": True},
            {"pieces": "random", "options": {"Resolution": 30}, "blocks": "collection", "ids": "cells points"},
            {"pieces": "random", "empty": 1, "options": {"GridMode": 1, "Spacing": [0.1, 0.07, 0.09]}},
            {"pieces": "random", "options": {"GridMode": 2, "Origin": [-1.5, -1.4, -1.6], "Spacing": [0.1, 0.1, 0.1],
                                             "Dimensions": [31, 30, 33]}},
            {"pieces": "random", "ghost levels": [0, 2, 0], "options": {"Resolution": 30}},
            {"pieces": "random", "asks again": 1, "options": {"Resolution": 30}},
            {"pieces": "random", "copies": True, "options": {"Resolution": 30}, "ids": "cells points"},
            {"pieces": "random", "options": {"Resolution": 3}},
        ]
        self.expect_of_each({1: cases, 2: cases, 3: cases, 7: cases[:1] + cases[-1:]}, self.expect_bits_of_one)

    def expect_axis_of_one(self, case, parts):
        points, triangles, _ = whole_surface(case, len(parts))
        expected = arrays_of(output_of_one(case, points, triangles))
        cells = np.zeros(len(expected["cells"]), int)
        seen = np.zeros(len(expected["points"]), bool)
        for part in parts:
            self.assertEqual(list(part["messages"]), [])
            numbers, own = part["vtkGlobalPointIds"], part["vtkGlobalCellIds"]
            seen[numbers] = True
            cells[own] += 1
            np.testing.assert_array_equal(part["cells"], expected["cells"][own])
            for name in set(expected) - {"cells"}:
                self.assertEqual(part[name].tobytes(), expected[name][numbers].tobytes(), name)
        self.assertGreater(len(cells), 100)
        self.assertTrue((cells == 1).all())
        self.assertTrue(seen.all())

    def test_axes_are_those_of_one_process(self):
        cases = [
            {"axis": True, "pieces": "random", "options": {"Resolution": 48}},
            {"axis": True, "pieces": "random", "options": {"Resolution": 40, "Angle": 30, "Representation": 1},
             "ids": "marked cells points", "ghosts": True},
            {"axis": True, "pieces": "runs", "options": {"Resolution": 40, "Angle": 20, "Side": 2}, "blocks": "multiblock"},
            {"axis": True, "pieces": "one", "owner": 1, "options": {"Resolution": 40, "SignMethod": 1}},
            {"axis": True, "pieces": "runs", "options": {"Resolution": 40, "SignMethod": 3}},
            {"axis": True, "pieces": "random", "options": {"Resolution": 40, "Topology": 1}},
            {"axis": True, "pieces": "random", "empty": 1, "options": {
                "GridMode": 2, "Origin": [-1.5, -1.4, -1.6], "Spacing": [0.08, 0.08, 0.08], "Dimensions": [39, 38, 41]}},
        ]
        self.expect_of_each({1: cases[:1], 2: cases, 3: cases, 7: cases[:1]}, self.expect_axis_of_one)

    def test_who_asks_for_the_whole_axis_gets_it_on_the_first_rank(self):
        case = {"axis": True, "pieces": "random", "options": {"Resolution": 40}, "whole": True}
        for ranks in (1, 3):
            (parts,) = run(ranks, [case])
            self.expect_axis_of_one(case, parts)
            for part in parts[1:]:
                self.assertEqual(len(part["points"]), 0)
                self.assertEqual(len(part["cells"]), 0)

    def expect_thickness_of_one(self, case, parts):
        points, triangles, _ = whole_surface(case, len(parts))
        expected = arrays_of(output_of_one(case, points, triangles))
        used = np.unique(triangles)  # the others are those of ghosts
        at_point = dict(zip(bytes_of(points[used]), used))
        at_cell = dict(zip(bytes_of(expected["corners"]), range(len(triangles))))
        seen = []
        for rank, part in enumerate(parts):
            self.assertEqual(list(part["messages"]), [])
            kept = own_cells(case, rank, len(parts))
            places, cells = bytes_of(part["points"]), bytes_of(part["corners"])
            if case.get("copies"):  # the first that has a cell keeps it
                kept = [corners for corners in dict.fromkeys(kept) if corners in set(cells)]
            self.assertEqual(cells, kept)
            self.assertEqual(set(places), set(bytes_of(part["corners"].reshape(-1, 3))))
            seen.extend(cells)
            for name, values in expected.items():
                kind = name.split()[0]
                if kind == "field":
                    self.assertEqual(part[name].tobytes(), values.tobytes(), name)
                elif kind in ("point", "cell") and len(cells) > 0:
                    numbers = [at_point[at] for at in places] if kind == "point" else [at_cell[at] for at in cells]
                    self.assertEqual(part[name].dtype, values.dtype)
                    self.assertEqual(part[name].tobytes(), values[numbers].tobytes(), name)
            self.expect_own_arrays(case, part)
        self.assertEqual(len(seen), len(set(seen)))
        self.assertEqual(set(seen), set(at_cell))
        if "MinimumThickness" in case.get("options", {}):  # there are regions of both kinds
            self.assertEqual(set(expected["field RegionThin"]), {0, 1})

    def expect_own_arrays(self, case, part):
        """A rank's own arrays go with its points and cells."""
        self.assertNotIn("cell vtkGhostType", part)
        points, triangles = surface()
        for kind, name, places in (("point", "vtkGlobalPointIds", points), ("cell", "vtkGlobalCellIds", points[triangles])):
            if kind in case.get("ids", "") and len(part["corners"]) > 0:
                numbers = part[f"{kind} {name}"]
                found = part["points" if kind == "point" else "corners"]
                np.testing.assert_array_equal(found, places[numbers])

    def test_thickness_is_that_of_one_process(self):
        cases = [
            {"pieces": "random"},
            {"pieces": "random", "ids": "marked cells points", "ghosts": True, "options": {"CellValues": 1}},
            {"pieces": "random", "ids": "cells points", "grid": True, "ghosts": True,
             "options": {"Method": 2, "Side": 2, "CellValues": 1}},
            {"pieces": "one", "owner": 1, "options": {"Method": 1}},
            {"pieces": "random", "empty": 1, "options": {"Angle": 40}},
            {"pieces": "runs", "blocks": "multiblock", "options": {"MinimumThickness": 1.2, "MaximumThickness": 1.4}},
            {"pieces": "runs", "blocks": "partitioned", "grid": True, "ghosts": True},
            {"pieces": "random", "blocks": "collection", "ids": "cells points", "options": {"Side": 1}},
            {"pieces": "random", "copies": True, "ids": "cells points",
             "options": {"MinimumThickness": 1.2, "MaximumThickness": 1.4}},
        ]
        cases = [{"thickness": True, **case} for case in cases]
        self.expect_of_each({1: cases, 2: cases, 3: cases, 7: cases[:1] + cases[5:6]}, self.expect_thickness_of_one)

    def test_a_divided_surface_is_that_of_one_process(self):
        options = {"MaximumEdgeLength": 0.2, "MinimumThickness": 1.2, "MaximumThickness": 1.4}
        cases = [
            {"pieces": "random", "ids": "marked cells points", "ghosts": True, "options": options},
            {"pieces": "random", "ids": "cells points", "copies": True, "options": {**options, "Method": 2}},
            {"pieces": "random", "empty": 1, "ids": "cells points", "options": options},
            {"pieces": "one", "owner": 1, "ids": "cells points", "options": options},
        ]
        cases = [{"thickness": True, **case} for case in cases]
        for ranks, some in ((1, cases), (2, cases[:2]), (3, cases), (7, cases[:1])):
            for case, parts in zip(some, run(ranks, some)):
                with self.subTest(ranks=ranks, case=case):
                    self.expect_divided_as_in_one(case, parts)

    def expect_divided_as_in_one(self, case, parts):
        whole = field_filter(case)
        whole.SetInputData(polydata(*whole_surface(case, len(parts))[:2]))
        whole.Update()
        expected = arrays_of(whole.GetOutput())
        self.assertGreater(len(expected["corners"]), 2 * len(surface()[1]))
        at_cell = {corners: i for i, corners in enumerate(bytes_of(expected["corners"]))}
        seen = []
        for part in parts:
            self.assertEqual(list(part["messages"]), [])
            for name in (name for name in expected if name.startswith("field")):
                self.assertEqual(part[name].tobytes(), expected[name].tobytes(), name)
            if len(part["corners"]) == 0:
                continue
            ids = part["point vtkGlobalPointIds"]
            self.assertEqual(part["points"].tobytes(), expected["points"][ids].tobytes())
            self.assertEqual(part["point Thickness"].tobytes(), expected["point Thickness"][ids].tobytes())
            cells = [at_cell[corners] for corners in bytes_of(part["corners"])]
            for name in ("cell Thickness", "cell Region", "cell InputCell"):
                self.assertEqual(part[name].tobytes(), expected[name][cells].tobytes(), name)
            seen.extend(cells)
        self.assertEqual(sorted(seen), list(range(len(expected["corners"]))))

    def expect_reconstruction_of_one(self, case, parts):
        whole = field_filter(case)
        whole.SetInputData(whole_axis())
        whole.Update()
        expected = rows_of(arrays_of(whole.GetOutput()))
        self.assertGreater(len(expected), 1000)
        found = []
        for part in parts:
            self.assertEqual(list(part["messages"]), [])
            if "corners" in part:
                self.assertEqual(part["unused"].size, 0)
                found.extend(rows_of(part))
        self.assertTrue(sorted(found) == sorted(expected))  # assertEqual would compare long texts for minutes
        return sum("corners" in part and len(part["corners"]) > 0 for part in parts)

    def test_reconstructions_are_those_of_one_process(self):
        cases = [
            {"pieces": "random", "options": {"Resolution": 64}},
            {"pieces": "random", "options": {"Resolution": 50, "Interpolate": 0}},
            {"pieces": "runs", "options": {"Resolution": 40}, "copies": True},
            {"pieces": "runs", "options": {"Resolution": 40}, "grid": True},
            {"pieces": "random", "options": {"Resolution": 40}, "blocks": "multiblock"},
            {"pieces": "random", "empty": 1, "options": {"Resolution": 33}},
            {"pieces": "one", "owner": 1, "options": {"Resolution": 48}},
            {"pieces": "random", "ids": "cells points", "pipeline": True, "options": {"Resolution": 70}},
            {"pieces": "random", "options": {"Resolution": 64}, "whole": True},
        ]
        cases = [{"reconstruction": True, **case} for case in cases]
        for ranks, some in ((1, cases[:5]), (2, cases), (3, cases), (7, cases[:1] + cases[5:])):
            for case, parts in zip(some, run(ranks, some)):
                with self.subTest(ranks=ranks, case=case):
                    busy = self.expect_reconstruction_of_one(case, parts)
                    if case["options"]["Resolution"] == 64:
                        self.assertEqual(busy, ranks)

    def test_a_reconstruction_smaller_than_the_ranks_parts(self):
        case = {"reconstruction": True, "pieces": "random", "options": {"Resolution": 30}}
        (parts,) = run(12, [case])
        self.assertLess(self.expect_reconstruction_of_one(case, parts), 12)

    def test_no_rank_holds_the_surface(self):
        cases = [{"pieces": "runs", "options": {"Resolution": 64}}, {"pieces": "runs", "thickness": True}]
        triangles = len(surface()[1])
        for parts in run(4, cases):
            for part in parts:
                own, held, sent = part["held"]
                self.assertLess(own, 0.3 * triangles)
                self.assertGreaterEqual(held, own)
                self.assertGreater(sent, 0)

    def test_what_fails_on_one_rank_fails_on_all(self):
        small = {"Resolution": 20}
        explicit = {"GridMode": 2, "Dimensions": [9, 9, 9]}
        failures = [
            ({"fault": "NaN", "rank": 1, "options": small}, "^rank 1: point 0 .*nan"),
            ({"fault": "NaN", "rank": 0, "options": explicit}, "^rank 0: point 0 .*nan"),
            ({"fault": "type", "rank": 2, "options": small}, "rank 2: cell 0 is a vtkTetra, not part of a surface"),
            ({"fault": "overlap", "rank": 2, "ids": "cells points", "options": small}, "the pieces overlap: cell"),
            ({"fault": "short", "array": "vtkGhostType", "rank": 1, "options": small},
             "^rank 1: vtkGhostType has 1 values, and there are [0-9]+ points or cells to have one"),
            ({"fault": "short", "array": "vtkGlobalCellIds", "ids": "cells points", "rank": 0, "options": small},
             "^rank 0: vtkGlobalCellIds has 1 values, and"),
            ({"fault": "copies", "rank": 2, "options": small}, "sign method pseudonormal needs a closed"),
            ({"fault": "hole", "rank": 0, "options": small}, "sign method pseudonormal needs a closed"),
            ({"options": small, "options of ranks": {"1": {"Resolution": 21}}},
             "rank 1: Resolution 21, but rank 0 has Resolution 20"),
            ({"options": small, "options of ranks": {"2": {"GenerateClosestCell": 0}}},
             "rank 2: GenerateClosestCell 0, but rank 0 has GenerateClosestCell 1"),
            ({"options": small, "options of ranks": {"0": explicit}}, "rank 1: GridMode Resolution, but rank 0"),
            ({"options": explicit, "options of ranks": {"1": {"Dimensions": [9, 0, 9]}}}, "rank 1: .*dimension"),
            ({"options": small, "options of ranks": {"1": {"MemoryLimit": 1}}}, "rank 1: MemoryLimit 1 is not"),
            ({"options": {"Resolution": 1}}, "resolution 1 is outside"),
            ({"options": {**small, "Engine": 1}}, "needs the engine processor"),
        ]
        axis = {"axis": True, "options": small}
        failures += [
            ({**axis, "fault": "NaN", "rank": 1}, "^rank 1: point 0 .*nan"),
            ({**axis, "options of ranks": {"1": {"Angle": 40}}}, "rank 1: Angle 40, but rank 0 has Angle 60"),
            ({**axis, "options": {**small, "GenerateDistanceField": 1}}, "^GenerateDistanceField must be off"),
            ({**axis, "options": {**small, "Topology": 1, "Representation": 2}}, "^points have no topology to preserve"),
            ({**axis, "options": {**small, "MaximumNumberOfSpheres": -1}}, "-1"),
            ({**axis, "options": {**small, "Angle": 200}}, "200"),
        ]
        thickness = {"thickness": True}
        limited = {**thickness, "options": {"MinimumThickness": 1.3}}
        failures += [
            ({**thickness, "fault": "NaN", "rank": 1}, "^rank 1: point 0 .*nan"),
            ({**thickness, "fault": "type", "rank": 2}, "rank 2: cell 0 is a vtkTetra, not part of a surface"),
            ({**thickness, "fault": "overlap", "rank": 2, "ids": "cells points"}, "the pieces overlap: cell"),
            ({**limited, "fault": "hole", "rank": 0}, "^limits of the thickness of one side need a mesh with an inside"),
            ({**thickness, "options of ranks": {"1": {"Method": 2}}}, "rank 1: Method Wall, but rank 0 has Method Ball"),
            ({**limited, "options of ranks": {"2": {"MinimumThickness": 1.4}}}, "rank 2: MinimumThickness 1.3999"),
            ({**thickness, "options": {"Method": 3}}, "^Method 3 is not one of 0"),
            ({**thickness, "options": {"Angle": 200}}, "200"),
            ({**thickness, "options": {"MaximumEdgeLength": 1e-9}}, "^edges of at most 1e-09 need more than"),
            ({**thickness, "options of ranks": {"1": {"MaximumEdgeLength": 0.1}}},
             "rank 1: MaximumEdgeLength 0.1.*, but rank 0 has MaximumEdgeLength 0"),
        ]
        reconstruction = {"reconstruction": True, "options": small}
        failures += [
            ({**reconstruction, "fault": "NaN", "rank": 1}, "^rank 1: point 0: coordinate -?nan is outside"),
            ({**reconstruction, "fault": "type", "rank": 2}, "rank 2: cell 0 is a vtkTetra, not part of a surface"),
            ({**reconstruction, "fault": "Radius", "rank": 1}, "^rank 1: the input has no point data array Radius"),
            ({**reconstruction, "options of ranks": {"1": {"Resolution": 21}}},
             "rank 1: Resolution 21, but rank 0 has Resolution 20"),
            ({**reconstruction, "options of ranks": {"2": {"Interpolate": 0}}},
             "rank 2: Interpolate 0, but rank 0 has Interpolate 1"),
            ({**reconstruction, "options": {"Resolution": 1}}, "^resolution 1 is outside"),
            ({**reconstruction, "pieces": "none"}, "^the medial axis has 0 points"),
        ]
        good = {"pieces": "random", "options": small}
        cases = [{"pieces": "random", **case} for case, _ in failures] + [good]
        *found, last = run(3, cases)
        for (case, message), parts in zip(failures, found):
            with self.subTest(case=case):
                for part in parts:
                    (text,) = part["messages"]
                    self.assertRegex(text.split("): ", 1)[1].strip(), message)
                    self.assertEqual(part["error"], medial.vtkMeshFieldAlgorithm.InvalidInputError)
                    self.assertNotIn("Distance", part)
                    self.assertEqual(part.get("points", np.empty(0)).size, 0)
        self.expect_bits_of_one(good, last)


def rows_of(arrays):
    """A triangle's corners and normals as bytes."""
    return [corners + normals for corners, normals in zip(bytes_of(arrays["corners"]), bytes_of(arrays["normals"]))]


def bytes_of(rows):
    return [row.tobytes() for row in rows]


def own_cells(case, rank, ranks):
    """The corners of a rank's cells in their order, without those of ghosts."""
    cells = []
    for data in blocks_of(piece(case, rank, ranks)):
        ghosts = data.GetCellData().GetArray("vtkGhostType")
        cells.extend(bytes_of(corners_of(data)[vtk_to_numpy(ghosts) == 0] if ghosts else corners_of(data)))
    return cells


class Alone(unittest.TestCase):
    """Without MPI a process is the only rank."""

    def test_pieces_of_one_process(self):
        case = {"options": {"Resolution": 20}, "ids": "cells points"}
        field = field_filter(case)
        field.SetController(None)
        field.DistributedInputOn()
        field.SetInputData(polydata(*surface()))
        field.Update()
        expected = field_of_one(case, 1)
        for name, values in arrays_of(field.GetOutput()).items():
            self.assertEqual(values.tobytes(), expected[name].tobytes(), name)

    def test_what_the_input_may_be(self):
        case = {"pieces": "runs", "blocks": "multiblock", "options": {"Resolution": 12}}
        blocks = piece(case, 0, 1)
        field = field_filter({**case, "options": {"Resolution": 12, "SignMethod": 1}})
        field.SetInputDataObject(blocks)
        for distributed, output in ((0, "vtkMultiBlockDataSet"), (1, "vtkImageData"), (0, "vtkMultiBlockDataSet")):
            field.SetDistributedInput(distributed)
            blocks.SetBlock(1, None)  # one without cells has no field of its own
            field.Update()
            self.assertEqual(field.GetOutputDataObject(0).GetClassName(), output)

    def test_what_the_input_of_thickness_may_be(self):
        blocks = piece({"pieces": "runs", "blocks": "multiblock"}, 0, 1)
        thickness = medial.vtkMedialThickness()
        thickness.SetInputDataObject(blocks)
        for distributed, output in ((0, "vtkMultiBlockDataSet"), (1, "vtkPolyData"), (0, "vtkMultiBlockDataSet")):
            thickness.SetDistributedInput(distributed)
            blocks.SetBlock(1, None)  # one without cells has no thickness of its own
            thickness.Update()
            self.assertEqual(thickness.GetOutputDataObject(0).GetClassName(), output)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
