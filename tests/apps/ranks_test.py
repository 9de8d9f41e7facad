"""medial-axis as several processes: fields with the bits of one process, and failures in one line.

usage: ranks_test.py MPIRUN MEDIAL-AXIS
"""

import math
import os
import re
import signal
import struct
import subprocess
import sys
import tempfile
import time
import unittest
from pathlib import Path

MPIRUN, PROGRAM = (os.path.abspath(path) for path in sys.argv[1:3])
# mpirun's own words about failures would get into the middle of the program's line.
LAUNCHER = (MPIRUN, "--quiet", "--oversubscribe")
# Both are for the tests' containers, where everything runs as root and there are few cores.
ENVIRONMENT = {**os.environ, "OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1"}
SINGLE = ("--engine", "processor", "--threads", "1")
BYTES = {"Distance": 4, "ClosestPoint": 12, "ClosestCell": 8, "ClosestFeature": 1, "ClosestSite": 4}


def torus(u=40, v=20, turned=False):
    """An OFF file of a torus, of quadrangles and triangles."""
    points, faces = [], []
    for i in range(u):
        for j in range(v):
            a, b = 2 * math.pi * i / u, 2 * math.pi * j / v
            points.append(((1 + 0.4 * math.cos(b)) * math.cos(a), (1 + 0.4 * math.cos(b)) * math.sin(a),
                           0.4 * math.sin(b)))
            p, q = i * v + j, (i + 1) % u * v + j
            r, s = (i + 1) % u * v + (j + 1) % v, i * v + (j + 1) % v
            faces += [(p, q, r, s)] if i % 3 == 0 else [(p, q, r), (p, r, s)]
    lines = ["OFF", f"{len(points)} {len(faces)} 0"]
    lines += [" ".join(repr(x) for x in point) for point in points]
    lines += [" ".join(map(str, (len(face), *(reversed(face) if turned else face)))) for face in faces]
    return "\n".join(lines) + "\n"


def children_of(parent):
    """The numbers of processes that another one has started."""
    children = []
    for path in Path("/proc").glob("[0-9]*/stat"):
        try:
            stat = path.read_text()
        except OSError:  # it has ended meanwhile
            continue
        if int(stat.rpartition(")")[2].split()[1]) == parent:
            children.append(int(path.parent.name))
    return sorted(children)


class Image:
    """A .vti file of a field."""

    def __init__(self, path):
        data = path.read_bytes()
        start = data.index(b'encoding="raw">\n   _') + len(b'encoding="raw">\n   _')
        header = data[:start].decode()
        self.extent = [int(x) for x in re.search(r'<Piece Extent="([^"]*)"', header).group(1).split()]
        self.arrays = {}
        for name, offset in re.findall(r'Name="(\w+)"[^>]*offset="(\d+)"', header):
            first = start + int(offset)
            size = struct.unpack_from("<Q", data, first)[0]
            self.arrays[name] = data[first + 8:first + 8 + size]

    def rows(self):
        """Points of rows along x, by where they begin, and their values of all arrays."""
        x0, x1, y0, y1, z0, z1 = self.extent
        count, at = x1 - x0 + 1, 0
        for z in range(z0, z1 + 1):
            for y in range(y0, y1 + 1):
                yield (x0, y, z), count, {name: values[at * BYTES[name]:(at + count) * BYTES[name]]
                                          for name, values in self.arrays.items()}
                at += count


class Ranks(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)
        (self.folder / "torus.off").write_text(torus())

    def run_ranks(self, count, *arguments):
        return self.run_command(*LAUNCHER, "-np", str(count), PROGRAM, *arguments)

    def run_command(self, *command):
        return subprocess.run(command, cwd=self.folder, env=ENVIRONMENT, text=True, capture_output=True,
                              timeout=300, check=False)

    def files(self):
        return sorted(path.name for path in self.folder.iterdir())

    def expect_same_bits(self, ranks, *options):
        one = self.run_command(PROGRAM, "torus.off", "--field", "one.vti", "-q", *SINGLE, *options)
        self.assertEqual((one.returncode, one.stderr), (0, ""))
        whole = {begin: values for begin, _, values in Image(self.folder / "one.vti").rows()}
        several = self.run_ranks(ranks, "torus.off", "--field", "many.pvti", *SINGLE, *options)
        self.assertEqual((several.returncode, several.stderr), (0, ""))
        self.assertIn(f"on {ranks} processes", several.stdout)
        index = (self.folder / "many.pvti").read_text()
        pieces = re.findall(r'<Piece Extent="([^"]*)" Source="([^"]*)"', index)
        seen = set()
        for extent, source in pieces:
            image = Image(self.folder / source)
            self.assertEqual(" ".join(map(str, image.extent)), extent)
            for (x, y, z), count, values in image.rows():
                for name, part in values.items():
                    size = BYTES[name]
                    self.assertEqual(part, whole[0, y, z][name][x * size:(x + count) * size], (source, name))
                seen.update((i, y, z) for i in range(x, x + count))
        self.assertEqual(len(seen), sum(len(values["ClosestFeature"]) for values in whole.values()))
        return len(pieces)

    def expect_failure(self, run, code, text):
        """One line, and no file but the mesh."""
        self.assertEqual(run.returncode, code, run.stderr)
        lines = [line for line in run.stderr.splitlines() if line.startswith("medial-axis")]
        self.assertEqual(len(lines), 1, run.stderr)
        self.assertRegex(lines[0], text)
        self.assertEqual(self.files(), ["torus.off"])

    def test_two_ranks_write_the_field_of_one(self):
        self.assertEqual(self.expect_same_bits(2, "--resolution", "45", "--sign", "pseudonormal"), 2)

    def test_seven_ranks_write_the_field_of_one(self):
        self.assertEqual(self.expect_same_bits(7, "--resolution", "60", "--sign", "none"), 7)

    def test_more_ranks_than_parts_of_the_grid(self):
        self.assertLess(self.expect_same_bits(7, "--resolution", "20", "--sign", "pseudonormal"), 7)

    def test_a_surface_inside_out(self):
        (self.folder / "torus.off").write_text(torus(turned=True))
        self.expect_same_bits(3, "--resolution", "33", "--sign", "pseudonormal")

    def test_a_missing_mesh(self):
        self.expect_failure(self.run_ranks(2, "absent.off", "--field", "a.pvti", "--sign", "none"), 3,
                            "^medial-axis: rank 0: absent.off: no such file$")

    def test_a_mesh_that_is_open(self):
        text = (self.folder / "torus.off").read_text().splitlines()
        text[1] = text[1].replace(text[1].split()[1], str(int(text[1].split()[1]) - 1))
        (self.folder / "torus.off").write_text("\n".join(text[:-1]) + "\n")
        run = self.run_ranks(2, "torus.off", "--field", "a.pvti", "--sign", "pseudonormal")
        self.expect_failure(run, 3, "^medial-axis: torus.off: sign method pseudonormal needs a closed")

    def test_a_folder_that_does_not_exist(self):
        run = self.run_ranks(2, "torus.off", "--field", "absent/a.pvti", "--sign", "none")
        self.expect_failure(run, 5, "^medial-axis: rank 0: absent/a.pvti")

    def test_what_several_processes_do_not_compute(self):
        for options, text in (((), "--field FILE.pvti"),
                              (("--field", "a.vti"), "--field FILE.pvti"),
                              (("--field", "a.pvti", "-o", "a.vtp"), "a medial axis needs a single one"),
                              (("--field", "a.pvti", "--sign", "winding"), "--sign pseudonormal"),
                              (("--field", "a.pvti", "--sign", "none", "--engine", "rasteriser"), "--engine processor"),
                              (("--field", "a.pvti", "--resolution", "1"), "--resolution")):
            self.expect_failure(self.run_ranks(2, "torus.off", *options), 2, text)

    def test_ranks_with_different_options(self):
        options = ("torus.off", "--field", "a.pvti", "--sign", "none", "--resolution")
        run = self.run_command(*LAUNCHER, "-np", "1", PROGRAM, *options, "20", ":",
                               "-np", "1", PROGRAM, *options, "21")
        self.expect_failure(run, 2, "^medial-axis: rank 1 has other options than rank 0$")

    def test_a_rank_that_is_killed(self):
        command = [*LAUNCHER, "-np", "3", PROGRAM, "torus.off", "--field", "a.pvti", "--sign",
                   "none", "--resolution", "500", "--threads", "1", "-q"]
        with subprocess.Popen(command, cwd=self.folder, env=ENVIRONMENT, stderr=subprocess.PIPE) as run:
            while len(list(self.folder.glob(".a*"))) < 4:  # the pieces and the index
                self.assertIsNone(run.poll())
                time.sleep(0.01)
            os.kill(children_of(run.pid)[1], signal.SIGKILL)
            run.communicate(timeout=60)
        self.assertNotEqual(run.returncode, 0)
        # Of the one that was killed a file without its name may stay; the others leave nothing.
        left = [name for name in self.files() if name != "torus.off"]
        self.assertLessEqual(len(left), 1, left)
        self.assertTrue(all(name.startswith(".") for name in left), left)

    def test_the_version_is_printed_once(self):
        run = self.run_ranks(3, "--version")
        self.assertEqual((run.returncode, len(run.stdout.splitlines())), (0, 1))


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
