"""Files that the documents name exist, and README states what the program states.

usage: documents_test.py SOURCES MEDIAL-AXIS MEDIAL-MEASURE MEDIAL-VIEWER
"""

import re
import subprocess
import sys
import unittest
from pathlib import Path

SOURCES = Path(sys.argv[1])
AXIS, MEASURE, VIEWER = sys.argv[2:5]
DOCUMENTS = [SOURCES / "README.md", SOURCES / "CONTRIBUTING.md", SOURCES / "examples/README.md",
             *sorted((SOURCES / "docs").glob("**/*.md"))]
TOP = {path.name for path in SOURCES.iterdir() if not path.name.startswith("build")}


def code_words(text):
    """Words in backticks and in indented or fenced code."""
    blocks = re.findall(r"^(?: {4}.*|```[\s\S]*?^```)$", text, re.MULTILINE)
    return " ".join(re.findall(r"`([^`\n]+)`", text) + blocks).split()


def named_files(text):
    """Paths from the project's root; patterns and build folders are none."""
    for word in code_words(text):
        path = re.sub(r"^\./|[,;:.)]+$", "", word)
        if re.fullmatch(r"[\w./-]+", path) and path.split("/")[0] in TOP - {"out"}:
            yield path
    # Lambdas of C++ look like links.
    prose = re.sub(r"^```[\s\S]*?^```$", "", text, flags=re.MULTILINE)
    yield from re.findall(r"\]\((?!https?:)([^)#]+)\)", prose)


def exists(path):
    """A file, a folder, or the stem of files."""
    return path.exists() or any(path.parent.glob(path.name + ".*"))


def readme_section(heading):
    """From a heading of README to the next; other sections name options of CMake."""
    text = (SOURCES / "README.md").read_text()
    start = text.index(f"## {heading}\n")
    return text[start:text.index("\n## ", start)]


def help_of(program):
    return subprocess.run([program, "--help"], capture_output=True, text=True, check=True).stdout


class Documents(unittest.TestCase):
    def test_named_files_exist(self):
        for document in DOCUMENTS:
            for path in named_files(document.read_text()):
                with self.subTest(document=document.name, path=path):
                    self.assertTrue(exists(SOURCES / path) or exists(document.parent / path))

    def test_some_files_are_named(self):
        names = set(named_files((SOURCES / "README.md").read_text()))
        self.assertLessEqual({"demo", "check", "docs/ARCHITECTURE.md"}, names)

    def test_readme_has_the_options_of_the_programs(self):
        options = re.compile(r"(?<![\w-])--[a-z][a-z-]+")
        for heading, program in (("Command line", AXIS), ("Viewer", VIEWER),
                                 ("Measuring an axis", MEASURE)):
            with self.subTest(program=program):
                stated = set(options.findall(readme_section(heading)))
                self.assertEqual(stated, set(options.findall(help_of(program))))

    def test_readme_words_the_options_as_the_programs_do(self):
        for heading, program, names in (
                ("Command line", AXIS,
                 ("resolution", "spacing", "padding", "angle", "threads", "memory")),
                ("Viewer", VIEWER,
                 ("resolution", "max-resolution", "angle", "side", "colour", "screenshot", "engine",
                  "threads")),
                ("Measuring an axis", MEASURE, ("json", "samples", "threads"))):
            help_text = " ".join(help_of(program).split())
            for name in names:
                row = re.search(rf"^\| `--{name} [\w.]+` \| (.*) \|$", readme_section(heading),
                                re.MULTILINE)
                with self.subTest(program=program, option=name):
                    self.assertIn(row[1].replace("`", ""), help_text)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
