"""Files that the documents name exist, tutorials agree with the programs' --help, README is short.

usage: documents_test.py SOURCES MEDIAL-AXIS MEDIAL-MEASURE MEDIAL-PROXIMITY MEDIAL-VIEWER
    MEDIAL-DISTANCE
"""

import json
import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

SOURCES = Path(sys.argv[1])
# The tutorials with tables of options, by the programs that have them.
TUTORIALS = dict(zip(sys.argv[2:7], ("COMMAND-LINE.md", "MEASURING.md", "PROXIMITY.md", "VIEWER.md",
                                   "DISTANCES.md")))
README_WORDS = 900
DOCUMENTS = [SOURCES / "README.md", SOURCES / "CONTRIBUTING.md", SOURCES / "examples/README.md",
             *sorted((SOURCES / "docs").glob("**/*.md"))]
TOP = {path.name for path in SOURCES.iterdir() if not path.name.startswith("build")}


def code_words(text):
    """Words in backticks and in indented or fenced code."""
    blocks = re.findall(r"^(?: {4}.*|```[\s\S]*?^```)$", text, re.MULTILINE)
    return " ".join(re.findall(r"`([^`\n]+)`", text) + blocks).split()


def named_files(text):
    """Paths from the project's root, without patterns and build folders."""
    for word in code_words(text):
        path = re.sub(r"^\./|[,;:.)]+$", "", word)
        if re.fullmatch(r"[\w./-]+", path) and path.split("/")[0] in TOP - {"out"}:
            yield path
    yield from (path for path, _ in links(text) if path)


def links(text):
    """Pairs of a file, empty for the same one, and a heading, empty for the whole file."""
    # Lambdas of C++ look like links.
    prose = re.sub(r"^```[\s\S]*?^```$", "", text, flags=re.MULTILINE)
    return re.findall(r"\]\((?!https?:)([^)#\s]*)#?([^)\s]*)\)", prose)


def headings(text):
    """Headings, as links name them."""
    return {re.sub(r"[^\w -]", "", heading.lower()).replace(" ", "-")
            for heading in re.findall(r"^#+ (.*)$", text, re.MULTILINE)}


def exists(path):
    """A file, a folder, or the stem of files."""
    return path.exists() or any(path.parent.glob(path.name + ".*"))


def section_of(tutorial, heading):
    """From the heading to the next."""
    text = (SOURCES / "docs" / tutorial).read_text()
    start = text.index(f"## {heading}\n")
    end = text.find("\n## ", start)
    return text[start:end if end >= 0 else len(text)]


def table_of_options(tutorial):
    """Other sections name options of other programs."""
    return section_of(tutorial, "All options")


def keys_within(value):
    """All keys of objects in a JSON value."""
    if isinstance(value, dict):
        for key, nested in value.items():
            yield key
            yield from keys_within(nested)


def rows_of_options(tutorial):
    """Pairs of a long option and what the table says about it."""
    return re.findall(r"^\| `(?:-\w, )?(--[a-z-]+)[^`|]*` \| (.*) \|$", table_of_options(tutorial),
                      re.MULTILINE)


def help_of(program):
    return subprocess.run([program, "--help"], capture_output=True, text=True, check=True).stdout


class Documents(unittest.TestCase):
    def test_named_files_exist(self):
        for document in DOCUMENTS:
            for path in named_files(document.read_text()):
                with self.subTest(document=document.name, path=path):
                    self.assertTrue(exists(SOURCES / path) or exists(document.parent / path))

    def test_linked_headings_exist(self):
        followed = 0
        for document in DOCUMENTS:
            for path, heading in links(document.read_text()):
                if heading:
                    target = document.parent / path if path else document
                    with self.subTest(document=document.name, heading=heading):
                        self.assertIn(heading, headings(target.read_text()))
                        followed += 1
        self.assertGreater(followed, 3)

    def test_some_files_are_named(self):
        names = set(named_files((SOURCES / "README.md").read_text()))
        self.assertLessEqual({"demo", "check", "docs/ARCHITECTURE.md"}, names)

    def test_readme_is_short(self):
        self.assertLessEqual(len((SOURCES / "README.md").read_text().split()), README_WORDS)

    def test_readme_leads_to_the_tutorials(self):
        names = set(named_files((SOURCES / "README.md").read_text()))
        self.assertLessEqual({f"docs/{tutorial}" for tutorial in TUTORIALS.values()}, names)

    def test_tutorials_have_the_options_of_the_programs(self):
        options = re.compile(r"(?<![\w-])--[a-z][a-z-]+")
        for program, tutorial in TUTORIALS.items():
            stated = set(options.findall(help_of(program)))
            with self.subTest(program=program):
                self.assertGreater(len(stated), 4)
                self.assertEqual({option for option, _ in rows_of_options(tutorial)}, stated)
                self.assertEqual(set(options.findall(table_of_options(tutorial))), stated)

    def test_tutorials_word_the_options_as_the_programs_do(self):
        for program, tutorial in TUTORIALS.items():
            help_text = " ".join(help_of(program).split())
            for option, meaning in rows_of_options(tutorial):
                with self.subTest(program=program, option=option):
                    self.assertIn(meaning.replace("`", ""), help_text)

    def test_every_key_of_a_report_is_documented(self):
        rows = dict(re.findall(r"^\| ((?:`\w+`(?:, )?)+) \| (.*) \|$",
                               section_of("COMMAND-LINE.md", "The report"), re.MULTILINE))
        documented = {key: meaning for keys, meaning in rows.items()
                      for key in re.findall(r"`(\w+)`", keys)}
        with tempfile.TemporaryDirectory() as folder:
            report = json.loads(subprocess.run(
                [sys.argv[2], SOURCES / "tests/examples/box.stl", "--resolution", "24", "--topology",
                 "preserve", "--thickness", f"{folder}/thickness.vtp", "--local-thickness",
                 f"{folder}/local.vti", "--skeleton-table", f"{folder}/skeleton.csv", "-o", f"{folder}/axis.vtp",
                 "--report", "-"], capture_output=True, text=True, check=True).stdout)
        self.assertEqual(set(report), set(documented))
        for key, value in report.items():
            for nested in keys_within(value):
                with self.subTest(key=key, nested=nested):
                    self.assertIn(f"`{nested}`", documented[key])

    def test_every_design_page_is_linked_from_the_architecture(self):
        linked = set(named_files((SOURCES / "docs/ARCHITECTURE.md").read_text()))
        pages = sorted((SOURCES / "docs/design").glob("*.md"))
        self.assertGreater(len(pages), 10)
        for page in pages:
            with self.subTest(page=page.name):
                self.assertIn(f"design/{page.name}", linked)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
