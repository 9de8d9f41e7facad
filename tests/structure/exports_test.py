"""libmedial exports what public headers mark with MEDIAL_EXPORT, all of it and nothing else.

usage: exports_test.py LIBRARY HEADERS
"""

import re
import subprocess
import sys
import unittest
from pathlib import Path

LIBRARY, HEADERS = Path(sys.argv[1]), Path(sys.argv[2])
TABLE = re.compile(r"(?:typeinfo|typeinfo name|vtable|VTT) for medial::(\w+)")
MEMBER = re.compile(r"medial::(\w+)::(~?\w+|operator\W+?)(?:\[abi:\w+\])*\(.*\)(?: const)?")
FUNCTION = re.compile(r"medial::(\w+)(?:\[abi:\w+\])*\(.*\)")
LINKER = {"_init", "_fini"}


def code_of(text):
    """The text without comments and macros."""
    text = re.sub(r"//[^\n]*|/\*[\s\S]*?\*/", "", text)
    return re.sub(r"^[ \t]*#[^\n]*", "", text, flags=re.MULTILINE)


def body_at(text, start):
    """What stands between the next brace and its partner."""
    begin = text.index("{", start)
    depth = 0
    for index in range(begin, len(text)):
        depth += {"{": 1, "}": -1}.get(text[index], 0)
        if depth == 0:
            return text[begin:index]
    raise ValueError(f"a brace is not closed after {text[start:start + 40]!r}")


class Declared:
    """What the headers mark with MEDIAL_EXPORT."""

    def __init__(self, texts):
        self.functions, self.classes = set(), {}
        for text in map(code_of, texts):
            for found in re.finditer(r"\b(?:class|struct) MEDIAL_EXPORT (\w+)", text):
                self.classes[found[1]] = body_at(text, found.end())
            for found in re.finditer(r"(?<!class )(?<!struct )\bMEDIAL_EXPORT ([^;{(]*)\(", text):
                self.functions.add(found[1].split()[-1].strip("&*"))

    def allows(self, symbol):
        table = TABLE.fullmatch(symbol)
        if table:
            return table[1] in self.classes
        member = MEMBER.fullmatch(symbol)
        if member and member[1] in self.classes:
            return re.search(rf"(?<![\w~]){re.escape(member[2])}\s*\(", self.classes[member[1]]) is not None
        function = FUNCTION.fullmatch(symbol)
        return function is not None and function[1] in self.functions


def exported(library):
    """Demangled names of the symbols that the library defines for others."""
    lines = subprocess.run(("nm", "-DC", "--defined-only", str(library)), check=True,
                           stdout=subprocess.PIPE, text=True).stdout.splitlines()
    return [line.split(maxsplit=2)[2] for line in lines]


class Exports(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.declared = Declared(path.read_text() for path in sorted(HEADERS.glob("*.h")))
        cls.symbols = set(exported(LIBRARY)) - LINKER

    def test_every_symbol_is_public(self):
        private = sorted(symbol for symbol in self.symbols if not self.declared.allows(symbol))
        self.assertEqual(private, [])

    def test_every_function_that_is_declared_is_exported(self):
        self.assertGreater(len(self.declared.functions), 10)
        names = {found[1] for found in map(FUNCTION.fullmatch, self.symbols) if found}
        self.assertEqual(self.declared.functions - names, set())

    def test_members_and_tables_are_exported(self):
        for name in ("vtable for medial::Error", "typeinfo for medial::Error",
                     "medial::MedialSolver::mesh() const"):
            self.assertIn(name, self.symbols)


class Declarations(unittest.TestCase):
    """What the test finds in a library that exports more."""

    HEADER = """
        #define MEDIAL_EXPORT defined(int)
        // MEDIAL_EXPORT void commented(int);
        struct MEDIAL_EXPORT Box { Box(); ~Box(); Box& operator=(Box&&); double size(int axis) const; };
        struct Plain { int count() const; };
        MEDIAL_EXPORT std::vector<int> sizesOf(const Box& box,
          int count = 3);
        double hidden(int value);
    """

    def expect(self, allowed, *symbols):
        declared = Declared([self.HEADER])
        for symbol in symbols:
            with self.subTest(symbol=symbol):
                self.assertEqual(declared.allows(symbol), allowed)

    def test_public_symbols(self):
        self.expect(True, "medial::Box::size(int) const", "medial::Box::Box()", "medial::Box::~Box()",
                    "medial::Box::operator=(medial::Box&&)", "medial::sizesOf(medial::Box const&, int)",
                    "medial::sizesOf[abi:cxx11](medial::Box const&, int)", "vtable for medial::Box",
                    "typeinfo name for medial::Box")

    def test_private_symbols(self):
        self.expect(False, "medial::Tile::near(int) const", "medial::Tile::near(int) const [clone .resolver]",
                    "medial::Box::size(int) const [clone .resolver]", "medial::Box::axis(int)",
                    "medial::Plain::count() const", "medial::hidden(int)", "medial::commented(int)", "medial::defined(int)",
                    "medial::gl::sizesOf(int)", "sizesOf(int)", "typeinfo for medial::Plain",
                    "vtable for medial::Tile", "typeinfo for std::future<void>",
                    "std::vector<medial::Box>::_M_default_append(unsigned long)")


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
