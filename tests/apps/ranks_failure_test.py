"""medial-axis as several processes: what fails on one fails on all, in one line.

usage: ranks_failure_test.py MPIRUN MEDIAL-AXIS FAILING-ALLOCATIONS
"""

import os
import signal
import subprocess
import sys
import time
import unittest
from pathlib import Path

from rank_runs import ENVIRONMENT, LAUNCHER, PROGRAM, SINGLE, RankTest, torus


def children_of(parent):
    """The numbers of processes that another one has started."""
    children = []
    for path in Path("/proc").glob("[0-9]*/stat"):
        try:
            stat = path.read_text()
        except OSError:  # it has ended meanwhile
            continue
        if int(stat.rpartition(")")[2].split()[1]) == parent:
            children.append(int(path.parent.name))
    return sorted(children)


class RanksFailure(RankTest):
    def test_a_report_in_a_folder_that_does_not_exist(self):
        run = self.run_ranks(2, "torus.off", "-o", "a.pvtp", "--report", "absent/a.json", "--sign", "none")
        self.expect_failure(run, 5, "^medial-axis: absent/a.json")

    def test_pieces_need_several_processes(self):
        for option in ("--output", "--thickness"):
            self.expect_failure(self.run_ranks(1, "torus.off", option, "a.pvtp"), 2,
                                f"{option} a.pvtp: .pvtp is for several processes, started by mpirun; use .vtp for one")

    def test_an_axis_in_a_folder_that_does_not_exist(self):
        run = self.run_ranks(2, "torus.off", "-o", "absent/a.pvtp", "--sign", "none")
        self.expect_failure(run, 5, "^medial-axis: absent/a.pvtp")

    def test_a_missing_mesh(self):
        self.expect_failure(self.run_ranks(2, "absent.off", "--field", "a.pvti", "--sign", "none"), 3,
                            "^medial-axis: rank 0: absent.off: no such file$")

    def test_a_mesh_that_is_open(self):
        points, faces = torus()
        self.write(points, faces[:-1])
        run = self.run_ranks(2, "torus.off", "--field", "a.pvti", "--sign", "pseudonormal")
        self.expect_failure(run, 3, "^medial-axis: torus.off: sign method pseudonormal needs a closed")

    def test_a_folder_that_does_not_exist(self):
        run = self.run_ranks(2, "torus.off", "--field", "absent/a.pvti", "--sign", "none")
        self.expect_failure(run, 5, "^medial-axis: absent/a.pvti")

    def test_what_several_processes_do_not_compute(self):
        for options, text in ((("--field", "a.vti"), "--field FILE.pvti"),
                              (("--thickness-image", "a.png"), "--thickness-image needs a single one"),
                              (("-o", "a.vtp", "--curves", "b.vtp"), "--curves needs a single one"),
                              (("--skeleton", "a.vtp"), "--skeleton needs a single one"),
                              (("--field", "a.pvti", "--sign", "none", "--engine", "rasteriser"), "--engine processor"),
                              (("-o", "a.vtp", "--require-gpu"), "--require-gpu needs a single one"),
                              (("-o", "a.vtp", "--verify"), "--verify needs a single one"),
                              (("--field", "a.pvti", "--resolution", "1"), "^medial-axis: --resolution")):
            self.expect_failure(self.run_ranks(2, "torus.off", *options), 2, text)

    def run_with_own_options(self, *options):
        """Runs a rank with each of the lists of options, besides those that all have."""
        command = list(LAUNCHER)
        for own in options:
            command += ["-np", "1", PROGRAM, "torus.off", "--field", "a.pvti", "--sign", "none", *own, ":"]
        return self.run_command(*command[:-1])

    def test_ranks_with_different_options(self):
        for first, second in ((("--resolution", "20"), ("--resolution", "21")),
                              (("--spacing", "1e-7"), ("--spacing", "1.3e-7")),
                              (("--padding", "0.0500000001"), ()),
                              ((), ("--version",))):
            self.expect_failure(self.run_with_own_options(first, second), 2,
                                "^medial-axis: rank 1 has other options than rank 0, or runs in another folder$")

    def test_options_that_are_wrong_on_one_rank(self):
        for wrong, text in ((("--bogus",), "unknown option --bogus"),
                            (("--resolution", "1"), "--resolution: 1 is outside"),
                            (("--curves", "a.vtp"), "several processes: --curves needs a single one")):
            self.expect_failure(self.run_with_own_options((), wrong, ()), 2, f"^medial-axis: rank 1: {text}")
            self.expect_failure(self.run_with_own_options(wrong, ()), 2, f"^medial-axis: rank 0: {text}")

    def send_signal(self, rank, number, *outputs, launcher=LAUNCHER):
        """Sends a signal to a rank of three, or to mpirun for None, while all of them compute."""
        command = [*launcher, "-np", "3", PROGRAM, "torus.off", *outputs, "--sign", "none", "--resolution", "500",
                   "--threads", "1", "-q"]
        with subprocess.Popen(command, cwd=self.folder, env=ENVIRONMENT, stderr=subprocess.PIPE, text=True) as run:
            while len(list(self.folder.glob(".a*"))) < 4:  # the pieces and the index
                self.assertIsNone(run.poll())
                time.sleep(0.01)
            os.kill(run.pid if rank is None else children_of(run.pid)[rank], number)
            errors = run.communicate(timeout=60)[1]
        return subprocess.CompletedProcess(command, run.returncode, "", errors)

    def interrupt(self, rank):
        return self.send_signal(rank, signal.SIGINT, "--field", "a.pvti", "-o", "a.pvtp")

    def test_a_rank_that_is_killed(self):
        # On a busy machine the others may need more than the second that mpirun gives them to end.
        launcher = (*LAUNCHER, "--mca", "odls_base_sigkill_timeout", "4")
        run = self.send_signal(1, signal.SIGKILL, "--field", "a.pvti", launcher=launcher)
        self.assertNotEqual(run.returncode, 0)
        # Of the one that was killed a file without its name may stay; the others leave nothing.
        left = [name for name in self.files() if name != "torus.off"]
        self.assertLessEqual(len(left), 1, left)
        self.assertTrue(all(name.startswith(".") for name in left), left)

    def test_a_rank_that_is_interrupted(self):
        self.expect_failure(self.interrupt(2), 130,
                            "^medial-axis: (torus.off: )?rank 2: interrupted; nothing was written$")

    def test_mpirun_that_is_interrupted(self):
        run = self.interrupt(None)
        self.assertEqual(run.returncode, 1)  # mpirun's own
        self.assertLessEqual(len([line for line in run.stderr.splitlines() if "medial-axis" in line]), 1, run.stderr)
        self.assertEqual(self.files(), ["torus.off"])

    def test_a_rank_without_memory(self):
        run = self.run_short_of_memory("torus.off", "--field", "a.pvti", "-o", "a.pvtp", "--sign", "none",
                                       "--resolution", "100", *SINGLE)
        self.expect_failure(run, 5, "^medial-axis: rank 2: not enough memory$")

    def test_a_rank_with_a_full_disk(self):
        options = f"{PROGRAM} torus.off --field a.pvti -o a.pvtp --sign none --resolution 60 {' '.join(SINGLE)}"
        command = (*LAUNCHER, "-np", "1", *options.split(), ":", "-np", "1", "sh", "-c", f"ulimit -f 60; exec {options}")
        self.expect_failure(self.run_command(*command), 5, "^medial-axis: rank 1: a_1.vti: cannot be written")

    def test_a_report_that_nobody_gets(self):
        """It is printed last: all ranks end, and the files stay."""
        command = (*LAUNCHER, "-np", "2", "sh", "-c",
                   f"exec {PROGRAM} torus.off --report - -o a.pvtp --resolution 20 {' '.join(SINGLE)} > /dev/full")
        run = self.run_command(*command)
        self.assertEqual(run.returncode, 5, run.stderr)
        self.assertRegex(run.stderr, "^medial-axis: (rank 0: )?standard output: cannot be written: [^\n]*\n$")

    def test_ranks_in_different_folders(self):
        """Their pieces would not lie beside the index."""
        (self.folder / "other").mkdir()
        (self.folder / "other" / "torus.off").write_bytes((self.folder / "torus.off").read_bytes())
        options = (PROGRAM, "torus.off", "-o", "a.pvtp", "--resolution", "20", *SINGLE)
        run = self.run_command(*LAUNCHER, "-np", "1", *options, ":", "-np", "1", "-wdir", "other", *options)
        self.assertEqual(run.returncode, 2, run.stderr)
        self.assertRegex(run.stderr, "^medial-axis: rank 1 has other options than rank 0, or runs in another folder$")
        self.assertEqual(self.files(), ["other", "torus.off"])

    def test_an_output_that_would_replace_a_piece_of_the_mesh(self):
        self.write_pieces(2)
        before = {path.name: path.read_bytes() for path in self.folder.iterdir()}
        for mesh, output, text in (
                ("torus_0.vtp", "torus.pvtp", "output torus.pvtp: its piece torus_0.vtp is the input file itself$"),
                ("torus.pvtp", "torus_1.vtp", "output torus_1.vtp is a file of the input torus.pvtp$"),
                ("torus.pvtp", "torus.pvtp", "output torus.pvtp is the input file itself$")):
            run = self.run_ranks(2, mesh, "--output", output, "--resolution", "20", "--sign", "none")
            self.assertEqual(run.returncode, 2, run.stderr)
            self.assertRegex(run.stderr, "^medial-axis: --" + text)
            self.assertEqual({path.name: path.read_bytes() for path in self.folder.iterdir()}, before)

    def test_pieces_that_would_replace_another_output(self):
        run = self.run_ranks(2, "torus.off", "-o", "x.pvtp", "--thickness", "x_0.vtp", "--sign", "none")
        self.expect_failure(run, 2, "^medial-axis: --output and --thickness name the same file, x_0.vtp$")

    def test_the_version_is_printed_once(self):
        run = self.run_ranks(3, "--version")
        self.assertEqual((run.returncode, len(run.stdout.splitlines())), (0, 1))


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
