"""Each filter's output on the bunny, as ParaView shows it by default, compared with a stored picture.

usage: pvpython pictures_test.py [--update]   --update makes the pictures anew: look at them
"""

import os
import sys
import tempfile
import unittest

sys.path.insert(0, os.path.dirname(__file__))
from paraview.simple import *
from session import bunny
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOImage import vtkPNGReader

BASELINES = os.path.join(os.path.dirname(os.path.abspath(__file__)), "baselines")
UPDATE = "--update" in sys.argv
CLOSE = 16  # of 255
ALLOWED = 0.005  # share of the pixels that may differ by more


def read(path):
    reader = vtkPNGReader()
    reader.SetFileName(path)
    reader.Update()
    colours = vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars())
    return colours[:, :3].astype(int)


def difference(path, baseline):
    """Share of the pixels that differ."""
    return (abs(read(path) - read(baseline)).max(axis=1) > CLOSE).mean()


class Pictures(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.mesh = bunny()
        cls.axis = MedialAxis(Input=cls.mesh, Resolution=96)

    def picture(self, *shown):
        """A new view of the proxies; a number behind one is its opacity."""
        view = CreateView("RenderView", ViewSize=[240, 200], OrientationAxesVisibility=0)
        self.addCleanup(Delete, view)
        for proxy, opacity in shown:
            Show(proxy, view).Opacity = opacity
        view.ResetCamera()
        view.CameraPosition = [-1.5, 1.0, 4.5]
        view.CameraFocalPoint = [0.0, 0.0, 0.0]
        view.StillRender()
        return view

    def expect(self, name, *shown):
        baseline = os.path.join(BASELINES, f"{name}.png")
        view = self.picture(*shown)
        if UPDATE:
            SaveScreenshot(baseline, view)
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "picture.png")
            SaveScreenshot(path, view)
            error = difference(path, baseline)
            self.assertLess(error, ALLOWED, f"{name} differs; if it should, see --update")

    def test_distance_field(self):
        field = MeshDistanceField(Input=self.mesh, Resolution=64)
        self.expect("distance_field", (field, 1.0))

    def test_medial_axis(self):
        self.expect("medial_axis", (self.axis, 1.0), (self.mesh, 0.2))

    def test_medial_curves(self):
        self.expect("medial_curves", (MedialCurves(Input=self.axis), 1.0))

    def test_medial_thickness(self):
        self.expect("medial_thickness", (MedialThickness(Input=self.mesh), 1.0))

    def test_medial_reconstruction(self):
        surface = MedialReconstruction(Input=self.axis, Resolution=64)
        self.expect("medial_reconstruction", (surface, 1.0))

    def test_mesh_proximity(self):
        pair = MeshProximity(Input=self.mesh, InputB=self.mesh)
        pair.TransformB.Translate = [0.7, 0.1, -0.2]
        self.expect("mesh_proximity", (OutputPort(pair, 1), 0.2), (OutputPort(pair, 2), 1.0))

    def test_pictures_differ_from_each_other(self):
        field, axis = (os.path.join(BASELINES, f"{name}.png")
                       for name in ("distance_field", "medial_axis"))
        self.assertGreater(difference(axis, field), 0.2)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1], verbosity=2)
