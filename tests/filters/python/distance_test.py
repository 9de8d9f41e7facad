"""Checks medial.distance() on shapes with known answers."""

import multiprocessing
import unittest

import medial
import numpy as np
import shapes
from vtkmodules.util.numpy_support import vtk_to_numpy


def random_points(count=500, seed=1):
    return np.random.default_rng(seed).uniform(-2, 2, (count, 3))


def sum_of(seed):
    """In another process."""
    return medial.distance(*shapes.box(), random_points(seed=seed)).distance.sum()


class Distance(unittest.TestCase):
    def test_arrays(self):
        points = random_points()
        found = medial.distance(*shapes.box(), points)
        np.testing.assert_allclose(found.distance, shapes.box_distance(points), atol=1e-12)
        np.testing.assert_allclose(points + np.abs(found.distance)[:, None] * found.direction,
                                   found.closest_point, atol=1e-12)
        self.assertEqual(found.sign, "winding")
        self.assertEqual(set(found.feature), {0, 1, 2})
        vertices, quads = shapes.box()
        corners = vertices[quads[found.cell]]
        slack = 1e-12
        self.assertTrue((found.closest_point >= corners.min(axis=1) - slack).all())
        self.assertTrue((found.closest_point <= corners.max(axis=1) + slack).all())

    def test_single_precision_points_and_lists(self):
        points = random_points(20)
        expected = medial.distance(*shapes.box(), points).distance
        single = medial.distance(*shapes.box(), points.astype(np.float32)).distance
        np.testing.assert_allclose(single, expected, atol=1e-6)
        self.assertEqual(single.dtype, np.float64)
        as_list = medial.distance(*shapes.box(), points.tolist()).distance
        np.testing.assert_array_equal(as_list, expected)

    def test_whole_mesh(self):
        mesh = medial.Surface(*shapes.box())
        for whole in (mesh, mesh.to_vtk()):
            found = medial.distance(whole, points=[[0, 0, 0]])
            self.assertAlmostEqual(found.distance[0], -0.5)

    def test_to_vtk(self):
        points = random_points(20).astype(np.float32)
        found = medial.distance(*shapes.box(), points)
        np.testing.assert_array_equal(found.points, points)
        mesh = found.to_vtk()
        self.assertEqual((mesh.GetNumberOfPoints(), mesh.GetNumberOfVerts()), (20, 20))
        algorithm = medial.vtkMeshPointDistance()
        algorithm.SetInputDataObject(mesh)
        algorithm.SetSurfaceData(medial.Surface(*shapes.box()).to_vtk())
        algorithm.Update()
        expected = algorithm.GetOutput().GetPointData()
        data = mesh.GetPointData()
        self.assertEqual(data.GetNumberOfArrays(), expected.GetNumberOfArrays())
        for i in range(expected.GetNumberOfArrays()):
            name = expected.GetArrayName(i)
            np.testing.assert_array_equal(vtk_to_numpy(data.GetArray(name)),
                                          vtk_to_numpy(expected.GetArray(name)))
        self.assertEqual(data.GetScalars().GetName(), "Distance")
        empty = medial.distance(*shapes.box(), np.empty((0, 3))).to_vtk()
        self.assertEqual(empty.GetNumberOfPoints(), 0)
        with self.assertRaisesRegex(medial.InvalidInputError, r"cell has the shape \(1,\)"):
            found._replace(cell=found.cell[:1]).to_vtk()

    def test_sign(self):
        found = medial.distance(*shapes.box(), [[0, 0, 0]], sign="none")
        self.assertAlmostEqual(found.distance[0], 0.5)
        self.assertEqual(found.sign, "none")

    def test_no_points(self):
        self.assertEqual(medial.distance(*shapes.box(), np.empty((0, 3))).distance.shape, (0,))

    def test_points_come_after_a_whole_mesh(self):
        points = random_points(20)
        mesh = medial.Surface(*shapes.box())
        expected = medial.distance(*shapes.box(), points).distance
        for whole in (mesh, mesh.to_vtk()):
            np.testing.assert_array_equal(medial.distance(whole, points).distance, expected)
            np.testing.assert_array_equal(medial.distance(whole, points=points).distance, expected)

    def test_threads_do_not_change_a_bit(self):
        one, other = (medial.distance(*shapes.ball(3, 1.0), random_points(5000), threads=threads)
                      for threads in (1, 3))
        for a, b in zip(one[:5], other[:5]):
            np.testing.assert_array_equal(a, b)

    def test_several_processes(self):
        with multiprocessing.get_context("spawn").Pool(2) as pool:
            sums = pool.map(sum_of, range(4))
        np.testing.assert_allclose(sums, [shapes.box_distance(random_points(seed=seed)).sum()
                                          for seed in range(4)])

    def test_refusals(self):
        box = shapes.box()
        with self.assertRaisesRegex(TypeError, "points are missing"):
            medial.distance(*box)
        with self.assertRaisesRegex(TypeError, "points are missing"):
            medial.distance(medial.Surface(*box))
        with self.assertRaisesRegex(medial.InvalidInputError, r"points have the shape \(3,\)"):
            medial.distance(*box, [0, 0, 0])
        with self.assertRaisesRegex(medial.InvalidInputError, "point 1"):
            medial.distance(*box, [[0, 0, 0], [0, np.nan, 0]])
        with self.assertRaisesRegex(medial.InvalidInputError, "sign 'inside' is none of"):
            medial.distance(*box, [[0, 0, 0]], sign="inside")


if __name__ == "__main__":
    unittest.main()
