"""Every script and command of docs/PARAVIEW.md, run in its order as a reader would.

usage: tutorial_test.py SOURCES
"""

import os
import re
import signal
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

SOURCES = Path(sys.argv[1])
ENVIRONMENT = {**os.environ, "OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1",
               "HWLOC_COMPONENTS": "-gl",
               "OMPI_MCA_rmaps_base_oversubscribe": "1"}


def blocks():
    """Scripts with the name that the text before gives them, and commands, in order."""
    text = (SOURCES / "docs/PARAVIEW.md").read_text()
    for match in re.finditer(r"```(python|sh)\n(.*?)```", text, re.DOTALL):
        names = re.findall(r"`(\w+\.py)`", text[:match.start()])
        yield match[1], names[-1] if names else None, match[2]


class Tutorial(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)
        for name in ("scripts", "build-paraview"):
            (self.folder / name).symlink_to(SOURCES / name)

    def serve(self, command):
        """A server in the background, once it waits for a client."""
        process = subprocess.Popen(["bash", "-c", command], cwd=self.folder, env=ENVIRONMENT,
                                   stdout=subprocess.PIPE, text=True, start_new_session=True)
        self.addCleanup(process.stdout.close)
        self.addCleanup(process.wait)
        self.addCleanup(self.end, process)
        for line in process.stdout:
            if "Accepting connection" in line:
                return

    def end(self, process):
        if process.poll() is None:
            os.killpg(process.pid, signal.SIGTERM)

    def run_command(self, command):
        run = subprocess.run(["bash", "-ec", command], cwd=self.folder, env=ENVIRONMENT,
                             capture_output=True, text=True, timeout=250)
        self.assertEqual((run.returncode, run.stderr.count("ERR|")), (0, 0), run.stderr)
        return run.stdout

    def test_scripts_and_commands(self):
        printed = ""
        for language, name, code in blocks():
            with self.subTest(code=code):
                if language == "python":
                    (self.folder / name).write_text(code)
                elif "pvserver" in code:
                    self.serve(code)
                else:
                    printed += self.run_command(code)
        self.assertRegex(printed, r"computed by the engine \w+")
        self.assertRegex(printed, r"\d\d\d\d cells")
        for output in ("bunny_axis.png", "bunny_axis.pvsm", "bunny_axis.vtp", "bunny_field.pvti",
                       "bunny_field/bunny_field_1.vti", "bunny_pieces.pvti", "bunny_pieces/bunny_pieces_1.vti"):
            self.assertGreater((self.folder / output).stat().st_size, 500, output)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1], verbosity=2)
