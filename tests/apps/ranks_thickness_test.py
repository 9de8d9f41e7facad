"""medial-axis as several processes: the thickness of one process.

usage: ranks_thickness_test.py MPIRUN MEDIAL-AXIS FAILING-ALLOCATIONS
"""

import sys
import unittest

from rank_runs import SINGLE, RankTest, boxes, read_polydata, torus


class RanksThickness(RankTest):
    def expect_same_thickness(self, ranks, *options):
        """One file of the same bytes, and pieces with the same values at the same points, each triangle once."""
        self.run_well(1, "torus.off", "--thickness", "one.vtp", "-q", *SINGLE, *options)
        self.run_well(ranks, "torus.off", "--thickness", "many.vtp", "-q", *SINGLE, *options)
        self.expect_same_file("many.vtp", "one.vtp")
        several = self.run_ranks(ranks, "torus.off", "--thickness", "many.pvtp", *SINGLE, *options)
        self.assertEqual(several.returncode, 0, several.stderr)
        self.assertRegex(several.stdout, "thickness interior.*: min .*, median .*, max ")
        self.assertNotIn("the first process", several.stderr)
        whole = read_polydata(self.folder / "one.vtp")
        values = whole.GetPointData().GetArray("Thickness")
        pieces = read_polydata(self.folder / "many.pvtp")
        ids = self.global_ids(pieces, "Point")
        self.assertEqual(set(ids), set(range(whole.GetNumberOfPoints())))
        thickness = pieces.GetPointData().GetScalars()
        self.assertEqual(thickness.GetName(), "Thickness")
        for i, number in enumerate(ids):
            self.assertEqual(pieces.GetPoint(i), whole.GetPoint(number))
            self.assertEqual(repr(thickness.GetValue(i)), repr(values.GetValue(number)))
        self.assertEqual(self.global_ids(pieces, "Cell"), list(range(pieces.GetNumberOfCells())))
        # The value of a cell is the least of its triangles'.
        cells = pieces.GetCellData().GetArray("InputCell")
        least = {}
        for i in range(pieces.GetNumberOfCells()):
            value = pieces.GetCellData().GetArray("Thickness").GetValue(i)
            least.setdefault(cells.GetValue(i), []).append(value)
        if "--max-edge" not in options:
            expected = whole.GetCellData().GetArray("Thickness")
            self.assertEqual({cell: min(found) for cell, found in least.items()},
                             {i: expected.GetValue(i) for i in range(whole.GetNumberOfCells())})
        return self.count_pieces("many.pvtp")

    def test_two_ranks_write_the_thickness_of_one(self):
        self.assertEqual(self.expect_same_thickness(2), 2)

    def test_seven_ranks_write_the_thickness_along_rays(self):
        self.assertEqual(self.expect_same_thickness(7, "--thickness-method", "ray"), 7)

    def test_the_thickness_of_walls_of_a_divided_surface(self):
        self.write(*boxes(((0, 0, 0), (1, 0.9, 0.8)), ((0, 0, 1.3), (0.1, 0.7, 0.5))))
        for ranks in (2, 3, 7):
            self.assertEqual(
                self.expect_same_thickness(ranks, "--thickness-method", "wall", "--max-edge", "0.4"), ranks)

    def test_thickness_together_with_an_axis(self):
        options = ("--resolution", "40", "--sign", "pseudonormal", "-q", *SINGLE)
        self.run_well(1, "torus.off", "--thickness", "one.vtp", "-o", "one.ply", *options)
        self.run_well(3, "torus.off", "--thickness", "many.vtp", "-o", "many.ply", *options)
        self.expect_same_file("many.vtp", "one.vtp")
        self.expect_same_file("many.ply", "one.ply")

    def test_a_report_of_thickness(self):
        self.write_pieces(3)
        self.run_well(1, "torus.off", "--thickness", "a.vtp", "--report", "one.json", *SINGLE)
        expected = self.report("one.json")
        expected["thickness"].pop("seconds")
        for mesh in ("torus.off", "torus.pvtp"):
            self.run_well(3, mesh, "--thickness", "a.pvtp", "--report", "many.json", *SINGLE)
            found = self.report("many.json")
            found["thickness"].pop("seconds")
            self.assertEqual(found["thickness"], expected["thickness"])
            self.assertGreater(found["thickness"]["median"], 0.7)
            self.assertIsNone(found["grid"])
            for rank in found["ranks"]:
                self.assertGreater(rank["bytes_sent"], 0)
                self.assertLess(rank["own_triangles"], expected["input"]["triangles"] / 2)

    def test_limits_of_thickness(self):
        self.write(*boxes(((0, 0, 0), (1, 0.9, 0.8)), ((3, 0, 0), (0.1, 0.9, 0.8))))
        files = {}
        lines = {}
        for ranks in (1, 3):
            run = self.run_ranks(ranks, "torus.off", "--min-thickness", "0.5", "--thin-regions", "thin.vtp",
                                 "--report", "a.json", "--max-edge", "0.5", *SINGLE)
            self.assertEqual(run.returncode, 1, run.stderr)
            lines[ranks] = run.stderr
            self.assertIn("       1  thin         0.2 ", run.stdout)
            report = self.report("a.json")["thickness"]
            report.pop("seconds")
            files[ranks] = ((self.folder / "thin.vtp").read_bytes(), report)
        self.assertEqual(files[3], files[1])
        self.assertEqual(lines[3], lines[1])
        self.run_well(2, "torus.off", "--min-thickness", "0.1", "-q")

    def test_facets_with_equal_corners(self):
        """They are edges of others, which are halved."""
        points, faces = boxes(((0, 0, 0), (1, 0.9, 0.8)))
        self.write(points, [*faces, [faces[0][0], faces[0][0], faces[0][1]]])
        self.expect_same_thickness(3, "--thickness-method", "wall", "--max-edge", "0.3")
        self.run_well(2, "torus.off", "--min-thickness", "0.1", "-q", *SINGLE)

    def test_seams_of_walls(self):
        """Faces that share no points, so that borders lie right beside each other, on all ranks."""
        points, faces = boxes(((0, 0, 0), (1, 0.9, 0.8)))
        loose = [[x + 1e-9 * (i % 5) for x in points[p]] for i, face in enumerate(faces) for p in face]
        corners = iter(range(len(loose)))
        self.write(loose, [[next(corners) for _ in face] for face in faces])
        self.expect_same_thickness(3, "--thickness-method", "wall", "--max-edge", "0.3")
        self.run_well(3, "torus.off", "--min-thickness", "0.5", "--max-edge", "0.3", "-q", *SINGLE)

    def test_limits_of_a_mesh_in_pieces(self):
        """The regions of the whole mesh, which no process holds."""
        self.write_pieces(4)
        for edge in (("--max-edge", "0.1"), ("--max-edge", "0")):
            found = {}
            for ranks, mesh in ((1, "torus.off"), (3, "torus.pvtp")):
                run = self.run_ranks(ranks, mesh, "--max-thickness", "0.7", "--thin-regions", "thick.vtp", *edge,
                                     *SINGLE)
                self.assertEqual(run.returncode, 1, run.stderr)
                table = [line for line in run.stdout.splitlines() if " thick " in line]
                self.assertGreater(len(table), 0)
                found[mesh] = (table, run.stderr.replace(mesh, ""), (self.folder / "thick.vtp").read_bytes())
            self.assertEqual(found["torus.pvtp"], found["torus.off"])

    def test_limits_of_a_mesh_in_pieces_without_ids(self):
        def points_of(name):
            data = read_polydata(self.folder / name)
            return data.GetNumberOfCells(), sorted(map(data.GetPoint, range(data.GetNumberOfPoints())))

        self.write_pieces(4, with_ids=False)
        for edge in ("0.1", "0"):
            limit = ("--max-thickness", "0.7", "--max-edge", edge, "-q", *SINGLE)
            for ranks, mesh, file in ((1, "torus.off", f"one{edge}.vtp"), (3, "torus.pvtp", f"many{edge}.vtp")):
                run = self.run_ranks(ranks, mesh, "--thin-regions", file, *limit)
                self.assertEqual(run.returncode, 1, run.stderr)
            self.assertEqual(points_of(f"many{edge}.vtp"), points_of(f"one{edge}.vtp"))

    def test_limits_together_with_the_thickness_itself(self):
        for edge in ((), ("--max-edge", "0")):
            options = ("--max-thickness", "0.7", "-q", *edge, *SINGLE)
            for ranks, name in ((1, "one"), (3, "many")):
                run = self.run_ranks(ranks, "torus.off", "--thickness", f"{name}.vtp", "--thin-regions",
                                     f"{name}_regions.vtp", *options)
                self.assertEqual(run.returncode, 1, run.stderr)
            self.expect_same_file("many.vtp", "one.vtp")
            self.expect_same_file("many_regions.vtp", "one_regions.vtp")

    def test_limits_of_thickness_that_are_refused(self):
        for options, code, text in ((("--min-thickness", "2", "--max-thickness", "1"), 2, "minimum thickness 2"),
                                    (("--min-thickness", "1", "--max-edge", "1e-9"), 3, "need more than")):
            self.expect_failure(self.run_ranks(2, "torus.off", *options), code, text)
        points, faces = torus()
        self.write(points, faces[:300])
        self.expect_failure(self.run_ranks(2, "torus.off", "--min-thickness", "1"), 3,
                            "^medial-axis: torus.off: limits of the thickness of one side need")

    def test_a_rank_without_memory_for_thickness(self):
        self.expect_failure(self.run_short_of_memory("torus.off", "--thickness", "a.pvtp", *SINGLE), 5,
                            "^medial-axis: (torus.off: )?rank 2: .*memory")


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
