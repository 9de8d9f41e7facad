"""A surface in pieces, from RedistributeDataSet and from a loop like Catalyst's, on one process and on three."""

import json
import tempfile
import unittest
from pathlib import Path

import numpy
from distributed_test import ROUNDING, box, parts, run
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOXML import vtkXMLPPolyDataReader

MODES = ("Assign_to_one_region", "Assign_to_all_regions", "Split_cells")
UNSIGNED = MODES[2]
PROCESSES = (1, 3)


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


def polydata_of(folder, name):
    reader = vtkXMLPPolyDataReader()
    reader.SetFileName(str(Path(folder, f"{name}.pvtp")))
    reader.Update()
    return reader.GetOutput()


def elements_of(data, array):
    """The bits of points with a value each, and of cells."""
    places = [place.tobytes() for place in vtk_to_numpy(data.GetPoints().GetData())]
    values = [value.tobytes() for value in vtk_to_numpy(data.GetPointData().GetArray(array))]
    cells = [tuple(places[i] for i in corners_of(data.GetCell(c))) for c in range(data.GetNumberOfCells())]
    return list(zip(places, values)), cells


def axis_of(folder, mode):
    """Points and cells of an axis that processes wrote, by their bits, and how many pieces have."""
    points, cells = elements_of(polydata_of(folder, mode), "Radius")
    return {"points": (len(points), set(points)), "cells": (len(cells), set(cells))}


def thickness_of(folder, mode):
    """The points that processes wrote, with their thickness, and the cells with theirs, in no order."""
    surface = polydata_of(folder, f"{mode}_thickness")
    points, cells = elements_of(surface, "Thickness")
    values = vtk_to_numpy(surface.GetCellData().GetArray("Thickness"))
    return set(points), sorted((cell, value.tobytes()) for cell, value in zip(cells, values))


def corners_of(cell):
    return [cell.GetPointId(i) for i in range(cell.GetNumberOfPoints())]


def steps_of(folder):
    """The steps of a loop, from what each process has."""
    for parts_of_step in zip(*(json.loads(path.read_text()) for path in sorted(folder.glob("steps_*.json")))):
        distances = numpy.array([part["distances"] for part in parts_of_step])
        bounds = numpy.array([part["bounds"] for part in parts_of_step])
        yield (parts_of_step[0]["radius"], (distances[:, 0].min(), distances[:, 1].max()),
               numpy.concatenate([bounds[:, ::2].min(axis=0), bounds[:, 1::2].max(axis=0)]))


class CoupledLoop(unittest.TestCase):
    def test_ten_steps_of_a_simulation(self):
        with tempfile.TemporaryDirectory() as folder:
            script = Path(__file__).with_name("coupled_loop.py")
            steps = {n: list(steps_of(run(n, folder, script, "--sym"))) for n in PROCESSES}
        self.assertEqual(len(steps[1]), 10)
        for radius, (lowest, highest), bounds in steps[1]:
            voxel = 2.4 * radius / 39  # with the margins
            self.assertAlmostEqual(lowest, -radius, delta=voxel)
            self.assertGreater(highest, 0.0)
            numpy.testing.assert_allclose(abs(bounds), radius - 0.25, atol=0.5 * voxel)
        for found, expected in zip(steps[3], steps[1]):
            self.assertEqual(found[1], expected[1])
            numpy.testing.assert_allclose(found[2], expected[2], rtol=0, atol=ROUNDING)


if __name__ == "__main__":
    unittest.main(verbosity=2)
