"""A page of medial-axis --html in headless Chromium, beside the axis that was written with it.

usage: browser_test.py MEDIAL-AXIS CHROMIUM FOLDER   pictures of the page stay in FOLDER
"""

import os
import re
import shlex
import subprocess
import sys
import tempfile
import unittest
from html import unescape
from pathlib import Path

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkFiltersCore import vtkTriangleFilter
from vtkmodules.vtkIOImage import vtkPNGReader
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader

AXIS, CHROMIUM, PICTURES = sys.argv[1], sys.argv[2], Path(sys.argv[3])
DOCUMENT = Path(__file__).resolve().parents[2] / "docs/WEB.md"
SIZE = (1280, 960)
VIEW = (slice(None), slice(320, 1080))  # between panel and legend
LIMIT = 15_000_000  # bytes of a page

# Without a GPU, SwiftShader draws. No name is resolved, so that nothing can come from elsewhere.
FLAGS = ["--headless=new", "--no-sandbox", "--use-gl=angle", "--use-angle=swiftshader",
         "--enable-unsafe-swiftshader", "--host-resolver-rules=MAP * ~NOTFOUND",
         f"--window-size={SIZE[0]},{SIZE[1]}", "--force-device-scale-factor=1",
         "--virtual-time-budget=10000", "--enable-logging=stderr"]

# A dumbbell of boxes, 2 x 1.4 x 0.8 and smaller, for want of a scan.
BOXES = (((0, 0, 0), (1.0, 0.7, 0.4)), ((3, 0, 0), (0.5, 0.35, 0.2)))
SIDES = ((1, 3, 4, 2), (5, 6, 8, 7), (1, 2, 6, 5), (3, 7, 8, 4), (1, 5, 7, 3), (2, 4, 8, 6))


def write_boxes(path, scale=1.0, moved=0.0):
    """All coordinates are scaled, and then moved."""
    lines = []
    for middle, half in BOXES:
        for signs in np.ndindex(2, 2, 2):
            point = np.array(middle) + (2 * np.array(signs[::-1]) - 1) * half
            lines.append("v " + " ".join(str(moved + scale * x) for x in point))
    for box in range(len(BOXES)):
        lines += ["f " + " ".join(str(8 * box + corner) for corner in side) for side in SIDES]
    path.write_text("\n".join(lines) + "\n")


def find_mesh(folder):
    """The gargoyle where it is, otherwise the boxes."""
    gargoyle = Path(os.environ.get("MEDIAL_MODELS", "none")) / "paper/gargoyle_20k.off"
    if gargoyle.exists():
        return gargoyle
    write_boxes(folder / "boxes.obj")
    return folder / "boxes.obj"


def least_angles(path):
    """The least separation angle of the corners of each triangle of the axis."""
    reader = vtkXMLPolyDataReader()
    reader.SetFileName(str(path))
    triangulate = vtkTriangleFilter()
    triangulate.SetInputConnection(reader.GetOutputPort())
    triangulate.Update()
    axis = triangulate.GetOutput()
    angles = vtk_to_numpy(axis.GetPointData().GetArray("SeparationAngle"))
    corners = vtk_to_numpy(axis.GetPolys().GetConnectivityArray()).reshape(-1, 3)
    return angles[corners].min(axis=1)


def read_picture(path):
    """Rows from the top, columns, red, green and blue."""
    reader = vtkPNGReader()
    reader.SetFileName(str(path))
    reader.Update()
    image = reader.GetOutput()
    width, height, _ = image.GetDimensions()
    pixels = vtk_to_numpy(image.GetPointData().GetScalars()).reshape(height, width, -1)
    return pixels[::-1, :, :3].astype(int)


def coloured(picture):
    """Where the axis is, seen through the surface or not."""
    return np.ptp(picture, axis=2) > 40


def grey(picture):
    """Where the surface is, with nothing behind it."""
    return ~coloured(picture) & (picture.min(axis=2) < 252)


class Browser(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.temporary = tempfile.TemporaryDirectory()
        cls.folder = Path(cls.temporary.name)
        cls.page = cls.folder / "page.html"
        cls.mesh = find_mesh(cls.folder)
        subprocess.run([AXIS, cls.mesh, "--resolution", "256", "--quiet", "--html", cls.page,
                        "-o", cls.folder / "axis.vtp"], check=True)
        cls.angles = least_angles(cls.folder / "axis.vtp")
        cls.default_picture = cls.picture("default")

    @classmethod
    def tearDownClass(cls):
        cls.temporary.cleanup()

    @classmethod
    def open(cls, action, fragment="", script="", page=None, flags=(), may_complain=False):
        """Opens the page with a script behind its own, and returns what Chromium prints. Errors of
        scripts and refused loads fail, unless the page may complain."""
        page = page or cls.page
        if script:
            page = cls.folder / "scripted.html"
            page.write_text(cls.page.read_text().replace(
                "</body>", f"<script>{script}</script></body>"))
        command = [CHROMIUM, *FLAGS, *flags, f"--user-data-dir={cls.folder}/profile", action,
                   page.as_uri() + fragment]
        result = subprocess.run(command, capture_output=True, text=True, check=True, timeout=200)
        messages = [line for line in result.stderr.splitlines() if "CONSOLE" in line]
        assert may_complain or not messages, messages
        return result.stdout

    @classmethod
    def picture(cls, name, fragment="", script="", page=None):
        path = PICTURES / f"{name}.png"
        path.unlink(missing_ok=True)
        cls.open(f"--screenshot={path}", fragment, script, page=page)
        return read_picture(path)

    def text(self, name, fragment="", script=""):
        """The text of the element after loading."""
        page = self.open("--dump-dom", fragment, script)
        return unescape(re.search(rf'id="{name}"[^>]*>([^<]*)<', page)[1])

    def shown(self, fragment="", script=""):
        """Number of triangles that the page says it shows, and has."""
        count = self.text("count", fragment, script)
        return tuple(int(n.replace(",", ""))
                     for n in re.match(r"([\d,]+) of ([\d,]+) triangles", count).groups())

    def assert_shown(self, angle, fragment="", script=""):
        shown, all_triangles = self.shown(fragment, script)
        step = 180 / 65535  # angles on the page are rounded
        self.assertEqual(all_triangles, len(self.angles))
        self.assertGreaterEqual(shown, (self.angles >= angle + step).sum())
        self.assertLessEqual(shown, (self.angles >= angle - step).sum())

    def test_page_is_small(self):
        self.assertLess(self.page.stat().st_size, LIMIT)

    def test_page_shows_axis_surface_and_legend(self):
        picture = self.default_picture
        self.assertEqual(picture.shape, (SIZE[1], SIZE[0], 3))
        view = picture[VIEW]
        self.assertGreater(coloured(view).mean(), 0.03)
        legend = picture[200:800, 1100:1270]
        for colour in ((68, 1, 84), (32, 145, 141), (253, 233, 37)):  # of the map
            with self.subTest(colour=colour):
                self.assertTrue((abs(legend - colour).max(axis=2) < 12).any())

    def test_title_and_notes(self):
        self.assertEqual(self.text("title"), self.mesh.name)
        self.assertIn("rounded", self.open("--dump-dom"))

    def test_all_triangles_at_first(self):
        self.assert_shown(0)

    def test_angle_of_the_address(self):
        for angle in (90, 150):
            with self.subTest(angle=angle):
                self.assert_shown(angle, f"#angle={angle}")

    def test_slider_takes_cells_away(self):
        script = """const slider = document.getElementById("angle");
            slider.value = 120; slider.dispatchEvent(new Event("input"));"""
        self.assert_shown(120, script=script)
        few = self.picture("angle-120", script=script)
        self.assertLess(coloured(few[VIEW]).sum(), 0.8 * coloured(self.default_picture[VIEW]).sum())

    def test_keys_change_the_angle(self):
        key = 'window.dispatchEvent(new KeyboardEvent("keydown", {key: "%s", shiftKey: %s}));'
        script = (key % ("ArrowRight", "true")) * 4 + key % ("ArrowLeft", "false")
        self.assert_shown(np.floor(self.angles.min()) + 39, script=script)

    def test_surface_can_be_switched_off(self):
        script = 'window.dispatchEvent(new KeyboardEvent("keydown", {key: "s"}));'
        translucent = self.picture("translucent", "#angle=180")[VIEW]
        self.assertGreater(grey(translucent).mean(), 0.05)
        fragment = "#angle=180&opacity=1"
        self.assertGreater(grey(self.picture("opaque", fragment)[VIEW]).mean(), 0.05)
        self.assertLess(grey(self.picture("no-surface", fragment, script)[VIEW]).mean(), 0.005)

    def test_colour_by_separation_angle(self):
        self.assertEqual(self.text("legend-title"), "Radius (world units)")
        fragment = "#colour=SeparationAngle"
        self.assertEqual(self.text("legend-title", fragment), "Separation angle (degrees)")
        picture = self.picture("separation-angle", fragment + "&angle=165&opacity=0")[VIEW]
        axis = picture[coloured(picture)]
        self.assertGreater(len(axis), 1000)
        self.assertGreater((axis[:, 1] > axis[:, 2]).mean(), 0.95)  # the greatest values are yellow

    def test_dragging_turns_and_reset_turns_back(self):
        drag = """const canvas = document.querySelector("#view canvas");
            const send = (type, x, buttons) => canvas.parentElement.dispatchEvent(
              new PointerEvent(type, {clientX: x, clientY: 500, button: 0, buttons, pointerId: 1,
                pointerType: "mouse", isPrimary: true, bubbles: true, cancelable: true}));
            canvas.parentElement.setPointerCapture = () => {};
            send("pointerdown", 600, 1); send("pointermove", 700, 1);
            send("pointermove", 800, 1); send("pointerup", 800, 0);"""
        turned = self.picture("turned", script=drag)
        changed = abs(turned - self.default_picture)[VIEW].max(axis=2) > 40
        self.assertGreater(changed.mean(), 0.02)
        self.assertGreater(coloured(turned[VIEW]).mean(), 0.01)
        back = self.picture("reset", script=drag + 'document.getElementById("reset").click();')
        self.assertLess((abs(back - self.default_picture)[VIEW].max(axis=2) > 40).mean(), 0.001)

    def test_command_and_address_of_the_document(self):
        text = DOCUMENT.read_text()
        command = re.search(r"^    build-web/bin/medial-axis (.*)$", text, re.MULTILINE)[1]
        subprocess.run([AXIS, *shlex.split(command), "--quiet"], cwd=self.folder, check=True)
        page, fragment = re.search(r"`(\w+\.html)(#\S+)`", text).groups()
        shown = self.open("--dump-dom", fragment, page=self.folder / page)
        self.assertIn("Separation angle ≥ 110°", re.sub(r"<[^>]*>", "", unescape(shown)))
        self.assertRegex(shown, r'id="legend-title"[^>]*>Separation angle \(degrees\)')

    def test_neither_size_nor_place_matters(self):
        pictures = []
        for scale, moved in ((1.0, 0.0), (2.0**-12, 1e4)):
            mesh = self.folder / "moved.obj"
            page = self.folder / "moved.html"
            write_boxes(mesh, scale, moved)
            subprocess.run([AXIS, mesh, "--resolution", "128", "--quiet", "--html", page],
                           check=True)
            pictures.append(self.picture(f"moved-by-{moved:g}", page=page)[VIEW])
        self.assertGreater(coloured(pictures[0]).mean(), 0.1)
        self.assertLess((abs(pictures[1] - pictures[0]).max(axis=2) > 40).mean(), 0.01)

    def test_nothing_can_be_loaded(self):
        script = """const title = document.getElementById("title");
            title.textContent = "refused:";
            document.addEventListener("securitypolicyviolation",
              (event) => { title.textContent += ` ${event.effectiveDirective}`; });
            new Image().src = "other.png";
            fetch("other.json").catch(() => {});"""
        page = self.open("--dump-dom", script=script, may_complain=True)
        refused = re.search(r">refused:([^<]*)<", page)[1].split()
        self.assertEqual(sorted(refused), ["connect-src", "img-src"])

    def test_says_so_without_webgl(self):
        page = self.open("--dump-dom", flags=["--disable-3d-apis"],
                         may_complain=True)
        self.assertRegex(page, r'id="failure"[^>]*>The page cannot be shown: [^<]*WebGL')
        self.assertNotRegex(page, r'id="failure"[^>]*hidden')


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
