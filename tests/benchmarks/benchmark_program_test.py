"""Runs every suite of the benchmark program on small shapes and checks what it writes.

usage: benchmark_program_test.py PROGRAM
"""

import json
import math
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

PROGRAM = sys.argv[1]
RASTERISER_SUITES = ["peers", "table1", "figure5", "figure6"]
FIELD_SUITES = [*RASTERISER_SUITES, "triangles", "models"]
SUITES = [*FIELD_SUITES, "frames", "proximity", "points", "skeletons"]
FIRST_METHODS = {"frames": ["solver"],
                 "proximity": ["medial-depths", "medial-all", "medial-collision"]}
EXACT = {"medial": 1e-2, "medial-raster": 1e-2, "embree": 1e-2, "cgal": 1e-2, "vtk": 1e-2}  # voxels


TETRAHEDRON = """OFF
4 4 0
0 0 0
1 0 0
0 1 0
0 0 1
3 0 2 1
3 0 1 3
3 0 3 2
3 1 2 3
"""


def fitted_exponent(rows, method):
    """Slope of the line through the logarithms of triangles and of median seconds."""
    seconds = [next(m["median_seconds"] for m in row["methods"] if m["id"] == method)
               for row in rows]
    xs = [math.log(row["triangles"]) for row in rows]
    ys = [math.log(s) for s in seconds]
    x, y = sum(xs) / len(xs), sum(ys) / len(ys)
    return sum((a - x) * (b - y) for a, b in zip(xs, ys)) / sum((a - x) ** 2 for a in xs)


class BenchmarkProgram(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.folder = Path(folder.name)
        (cls.folder / "tetrahedron.off").write_text(TETRAHEDRON)
        run = subprocess.run([PROGRAM, "--quick", "--output", folder.name,
                              "--files", cls.folder / "tetrahedron.off", "--suite", *SUITES],
                             check=True, stderr=subprocess.PIPE, text=True)
        cls.progress = run.stderr

    def report(self, suite):
        return json.loads((self.folder / f"{suite}.json").read_text())

    def test_machine_is_named(self):
        machine = self.report("peers")["machine"]
        self.assertTrue(machine["renderer"])
        self.assertGreaterEqual(machine["cores"], 1)
        self.assertRegex(machine["date"], r"^\d{4}-\d\d-\d\d")

    def test_every_suite_has_rows_and_a_table(self):
        for suite in SUITES:
            with self.subTest(suite=suite):
                report = self.report(suite)
                self.assertTrue(report["rows"])
                text = (self.folder / f"{suite}.md").read_text()
                self.assertIn(report["title"], text)
                if suite in FIELD_SUITES:
                    self.assertIn("| Medial |", text)
                if suite in RASTERISER_SUITES:
                    self.assertIn("| Medial, rasteriser |", text)
        self.assertFalse(list(self.folder.glob("*.part")))

    def test_samples_add_up_and_are_compared(self):
        for suite in SUITES:
            report = self.report(suite)
            for row in report["rows"]:
                self.assertIn(row["methods"][0]["id"], FIRST_METHODS.get(suite, ["medial"]))
                for method in row["methods"]:
                    with self.subTest(suite=suite, mesh=row["mesh"], method=method["id"]):
                        self.assertNotIn("failure", method)
                        if "predicted_seconds" in method:
                            continue
                        self.assertIn(len(method["samples"]), range(1, report["rounds"] + 1))
                        for sample in method["samples"]:
                            self.assertAlmostEqual(
                                sample["total"], sum(sample["seconds"].values()))
                        self.assertGreater(method["median_seconds"], 0)
                        self.assertGreater(method["median_ratio"], 0)

    def test_exponents_fit_the_medians_of_each_grid(self):
        report = self.report("triangles")
        self.assertEqual(len(report["figures"]), 2)
        for grid, exponents in report["figures"].items():
            rows = [row for row in report["rows"]
                    if "x".join(map(str, row["grid"]["dimensions"])) == grid]
            self.assertEqual(len(rows), 3)
            methods = [method["id"] for method in rows[0]["methods"]]
            self.assertIn("medial", methods)
            for method in methods:
                with self.subTest(grid=grid, method=method):
                    self.assertAlmostEqual(exponents[f"exponent_{method}"],
                                           fitted_exponent(rows, method))
            self.assertRegex(self.progress, rf"\| {grid} \| [\d,]+ to [\d,]+ \| -?\d")

    def test_no_round_is_left_out_where_medians_need_all(self):
        with tempfile.TemporaryDirectory() as folder:
            subprocess.run([PROGRAM, "--quick", "--budget", "1e-9", "--time-cap", "1e-9",
                            "--output", folder, "--suite", "triangles", "--meshes", "torus 1K"],
                           check=True, stderr=subprocess.DEVNULL)
            report = json.loads((Path(folder) / "triangles.json").read_text())
        self.assertEqual([row["mesh"] for row in report["rows"]], 2 * ["torus 1K"])
        for row in report["rows"]:
            for method in row["methods"]:
                self.assertEqual(len(method.get("samples", [])), report["rounds"])

    def test_files_of_the_user_are_measured_as_they_are(self):
        row = self.report("models")["rows"][-1]
        self.assertEqual((row["mesh"], row["triangles"]), ("tetrahedron", 4))

    def test_memory_is_that_of_a_process_of_its_own(self):
        for row in self.report("peers")["rows"]:
            for method in row["methods"]:
                if method["id"] == "medial":
                    with self.subTest(mesh=row["mesh"]):
                        self.assertGreater(method["peak_bytes"], row["output_bytes"])
                        self.assertLess(method["peak_bytes"], 1e9)

    def test_targets_do_not_apply_to_other_meshes(self):
        for suite in ["peers", "table1", "figure5"]:
            targets = self.report(suite)["targets"]
            self.assertTrue(targets)
            for target in targets:
                with self.subTest(suite=suite, mesh=target["mesh"], what=target["what"]):
                    self.assertEqual(target["verdict"], "-")

    def test_exact_methods_are_exact(self):
        for suite in SUITES:
            for row in self.report(suite)["rows"]:
                for method in row["methods"]:
                    with self.subTest(suite=suite, mesh=row["mesh"], method=method["id"]):
                        accuracy = method.get("accuracy")
                        if method["id"] in EXACT and accuracy:
                            self.assertGreater(accuracy["checked_points"], 0)
                            self.assertLess(accuracy["greatest_voxels"], EXACT[method["id"]])
                            self.assertEqual(accuracy.get("wrong_triangle_share", 0), 0)

    def test_methods_agree_how_pairs_lie(self):
        rows = self.report("proximity")["rows"]
        self.assertEqual(len(rows), 4 * 3)
        for row in rows:
            for method in row["methods"]:
                with self.subTest(pair=row["mesh"], method=method["id"]):
                    figures = method["figures"]
                    self.assertEqual(figures.get("wrong_collisions", 0), 0)
                    self.assertLess(figures.get("separation_difference", 0), 1e-12)
                    self.assertLess(figures.get("point_depth_difference", 0), 1e-12)
                    self.assertTrue(math.isfinite(figures["apart"]))
                    self.assertTrue(math.isfinite(figures["colliding"]))
        self.assertNotIn(self.report("proximity")["machine"]["renderer"],
                         (self.folder / "proximity.md").read_text())

    @unittest.skipUnless(shutil.which("gnuplot"), "gnuplot is not installed")
    def test_plots_named_by_the_tables_exist(self):
        for suite in SUITES:
            text = (self.folder / f"{suite}.md").read_text()
            names = [part.split(")")[0] for part in text.split("](")[1:]]
            for name in names:
                with self.subTest(suite=suite, plot=name):
                    self.assertGreater((self.folder / name).stat().st_size, 1000)

    def test_wrong_options_end_with_usage(self):
        for options in (["--suite", "nothing"], ["--repeats", "0"], ["--methods", "magic"],
                        ["--max-triangles", "9999"], ["--max-triangles", "2000001"],
                        ["--files", "/nowhere.off"]):
            with self.subTest(options=options):
                run = subprocess.run([PROGRAM, *options], capture_output=True, check=False)
                self.assertEqual(run.returncode, 2)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
