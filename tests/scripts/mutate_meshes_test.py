"""Runs scripts/mutate-meshes on made-up programs, each with one fault.

usage: mutate_meshes_test.py SCRIPT
"""

import importlib.machinery
import importlib.util
import os
import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

SCRIPT = sys.argv[1]
sys.path.insert(0, str(Path(SCRIPT).parent))

from comparison.meshes import made_up_shapes  # noqa: E402
from mutation.shapes import Shape  # noqa: E402
from mutation.winding import oriented_surface, winding_number  # noqa: E402

# Refuses every mesh, as medial-axis does.
PROGRAM = """#!{python} -IS
import os, signal, struct, sys
mesh, outputs = sys.argv[1], {{name: sys.argv[sys.argv.index(name) + 1] for name in ("-o", "--field", "--report")}}
{fault}
print("program: " + mesh + ": refused", file=sys.stderr)
sys.exit(3)
"""
FIELD = """
open(outputs["-o"], "w").close()
with open(outputs["--field"], "wb") as field, open(outputs["--report"], "w") as report:
    report.write('{{"sign_method": "winding"}}')
    field.write(b'<ImageData WholeExtent="0 1 0 1 0 1" Origin="1e6 0 0" Spacing="1 1 1"><AppendedData>_' +
                struct.pack("<Q8f", 32, *(8 * [{distance}])))
sys.exit(0)
"""


class MutateMeshes(unittest.TestCase):
    def run_on(self, fault, count=12):
        with tempfile.TemporaryDirectory() as folder:
            program = Path(folder) / "program"
            program.write_text(PROGRAM.format(python=sys.executable, fault=fault))
            program.chmod(0o755)
            done = subprocess.run([SCRIPT, "--count", str(count), "--program", program, "--keep", folder + "/kept"],
                                  capture_output=True, text=True, check=False,
                                  env={**os.environ, "MEDIAL_MODELS": folder})
            kept = len(list((Path(folder) / "kept").glob("*")))
        self.assertEqual(done.returncode, 1 if kept else 0, done.stdout + done.stderr)
        return done.stdout, kept

    def test_a_program_that_refuses_all_is_right(self):
        text, kept = self.run_on("")
        self.assertEqual(kept, 0)
        self.assertIn("12 damaged meshes, 0 real ones to choose from: exit codes 12 with 3;", text)

    def test_faults_are_named_and_their_files_kept(self):
        for fault, words in (("os.kill(os.getpid(), signal.SIGSEGV)", "exit code -11"),
                             ("sys.exit(1)", "exit code 1"),
                             ("open(outputs['-o'] + '.part', 'w')", "the files ['axis.vtp.part']"),
                             ("sys.exit(3)", "no single line"),
                             ("bytearray(2200 << 20)", "GB of memory"),
                             (FIELD.format(distance=1.0), "voxels off")):
            with self.subTest(fault=fault):
                text, kept = self.run_on(fault, 12 if "voxels" in words else 1)
                self.assertGreater(kept, 0)
                self.assertIn(words, text)

    def test_the_same_seed_gives_the_same_files(self):
        fault = "import hashlib; print(hashlib.md5(open(mesh, 'rb').read()).hexdigest()); sys.exit(9)"
        texts = [re.findall(r"^  [0-9a-f]{32}$", self.run_on(fault, 6)[0], re.MULTILINE) for _ in range(2)]
        self.assertEqual(len(texts[0]), 6)
        self.assertEqual(texts[0], texts[1])


def box(*changes):
    """A box whose triangles are changed."""
    points, triangles = made_up_shapes()["box"]
    cells = [list(triangle) for triangle in triangles]
    for change in changes:
        change(cells)
    return Shape([tuple(point) for point in points], cells)


MIDDLE = [sum(point[axis] for point in box().points) / len(box().points) for axis in range(3)]


def turn_all(cells):
    for cell in cells:
        cell.reverse()


class Signs(unittest.TestCase):
    def test_surfaces_face_outwards_whatever_was_done_to_them(self):
        far = [1000.0, 2000.0, 3000.0]
        for change in (lambda cells: None, turn_all, lambda cells: cells[3].reverse(),
                       lambda cells: cells.append(cells[5][::-1]), lambda cells: cells.insert(0, cells.pop())):
            surface = oriented_surface(box(change), 1.0)
            self.assertAlmostEqual(winding_number(surface, MIDDLE, 1.0), 1.0)
            self.assertAlmostEqual(winding_number(surface, far, 1.0), 0.0)

    def test_what_could_face_both_ways_is_not_compared(self):
        for change in (lambda cells: cells.append([0]), lambda cells: cells.append([0, 0, 1]),
                       lambda cells: (turn_all(cells), cells.pop())):
            self.assertIsNone(oriented_surface(box(change), 1.0))

    def test_a_wrong_sign_is_found(self):
        loader = importlib.machinery.SourceFileLoader("mutate_meshes", SCRIPT)
        module = importlib.util.module_from_spec(importlib.util.spec_from_loader("mutate_meshes", loader))
        loader.exec_module(module)
        surface = oriented_surface(box(), 1.0)
        field = type("Field", (), {"spacing": [1.0] * 3})()
        for distance, wrong in ((-0.5, False), (0.5, True), (0.0, False)):
            field.samples = lambda case, distance=distance: [([0, 0, 0], MIDDLE, distance)]
            self.assertEqual(module.wrong_sign(None, field, surface) is not None, wrong)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
