"""Doxygen reports no warning about the public headers, and everything public is documented.

usage: header_docs_test.py DOXYGEN DOXYFILE
"""

import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

DOXYGEN, DOXYFILE = sys.argv[1], Path(sys.argv[2])
SHOWN = {
    "index.html": "Medial from C++",
    "namespacemedial.html": "computeMedialAxis",
    "structmedial_1_1MedialAxisOptions.html": "Minimum separation angle theta",
    "classvtkMedialAxis.html": "SetAngle",
    "classvtkMeshFieldAlgorithm.html": "GetSpacing",
}
UNDOCUMENTED = """\
/// Documented.
namespace medial
{
int secret(int value);
}
"""


class HeaderDocs(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def doxygen(self, *settings):
        lines = [DOXYFILE.read_text(), f'OUTPUT_DIRECTORY = "{self.folder}"', *settings]
        return subprocess.run([DOXYGEN, "-"], input="\n".join(lines), text=True, cwd=self.folder,
                              capture_output=True)

    def test_nothing_is_undocumented_or_wrong(self):
        run = self.doxygen()
        self.assertEqual((run.returncode, run.stderr), (0, ""))

    def test_classes_functions_and_macros_are_shown(self):
        self.doxygen()
        for page, text in SHOWN.items():
            with self.subTest(page=page):
                self.assertIn(text, (self.folder / "html" / page).read_text())

    def test_what_filters_keep_for_themselves_is_not(self):
        self.doxygen()
        self.assertNotIn("RequestData", (self.folder / "html/classvtkMedialAxis.html").read_text())

    def test_something_undocumented_is_an_error(self):
        header = self.folder / "secret.h"
        header.write_text(UNDOCUMENTED)
        run = self.doxygen(f'INPUT = "{header}"', "USE_MDFILE_AS_MAINPAGE =")
        self.assertNotEqual(run.returncode, 0)
        self.assertIn("secret", run.stderr)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
