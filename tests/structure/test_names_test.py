"""ctest's names of tests say what a test's parameter is: GoogleTest shows the bytes of types that it cannot print.

usage: test_names_test.py CTEST BUILD_FOLDER
"""

import re
import subprocess
import sys
import unittest

CTEST, BUILD_FOLDER = sys.argv[1:]


def names_of_tests():
    listing = subprocess.run((CTEST, "--test-dir", BUILD_FOLDER, "--show-only"), check=True,
                             stdout=subprocess.PIPE, text=True).stdout
    return re.findall(r"^ *Test +#\d+: (.*)$", listing, re.MULTILINE)


class TestNames(unittest.TestCase):
    def test_no_name_holds_bytes(self):
        names = names_of_tests()
        self.assertIn("test_names", names)
        self.assertEqual([name for name in names if "-byte object <" in name], [],
                         "print the type in tests/support/printing.h, or use tests/support/named.h")


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
