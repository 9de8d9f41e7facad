"""A surface in pieces, from RedistributeDataSet, from a loop like Catalyst's and from a series of files, on one process
and on several."""

import json
import tempfile
import unittest
from pathlib import Path

import numpy
from distributed_test import ROUNDING, box, parts, run
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader, vtkXMLPPolyDataReader

MODES = ("Assign_to_one_region", "Assign_to_all_regions", "Split_cells")
UNSIGNED = MODES[2]
PROCESSES = (1, 3)
SEVERAL = (2, 3)  # in the loop
STEPS, FILES = 10, 3
TOPOLOGIES = ("Selected", "Preserve")


class Redistributed(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.folder.cleanup)
        script = Path(__file__).with_name("redistributed_field.py")
        cls.runs = {n: run(n, cls.folder.name, script) for n in PROCESSES}
        cls.results = {n: json.loads(Path(path, "result.json").read_text()) for n, path in cls.runs.items()}
        (_, cls.whole), = parts(cls.runs[1], "whole")

    def expect_field_of_whole(self, processes, mode):
        covered = numpy.zeros(self.whole["Distance"].shape[:3], bool)
        for extent, arrays in parts(self.runs[processes], mode):
            covered[box(extent)] = True
            whole = self.whole["Distance"][box(extent)]
            numpy.testing.assert_allclose(arrays["Distance"], abs(whole) if mode == UNSIGNED else whole, rtol=0,
                                          atol=ROUNDING)
        self.assertTrue(covered.all())

    def test_every_mode_gives_the_field_of_the_whole(self):
        for processes in PROCESSES:
            for mode in MODES:
                with self.subTest(processes=processes, mode=mode):
                    self.expect_field_of_whole(processes, mode)

    def test_filters_behind_it_find_the_same(self):
        expected = self.results[1]["whole"]
        for processes in PROCESSES:
            for mode in MODES:
                with self.subTest(processes=processes, mode=mode):
                    found = self.results[processes][mode]
                    for name in ("clip",) if mode == UNSIGNED else ("contour", "clip", "bounds"):
                        numpy.testing.assert_allclose(found[name], expected[name], rtol=1e-5)

    def expect_axis_of_whole(self, processes, mode):
        whole = axis_of(self.runs[1], "whole")
        found = axis_of(self.runs[processes], mode)
        self.assertEqual(found.keys(), whole.keys())
        for name, (count, values) in found.items():
            self.assertTrue(values == whole[name][1], name)
            self.assertGreaterEqual(count, whole[name][0], name)  # points on cuts are in several pieces
        self.assertEqual(found["cells"][0], whole["cells"][0])

    def test_axes_have_the_points_and_cells_of_the_whole(self):
        for processes in PROCESSES:
            for mode in MODES[:2]:
                with self.subTest(processes=processes, mode=mode):
                    self.expect_axis_of_whole(processes, mode)

    def test_thickness_is_that_of_the_whole(self):
        points, cells = thickness_of(self.runs[1], "whole")
        self.assertGreater(len(cells), 1000)
        for processes in PROCESSES:
            for mode in MODES[:2]:
                with self.subTest(processes=processes, mode=mode):
                    found = thickness_of(self.runs[processes], mode)
                    self.assertTrue(found[0] == points)
                    self.assertTrue(found[1] == cells)  # each cell once
                    self.assertEqual(self.results[processes][mode]["thickness"]["median"],
                                     self.results[1]["whole"]["thickness"]["median"])
            for mode in MODES:
                self.assertAlmostEqual(self.results[processes][mode]["thickness"]["area"],
                                       self.results[1]["whole"]["thickness"]["area"], delta=1e-4)

    def test_reconstructions_have_the_triangles_of_the_whole(self):
        points, triangles, shared = reconstruction_of(self.runs[1], "whole")
        self.assertGreater(len(triangles), 1000)
        for processes in PROCESSES:
            for mode in MODES[:2]:
                with self.subTest(processes=processes, mode=mode):
                    found = reconstruction_of(self.runs[processes], mode)
                    self.assertTrue(found[0] == points)
                    self.assertTrue(found[1] == triangles)  # each once
                    self.assertEqual(found[2] > shared, processes > 1)  # on cuts

    def test_filters_behind_an_axis_find_the_same(self):
        expected = self.results[1]["whole"]["axis"]
        self.assertGreater(expected["curves"][1], 20)
        for processes in PROCESSES:
            for mode in MODES:
                with self.subTest(processes=processes, mode=mode):
                    found = self.results[processes][mode]["axis"]
                    # Where cells are split, their ends differ by rounding, and so do few of the axis' points.
                    tolerance = 1e-4 if mode == UNSIGNED else 1e-9
                    for name, values in expected.items():
                        numpy.testing.assert_allclose(found[name], values, rtol=tolerance, err_msg=name)


def polydata_of(path):
    reader = vtkXMLPPolyDataReader() if path.suffix == ".pvtp" else vtkXMLPolyDataReader()
    reader.SetFileName(str(path))
    reader.Update()
    return reader.GetOutput()


def bits(array):
    """Of each tuple."""
    return [values.tobytes() for values in vtk_to_numpy(array)]


def elements_of(data, array):
    """The bits of points with a value each, and of cells."""
    places = bits(data.GetPoints().GetData())
    values = bits(data.GetPointData().GetArray(array))
    cells = [tuple(places[i] for i in corners_of(data.GetCell(c))) for c in range(data.GetNumberOfCells())]
    return list(zip(places, values)), cells


def axis_of(folder, mode):
    """Points and cells of an axis that processes wrote, by their bits, and how many pieces have."""
    points, cells = elements_of(polydata_of(Path(folder, f"{mode}.pvtp")), "Radius")
    return {"points": (len(points), set(points)), "cells": (len(cells), set(cells))}


def thickness_of(folder, mode):
    """The points that processes wrote, with their thickness, and the cells with theirs, in no order."""
    surface = polydata_of(Path(folder, f"{mode}_thickness.pvtp"))
    points, cells = elements_of(surface, "Thickness")
    values = vtk_to_numpy(surface.GetCellData().GetArray("Thickness"))
    return set(points), sorted((cell, value.tobytes()) for cell, value in zip(cells, values))


def reconstruction_of(folder, mode):
    """The points that processes wrote, with their normals, the triangles in no order, and how often a point is there
    again."""
    points, triangles = elements_of(polydata_of(Path(folder, f"{mode}_reconstruction.pvtp")), "Normals")
    return set(points), sorted(triangles), len(points) - len(set(points))


def corners_of(cell):
    return [cell.GetPointId(i) for i in range(cell.GetNumberOfPoints())]


def steps_of(folder):
    """The steps of a loop, from what each process has."""
    for parts_of_step in zip(*(json.loads(path.read_text()) for path in sorted(folder.glob("steps_*.json")))):
        distances = numpy.array([part["distances"] for part in parts_of_step])
        bounds = numpy.array([part["bounds"] for part in parts_of_step])
        yield (parts_of_step[0]["radius"], (distances[:, 0].min(), distances[:, 1].max()),
               numpy.concatenate([bounds[:, ::2].min(axis=0), bounds[:, 1::2].max(axis=0)]))


class NumberedAxis:
    """An axis from what each process has of it: a point's bits by its number, and cells with their number and their
    points'."""

    def __init__(self, pieces):
        self.points, self.cells = {}, []
        self.shared = 0  # how often points are in a further piece
        self.cells_of_pieces = []
        for data in pieces:
            self.add(data)
        self.cells.sort()

    def add(self, data):
        arrays = data.GetPointData()
        names = sorted(arrays.GetArrayName(i) for i in range(arrays.GetNumberOfArrays()))
        assert {"Radius", "vtkGlobalPointIds"} < set(names), names
        places = bits(data.GetPoints().GetData())
        numbers = vtk_to_numpy(arrays.GetGlobalIds()).tolist()
        for number, *values in zip(numbers, places, *(bits(arrays.GetArray(name)) for name in names)):
            self.shared += number in self.points
            if self.points.setdefault(number, values) != values:
                raise AssertionError(f"point {number} differs between pieces")
        cells = vtk_to_numpy(data.GetCellData().GetGlobalIds()).tolist()
        self.cells_of_pieces.append(len(cells))
        self.cells += [(number, [numbers[i] for i in corners_of(data.GetCell(c))]) for c, number in enumerate(cells)]


class CoupledLoop(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.folder.cleanup)
        script = Path(__file__).with_name("coupled_loop.py")
        cls.runs = {n: run(n, cls.folder.name, script, "--sym") for n in (1, *SEVERAL)}

    def axis(self, processes, name):
        paths = [self.runs[processes] / f"{name}_{rank}.vtp" for rank in range(processes)]
        return NumberedAxis(polydata_of(path) for path in paths)

    def test_ten_steps_of_a_simulation(self):
        steps = {n: list(steps_of(path)) for n, path in self.runs.items()}
        self.assertEqual(len(steps[1]), STEPS)
        for radius, (lowest, highest), bounds in steps[1]:
            voxel = 2.4 * radius / 39  # with the margins
            self.assertAlmostEqual(lowest, -radius, delta=voxel)
            self.assertGreater(highest, 0.0)
            numpy.testing.assert_allclose(abs(bounds), radius - 0.25, atol=0.5 * voxel)
        for processes in SEVERAL:
            self.assertEqual(len(steps[processes]), STEPS)
            for found, expected in zip(steps[processes], steps[1]):
                self.assertEqual(found[1], expected[1])
                numpy.testing.assert_allclose(found[2], expected[2], rtol=0, atol=ROUNDING)

    def expect_axis_of_one_process(self, processes, name, expected):
        found = self.axis(processes, name)
        self.assertTrue(found.cells == expected.cells)  # each once
        self.assertTrue(found.points == expected.points)
        if processes > 1:
            self.assertGreater(min(found.cells_of_pieces), 0)  # so that no piece can be left out
            self.assertGreater(found.shared, 0)  # on cuts

    def test_axes_of_every_step_are_those_of_one_process(self):
        for topology in TOPOLOGIES:
            for step in range(STEPS):
                name = f"loop_{topology}_{step}"
                expected = self.axis(1, name)
                for of_whole in ([number for number, _ in expected.cells], sorted(expected.points)):
                    self.assertEqual(of_whole, list(range(len(of_whole))))
                for processes in SEVERAL:
                    with self.subTest(processes=processes, topology=topology, step=step):
                        self.expect_axis_of_one_process(processes, name, expected)

    def test_axes_change_with_steps_and_topology(self):
        cells = [self.axis(1, f"loop_{topology}_{step}").cells for topology in TOPOLOGIES for step in range(STEPS)]
        self.assertTrue(all(a != b for i, a in enumerate(cells) for b in cells[:i]))

    def test_files_of_a_series_give_the_axes_of_the_steps_in_them(self):
        for topology in TOPOLOGIES:
            for time in range(FILES):
                expected = self.axis(1, f"loop_{topology}_{time}")
                for processes in self.runs:
                    with self.subTest(processes=processes, topology=topology, time=time):
                        self.expect_axis_of_one_process(processes, f"series_{topology}_{time}", expected)


if __name__ == "__main__":
    unittest.main(verbosity=2)
