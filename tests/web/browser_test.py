"""A page of medial-axis --html in headless Chromium, compared with the axis written by the same run.

usage: browser_test.py MEDIAL-AXIS CHROMIUM FOLDER [Browser.TEST...]

Pictures of the page stay in FOLDER.
"""

import json
import os
import re
import resource
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
NO_SPACE = 5  # exit code, as docs/COMMAND-LINE.md has it

# Without a GPU, SwiftShader draws. No name is resolved, so that nothing can come from elsewhere.
FLAGS = ["--headless=new", "--no-sandbox", "--use-gl=angle", "--use-angle=swiftshader",
         "--enable-unsafe-swiftshader", "--host-resolver-rules=MAP * ~NOTFOUND",
         f"--window-size={SIZE[0]},{SIZE[1]}", "--force-device-scale-factor=1",
         "--virtual-time-budget=10000", "--enable-logging=stderr"]

# A dumbbell of boxes, 2 x 1.4 x 0.8 and smaller, in case there is no scan.
BOXES = (((0, 0, 0), (1.0, 0.7, 0.4)), ((3, 0, 0), (0.5, 0.35, 0.2)))
SIDES = ((1, 3, 4, 2), (5, 6, 8, 7), (1, 2, 6, 5), (3, 7, 8, 4), (1, 5, 7, 3), (2, 4, 8, 6))


def write_boxes(path, boxes=BOXES, scale=1.0, moved=0.0):
    """Boxes by middle and half their sides. All coordinates are scaled, and then moved."""
    lines = []
    for middle, half in boxes:
        for signs in np.ndindex(2, 2, 2):
            point = np.array(middle) + (2 * np.array(signs[::-1]) - 1) * half
            lines.append("v " + " ".join(str(moved + scale * x) for x in point))
    for box in range(len(boxes)):
        lines += ["f " + " ".join(str(8 * box + corner) for corner in side) for side in SIDES]
    path.write_text("\n".join(lines) + "\n")


def find_mesh(folder):
    """The gargoyle where it is, otherwise the boxes."""
    gargoyle = Path(os.environ.get("MEDIAL_MODELS", "none")) / "paper/gargoyle_20k.off"
    if gargoyle.exists():
        return gargoyle
    write_boxes(folder / "boxes.obj")
    return folder / "boxes.obj"


def read_axis(path):
    """The minimum separation angle of the corners of each triangle of the axis, and its largest
    radius."""
    reader = vtkXMLPolyDataReader()
    reader.SetFileName(str(path))
    triangulate = vtkTriangleFilter()
    triangulate.SetInputConnection(reader.GetOutputPort())
    triangulate.Update()
    axis = triangulate.GetOutput()
    angles = vtk_to_numpy(axis.GetPointData().GetArray("SeparationAngle"))
    corners = vtk_to_numpy(axis.GetPolys().GetConnectivityArray()).reshape(-1, 3)
    return angles[corners].min(axis=1), axis.GetPointData().GetArray("Radius").GetRange()[1]


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


def text_of(dom, name):
    """The text of the element with this id."""
    return unescape(re.search(rf'id="{name}"[^>]*>([^<]*)<', dom)[1])


def items_of(dom, name):
    """The texts of the list with this id."""
    items = re.search(rf'id="{name}"[^>]*>((?:<li[^>]*>[^<]*</li>)*)</', dom)[1]
    return [unescape(item) for item in re.findall("<li[^>]*>([^<]*)</li>", items)]


def is_hidden(dom, name):
    return re.search(rf'id="{name}"[^>]* hidden', dom) is not None


class Browser(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.temporary = tempfile.TemporaryDirectory()
        cls.folder = Path(cls.temporary.name)
        cls.page = cls.folder / "page.html"
        cls.mesh = find_mesh(cls.folder)
        subprocess.run([AXIS, cls.mesh, "--resolution", "256", "--quiet", "--html", cls.page,
                        "-o", cls.folder / "axis.vtp"], check=True)
        cls.angles, cls.max_radius = read_axis(cls.folder / "axis.vtp")
        # The slider begins at the angle of the axis, or at the least one that there is.
        cls.first = max(60, int(np.floor(cls.angles.min())))
        cls.default_picture, cls.default_dom = cls.picture_and_dom("default")

    @classmethod
    def tearDownClass(cls):
        cls.temporary.cleanup()

    @classmethod
    def open(cls, action, fragment="", script="", page=None, flags=(), may_complain=False):
        """Opens the page with a script behind its own, and returns what Chromium prints. Errors of
        scripts and refused loads fail, unless the page may complain."""
        page = page or cls.page
        if script:
            text = page.read_text()
            page = cls.folder / "scripted.html"
            page.write_text(text.replace("</body>", f"<script>{script}</script></body>"))
        command = [CHROMIUM, *FLAGS, *flags, f"--user-data-dir={cls.folder}/profile", action,
                   page.as_uri() + fragment]
        result = subprocess.run(command, capture_output=True, text=True, check=True, timeout=200)
        messages = [line for line in result.stderr.splitlines() if "CONSOLE" in line]
        assert may_complain or not messages, messages
        return result.stdout

    @classmethod
    def picture_and_dom(cls, name, fragment="", script="", page=None):
        path = PICTURES / f"{name}.png"
        path.unlink(missing_ok=True)
        dom = cls.open("--dump-dom", fragment, script, page, flags=[f"--screenshot={path}"])
        return read_picture(path), dom

    @classmethod
    def picture(cls, name, fragment="", script="", page=None):
        return cls.picture_and_dom(name, fragment, script, page)[0]

    @classmethod
    def write_page(cls, mesh, *options):
        """A page of the mesh, and what the command says on standard output and error."""
        page = mesh.with_suffix(".html")
        result = subprocess.run([AXIS, mesh, *options, "--html", page], check=True, text=True,
                                capture_output=True)
        return page, result.stdout, result.stderr

    @staticmethod
    def shown(dom):
        """Number of triangles that the page says it shows, and has."""
        return tuple(int(n.replace(",", "")) for n in re.match(
            r"([\d,]+) of ([\d,]+) triangles", text_of(dom, "count")).groups())

    def assert_shown(self, angle, fragment="", script=""):
        self.assert_shows(angle, self.open("--dump-dom", fragment, script))

    def assert_shows(self, angle, dom):
        shown, all_triangles = self.shown(dom)
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
        self.assertEqual(text_of(self.default_dom, "title"), self.mesh.name)
        self.assertRegex(text_of(self.default_dom, "settings"), r"^medial axis, interior, angle .*, grid \d+ x \d+ x \d+$")
        self.assertIn("rounded", items_of(self.default_dom, "notes")[0])
        self.assertNotIn("simplified", self.default_dom.partition("</section>")[0])

    def test_all_triangles_at_first(self):
        self.assert_shows(0, self.default_dom)

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
        self.assert_shown(self.first + 39, script=script)

    def test_keys_on_a_slider_and_unknown_names_in_the_address(self):
        script = """const of = (id) => document.getElementById(id);
            let resets = 0;
            of("reset").addEventListener("click", () => ++resets);
            const press = (key, shiftKey = false) => of("angle").dispatchEvent(
              new KeyboardEvent("keydown", {key, shiftKey, bubbles: true, cancelable: true}));
            of("angle").focus();
            const before = {angle: +of("angle").value, opacity: +of("opacity").value};
            const left = press("ArrowRight");
            for (const key of ["c", "S", "r", "h"]) { press(key); }
            press("ArrowRight", true);
            of("title").textContent = JSON.stringify({before, left, resets,
              focus: document.activeElement.id, angle: +of("angle").value,
              opacity: +of("opacity").value, help: of("help").open});"""
        dom = self.open("--dump-dom", "#constructor=1&__proto__=2&angle=wide&opacity=0.6", script)
        self.assertTrue(is_hidden(dom, "failure"))
        state = json.loads(text_of(dom, "title"))
        self.assertEqual(state, {
            "before": {"angle": self.first, "opacity": 0.6}, "focus": "angle",
            "left": True,  # to the slider, which invented events do not move
            "angle": self.first + 10, "opacity": 0, "resets": 1, "help": True})
        self.assertEqual(text_of(dom, "legend-title"), "Separation angle (degrees)")

    def test_surface_can_be_switched_off(self):
        script = 'window.dispatchEvent(new KeyboardEvent("keydown", {key: "s"}));'
        translucent = self.picture("translucent", "#angle=180")[VIEW]
        self.assertGreater(grey(translucent).mean(), 0.05)
        fragment = "#angle=180&opacity=1"
        self.assertGreater(grey(self.picture("opaque", fragment)[VIEW]).mean(), 0.05)
        self.assertLess(grey(self.picture("no-surface", fragment, script)[VIEW]).mean(), 0.005)

    def test_colour_by_separation_angle(self):
        self.assertEqual(text_of(self.default_dom, "legend-title"), "Radius (world units)")
        fragment = "#colour=SeparationAngle&angle=165&opacity=0"
        picture, dom = self.picture_and_dom("separation-angle", fragment)
        self.assertEqual(items_of(dom, "legend-labels"), ["0", "50", "100", "150", "180"])
        axis = picture[VIEW][coloured(picture[VIEW])]
        self.assertGreater(len(axis), 1000)
        self.assertGreater((axis[:, 1] > axis[:, 2]).mean(), 0.95)  # the largest values are yellow

    def test_legend_begins_at_zero(self):
        labels = items_of(self.default_dom, "legend-labels")
        first, *between, last = map(float, labels)
        self.assertEqual(labels[0], "0")
        self.assertEqual(labels[-1], f"{self.max_radius:.3g}")
        self.assertGreaterEqual(len(between), 2)
        self.assertTrue((np.diff([first, *between, last]) > 0).all())
        for value in between:  # have one digit or two
            self.assertEqual(value, float(f"{value:.1e}"))

    def test_edge_of_a_plate(self):
        """Its face is yellow, but for light, from the front and edge-on."""
        mesh = self.folder / "sheet.obj"
        write_boxes(mesh, [((0, 0, 0), (1, 0.6, 0.05))])
        page, _, _ = self.write_page(mesh, "--resolution", "96", "--quiet")
        front, dom = self.picture_and_dom("sheet-front", page=page)
        self.assertFalse(is_hidden(dom, "flat"))
        key = "window.dispatchEvent(new KeyboardEvent('keydown', {key: 'e'}));"
        button = "document.getElementById('%s').click();"
        edge, back, reset = (
            self.picture(f"sheet-{name}", script=script, page=page)[VIEW] for name, script in (
                ("edge", key), ("back", button % "edge" + key), ("reset", key + button % "reset")))
        front = front[VIEW]
        for other in (back, reset):
            self.assertLess((abs(other - front).max(axis=2) > 40).mean(), 0.001)
        heights = [np.ptp(np.flatnonzero(coloured(view).any(axis=1))) for view in (front, edge)]
        self.assertGreater(heights[0], 400)
        self.assertLess(heights[1], 200)
        for view in (front, edge):
            red, green, blue = view[coloured(view)].T
            self.assertGreater(((red > 190) & (green > 170) & (blue < 90)).mean(), 0.3)
        bottom = np.flatnonzero(coloured(edge).any(axis=1))[-1]
        near_side = edge[bottom - heights[1] // 5:bottom]  # its middle is green to yellow, and lit
        self.assertGreater(near_side[..., 1].max(), 165)

    def test_key_turns_what_is_not_flat_too(self):
        self.assertTrue(is_hidden(self.default_dom, "flat"))
        key = "window.dispatchEvent(new KeyboardEvent('keydown', {key: 'e'}));"
        edge = self.picture("other-side", script=key)[VIEW]
        self.assertGreater((abs(edge - self.default_picture[VIEW]).max(axis=2) > 40).mean(), 0.02)

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
            write_boxes(mesh, scale=scale, moved=moved)
            page, _, _ = self.write_page(mesh, "--resolution", "128")
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
        self.assertRegex(text_of(page, "failure"), r"The page cannot be shown: .*It needs WebGL 2")
        self.assertFalse(is_hidden(page, "failure"))

    def test_does_not_blame_webgl_for_other_failures(self):
        broken = self.folder / "broken.html"
        broken.write_text(self.page.read_text().replace('"surface":{', '"other":{'))
        page = self.open("--dump-dom", page=broken, may_complain=True)
        self.assertRegex(text_of(page, "failure"), r"^The page cannot be shown: Cannot read .*\.$")
        self.assertNotIn("WebGL", text_of(page, "failure"))
        self.assertFalse(is_hidden(page, "failure"))

    def test_an_empty_axis_has_no_legend_and_names_are_text(self):
        mesh = self.folder / "<b>.obj"
        write_boxes(mesh, BOXES[:1])
        page, out, _ = self.write_page(mesh, "--side", "exterior", "--resolution", "16")
        self.assertIn(f"wrote     {page}: page with axis and surface", out)
        self.assertIn(r'"title":"\u003cb>.obj"', page.read_text())
        dom = self.open("--dump-dom", page=page)
        self.assertTrue(is_hidden(dom, "failure"))
        self.assertEqual(text_of(dom, "title"), "<b>.obj")
        self.assertEqual(text_of(dom, "count"), "the axis is empty")
        self.assertTrue(is_hidden(dom, "legend"))

    def test_skeleton(self):
        """The middle line of a beam, which covers less of the picture than the axis around it."""
        mesh = self.folder / "beam.obj"
        write_boxes(mesh, [((0, 0, 0), (4, 1, 1))])
        page, _, _ = self.write_page(mesh, "--resolution", "64", "--skeleton",
                                     self.folder / "beam.vtp")
        dom = self.open("--dump-dom", page=page)
        self.assertFalse(is_hidden(dom, "show"))
        counts = {choice: coloured(self.picture(f"skeleton-{choice}", f"#show={choice}", page=page)[VIEW]).sum()
                  for choice in ("skeleton", "axis", "both")}
        self.assertGreater(counts["skeleton"], 300)
        self.assertGreater(counts["axis"], 3 * counts["skeleton"])
        self.assertGreaterEqual(counts["both"], counts["axis"])
        shown = self.picture("skeleton-default", page=page)[VIEW]
        self.assertEqual(coloured(shown).sum(), counts["skeleton"])
        key = "window.dispatchEvent(new KeyboardEvent('keydown', {key: 'k'}));"
        after = self.picture("skeleton-key", script=key, page=page)[VIEW]
        self.assertEqual(coloured(after).sum(), counts["axis"])
        self.assertTrue(is_hidden(self.default_dom, "show"))

    def test_simplified_axis_of_one_radius(self):
        """The middle of a plate as fine as the grid: more than a page can have."""
        mesh = self.folder / "plate.obj"
        write_boxes(mesh, [((0, 0, 0), (1, 1, 0.01))])
        page, _, error = self.write_page(
            mesh, "--resolution", "700", "--padding", "0.002", "--angle", "170")
        self.assertLess(page.stat().st_size, LIMIT)
        picture, dom = self.picture_and_dom("plate", page=page)
        how = re.fullmatch(
            rf"medial-axis: note: {page}: to keep the page small (the medial axis was simplified "
            r"from (\d+) to (\d+) triangles: points that share a box of side [\d.]+ are one)\n", error)
        self.assertEqual(items_of(dom, "notes")[0], f"To keep this file small {how[1]}.")
        self.assertEqual(self.shown(dom), (int(how[3]), int(how[3])))
        self.assertGreater(int(how[2]), 1.5 * int(how[3]))
        self.assertRegex(dom, r'id="about"[^>]* open')
        labels = items_of(dom, "legend-labels")
        self.assertEqual((labels[0], labels[-1]), ("0", "0.01"))
        axis = picture[VIEW][coloured(picture[VIEW])]
        self.assertGreater(len(axis), 100_000)
        self.assertLess(abs(axis - (253, 231, 37)).max(axis=1).mean(), 40)  # but for light

    def test_full_disk(self):
        page = self.folder / "old.html"
        page.write_text("old")
        before = sorted(os.listdir(self.folder))
        result = subprocess.run(
            [AXIS, self.mesh, "--resolution", "16", "--html", page], capture_output=True, text=True,
            preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (4096, 4096)))
        self.assertEqual(result.returncode, NO_SPACE)
        self.assertRegex(result.stderr, rf"^medial-axis: {page}: cannot be written: [^\n]+\n$")
        self.assertEqual(page.read_text(), "old")
        self.assertEqual(sorted(os.listdir(self.folder)), before)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1] + sys.argv[4:])
