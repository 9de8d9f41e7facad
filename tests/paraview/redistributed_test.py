"""A surface in pieces, from RedistributeDataSet and from a loop like Catalyst's, on 1, 2 and 3 processes."""

import json
import tempfile
import unittest
from pathlib import Path

import numpy
from distributed_test import ROUNDING, box, parts, run

MODES = ("Assign_to_one_region", "Assign_to_all_regions", "Split_cells")
UNSIGNED = MODES[2]


class Redistributed(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.folder.cleanup)
        script = Path(__file__).with_name("redistributed_field.py")
        cls.runs = {n: run(n, cls.folder.name, script) for n in (1, 2, 3)}
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
        for processes in (1, 2, 3):
            for mode in MODES:
                with self.subTest(processes=processes, mode=mode):
                    self.expect_field_of_whole(processes, mode)

    def test_filters_behind_it_find_the_same(self):
        expected = self.results[1]["whole"]
        for processes in (1, 2, 3):
            for mode in MODES:
                with self.subTest(processes=processes, mode=mode):
                    found = self.results[processes][mode]
                    for name in ("clip",) if mode == UNSIGNED else ("contour", "clip", "bounds"):
                        numpy.testing.assert_allclose(found[name], expected[name], rtol=1e-5)

    def test_axes_are_as_large_as_that_of_the_whole(self):
        expected = self.results[1]["whole"]["axis"]
        self.assertGreater(expected, 0.0)
        for processes in (1, 2, 3):
            for mode in MODES[:2]:
                with self.subTest(processes=processes, mode=mode):
                    self.assertAlmostEqual(self.results[processes][mode]["axis"], expected, delta=1e-6 * expected)


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
            steps = {n: list(steps_of(run(n, folder, script, "--sym"))) for n in (1, 2, 3)}
        self.assertEqual(len(steps[1]), 10)
        for radius, (lowest, highest), bounds in steps[1]:
            voxel = 2.4 * radius / 39  # with the margins
            self.assertAlmostEqual(lowest, -radius, delta=voxel)
            self.assertGreater(highest, 0.0)
            numpy.testing.assert_allclose(abs(bounds), radius - 0.25, atol=0.5 * voxel)
        for n in (2, 3):
            for found, expected in zip(steps[n], steps[1]):
                self.assertEqual(found[1], expected[1])
                numpy.testing.assert_allclose(found[2], expected[2], rtol=0, atol=ROUNDING)


if __name__ == "__main__":
    unittest.main(verbosity=2)
