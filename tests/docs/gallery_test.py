"""The gallery has a command for each of its pictures, and scripts/make-gallery makes them.

usage: gallery_test.py SOURCES FOLDER-OF-PROGRAMS
"""

import os
import re
import shutil
import struct
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

SOURCES, PROGRAMS = Path(sys.argv[1]), Path(sys.argv[2])
SIZE = (640, 480)
LARGEST = 60000  # bytes
GALLERY = """\
![A box](images/box.png)

    medial-axis "$MEDIAL_MODELS/box.stl" --resolution 41 \\
      --image box.png

![No box](images/absent.png)

    medial-axis "$MEDIAL_MODELS/absent.off" --image absent.png
"""


def size_of(png):
    """Width and height, from the header."""
    return struct.unpack(">II", png.read_bytes()[16:24])


class Gallery(unittest.TestCase):
    def test_each_picture_has_the_command_that_makes_it(self):
        text = (SOURCES / "docs/GALLERY.md").read_text()
        pictures = re.findall(r"^!\[.*\]\((.*)\)$", text, re.MULTILINE)
        commands = re.findall(r"^!\[.*\]\(.*/(.*)\)\n\n(    .*(?:\n    .*)*)$", text, re.MULTILINE)
        self.assertGreater(len(pictures), 5)
        self.assertEqual(len(commands), len(pictures))
        for name, command in commands:
            with self.subTest(picture=name):
                self.assertRegex(command, rf"    medial-(axis|distance|proximity) .*"
                                 rf"-(image|histogram) {name}( \|\| \[ \$\? = 1 \])?$")

    def test_pictures_are_small(self):
        pictures = sorted((SOURCES / "docs/images/gallery").glob("*.png"))
        self.assertGreater(len(pictures), 5)
        for picture in pictures:
            with self.subTest(picture=picture.name):
                self.assertEqual(size_of(picture), SIZE)
                self.assertLess(picture.stat().st_size, LARGEST)


class MakeGallery(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)
        shutil.copy(SOURCES / "tests/examples/box.stl", self.folder)

    def make(self, gallery, *arguments, **environment):
        (self.folder / "GALLERY.md").write_text(gallery)
        return subprocess.run(
            [sys.executable, SOURCES / "scripts/make-gallery", "--bin", PROGRAMS, "--gallery",
             self.folder / "GALLERY.md", *arguments],
            env={**os.environ, "MEDIAL_MODELS": str(self.folder), **environment},
            capture_output=True, text=True)

    def test_makes_pictures_and_tells_which_meshes_are_missing(self):
        run = self.make(GALLERY)
        self.assertEqual(run.returncode, 0, run.stderr)
        self.assertEqual(size_of(self.folder / "images/box.png"), SIZE)
        self.assertIn("absent: left out, MEDIAL_MODELS has no absent.off", run.stdout)
        self.assertFalse((self.folder / "images/absent.png").exists())

    def test_a_command_that_fails_is_a_failure(self):
        run = self.make(GALLERY.replace("41", "1"))
        self.assertEqual(run.returncode, 1)
        self.assertIn("failed: box", run.stderr)
        self.assertFalse((self.folder / "images/box.png").exists())

    def test_unknown_pictures_are_refused(self):
        run = self.make(GALLERY, "sphere")
        self.assertEqual(run.returncode, 1)
        self.assertIn("no such picture: sphere; there are box, absent", run.stderr)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
