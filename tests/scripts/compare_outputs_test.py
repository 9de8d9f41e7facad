"""Compares made-up builds: scripts in place of the programs, which differ in one thing.

usage: compare_outputs_test.py SCRIPT
"""

import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

SCRIPT = sys.argv[1]
MESH = "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"

# Counts its runs in a file beside it.
PROGRAM = """#!{python} -IS
import sys, time
if "--help" in sys.argv:
    print("options: --{engine}")
    sys.exit()
with open(__file__ + ".runs", "a") as runs:
    runs.write(".")
for option, file in zip(sys.argv, sys.argv[1:]):
    if option in ("--engine", "--evaluator") and option != "--{engine}":
        sys.exit(2)
    if option in ("--report", "--json"):
        with open(file, "w") as report:
            report.write('{{"{engine}": "any", "seconds": {{"all": %r}}, "points": {points}, '
                         '"grid": {{"spacing": [0.5]}}}}' % time.time())
    elif option in ("-o", "--curves") and file not in {left_out}:
        with open(file, "w") as output:
            output.write("{text}")
sys.exit({code})
"""


class CompareOutputs(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)
        self.mesh = self.folder / "one.off"
        self.mesh.write_text(MESH)
        self.old = self.build("old", engine="evaluator", measure="medial-evaluate")

    def build(self, name, engine="engine", measure="medial-measure", text="axis", points=7,
              left_out=(), code=0):
        programs = self.folder / name
        programs.mkdir()
        for program in ("medial-axis", measure):
            file = programs / program
            file.write_text(PROGRAM.format(python=sys.executable, engine=engine, text=text,
                                           points=points, left_out=left_out, code=code))
            file.chmod(0o755)
        return programs

    def compare(self, new, *options):
        return subprocess.run(
            [SCRIPT, "--programs", self.old, new, "--meshes", self.mesh, "--sets", "threads", "balls",
             *options], capture_output=True, text=True, check=False)

    def assert_differ(self, done, count, line):
        self.assertEqual(done.returncode, 1, done.stdout + done.stderr)
        self.assertIn(line, done.stdout)
        self.assertRegex(done.stdout, rf"10 outputs of 6 runs compared, {count} differ\n$")

    def test_renamed_words_and_times_are_no_difference(self):
        done = self.compare(self.build("new"))
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        self.assertRegex(done.stdout, r"10 outputs of 6 runs compared, 0 differ\n$")

    def test_first_byte_that_differs_is_told(self):
        done = self.compare(self.build("new", text="axes"))
        self.assert_differ(done, 6, "one.off threads axis.ply: byte 2 of 4 and 4")

    def test_other_values_of_reports_are_told(self):
        done = self.compare(self.build("new", points=8))
        self.assert_differ(done, 4, 'one.off threads report.json: - "points": "7" + "points": "8"')

    def test_missing_output_is_told(self):
        done = self.compare(self.build("new", left_out=("curves.vtp",)))
        self.assert_differ(done, 1, "one.off threads curves.vtp: only the old build writes it")

    def test_other_exit_codes_are_told(self):
        done = self.compare(self.build("new", code=3))
        self.assert_differ(done, 6, "one.off balls: exit code 0 and 3: medial-measure")

    def test_old_build_runs_once_with_a_cache(self):
        new = self.build("new")
        for runs in (1, 2):
            self.assertEqual(self.compare(new, "--cache", self.folder / "cache").returncode, 0)
            self.assertEqual(len((self.old / "medial-axis.runs").read_text()), 5)
            self.assertEqual(len((new / "medial-axis.runs").read_text()), 5 * runs)

    def test_outputs_that_differ_are_kept(self):
        self.compare(self.build("new", text="axes"), "--keep", self.folder / "kept")
        kept = self.folder / "kept/one.off/threads"
        self.assertEqual((kept / "old/files/axis.ply").read_text(), "axis")
        self.assertEqual((kept / "new/files/axis.ply").read_text(), "axes")

    def test_no_outputs_are_no_proof(self):
        self.old = self.build("silent")
        for program in (self.old / "medial-axis", self.old / "medial-measure"):
            program.write_text(f"#!{sys.executable} -IS\nprint('--engine')\n")
        done = self.compare(self.old)
        self.assertEqual(done.returncode, 1, done.stdout + done.stderr)
        self.assertIn("0 outputs of 6 runs compared, 0 differ", done.stdout)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
