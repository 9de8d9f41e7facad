"""No file of lib includes what the table of rooms in docs/ARCHITECTURE.md does not allow.

usage: rooms_test.py SOURCES
"""

import re
import shutil
import sys
import tempfile
import unittest
from pathlib import Path

from rooms import all_faults, includes, read_rooms

SOURCES = Path(sys.argv[1])
DOCUMENT = "docs/ARCHITECTURE.md"


class Tree(unittest.TestCase):
    def test_all_includes_follow_the_arrows(self):
        self.assertEqual("\n".join(all_faults(SOURCES)), "")

    def test_many_includes_between_rooms_were_read(self):
        rooms = read_rooms(SOURCES / DOCUMENT)
        crossing = [name for _, room, name in includes(SOURCES, rooms) if rooms.of_include(name) != room]
        self.assertGreater(len(crossing), 100)
        self.assertGreater(len(rooms.arrows), 10)


class ChangedTree(unittest.TestCase):
    """Each of these changes to a copy of the tree is a fault, and the only one. It is undone afterwards."""

    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.root = Path(folder.name)
        (cls.root / "docs").mkdir()
        shutil.copy(SOURCES / DOCUMENT, cls.root / DOCUMENT)
        for name in ("lib", "shaders", "tests/lib"):
            shutil.copytree(SOURCES / name, cls.root / name)
        cls.before = set(all_faults(SOURCES))

    def setUp(self):
        self.assertEqual(set(all_faults(self.root)), self.before)

    def expect_fault(self, pattern):
        faults = set(all_faults(self.root)) - self.before
        self.assertEqual(len(faults), 1, faults)
        self.assertRegex(faults.pop(), pattern)

    def append(self, file, line):
        path = self.root / file
        before = ""
        if path.exists():
            before = path.read_text()
            self.addCleanup(path.write_text, before)
        else:
            self.addCleanup(path.unlink)
        path.write_text(f"{before}\n{line}\n")

    def add_folder(self, name):
        path = self.root / name
        path.mkdir()
        self.addCleanup(path.rmdir)

    def edit_table(self, pattern, replacement):
        path = self.root / DOCUMENT
        before = path.read_text()
        text, count = re.subn(pattern, replacement, before, count=1, flags=re.MULTILINE)
        self.assertEqual(count, 1)
        self.addCleanup(path.write_text, before)
        path.write_text(text)

    def test_private_header_of_a_later_room(self):
        self.append("lib/base/grid.cpp", '#include "sites/site_set.h"')
        self.expect_fault("base/grid.cpp includes sites/site_set.h: no arrow leads from base to sites")

    def test_spaces_do_not_hide_an_include(self):
        self.append("lib/base/grid.cpp", '  #  include   "sites/site_set.h" // for a moment')
        self.expect_fault("no arrow leads from base to sites")

    def test_public_header_of_a_later_room(self):
        self.append("lib/base/grid.cpp", '#include "medial/thickness.h"')
        self.expect_fault("base/grid.cpp includes medial/thickness.h: .* from base to thickness")

    def test_public_header_that_includes_a_later_one(self):
        self.append("lib/include/medial/grid.h", '#include "medial/thickness.h"')
        self.expect_fault("include/medial/grid.h includes medial/thickness.h: .* from base to thickness")

    def test_room_below_another_is_one_of_its_own(self):
        self.append("lib/field/field_tap.h", '#include "field/engines/processor/slab_field.h"')
        self.expect_fault("no arrow leads from field to field/engines")

    def test_header_of_all_headers(self):
        self.append("lib/pipeline/medial_solver.cpp", '#include "medial/medial.h"')
        self.expect_fault("medial/medial.h, which is in no room")

    def test_include_relative_to_the_file(self):
        self.append("lib/sites/site_set.cpp", '#include "site_set.h"')
        self.expect_fault("site_set.h, which is in no room")

    def test_new_room(self):
        self.add_folder("lib/attic")
        self.append("lib/attic/attic.cpp", '#include "base/run.h"')
        self.expect_fault("attic/attic.cpp lies in no room")

    def test_new_public_header(self):
        self.append("lib/include/medial/attic.h", "#pragma once")
        self.expect_fault("the table lacks the header attic.h")

    def test_row_without_a_room(self):
        self.edit_table(r"^(\| `sites`)", r"| `attic` | | | |\n\1")
        self.expect_fault("there is no room lib/attic")

    def test_arrow_in_a_circle(self):
        self.append("lib/base/grid.cpp", '#include "sites/site_set.h"')
        self.edit_table(r"^(\| `base` .*)\|$", r"\1 `sites` |")
        self.expect_fault("in a circle: (base -> .*sites -> base|sites -> base -> sites)")

    def test_arrow_that_nothing_needs(self):
        self.edit_table(r"^(\| `pipeline` .*)\|$", r"\1 `measure` |")
        self.expect_fault("no file needs the arrow from pipeline to measure")

    def test_folder_of_tests_without_a_room(self):
        self.add_folder("tests/lib/attic")
        self.expect_fault("tests/lib/attic mirrors no folder of lib")

    def test_folder_of_shaders_without_a_room(self):
        self.add_folder("shaders/attic")
        self.expect_fault("shaders/attic mirrors no folder of lib")


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
