"""Files that the documents name exist, and README states what the program states.

usage: documents_test.py SOURCES PROGRAM
"""

import re
import subprocess
import sys
import unittest
from pathlib import Path

SOURCES, PROGRAM = Path(sys.argv[1]), sys.argv[2]
DOCUMENTS = [SOURCES / "README.md", SOURCES / "CONTRIBUTING.md", SOURCES / "examples/README.md",
             *sorted((SOURCES / "docs").glob("**/*.md"))]
TOP = {path.name for path in SOURCES.iterdir()}


def code_words(text):
    """Words in backticks and in indented or fenced code."""
    blocks = re.findall(r"^(?: {4}.*|```[\s\S]*?^```)$", text, re.MULTILINE)
    return " ".join(re.findall(r"`([^`\n]+)`", text) + blocks).split()


def named_files(text):
    """Paths from the project's root; patterns and build folders are none."""
    for word in code_words(text):
        path = re.sub(r"^\./|[,;:.)]+$", "", word)
        if re.fullmatch(r"[\w./-]+", path) and path.split("/")[0] in TOP - {"build", "out"}:
            yield path
    yield from re.findall(r"\]\((?!https?:)([^)#]+)\)", text)


def exists(path):
    """A file, a folder, or the stem of files."""
    return path.exists() or any(path.parent.glob(path.name + ".*"))


class Documents(unittest.TestCase):
    def test_named_files_exist(self):
        for document in DOCUMENTS:
            for path in named_files(document.read_text()):
                with self.subTest(document=document.name, path=path):
                    self.assertTrue(exists(SOURCES / path) or exists(document.parent / path))

    def test_some_files_are_named(self):
        names = set(named_files((SOURCES / "README.md").read_text()))
        self.assertLessEqual({"demo", "check", "docs/ARCHITECTURE.md"}, names)

    def test_readme_has_the_options_of_the_program(self):
        options = re.compile(r"(?<![\w-])--[a-z][a-z-]+")
        # The section on the command line; elsewhere README names options of CMake.
        text = (SOURCES / "README.md").read_text()
        section = text[text.index("## Command line"):text.index("## C++")]
        stated = set(options.findall(section))
        help_text = subprocess.run([PROGRAM, "--help"], capture_output=True, text=True, check=True)
        self.assertEqual(stated, set(options.findall(help_text.stdout)))

    def test_readme_words_the_options_as_the_program_does(self):
        help_text = " ".join(subprocess.run(
            [PROGRAM, "--help"], capture_output=True, text=True, check=True).stdout.split())
        readme = (SOURCES / "README.md").read_text()
        for option in ("resolution", "spacing", "padding", "angle", "threads", "memory"):
            row = re.search(rf"^\| `--{option} \w+` \| (.*) \|$", readme, re.MULTILINE)
            with self.subTest(option=option):
                self.assertIn(row[1].replace("`", ""), help_text)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
