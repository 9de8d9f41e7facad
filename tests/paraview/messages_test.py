"""Wrong use of the filters in pvpython: one message that helps, and ParaView goes on working."""

import os
import subprocess
import sys
import tempfile
import unittest

sys.path.insert(0, os.path.dirname(__file__))
from paraview.simple import *
from session import box, messages

ON_MESHES = (MeshDistanceField, MedialAxis, MedialThickness)


class Messages(unittest.TestCase):
    def expect(self, words, filter, properties, **repaired):
        """The message has the words, there is no output, and repaired properties work."""
        with messages() as shown:
            proxy = filter(**properties)
            proxy.UpdatePipeline()
            self.assertIn(words, shown())
        self.assertEqual(proxy.GetDataInformation().GetNumberOfPoints(), 0)
        with messages() as shown:
            for name, value in repaired.items():
                setattr(proxy, name, value)
            proxy.UpdatePipeline()
            self.assertEqual(shown(), "")
        self.assertGreater(proxy.GetDataInformation().GetNumberOfPoints(), 0)

    def test_files_that_are_no_meshes(self):
        with tempfile.TemporaryDirectory() as folder:
            damaged = os.path.join(folder, "damaged.stl")
            missing = os.path.join(folder, "missing.stl")
            with open(damaged, "w") as file:
                file.write("solid x\nfacet normal 0 0 1\nouter loop\nvertex 0 0")
            for path, words in ((damaged, " at line 4"), (missing, " not found")):
                for filter in ON_MESHES:
                    with self.subTest(words=words, filter=filter.__name__):
                        self.expect(path + words, filter, {"Input": STLReader(FileNames=[path])},
                                    Input=box())

    def test_a_mesh_without_cells(self):
        outside = Clip(Input=box(), ClipType="Plane", Invert=0)
        outside.ClipType.Origin = [5, 0, 0]
        for filter in ON_MESHES:
            with self.subTest(filter=filter.__name__):
                self.expect("the mesh has no cells", filter,
                            {"Input": ExtractSurface(Input=outside)}, Input=box())
        self.expect("mesh B: the mesh has no cells", MeshProximity,
                    {"Input": box(), "InputB": ExtractSurface(Input=outside)}, InputB=box())

    def test_parameters_outside_their_range(self):
        self.expect("resolution 1 is outside [2, 8192]", MedialAxis,
                    {"Input": box(), "Resolution": 1}, Resolution=16)
        self.expect("spacing along y -0.1 is outside", MeshDistanceField,
                    {"Input": box(), "GridMode": "Spacing", "Spacing": [0.1, -0.1, 0.1]},
                    Spacing=[0.1, 0.1, 0.1])
        self.expect("minimum lambda -1 is outside [0, infinity)", MedialAxis,
                    {"Input": box(), "Resolution": 16, "MinimumLambda": -1}, MinimumLambda=0)
        self.expect("separation angle 180 is outside (0, 180) degrees", MedialThickness,
                    {"Input": box(), "Angle": 180}, Angle=60)

        pair = {"Input": box(), "InputB": box()}
        self.expect("depth tolerance 1 is outside (0, 1)", MeshProximity,
                    {**pair, "DepthTolerance": 1}, DepthTolerance=0.01)
        self.expect("maximum number of contacts -1 is outside [0, infinity)", MeshProximity,
                    {**pair, "MaximumNumberOfContacts": -1}, MaximumNumberOfContacts=0)

    def test_a_scale_of_zero(self):
        with messages() as shown:
            pair = MeshProximity(Input=box(), InputB=box())
            pair.TransformB.Scale = [1, 1, 0]
            pair.UpdatePipeline()
            self.assertIn("mesh B: the determinant 0 of the transform is not finite", shown())
        pair.TransformB.Scale = [1, 1, 1]
        pair.UpdatePipeline()
        self.assertGreater(pair.GetDataInformation().GetNumberOfPoints(), 0)

    def test_combinations_that_cannot_be(self):
        self.expect("the representation must be surface or faces", MedialAxis,
                    {"Input": box(), "Resolution": 16, "Topology": "Preserve",
                     "Representation": "Points"}, Representation="Surface")
        self.expect("needs a closed, consistently oriented mesh", MeshDistanceField,
                    {"Input": Plane(), "Resolution": 16, "SignMethod": "Pseudonormal"},
                    SignMethod="Auto")

    def test_grids_larger_than_memory(self):
        axis = MedialAxis(Input=box(), Resolution=32)
        for filter, properties in ((MeshDistanceField, {"Input": box()}),
                                   (MedialAxis, {"Input": box(), "Topology": "Preserve"}),
                                   (MedialReconstruction, {"Input": axis})):
            with self.subTest(filter=filter.__name__):
                self.expect(" MiB are available", filter, {**properties, "Resolution": 8192},
                            Resolution=16)

    def test_reconstruction_of_what_is_no_axis(self):
        self.expect("no point data array Radius", MedialReconstruction,
                    {"Input": box(), "Resolution": 16},
                    Input=MedialAxis(Input=box(), Resolution=32))

    def test_no_egl(self):
        script = ("from paraview.simple import *\n"
                  "axis = MedialAxis(Input=Box(), Resolution=16, Engine='Rasteriser')\n"
                  "axis.UpdatePipeline()\n"
                  "print(axis.GetDataInformation().GetNumberOfPoints(), 'points')\n")
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "axis.py")
            with open(path, "w") as file:
                file.write(script)
            environment = dict(os.environ, __EGL_VENDOR_LIBRARY_DIRS=folder,
                               __EGL_VENDOR_LIBRARY_FILENAMES=f"{folder}/none.json")
            run = subprocess.run(["pvpython", path], env=environment, capture_output=True,
                                 text=True, timeout=120)
        self.assertEqual((run.returncode, run.stdout), (0, "0 points\n"), run.stderr)
        self.assertIn("no EGL device offers an OpenGL 4.5 core context; install a driver",
                      run.stderr)


if __name__ == "__main__":
    unittest.main(verbosity=2)
