"""Each public header compiles alone, without warnings, and includes public and standard headers only.

usage: public_headers_test.py HEADERS COMPILER [FLAG...]
HEADERS: the folder that holds the folder medial
"""

import re
import subprocess
import sys
import tempfile
import unittest
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

HEADERS = Path(sys.argv[1])
COMPILE = [*sys.argv[2:], "-std=c++17", "-fsyntax-only", "-Wall", "-Wextra", "-Werror", f"-I{HEADERS}",
           "-x", "c++"]
INCLUDE = re.compile(r'^[ \t]*#[ \t]*include[ \t]*([<"][^>"\n]*[>"])', re.MULTILINE)


def foreign_includes(text):
    """Includes other than "medial/name.h" and those of the standard library, <name>."""
    return [name for name in INCLUDE.findall(text) if not re.fullmatch(r'"medial/\w+\.h"|<\w+>', name)]


def errors_of(source):
    # From the standard input, so that no "#pragma once in main file" is in the way.
    run = subprocess.run([*COMPILE, "-"], input=source, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                         text=True)
    return "" if run.returncode == 0 else run.stdout or "the compiler failed"


class PublicHeaders(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.headers = sorted((HEADERS / "medial").glob("*.h"))

    def test_each_compiles_alone(self):
        with ThreadPoolExecutor(2) as pool:
            sources = [f'#include "medial/{header.name}"\n' for header in self.headers]
            for header, errors in zip(self.headers, pool.map(errors_of, sources)):
                with self.subTest(header=header.name):
                    self.assertEqual(errors, "")

    def test_they_include_public_and_standard_headers_only(self):
        self.assertGreater(len(self.headers), 20)
        for header in self.headers:
            with self.subTest(header=header.name):
                self.assertEqual(foreign_includes(header.read_text()), [])

    def test_the_collection_includes_all(self):
        included = INCLUDE.findall((HEADERS / "medial/medial.h").read_text())
        self.assertEqual(sorted(included),
                         sorted(f'"medial/{header.name}"' for header in self.headers if header.name != "medial.h"))

    def test_headers_that_do_not_compile_or_include_others_are_found(self):
        with tempfile.TemporaryDirectory() as folder:
            header = Path(folder) / "alone.h"
            header.write_text("#pragma once\ninline std::size_t count() { return 0; }\n")
            self.assertNotEqual(errors_of(f'#include "{header}"\n'), "")
        for name in ("<glm/vec3.hpp>", "<tbb/task_arena.h>", "<epoxy/gl.h>", "<vtkType.h>", '"base/run.h"',
                     "<OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>", '"medial/base/grid.h"'):
            with self.subTest(name=name):
                self.assertEqual(foreign_includes(f"#include <vector>\n # include {name} // for it\n"), [name])


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
