"""Each folder names the VTK modules whose headers it includes, and VTK is asked for all of them.

usage: vtk_modules_test.py SOURCES HIERARCHY
HIERARCHY: the folder where VTK's installation lists the classes of its modules
"""

import re
import sys
import tempfile
import unittest
from pathlib import Path

SOURCES, HIERARCHY = Path(sys.argv[1]), Path(sys.argv[2])
BUILD_FILES = ("CMakeLists.txt", "vtk.module", "build.cmake")
INCLUDE = re.compile(r'^[ \t]*#[ \t]*include[ \t]*[<"](\w+\.h)[>"]', re.MULTILINE)


def read_modules():
    """Headers of VTK and the modules that they belong to, without the prefix vtk."""
    modules = {}
    for path in HIERARCHY.glob("*-hierarchy.txt"):
        for header, module in re.findall(r"; (\w+\.h) ; vtk(\w+)", path.read_text()):
            modules[header] = module
    return modules


def named_modules(folder):
    """Modules after VTK::, and components that VTK is asked for."""
    text = "".join((folder / name).read_text() for name in BUILD_FILES if (folder / name).exists())
    asked = " ".join(re.findall(r"find_package\(VTK[^)]*COMPONENTS([^)]*)\)", text))
    return set(re.findall(r"VTK::(\w+)", text)) | set(asked.split())


def included_modules(folder, modules):
    files = [path for path in folder.iterdir() if path.suffix in {".h", ".cpp", ".cxx"}]
    return {modules[header] for path in files for header in INCLUDE.findall(path.read_text()) if header in modules}


def code_folders(root):
    for top in ("apps", "benchmarks", "examples", "filters", "tests"):
        yield from sorted(path.parent for path in (root / top).rglob("CMakeLists.txt"))


def unnamed_modules(root, modules):
    faults = []
    for folder in code_folders(root):
        missing = included_modules(folder, modules) - named_modules(folder)
        if missing:
            faults.append(f"{folder.relative_to(root)} does not name {sorted(missing)}")
    return faults


class VtkModules(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.modules = read_modules()

    def test_folders_name_the_modules_that_they_include(self):
        self.assertEqual(unnamed_modules(SOURCES, self.modules), [])

    def test_modules_of_the_programs_are_asked_for(self):
        asked = re.search(r"COMPONENTS([^)]*)\)", (SOURCES / "apps/vtk.cmake").read_text())[1].split()
        named = set().union(*(named_modules(path) for path in (SOURCES / "apps").iterdir() if path.is_dir()))
        self.assertGreater(len(named), 10)
        self.assertEqual(named, set(asked) - {"OPTIONAL_COMPONENTS"})

    def test_a_module_that_is_not_named_is_found(self):
        with tempfile.TemporaryDirectory() as root:
            folder = Path(root) / "apps/attic"
            folder.mkdir(parents=True)
            (folder / "attic.cpp").write_text("#include <vtkSTLReader.h>\n#include <vtkNew.h>\n")
            (folder / "CMakeLists.txt").write_text("target_link_libraries(attic VTK::CommonCore)\n")
            self.assertEqual(unnamed_modules(Path(root), self.modules),
                             ["apps/attic does not name ['IOGeometry']"])


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
