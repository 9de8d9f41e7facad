"""What bash offers to complete command lines of the programs.

usage: completion_test.py COMPLETION FOLDER-OF-PROGRAMS
"""

import os
import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

COMPLETION, PROGRAMS = (str(Path(path).resolve()) for path in sys.argv[1:3])
ENVIRONMENT = {**os.environ, "PATH": f"{PROGRAMS}:{os.environ['PATH']}"}
# As bash does for "PROGRAM WORD...": the words of the line, and the number of the last one.
COMPLETE = """\
source "$1"
shift
COMP_WORDS=("$@")
COMP_CWORD=$(($# - 1))
function=$(complete -p "$1" | sed -E 's/.* -F (\\S+) .*/\\1/')
$function "$1" "${COMP_WORDS[COMP_CWORD]}" "${COMP_WORDS[COMP_CWORD - 1]}"
printf '%s\\n' "${COMPREPLY[@]}"
"""
CHOICES = {"medial-axis": ("--side", "--representation", "--topology", "--sign", "--engine"),
           "medial-viewer": ("--side", "--colour", "--engine")}


def help_of(program):
    return subprocess.run([program, "--help"], capture_output=True, text=True, env=ENVIRONMENT,
                          check=True).stdout


class Completion(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)
        for name in ("part.stl", "part.STL", "my part.obj", "axis.vtp", "axis.ma", "notes.txt",
                     "picture.png"):
            (self.folder / name).touch()
        (self.folder / "parts").mkdir()

    def offers(self, *words):
        run = subprocess.run(["bash", "-c", COMPLETE, "bash", COMPLETION, *words], text=True,
                             cwd=self.folder, env=ENVIRONMENT, capture_output=True)
        self.assertEqual(run.stderr, "")
        return sorted(line for line in run.stdout.splitlines() if line)

    def test_options_are_those_of_help(self):
        for program in ("medial-axis", "medial-distance", "medial-measure", "medial-proximity",
                        "medial-viewer"):
            with self.subTest(program=program):
                stated = re.findall(r"^  (?:(-\w),)?(--[a-z-]+)", help_of(program), re.MULTILINE)
                self.assertEqual(self.offers(program, "-"),
                                 sorted(word for pair in stated for word in pair if word))

    def test_options_that_begin_so(self):
        self.assertEqual(self.offers("medial-axis", "part.stl", "--re"),
                         ["--report", "--representation", "--require-gpu", "--resolution"])

    def test_choices_are_those_that_the_program_allows(self):
        for program, option in ((name, option) for name in CHOICES for option in CHOICES[name]):
            run = subprocess.run([program, "part.stl", option, "none of them"], text=True,
                                 env=ENVIRONMENT, capture_output=True)
            allowed = re.search(r"is not one of ([\w, ]+) \(", run.stderr)[1].split(", ")
            with self.subTest(program=program, option=option):
                self.assertEqual(self.offers(program, "part.stl", option, ""),
                                 allowed)

    def test_choices_that_begin_so(self):
        self.assertEqual(self.offers("medial-axis", "--side", "in"), ["interior"])
        self.assertEqual(self.offers("medial-axis", "--side", "=", "b"), ["both"])
        self.assertEqual(self.offers("medial-axis", "--topology", "="), ["preserve", "selected"])

    def test_files_have_the_extensions_that_are_taken(self):
        self.assertEqual(self.offers("medial-axis", ""),
                         ["axis.vtp", "my part.obj", "part.STL", "part.stl", "parts"])
        self.assertEqual(self.offers("medial-axis", "part.stl", "-o", "axis"),
                         ["axis.ma", "axis.vtp"])
        self.assertEqual(self.offers("medial-axis", "part.stl", "--image", "pi"), ["picture.png"])
        self.assertEqual(self.offers("medial-measure", "axis.m"), ["axis.ma"])
        self.assertEqual(self.offers("medial-viewer", "part.stl", "--screenshot", "pi"),
                         ["picture.png"])
        self.assertEqual(self.offers("medial-proximity", "part.stl", ""),
                         ["axis.vtp", "my part.obj", "part.STL", "part.stl", "parts"])
        self.assertEqual(self.offers("medial-proximity", "--contacts", "axis"), ["axis.vtp"])
        self.assertEqual(self.offers("medial-proximity", "--animation", "pa"), ["parts"])

    def test_scans_are_offered_where_they_are_taken(self):
        for name in ("head.nrrd", "head.nii.gz", "head.txt.gz"):
            (self.folder / name).touch()
        for program in ("medial-axis", "medial-distance", "medial-viewer"):
            with self.subTest(program=program):
                self.assertEqual(self.offers(program, "he"), ["head.nii.gz", "head.nrrd"])
        self.assertEqual(self.offers("medial-proximity", "he"), [])

    def test_numbers_are_not_guessed(self):
        self.assertEqual(self.offers("medial-axis", "part.stl", "--angle", ""), [])
        self.assertEqual(self.offers("medial-axis", "part.stl", "--lambda", ""), [])

    def test_a_mesh_may_follow_a_flag(self):
        self.assertEqual(self.offers("medial-axis", "-q", "part.s"), ["part.stl"])


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
