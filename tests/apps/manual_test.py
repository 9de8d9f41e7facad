"""Manual pages are well-formed and have every option of --help.

usage: manual_test.py MANDOC FOLDER-OF-PAGES PROGRAM...
"""

import re
import subprocess
import sys
import unittest
from pathlib import Path

MANDOC, PAGES, PROGRAMS = sys.argv[1], Path(sys.argv[2]), [Path(path) for path in sys.argv[3:]]
OPTION = re.compile(r"(?<![\w-])--?[a-z][a-z-]*")


def page(program):
    return PAGES / f"{program.name}.1"


def text(program):
    """The text as people read it, without a terminal's overstrikes and hyphens at line ends."""
    shown = subprocess.run([MANDOC, "-T", "utf8", "-O", "width=1000", page(program)], text=True,
                           capture_output=True, check=True).stdout
    return re.sub(r".\x08", "", shown)


def help_of(program):
    return subprocess.run([program, "--help"], capture_output=True, text=True, check=True).stdout


class Manual(unittest.TestCase):
    def test_pages_are_well_formed(self):
        for program in PROGRAMS:
            with self.subTest(program=program.name):
                found = subprocess.run([MANDOC, "-T", "lint", "-W", "warning", page(program)],
                                       capture_output=True, text=True).stdout.splitlines()
                # help2man gives months.
                self.assertEqual([line for line in found if "cannot parse date" not in line], [])

    def test_each_option_has_an_entry(self):
        for program in PROGRAMS:
            # The text of a short entry follows on the same line.
            entries = re.findall(r"^ {7}(?:-\w,)?(--[a-z-]+)(?: |$)", text(program), re.MULTILINE)
            with self.subTest(program=program.name):
                stated = re.findall(r"^  (?:-\w,)?(--[a-z-]+)", help_of(program), re.MULTILINE)
                self.assertGreater(len(stated), 4)
                self.assertEqual(sorted(entries), sorted(stated))

    def test_says_what_help_says(self):
        for program in PROGRAMS:
            words = " ".join(text(program).split()).lower()
            for line in help_of(program).splitlines():
                with self.subTest(program=program.name, line=line):
                    # Entries and their texts are on lines of their own in the page.
                    for part in re.split(r" {2,}", line.strip()):
                        said = part.removeprefix("Usage: ").removesuffix(":").lower()
                        self.assertIn(said, words)

    def test_examples_use_options_that_there_are(self):
        for program in PROGRAMS:
            examples = text(program).split("EXAMPLES")[1].split("SEE ALSO")[0]
            with self.subTest(program=program.name):
                self.assertIn(f"{program.name} ", examples)
                self.assertLessEqual(set(OPTION.findall(examples)),
                                     set(OPTION.findall(help_of(program))))


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
