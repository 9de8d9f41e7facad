"""Checks medial.thickness(), skeleton(), local_thickness(), reconstruction() and curves() on shapes with known answers."""

import dataclasses
import unittest

import medial
import numpy as np
import shapes
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkCellArray


class Skeleton(unittest.TestCase):
    def test_of_a_beam_is_its_middle_line(self):
        half = np.array([2.0, 0.25, 0.25])
        vertices, quads = shapes.box(half)
        network = medial.skeleton(vertices, quads, resolution=64)
        self.assertEqual(len(network.branches), 1)
        branch = network.branches[0]
        self.assertEqual(branch.kind, "isolated")
        self.assertAlmostEqual(branch.length, 3.5, delta=0.035)
        line = network.points[branch.indices]
        self.assertEqual(line.shape, network.points.shape)
        np.testing.assert_allclose(line[:, 1:], 0.0, atol=0.01)
        np.testing.assert_allclose(network.radius, 0.25, atol=0.01)
        np.testing.assert_allclose(network.arc_length.max(), branch.length)
        np.testing.assert_array_equal(np.sort(network.degree)[:3], [1, 1, 2])
        np.testing.assert_allclose(np.abs(network.tangent[:, 0]), 1.0, atol=1e-3)
        self.assertLessEqual(branch.min_radius, branch.mean_radius)
        self.assertLessEqual(branch.mean_radius, branch.max_radius)

    def test_of_a_ball_is_a_point(self):
        network = medial.skeleton(*shapes.ball(3), resolution=32)
        self.assertEqual([len(branch.indices) for branch in network.branches], [1])
        np.testing.assert_array_equal(network.degree, [0])

    def test_its_thinnest_branch_chooses_the_resolution(self):
        def points_in_radius(**parameters):
            network = medial.skeleton(vertices, quads, **parameters)
            steps = np.linalg.norm(np.diff(network.points[network.branches[0].indices], axis=0), axis=1)
            return network.radius.mean() / steps.mean()

        vertices, quads = shapes.box(np.array([2.0, 0.04, 0.04]))
        self.assertLess(points_in_radius(resolution=128), 3)
        self.assertGreater(points_in_radius(resolution="auto"), 3.5)
        with self.assertRaisesRegex(medial.InvalidInputError, "'auto' and spacing 0.1 exclude"):
            medial.skeleton(vertices, quads, resolution="auto", spacing=0.1)
        with self.assertRaisesRegex(TypeError, "'Auto' is not an integer in .* or 'auto'"):
            medial.skeleton(vertices, quads, resolution="Auto")
        for function in (medial.medial_axis, medial.local_thickness):
            with self.assertRaisesRegex(TypeError, "resolution 'auto' is not an integer"):
                function(vertices, quads, resolution="auto")

    def test_to_vtk(self):
        # A beam and a ball beside it, which is a branch of a single point.
        vertices, quads = shapes.box(np.array([2.0, 0.25, 0.25]))
        ball, triangles = shapes.ball(2, radius=0.5)
        faces = [*quads.tolist(), *(triangles + len(vertices)).tolist()]
        mesh = medial.Surface(np.concatenate([vertices, ball + [0, 2, 0]]), faces)
        network = medial.skeleton(mesh, resolution=64)
        self.assertEqual([len(branch.indices) > 1 for branch in network.branches], [True, False])
        algorithm = medial.vtkMedialSkeleton()
        algorithm.SetInputData(mesh.to_vtk())
        algorithm.SetResolution(64)
        algorithm.Update()
        made, expected = network.to_vtk(), algorithm.GetOutput()
        for got, wanted in ((made.GetPointData(), expected.GetPointData()),
                            (made.GetCellData(), expected.GetCellData())):
            self.assertEqual(got.GetNumberOfArrays(), wanted.GetNumberOfArrays())
            for i in range(wanted.GetNumberOfArrays()):
                name = wanted.GetArrayName(i)
                of_both = [vtk_to_numpy(data.GetArray(name)) for data in (got, wanted)]
                np.testing.assert_array_equal(*of_both, err_msg=name)
                self.assertEqual(of_both[0].dtype, of_both[1].dtype, name)
        self.assertEqual(made.GetPointData().GetScalars().GetName(), "Radius")
        for cells in ("GetVerts", "GetLines"):
            np.testing.assert_array_equal(*(
                vtk_to_numpy(getattr(one, cells)().GetConnectivityArray())
                for one in (made, expected)))
        wrong = network.branches[0]._replace(indices=np.array([0, len(network.points)]))
        with self.assertRaisesRegex(medial.InvalidInputError, "branches name the vertex"):
            dataclasses.replace(network, branches=[wrong]).to_vtk()
        with self.assertRaisesRegex(medial.InvalidInputError, "radius has the shape"):
            dataclasses.replace(network, radius=network.radius[1:]).to_vtk()

    def test_without_an_inside_is_refused(self):
        vertices, quads = shapes.box()
        with self.assertRaisesRegex(medial.InvalidInputError, "inside from outside"):
            medial.skeleton(vertices, quads[:1], resolution=16)


class LocalThickness(unittest.TestCase):
    def test_of_a_plate_is_its_height(self):
        half = np.array([2.0, 2.0, 0.5])
        plate = medial.local_thickness(*shapes.box(half), resolution=48, bins=10)
        self.assertEqual((plate.values.dtype, plate.values.ndim), (np.float32, 3))
        x, y, z = (first + step * np.arange(count) for first, step, count
                   in zip(plate.origin, plate.spacing, plate.values.shape))
        places = np.stack(np.meshgrid(x, y, z, indexing="ij"), axis=-1)
        inside = (np.abs(places) < half).all(axis=-1)
        np.testing.assert_array_equal(plate.values > 0, inside)
        middle = inside & (np.abs(places[..., :2]) < 1.4).all(axis=-1)
        np.testing.assert_allclose(plate.values[middle], 1.0, atol=0.01)
        thickness = plate.thickness
        self.assertIsNone(plate.separation)
        self.assertEqual(thickness.points, inside.sum())
        self.assertAlmostEqual(thickness.mean, plate.values[inside].mean(), places=5)
        self.assertAlmostEqual(thickness.standard_deviation, plate.values[inside].std(), places=5)
        self.assertAlmostEqual(thickness.max, plate.values.max(), places=5)
        self.assertEqual((len(thickness.histogram), len(thickness.edges)), (10, 11))
        self.assertEqual(thickness.histogram.sum(), thickness.points)
        counts, _ = np.histogram(plate.values[inside], thickness.edges)
        self.assertLessEqual(np.abs(counts - thickness.histogram).sum(), 0.01 * thickness.points)

    def test_to_vtk(self):
        plate = medial.local_thickness(*shapes.box(), resolution=16)
        image = plate.to_vtk()
        self.assertEqual(image.GetDimensions(), plate.values.shape)
        np.testing.assert_array_equal(image.GetOrigin(), plate.origin)
        np.testing.assert_array_equal(image.GetSpacing(), plate.spacing)
        scalars = image.GetPointData().GetScalars()
        self.assertEqual(scalars.GetName(), "LocalThickness")
        np.testing.assert_array_equal(
            vtk_to_numpy(scalars).reshape(plate.values.shape, order="F"), plate.values)
        self.assertTrue(np.shares_memory(vtk_to_numpy(scalars), plate.values))
        with self.assertRaisesRegex(medial.InvalidInputError, r"not \(nx, ny, nz\)"):
            dataclasses.replace(plate, values=plate.values[0]).to_vtk()

    def test_both_sides(self):
        ball = medial.local_thickness(*shapes.ball(3), side="both", resolution=32)
        self.assertLess(ball.values.min(), 0.0)
        self.assertAlmostEqual(ball.thickness.max, 2.0, delta=0.05)
        self.assertEqual(ball.thickness.points + ball.separation.points, ball.values.size)

    def test_refusals(self):
        vertices, quads = shapes.box()
        with self.assertRaisesRegex(medial.InvalidInputError, "inside"):
            medial.local_thickness(vertices, quads[:1], resolution=16)
        for bins in (0, 65537):
            with self.assertRaisesRegex(medial.InvalidInputError, rf"bins {bins} is outside \[1, 65536\]"):
                medial.local_thickness(vertices, quads, bins=bins)


class Thickness(unittest.TestCase):
    def test_of_a_ball_is_its_diameter(self):
        vertices, faces = shapes.ball(4, radius=2.0)
        values = medial.thickness(vertices, faces)
        self.assertEqual((values.dtype, values.shape), (np.float32, (len(vertices),)))
        np.testing.assert_allclose(values, 4.0, rtol=0.02)

    def test_edges_and_the_other_side_of_a_box(self):
        vertices, quads = shapes.box()
        np.testing.assert_array_equal(medial.thickness(vertices, quads), 0.0)
        # Outside a box there is nothing opposite its faces.
        np.testing.assert_array_equal(
            np.isnan(medial.thickness(vertices, quads, side="exterior")), True)

    def test_plates(self):
        half = np.array([1.0, 1.0, 0.125])
        vertices, quads = shapes.box(half)
        above = vertices + [0, 0, 1.0]
        # A point in the middle of the upper side of the lower plate.
        vertices = np.concatenate([vertices, above, [[0, 0, 0.125]]])
        fan = [[1, 5, 16], [5, 7, 16], [7, 3, 16], [3, 1, 16]]
        faces = [face for face in quads.tolist() if face != [1, 5, 7, 3]]
        faces += fan + (quads + 8).tolist()
        for side, expected in (("interior", 0.25), ("exterior", 0.75), ("both", 0.25)):
            values = medial.thickness(vertices, faces, side=side)
            self.assertAlmostEqual(values[16], expected, places=5, msg=side)

    def test_angle(self):
        vertices, quads = shapes.box()
        # The dihedral angles are 90 degrees: no convex edge bends by 120.
        self.assertGreater(medial.thickness(vertices, quads, angle=120).min(), 0.0)


    def test_methods_at_faces(self):
        vertices, quads = shapes.box(np.array([2.0, 1.0, 0.5]))
        np.testing.assert_allclose(
            medial.thickness(vertices, quads, method="wall", at_faces=True), 1.0, rtol=1e-5)
        rays = medial.thickness(vertices, quads, method="ray", at_faces=True)
        np.testing.assert_allclose(sorted(rays), [1, 1, 2, 2, 4, 4], rtol=1e-5)
        with self.assertRaisesRegex(medial.InvalidInputError, "rod"):
            medial.thickness(vertices, quads, method="rod")

    def test_of_a_divided_mesh(self):
        vertices, quads = shapes.box(np.array([2.0, 1.0, 0.5]))
        for at_faces in (False, True):
            found = medial.thickness(vertices, quads, method="wall", max_edge=0.5, at_faces=at_faces)
            corners = found.vertices[found.faces]
            edges = np.linalg.norm(corners - np.roll(corners, 1, axis=1), axis=2)
            self.assertLessEqual(edges.max(), 0.5)
            self.assertAlmostEqual(shapes.area(found.vertices, found.faces), 28.0)
            self.assertEqual(found.thickness.shape,
                             (len(found.faces if at_faces else found.vertices),))
            np.testing.assert_allclose(found.thickness, 1.0, rtol=1e-5)
            np.testing.assert_array_equal(np.unique(found.cell), np.arange(6))
            outwards = vertices[quads[found.cell]].mean(axis=1)
            np.testing.assert_allclose(((corners.mean(axis=1) - outwards) * outwards).sum(axis=1),
                                       0.0, atol=1e-12)
            mesh = found.to_vtk()
            data = mesh.GetCellData() if at_faces else mesh.GetPointData()
            np.testing.assert_array_equal(vtk_to_numpy(data.GetScalars()), found.thickness)
            np.testing.assert_array_equal(
                vtk_to_numpy(mesh.GetCellData().GetArray("InputCell")), found.cell)
        # Inside the faces the ball method has values as well.
        self.assertGreater(medial.thickness(vertices, quads, max_edge="10%").thickness.max(), 0.9)

    def test_limits_of_edges(self):
        tetrahedron = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]]
        faces = [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]]
        undivided = medial.thickness(tetrahedron, faces, max_edge=0, at_faces=True)
        self.assertEqual((len(undivided.vertices), len(undivided.faces)), (4, 4))
        np.testing.assert_array_equal(
            undivided.thickness, medial.thickness(tetrahedron, faces, at_faces=True))
        self.assertEqual(undivided.to_vtk().GetCellData().GetScalars().GetName(), "Thickness")
        halved = medial.thickness(tetrahedron, faces, max_edge=f"{100 / 3 ** 0.5 + 1}%")
        self.assertEqual(len(halved.vertices), 7)  # the three edges of root 2 are longer
        for value, message in ((-1, "edge length -1"), ("x%", "max_edge 'x%' is not a length")):
            with self.assertRaisesRegex(medial.InvalidInputError, message):
                medial.thickness(tetrahedron, faces, max_edge=value)
        with self.assertRaisesRegex(TypeError, "max_edge '2' is not a number"):
            medial.thickness(tetrahedron, faces, max_edge="2")

    def test_lines_of_a_divided_mesh(self):
        mesh = medial.Surface(*shapes.box()).to_vtk()
        lines = vtkCellArray()
        lines.InsertNextCell(2, [0, 7])
        mesh.SetLines(lines)
        found = medial.thickness(mesh, max_edge=0.5, at_faces=True, side="both")
        self.assertEqual(len(found.cell), len(found.faces))
        self.assertEqual((found.cell.min(), found.cell.max()), (1, 6))
        self.assertEqual(found.thickness.shape, (len(found.faces),))

    def test_divided_arrays_that_do_not_fit(self):
        vertices, quads = shapes.box()
        for at_faces in (False, True):
            found = medial.thickness(vertices, quads, max_edge=0.5, at_faces=at_faces)
            self.assertEqual(found.to_vtk().GetNumberOfCells(), len(found.faces))
            for change in ({"thickness": found.thickness[:-1]}, {"cell": found.cell[1:]},
                           {"at_faces": not at_faces}):
                with self.assertRaisesRegex(medial.InvalidInputError, "has the shape"):
                    found._replace(**change).to_vtk()

    def test_limits_in_per_cent_of_the_diagonal(self):
        vertices, quads = shapes.box(np.array([2.0, 1.0, 0.5]))
        diagonal = 21 ** 0.5
        for limits in ({"min_thickness": 30, "max_edge": 5}, {"max_thickness": 20, "max_edge": 0}):
            by_share, by_length = (
                medial.thickness_regions(vertices, quads, **{
                    name: convert(share) for name, share in limits.items()})
                for convert in ("{}%".format, lambda share: 0.01 * share * diagonal))
            self.assertEqual(len(by_share), 1)
            for one, other in zip(by_share, by_length):
                self.assertEqual((one.thin, one.value, one.area), (other.thin, other.value, other.area))
        self.assertEqual(medial.thickness_regions(vertices, quads, min_thickness="20%"), [])
        for name in ("min_thickness", "max_thickness", "max_edge"):
            with self.assertRaisesRegex(medial.InvalidInputError, f"{name} 'x%' is not a length"):
                medial.thickness_regions(vertices, quads, **{"min_thickness": 1, name: "x%"})

    def test_shares_of_diagonals_that_are_none(self):
        vertices, quads = shapes.box()
        vertices[3, 1] = np.inf
        for limits in ({"min_thickness": "1%"}, {"max_thickness": "1%"},
                       {"min_thickness": 1, "max_edge": "1%"}):
            with self.assertRaisesRegex(medial.InvalidInputError, "^point 3 .*not finite"):
                medial.thickness_regions(vertices, quads, **limits)
            with self.assertRaisesRegex(medial.InvalidInputError, "the mesh has no triangles"):
                medial.thickness_regions(np.zeros((8, 3)), quads, **limits)

    def test_regions(self):
        vertices, quads = shapes.box(np.array([2.0, 1.0, 0.5]))
        self.assertEqual(medial.thickness_regions(vertices, quads, min_thickness=0.9), [])
        thin, = medial.thickness_regions(vertices, quads, min_thickness=1.1, max_edge=0.2)
        self.assertTrue(thin.thin)
        self.assertAlmostEqual(thin.value, 1.0, places=5)
        self.assertAlmostEqual(thin.area, 28.0, places=5)
        self.assertEqual(thin.place.shape, (3,))
        np.testing.assert_array_equal(thin.faces, np.arange(6))
        thick, = medial.thickness_regions(vertices, quads, max_thickness=0.5, max_edge=0)
        self.assertFalse(thick.thin)

    def test_limits_that_contradict_each_other(self):
        for limits, words in (({"min_thickness": 2, "max_thickness": 1}, "is not below"),
                              ({}, "neither"), ({"min_thickness": -1}, "minimum thickness -1")):
            with self.assertRaisesRegex(medial.InvalidInputError, words):
                medial.thickness_regions(*shapes.box(), **limits)

    def test_limits_on_one_side_of_an_open_mesh(self):
        vertices, quads = shapes.box()
        with self.assertRaisesRegex(medial.InvalidInputError, "need a mesh with an inside"):
            medial.thickness_regions(vertices, quads[:3], min_thickness=1)


class Reconstruction(unittest.TestCase):
    def setUp(self):
        self.axis = medial.medial_axis(*shapes.box(), resolution=33, angle=30)

    def test_has_the_volume_of_the_box(self):
        surface = medial.reconstruction(self.axis, resolution=48)
        self.assertEqual(surface.vertices.dtype, np.float64)
        self.assertEqual(surface.faces.dtype, np.int64)
        self.assertAlmostEqual(shapes.signed_volume(*surface), 3.0, delta=0.15)
        np.testing.assert_allclose(np.abs(surface.vertices).max(axis=0), shapes.HALF, atol=0.05)

    def test_of_vtk_is_the_same(self):
        surfaces = [medial.reconstruction(axis, resolution=24)
                    for axis in (self.axis, self.axis.to_vtk())]
        np.testing.assert_array_equal(surfaces[0].vertices, surfaces[1].vertices)

    def test_of_larger_balls_is_larger(self):
        larger = dataclasses.replace(self.axis, radius=self.axis.radius + np.float32(0.25))
        volume = shapes.signed_volume(*medial.reconstruction(larger, resolution=48))
        # A box grown by r: its volume, r times its area, pi r^2 times a quarter of the edges' sum,
        # and a ball.
        sides = 2 * shapes.HALF
        area = 2 * (sides[0] * sides[1] + sides[1] * sides[2] + sides[2] * sides[0])
        grown = 3 + 0.25 * area + np.pi * 0.25 ** 2 * sides.sum() + 4 / 3 * np.pi * 0.25 ** 3
        self.assertAlmostEqual(volume, grown, delta=0.05 * grown)

    def test_balls_alone(self):
        axis = medial.medial_axis(*shapes.box(), resolution=33, max_spheres=12)
        volumes = [shapes.signed_volume(*medial.reconstruction(axis, interpolate=interpolate))
                   for interpolate in (False, True)]
        self.assertLess(volumes[0], 0.9 * volumes[1])

    def test_surface_is_a_mesh_again(self):
        surface = medial.reconstruction(self.axis, resolution=48)
        centre = medial.distance_field(surface, origin=(0, 0, 0), spacing=1, dimensions=(1, 1, 1))
        self.assertEqual(centre.sign, "winding")
        self.assertAlmostEqual(centre.distance[0, 0, 0], -0.5, delta=0.02)


class Curves(unittest.TestCase):
    def test_a_rectangle_has_a_rim(self):
        # Only the middle sheet of the box has such angles.
        axis = medial.medial_axis(*shapes.box(), resolution=65, angle=150)
        found = medial.curves(axis)
        self.assertEqual([curve.kind for curve in found], ["rim"])
        indices = found[0].indices
        self.assertEqual(indices[0], indices[-1])
        self.assertEqual(set(axis.feature[indices]), {1})
        rim = axis.points[indices]
        lengths = np.linalg.norm(np.diff(rim, axis=0), axis=1)
        # A rectangle of 1 x 0.5; its rim goes in steps, at most along both sides of each cell.
        self.assertGreater(lengths.sum(), 2.7)
        self.assertLess(lengths.sum(), 3.0 * 1.5)
        self.assertEqual(medial.curves(axis, rims=False), [])

    def test_a_box_has_seams_where_its_sheets_meet(self):
        axis = medial.medial_axis(*shapes.box(), resolution=33)
        seams = medial.curves(axis, rims=False, other=False)
        self.assertGreater(len(seams), 0)
        self.assertEqual({curve.kind for curve in seams}, {"seam"})
        # Along a seam three sides of the box are equally near.
        points = axis.points[np.concatenate([curve.indices for curve in seams])]
        depths = np.concatenate([shapes.HALF - points, shapes.HALF + points], axis=1)
        nearest = np.sort(depths, axis=1)
        self.assertLess(np.median(nearest[:, 2] - nearest[:, 0]), 2.5 / 33)
        mesh = axis.to_vtk()
        arrays = mesh.GetPointData().GetNumberOfArrays()
        of_vtk = medial.curves(mesh, rims=False, other=False)
        self.assertEqual(mesh.GetPointData().GetNumberOfArrays(), arrays)
        np.testing.assert_array_equal(of_vtk[0].indices, seams[0].indices)

    def test_an_axis_of_points_is_refused(self):
        axis = medial.medial_axis(*shapes.box(), resolution=17, representation="points")
        with self.assertRaisesRegex(ValueError, "representation 'points'.*'faces' is needed"):
            medial.curves(axis)

    def test_a_single_ball_has_none(self):
        axis = medial.medial_axis(*shapes.box(), resolution=17, max_spheres=1)
        self.assertEqual((len(axis.vertices), medial.curves(axis)), (1, []))


if __name__ == "__main__":
    unittest.main()
