"""medial-axis as several processes: the axis of one process, and reports about it.

usage: ranks_axis_test.py MPIRUN MEDIAL-AXIS FAILING-ALLOCATIONS
"""

import json
import sys
import unittest

from vtkmodules.vtkIOXML import vtkXMLPImageDataReader

from rank_runs import SINGLE, RankTest, boxes, read_polydata, torn_torus


def points_of(axis):
    """What is known of each point."""
    data = axis.GetPointData()
    names = ("Radius", "SeparationAngle", "Lambda", "ClosestPointA", "ClosestPointB", "AxisFeature")
    return [(axis.GetPoint(i), *(data.GetArray(name).GetTuple(i) for name in names))
            for i in range(axis.GetNumberOfPoints())]


def cells_of(axis):
    """The points of each cell."""
    return [tuple(axis.GetCell(i).GetPointId(k) for k in range(axis.GetCell(i).GetNumberOfPoints()))
            for i in range(axis.GetNumberOfCells())]


class RanksAxis(RankTest):
    def expect_same_axis(self, ranks, *options):
        """Pieces with all points and cells of one process, by their global ids; each cell once."""
        self.run_well(1, "torus.off", "-o", "one.vtp", "-q", *SINGLE, *options)
        whole = read_polydata(self.folder / "one.vtp")
        points, cells = points_of(whole), cells_of(whole)
        self.assertGreater(len(cells), 20)
        several = self.run_ranks(ranks, "torus.off", "-o", "many.pvtp", *SINGLE, *options)
        self.assertEqual(several.returncode, 0, several.stderr)
        for line in several.stderr.splitlines():
            self.assertTrue(line.startswith("medial-axis: note: "), line)
        self.assertIn(f"axis      {len(points)} points, {len(cells)} cells", several.stdout)
        axis = read_polydata(self.folder / "many.pvtp")
        ids = self.global_ids(axis, "Point")
        self.assertEqual(set(ids), set(range(len(points))))
        if "points" not in options:  # those on cuts are in several pieces
            self.assertGreater(len(ids), len(points))
        for point, number in zip(points_of(axis), ids):
            self.assertEqual(point, points[number])
        numbers = self.global_ids(axis, "Cell")
        self.assertEqual(sorted(numbers), list(range(len(cells))))
        for cell, number in zip(cells_of(axis), numbers):
            self.assertEqual(tuple(ids[i] for i in cell), cells[number])
        return self.count_pieces("many.pvtp")

    def test_three_ranks_write_the_axis_of_one(self):
        self.assertGreater(self.expect_same_axis(3, "--resolution", "50", "--sign", "pseudonormal"), 1)

    def test_a_mesh_with_holes_by_winding_numbers(self):
        self.write(*torn_torus())
        self.expect_same_axis(3, "--resolution", "40", "--sign", "winding")
        run = self.run_ranks(2, "torus.off", "-o", "many.vtp", "--resolution", "30")
        self.assertIn("note: torus.off: 3 holes with 10 edges closed in thought", run.stderr)

    def test_an_axis_of_points_without_a_sign(self):
        self.assertEqual(self.expect_same_axis(2, "--resolution", "60", "--sign", "none", "--representation", "points",
                                               "--angle", "50"), 2)

    def test_more_ranks_than_parts_of_the_grid_with_an_axis(self):
        self.assertLess(self.expect_same_axis(7, "--resolution", "30", "--sign", "pseudonormal"), 7)

    def test_three_ranks_preserve_the_topology_as_one(self):
        for more in ((), ("--representation", "faces"), ("--side", "both", "--angle", "40")):
            options = ("--resolution", "40", "--topology", "preserve", "--sign", "pseudonormal", *more)
            self.assertGreater(self.expect_same_axis(3, *options), 1)

    def test_preserved_topology_of_bodies_that_touch_in_one_file(self):
        self.write(*boxes(((0, 0, 0), (1, 0.9, 0.8)), ((1, 0.1, 0.1), (0.5, 0.6, 0.5))))
        options = ("--resolution", "40", "--topology", "preserve", *SINGLE)
        self.run_well(1, "torus.off", "-o", "one.vtp", "-q", *options)
        several = self.run_ranks(4, "torus.off", "-o", "many.vtp", *options)
        self.assertEqual(several.returncode, 0, several.stderr)
        self.assertNotIn("first process", several.stderr)
        self.expect_same_file("many.vtp", "one.vtp")

    def test_a_mesh_in_pieces_has_the_axis_of_the_whole(self):
        self.write_pieces(3)
        for topology in ("selected", "preserve"):
            options = ("--resolution", "40", "--topology", topology, *SINGLE, "-q")
            self.run_well(1, "torus.off", "-o", "one.vtp", *options)
            for ranks in (2, 4):  # of which one has two pieces, or none
                self.run_well(ranks, "torus.pvtp", "-o", "many.vtp", *options)
                self.expect_same_file("many.vtp", "one.vtp")

    def test_a_mesh_in_pieces_without_ids_does_not_depend_on_ranks(self):
        self.write_pieces(5, with_ids=False)
        options = ("--resolution", "24", *SINGLE, "-q", "--field-arrays", "closest_cell")
        found = []
        for ranks in (2, 3, 5):
            self.run_well(ranks, "torus.pvtp", "-o", "many.vtp", "--field", "f.pvti", *options)
            reader = vtkXMLPImageDataReader()
            reader.SetFileName(str(self.folder / "f.pvti"))
            reader.Update()
            cells = reader.GetOutput().GetPointData().GetArray("ClosestCell")
            found.append(((self.folder / "many.vtp").read_bytes(),
                          [cells.GetValue(i) for i in range(cells.GetNumberOfValues())]))
        self.assertTrue(found[0] == found[1] == found[2])

    def test_a_mesh_in_pieces_has_the_field_and_thickness_of_the_whole(self):
        self.write_pieces(2)
        options = (*SINGLE, "-q", "--resolution", "30", "--field", "f.pvti", "--thickness", "t.pvtp")
        found = []
        for mesh in ("torus.off", "torus.pvtp"):
            self.run_well(2, mesh, *options)
            fields = [(self.folder / name).read_bytes() for name in ("f_0.vti", "f_1.vti")]
            surface = read_polydata(self.folder / "t.pvtp")
            values, cells = (surface.GetCellData().GetArray(name) for name in ("Thickness", "InputCell"))
            ids = self.global_ids(surface, "Point")
            found.append((fields, {tuple(ids[p] for p in cell): (cells.GetValue(i), values.GetValue(i))
                                   for i, cell in enumerate(cells_of(surface))}))
        self.assertEqual(found[0][0], found[1][0])
        self.assertEqual(len(found[0][1]), 1600)
        self.assertEqual(found[0][1], found[1][1])

    def test_a_mesh_in_pieces_that_is_damaged(self):
        self.write_pieces(3)
        def several(*options):
            return self.run_ranks(2, "torus.pvtp", "-o", "a.vtp", "-q", *options)

        alone = self.run_ranks(1, "torus.pvtp", "-o", "a.vtp")
        for run, code, text in (
                (alone, 2, "^medial-axis: INPUT torus.pvtp: .pvtp is for several processes"),
                (several("--thickness", "t.vtp"), 2, "torus.pvtp lies in pieces: --thickness FILE.vtp needs a mesh")):
            self.expect_line(run, code, text)
        (self.folder / "torus_1.vtp").unlink()
        self.expect_line(several(), 3, "^medial-axis: rank 1: torus_1.vtp: no such file$")
        for index, text in (("<VTKFile/>", "not an index of polygonal data"),
                            ("<VTKFile><PPolyData><Piece/></PPolyData></VTKFile>", "a Piece has no Source"),
                            ("<VTKFile><PPolyData/></VTKFile>", "the mesh has no cells")):
            (self.folder / "torus.pvtp").write_text(index)
            self.expect_line(several(), 3, f"^medial-axis: torus.pvtp: {text}")

    def test_what_the_first_rank_computes_alone(self):
        for topology in ("selected", "preserve"):
            options = ("--resolution", "30", "--sign", "pseudonormal", *SINGLE, "--topology", topology, "--max-spheres", "50")
            self.run_well(1, "torus.off", "-o", "one.ply", "-q", *options)
            several = self.run_ranks(2, "torus.off", "-o", "many.ply", *options)
            self.assertEqual(several.returncode, 0)
            self.assertIn("note: torus.off: --max-spheres looks at the whole axis", several.stderr)
            self.expect_same_file("many.ply", "one.ply")

    def expect_same_report(self, ranks, *options, mesh="torus.off"):
        """The figures and notes of one process, but for times and what ranks count."""
        one = self.run_ranks(1, "torus.off", "--report", "one.json", *SINGLE, *options)
        several = self.run_ranks(ranks, mesh, "--report", "many.json", *SINGLE, *options)
        self.assertEqual((one.returncode, several.returncode), (0, 0), several.stderr)
        own = " looks at the whole axis: the first process"
        notes = several.stderr.replace(mesh, "torus.off").splitlines()
        self.assertEqual([line for line in notes if own not in line], one.stderr.splitlines())
        expected, found = self.report("one.json"), self.report("many.json")
        self.assertEqual(found["input"].pop("path"), mesh)
        expected["input"].pop("path")
        self.assertIsNone(expected.pop("ranks"))
        per_rank = found.pop("ranks")
        self.assertEqual(len(per_rank), ranks)
        self.assertEqual(max(rank["peak_memory_mib"] for rank in per_rank), found["peak_memory_mib"])
        self.assertEqual(sum(rank["medial_cells"] for rank in per_rank), expected["counts"]["medial_cells"])
        for report in (expected, found):
            for key in ("seconds", "peak_memory_mib", "fragments_per_voxel"):
                del report[key]
            for key in ("fragments", "group_tests", "site_tests", "candidate_pairs"):  # where parts meet, tiles count twice
                del report["counts"][key]
            for key in ("coverage", "simplification"):
                (report[key] or {}).pop("seconds", None)
        self.assertEqual(found, expected)
        return found

    def test_a_report_has_the_figures_of_one(self):
        report = self.expect_same_report(3, "--resolution", "40")
        self.assertEqual(report["topology"]["axis"]["genus"], 1)

    def test_a_report_of_a_mesh_in_pieces(self):
        self.write_pieces(4)
        report = self.expect_same_report(3, "--resolution", "40", mesh="torus.pvtp")
        self.assertEqual((report["input"]["closed"], report["input"]["components"]), (True, 1))
        self.write_pieces(3, with_ids=False)
        self.run_well(4, "torus.pvtp", "--report", "r.json", "--resolution", "30", *SINGLE)
        found = self.report("r.json")["input"]
        found.pop("path")
        self.assertEqual(found, report["input"])

    def test_a_report_of_what_the_axis_leaves_out(self):
        # The grid misses a thin plate.
        self.write(*boxes(((0, 0, 0), (1, 0.9, 0.8)), ((2, 0, 0), (0.01, 0.9, 0.8))))
        report = self.expect_same_report(3, "--resolution", "41", "--sign", "pseudonormal")
        self.assertGreater(report["coverage"]["uncovered_share"], 0.1)
        self.assertGreater(len(report["coverage"]["places"]), 0)
        self.assertLess(report["coverage"]["spacing"], 0.01)

    def test_a_report_of_preserved_topology(self):
        for more in ((), ("--max-spheres", "60")):
            report = self.expect_same_report(2, "--resolution", "30", "--topology", "preserve", *more)
            self.assertEqual(report["topology"]["solid"]["genus"], 1)

    def test_a_report_on_standard_output(self):
        run = self.run_ranks(2, "torus.off", "-o", "a.pvtp", "--report", "-", "--resolution", "30")
        self.assertEqual(run.returncode, 0, run.stderr)
        report = json.loads(run.stdout)
        self.assertEqual((report["topology"]["axis"]["components"], len(report["ranks"])), (1, 2))
        self.assertIn("a.pvtp", self.files())


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
