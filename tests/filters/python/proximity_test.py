"""Checks medial.proximity() on shapes with known answers."""

import types
import unittest

import medial
import numpy as np
import shapes

CUBE = np.full(3, 0.5)


def shift(*by):
    matrix = np.eye(4)
    matrix[:3, 3] = by
    return matrix


def cubes(x, **options):
    """Two cubes of side 1, the second moved along x."""
    return medial.proximity(*shapes.box(CUBE), *shapes.box(CUBE), transform_b=shift(x, 0, 0),
                            **options)


def sunken_cube(**options):
    """A cube of side 1 sunk 0.1 into a face of a plate."""
    plate = shapes.box(np.array([2.0, 2.0, 0.5]))
    return medial.proximity(*plate, *shapes.box(CUBE), transform_b=shift(0, 0, 0.9), **options)


class Apart(unittest.TestCase):
    def test_separation_and_witnesses(self):
        found = cubes(2.5)
        self.assertEqual(found.separation, 1.5)
        self.assertEqual((found.witness_a[0], found.witness_b[0]), (0.5, 2.0))
        np.testing.assert_allclose(found.witness_b - found.witness_a, [1.5, 0, 0], atol=1e-12)
        vertices, quads = shapes.box(CUBE)
        self.assertTrue((vertices[quads[found.cell_a], 0] == 0.5).all())
        self.assertTrue((vertices[quads[found.cell_b], 0] == -0.5).all())
        self.assertEqual((found.intersect, found.collide, found.inside_undefined),
                         (False, False, False))
        self.assertEqual(found.depth, 0.0)
        self.assertEqual(found.translational_depth, (0.0, 0.0))
        self.assertEqual(len(found.contacts.points), 0)
        np.testing.assert_array_equal(found.depths_a, np.zeros(8))
        self.assertGreaterEqual(found.seconds, 0.0)
        self.assertEqual(repr(found),
                         "<Proximity: the meshes do not collide, separation 1.5, 0 contacts>")

    def test_order_does_not_matter(self):
        box, ball = shapes.box(), shapes.ball(3, 0.7)
        moved = shift(2, 0.3, 0.1)
        one = medial.proximity(*box, *ball, transform_b=moved)
        other = medial.proximity(*ball, *box, transform_a=moved)
        self.assertEqual(one.separation, other.separation)
        np.testing.assert_array_equal(one.witness_a, other.witness_b)
        self.assertEqual(one.cell_a, other.cell_b)

    def test_whole_meshes(self):
        mesh = medial.Surface(*shapes.box(CUBE))
        as_object = types.SimpleNamespace(vertices=mesh.vertices, faces=mesh.faces)
        for a, b in ((mesh, as_object), (as_object, mesh.to_vtk())):
            found = medial.proximity(a, None, b, transform_a=shift(0, 0, 3))
            self.assertEqual(found.separation, 2.0)


    def test_without_separation(self):
        found = cubes(3, separation=False)
        self.assertTrue(np.isnan(found.separation))
        self.assertEqual((found.witness_a, found.witness_b), (None, None))
        self.assertEqual((found.cell_a, found.cell_b, found.collide), (-1, -1, False))

    def test_beyond_the_largest_separation(self):
        found = cubes(3, max_separation=1.5)
        self.assertEqual(found.separation, np.inf)
        self.assertIsNone(found.witness_a)
        self.assertEqual(cubes(3, max_separation=2).separation, 2.0)


class Together(unittest.TestCase):
    def test_overlap(self):
        found = cubes(0.75)
        self.assertEqual((found.separation, found.intersect, found.collide), (0.0, True, True))
        np.testing.assert_array_equal(found.witness_a, found.witness_b)
        self.assertAlmostEqual(found.depth, 0.25, delta=1e-3)
        self.assertGreaterEqual(found.depth_at_most, 0.25)
        self.assertLess(found.depth_at_most, 0.2503)
        self.assertEqual(found.deepest_point.shape, (3,))
        self.assertIn("the meshes collide", repr(found))

    def test_depths_of_vertices(self):
        found = sunken_cube()
        np.testing.assert_array_equal(found.depths_a, np.zeros(8))
        lower = shapes.box(CUBE)[0][:, 2] < 0
        np.testing.assert_allclose(found.depths_b, np.where(lower, 0.1, 0.0), atol=1e-12)

    def test_one_inside_the_other(self):
        found = medial.proximity(*shapes.box(CUBE), *shapes.box(CUBE / 10))
        self.assertEqual((found.intersect, found.collide), (False, True))
        self.assertAlmostEqual(found.separation, 0.45)
        self.assertAlmostEqual(found.depth, 0.45, delta=1e-3)
        np.testing.assert_allclose(found.depths_b, 0.45)

    def test_only_what_is_wanted(self):
        found = cubes(0.75, depths=False, translational_depth=False)
        self.assertTrue(found.collide)
        for name in ("depth", "depth_at_most", "deepest_point", "depths_a", "depths_b", "translational_depth",
                     "separating_translation"):
            self.assertIsNone(getattr(found, name), name)
        self.assertEqual(found.contacts.points.shape, (0, 3))

    def test_contacts(self):
        found = sunken_cube().contacts
        self.assertEqual((found.points.shape, found.normals.shape), ((4, 3), (4, 3)))
        self.assertGreater(found.normals[:, 2].min(), np.cos(np.radians(1)))
        np.testing.assert_allclose(found.depths, 0.1, atol=1e-6)
        np.testing.assert_array_equal(found.manifolds, 0)
        for cells in (found.cells_a, found.cells_b):
            self.assertTrue(((0 <= cells) & (cells < 6)).all())
        self.assertEqual(len(sunken_cube(max_contacts=1).contacts.points), 1)
        self.assertEqual(len(sunken_cube(max_contacts=0).contacts.points), 0)

    def test_translational_depth(self):
        found = sunken_cube()
        np.testing.assert_allclose(found.translational_depth, 0.1, atol=1e-6)
        np.testing.assert_allclose(found.separating_translation, [0, 0, -0.1], atol=1e-6)

    def test_translation_that_is_unknown(self):
        vertices, quads = shapes.box(np.ones(3))
        # Two opposite sides, between whose edges the winding number is about one half.
        undefined = medial.proximity(vertices, quads[:2], *shapes.box(CUBE),
                                     transform_b=shift(0.5, 0.9, 0))
        self.assertTrue(undefined.inside_undefined)
        without_depths = cubes(0.75, depths=False)
        self.assertTrue(without_depths.collide)
        for found in (undefined, without_depths):
            self.assertEqual(found.translational_depth, (0.0, np.inf))
            np.testing.assert_array_equal(found.separating_translation, np.full(3, np.nan))
        apart = cubes(3, depths=False)
        self.assertEqual(apart.translational_depth, (0.0, 0.0))
        np.testing.assert_array_equal(apart.separating_translation, np.zeros(3))


class Frames(unittest.TestCase):
    def test_a_filter_follows_meshes_that_move(self):
        algorithm = medial.vtkMeshProximity()
        vertices, faces = shapes.ball(3, 0.5)
        for port in (0, 1):
            algorithm.SetInputData(port, medial.Surface(vertices, faces).to_vtk())
        for x in (3.0, 2.0, 1.5):
            algorithm.SetInputData(1, medial.Surface(vertices + [x, 0, 0], faces).to_vtk())
            medial.update(algorithm)
            field = algorithm.GetOutput().GetFieldData()
            self.assertAlmostEqual(field.GetArray("Separation").GetValue(0), x - 1, delta=1e-12)


class Refusals(unittest.TestCase):
    def expect(self, words, *meshes, error=medial.InvalidInputError, **options):
        meshes = meshes or (*shapes.box(), *shapes.box())
        with self.assertRaisesRegex(error, words):
            medial.proximity(*meshes, **options)

    def test_parameters(self):
        self.expect(r"max_contacts -1 is outside \[0, 2147483647\]", max_contacts=-1)
        self.expect("depth tolerance 1 is outside", depth_tolerance=1)
        self.expect(r"maximum separation -1 is outside \[0, infinity\]", max_separation=-1)
        self.expect("threads -1", threads=-1)
        self.expect(r"depth_tolerance '1' is not a number in \(0, 1\)", error=TypeError,
                    depth_tolerance="1")

    def test_transforms(self):
        self.expect(r"transform_a has the shape \(3, 3\), not \(4, 4\)", transform_a=np.eye(3))
        self.expect(r"transform_b is not of numbers", transform_b="turn")
        self.expect(r"transform_b has the last row .*, not \(0, 0, 0, 1\)",
                    transform_b=np.ones((4, 4)))
        self.expect("mesh B: the determinant 0 of the transform is not finite and not 0",
                    transform_b=np.diag([1, 0, 1, 1]))
        self.expect("mesh A: the determinant nan", transform_a=np.diag([1, np.nan, 1, 1]))

    def test_meshes(self):
        vertices, faces = shapes.box()
        self.expect("mesh B: the mesh has no cells", vertices, faces, vertices, faces[:0])
        broken = vertices.copy()
        broken[3, 1] = np.nan
        self.expect("mesh A: .*point 3", broken, faces, vertices, faces)
        self.expect("faces name the vertex 8", vertices, faces, vertices, faces + 1)
        self.expect("a mesh is given as", vertices, faces, "box.stl", error=TypeError)


if __name__ == "__main__":
    unittest.main()
