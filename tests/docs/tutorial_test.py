"""A tutorial does what it says: its files and commands, in their order, in a folder of their own.

Blocks in Markdown: a block of sh is run and must succeed; a block without a language after it is its output,
where ... stands for anything; blocks of other languages become the file that the text before names
last.

usage: tutorial_test.py DOCUMENT [FOLDER-OF-PROGRAMS]
"""

import os
import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

DOCUMENT, PROGRAMS = Path(sys.argv[1]), [str(Path(folder).resolve()) for folder in sys.argv[2:]]
ENVIRONMENT = {**os.environ, "PATH": ":".join([*PROGRAMS, os.environ["PATH"]])}
BLOCK = re.compile(r"^```(\w*)\n(.*?)^```$", re.MULTILINE | re.DOTALL)
FILE = re.compile(r"`([\w-]+\.\w+)`")


def blocks():
    text = DOCUMENT.read_text()
    for match in BLOCK.finditer(text):
        names = FILE.findall(text[:match.start()])
        yield match[1], match[2], names[-1] if names else None


def pattern(expected):
    """Dots on a line of their own stand for any number of lines, others for what is in the line."""
    lines = [r"(?:.*\n)*?" if line == "..." else re.escape(line).replace(r"\.\.\.", ".*") + r"\n"
             for line in expected.splitlines()]
    return "".join(lines)


class Tutorial(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def run_command(self, command):
        run = subprocess.run(["bash", "-euc", command], cwd=self.folder, env=ENVIRONMENT,
                             stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
        self.assertEqual(run.returncode, 0, f"{command}\n{run.stdout}")
        return run.stdout

    def test_files_commands_and_what_they_print(self):
        printed, compared = "", 0
        for language, text, name in blocks():
            if language == "sh":
                printed = self.run_command(text)
            elif language:
                (self.folder / name).write_text(text)
            else:
                self.assertRegex(printed, rf"\A{pattern(text)}\Z")
                compared += 1
        self.assertGreater(compared, 2)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
