"""pvbatch with 1, 2 and 3 processes: the same field, of which each computes its own part."""

import json
import os
import subprocess
import tempfile
import unittest
from pathlib import Path

import numpy
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOXML import vtkXMLImageDataReader

SCRIPT = Path(__file__).with_name("distributed_field.py")
ROUNDING = 1e-6  # of single precision; a voxel is 0.03
ENVIRONMENT = {"OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1",
               "HWLOC_COMPONENTS": "-gl"}


def run(processes, folder, script=SCRIPT, *options):
    """Runs a script, and returns the folder of what it writes."""
    folder = Path(folder, str(processes))
    folder.mkdir()
    # Where a process waits for others for ever, the launcher ends all of them.
    subprocess.run(["mpirun", "--oversubscribe", "--timeout", "900", "-np", str(processes), "pvbatch", *options, script,
                    folder], env={**os.environ, **ENVIRONMENT}, check=True, timeout=960)
    return folder


def parts(folder, name="field"):
    """Extent and arrays of each process's part."""
    for path in sorted(folder.glob(f"{name}/{name}_*.vti")):
        reader = vtkXMLImageDataReader()
        reader.SetFileName(str(path))
        reader.Update()
        image = reader.GetOutput()
        arrays = image.GetPointData()
        yield image.GetExtent(), {
            arrays.GetArrayName(i): vtk_to_numpy(arrays.GetArray(i)).reshape(
                *image.GetDimensions()[::-1], -1)
            for i in range(arrays.GetNumberOfArrays())}


def box(extent):
    """The part of arrays that an extent is."""
    return tuple(slice(extent[2 * axis], extent[2 * axis + 1] + 1) for axis in (2, 1, 0))


class Distributed(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.folder.cleanup)
        cls.runs = {n: run(n, cls.folder.name) for n in (1, 2, 3)}
        cls.results = {n: json.loads(Path(path, "result.json").read_text())
                       for n, path in cls.runs.items()}
        (_, cls.whole), = parts(cls.runs[1])
        cls.size = cls.whole["Distance"].size

    def test_every_part_is_that_of_one_process(self):
        self.assertEqual(set(self.whole), {"Distance", "ClosestPoint", "ClosestFeature"})
        for processes in (2, 3):
            found = list(parts(self.runs[processes]))
            self.assertEqual(len(found), processes)
            covered = numpy.zeros(self.whole["Distance"].shape[:3], bool)
            for extent, arrays in found:
                covered[box(extent)] = True
                self.expect_part(arrays, {name: values[box(extent)]
                                          for name, values in self.whole.items()})
            self.assertTrue(covered.all())

    def expect_part(self, part, whole):
        """The same values, but for rounding, and for samples between two equally near features."""
        numpy.testing.assert_allclose(part["Distance"], whole["Distance"], rtol=0, atol=ROUNDING)
        for name in ("ClosestPoint", "ClosestFeature"):
            same = numpy.isclose(part[name], whole[name], rtol=0, atol=ROUNDING).all(axis=3)
            self.assertGreater(same.mean(), 0.99, name)

    def test_no_process_has_the_whole(self):
        for processes in (2, 3):
            for extent, arrays in parts(self.runs[processes]):
                self.assertLess(arrays["Distance"].size, 1.2 * self.size / processes)

    def test_no_process_computes_the_whole(self):
        for processes in (1, 2, 3):
            fewest, most = self.results[processes]["samples of a process"]
            self.assertLess(most, 1.2 * self.size / processes)
            self.assertGreater(fewest, 0)

    def test_other_outputs_do_not_depend_on_the_number_of_processes(self):
        for processes in (2, 3):
            for name in ("axis", "curves", "reconstruction", "thickness", "contour bounds"):
                with self.subTest(processes=processes, output=name):
                    numpy.testing.assert_allclose(self.results[processes][name],
                                                  self.results[1][name], rtol=1e-6)


if __name__ == "__main__":
    unittest.main(verbosity=2)
