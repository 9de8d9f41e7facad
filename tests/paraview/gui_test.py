"""ParaView's window on a virtual display: filters from the menu, and a state file opened."""

import os
import subprocess
import sys
import tempfile
import time
import unittest
from pathlib import Path

from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOImage import vtkPNGReader

BUNNY = "/usr/share/glmark2/models/bunny.obj"
WINDOW = ["paraview", "--disable-registry"]
STATE = f"""
from paraview.simple import *
mesh = WavefrontOBJReader(FileName="{BUNNY}")
axis = MedialAxis(Input=mesh, Resolution=96)
view = GetActiveViewOrCreate("RenderView")
Show(axis, view)
view.ResetCamera()
SaveState("bunny.pvsm")
"""
APPLY = ('<pqevent object="pqClientMainWindow/propertiesDock/propertiesPanel/Accept" '
         'command="activate" arguments=""/>')


def choose(menu, item):
    return f'<pqevent object="pqClientMainWindow/{menu}" command="activate" arguments="{item}"/>'


def in_dialogue(widget, command, arguments=""):
    """An event of the dialogue that asks for the inputs of a filter with several."""
    return (f'<pqevent object="pqClientMainWindow/SelectInputDialog/{widget}" command="{command}" '
            f'arguments="{arguments}"/>')


# The first source of the pipeline becomes the second input, as it is the first already.
SECOND_INPUT = "\n".join([in_dialogue("buttonFrame/InputB", "set_boolean", "true"),
                          in_dialogue("pipelineView", "currentChanged", "/0|0/0|0"),
                          in_dialogue("buttonBox/1QPushButton0", "activate")])


def add_filter(name):
    """What a user does: Filters > Medial > name, Apply."""
    inputs = [SECOND_INPUT] if name == "MeshProximity" else []
    return "\n".join([choose("menubar", "menuFilters"), choose("menubar/menuFilters", "Medial"),
                      choose("menubar/menuFilters/Medial", name), *inputs, APPLY])


def shows_axis(path):
    """Whether the middle of the display has the red of great radii and the blue of small ones."""
    reader = vtkPNGReader()
    reader.SetFileName(str(path))
    reader.Update()
    width, height, _ = reader.GetOutput().GetDimensions()
    colours = vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars()).astype(int)
    view = colours.reshape(height, width, 3)[height // 3:3 * height // 4, width // 4:3 * width // 4]
    excess = view[:, :, 0] - view[:, :, 2]
    return (excess > 60).sum() > 1000 and (excess < -60).sum() > 1000


class Window(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def play(self, *filters):
        """Adds filters to the bunny through the menu, and returns what ParaView printed."""
        script = self.folder / "events.xml"
        events = "\n".join([APPLY, *map(add_filter, filters)])
        script.write_text(f'<?xml version="1.0"?>\n<pqevents>\n{events}\n</pqevents>\n')
        run = subprocess.run([*WINDOW, f"--data={BUNNY}", f"--test-script={script}", "--exit"],
                             capture_output=True, text=True, timeout=200)
        return run.returncode, run.stdout + run.stderr

    def test_filters_from_the_menu(self):
        code, text = self.play("MedialAxis", "MedialCurves")
        self.assertIn("Success =  true", text)
        self.assertEqual((code, text.count("ERR|")), (0, 0), text)
        code, text = self.play("MedialThickness", "MeshDistanceField")
        self.assertEqual((code, text.count("ERR|")), (0, 0), text)

    def test_a_filter_of_two_inputs(self):
        code, text = self.play("MeshProximity")
        self.assertIn("Success =  true", text)
        self.assertEqual((code, text.count("ERR|")), (0, 0), text)

    def test_a_filter_that_is_not_in_the_menu(self):
        code, text = self.play("MedialDream")
        self.assertNotEqual(code, 0, text)

    def test_state_file(self):
        script = self.folder / "state.py"
        script.write_text(STATE)
        subprocess.run(["pvpython", script], cwd=self.folder, check=True, timeout=200)
        picture = Path(os.environ.get("MEDIAL_PICTURES", self.folder), "window.png")
        with subprocess.Popen([*WINDOW, f"--state={self.folder / 'bunny.pvsm'}"]) as window:
            try:
                deadline = time.monotonic() + 120
                while time.monotonic() < deadline:
                    time.sleep(2)
                    self.assertIsNone(window.poll(), "the window is gone")
                    subprocess.run(["import", "-window", "root", f"PNG24:{picture}"], check=True)
                    if shows_axis(picture):
                        return
                self.fail("the window does not show the axis after two minutes")
            finally:
                window.kill()


if __name__ == "__main__":
    unittest.main(verbosity=2)
