"""Compares medial.medial_axis() with known axes."""

import dataclasses
import unittest
import warnings

import medial
import numpy as np
import shapes
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkPolyData

RESOLUTION = 33


def box_axis(**parameters):
    return medial.medial_axis(*shapes.box(), **{"resolution": RESOLUTION, **parameters})


def imbalance(points):
    """Difference of the distances to the two nearest sides of the box: 0 on its axis."""
    depths = np.concatenate([shapes.HALF - points, shapes.HALF + points], axis=1)
    nearest = np.sort(depths, axis=1)
    return nearest[:, 1] - nearest[:, 0]


class Points(unittest.TestCase):
    def test_balls_touch_the_box_twice(self):
        axis = box_axis()
        voxel = 2.5 / RESOLUTION
        self.assertGreater(len(axis.points), 500)
        np.testing.assert_allclose(axis.radius, -shapes.box_distance(axis.points), atol=1e-5)
        self.assertLess(imbalance(axis.points).max(), voxel)
        for closest in (axis.closest_a, axis.closest_b):
            np.testing.assert_allclose(shapes.box_distance(closest), 0, atol=1e-5)
            distances = np.linalg.norm(closest - axis.points, axis=1)
            self.assertLess(np.abs(distances - axis.radius).max(), voxel)

    def test_separation_angle_and_lambda(self):
        axis = box_axis()
        directions = [closest - axis.points for closest in (axis.closest_a, axis.closest_b)]
        directions = [d / np.linalg.norm(d, axis=1, keepdims=True) for d in directions]
        cosine = np.clip(np.sum(directions[0] * directions[1], axis=1), -1, 1)
        np.testing.assert_allclose(axis.separation_angle, np.degrees(np.arccos(cosine)), atol=0.1)
        np.testing.assert_allclose(
            axis.lambda_, axis.radius * np.sin(np.radians(axis.separation_angle) / 2), rtol=1e-5)

    def test_types_and_shapes(self):
        axis = box_axis()
        n = len(axis.points)
        self.assertEqual((axis.points.dtype, axis.points.shape), (np.float64, (n, 3)))
        for name in ("radius", "separation_angle", "lambda_"):
            values = getattr(axis, name)
            self.assertEqual((values.dtype, values.shape), (np.float32, (n,)), name)
        self.assertEqual((axis.feature.dtype, axis.feature.shape), (np.uint8, (n,)))
        for name, corners in (("triangles", 3), ("quads", 4), ("lines", 2), ("vertices", 1)):
            cells = getattr(axis, name)
            self.assertEqual((cells.dtype, cells.shape[1]), (np.int64, corners), name)
        self.assertGreater(len(axis.quads), 0)
        self.assertLess(axis.quads.max(), n)
        self.assertEqual(len(axis.faces), 2 * len(axis.quads) + len(axis.triangles))

    def test_is_described_in_short(self):
        axis = box_axis(representation="faces")
        self.assertEqual(repr(axis), f"<MedialAxis of {len(axis.points)} points, 0 vertices, "
                                     f"0 lines, 0 triangles, {len(axis.quads)} quads; interior>")

    def test_middle_sheet_alone_has_separation_angles_of_180_degrees(self):
        axis = box_axis(angle=150)
        np.testing.assert_allclose(axis.points[:, 2], 0, atol=1e-6)
        # The sheet is 1 wide and 0.5 deep less: |x| <= 0.5, |y| <= 0.25.
        np.testing.assert_allclose(np.abs(axis.points).max(axis=0)[:2], [0.5, 0.25], atol=0.1)
        area = shapes.area(axis.points, axis.faces)
        self.assertAlmostEqual(area, 0.5, delta=0.08)


class Parameters(unittest.TestCase):
    def test_angle(self):
        self.assertLess(len(box_axis(angle=100).points), len(box_axis(angle=60).points))

    def test_lambda_and_radius_in_per_cent_of_the_diagonal(self):
        vertices, faces = shapes.box()
        diagonal = float(np.linalg.norm(np.ptp(vertices, axis=0)))
        stray = np.vstack([vertices, [[50.0, 0.0, 0.0]]])  # of no face, so outside the bounds
        for name in ("min_lambda", "min_radius"):
            share = medial.medial_axis(stray, faces, resolution=33, **{name: "10%"})
            units = medial.medial_axis(vertices, faces, resolution=33, **{name: 0.1 * diagonal})
            every = medial.medial_axis(vertices, faces, resolution=33)
            np.testing.assert_array_equal(share.points, units.points)
            self.assertLess(len(share.points), len(every.points))
            for wrong in ("x%", "%", "-1%"):
                with self.assertRaises(medial.InvalidInputError):
                    medial.medial_axis(vertices, faces, **{name: wrong})

    def test_least_radius_and_lambda(self):
        self.assertLess(box_axis().radius.min(), 0.2)
        self.assertGreaterEqual(box_axis(min_radius=0.3).radius.min(), 0.3 - 1e-6)
        self.assertGreaterEqual(box_axis(min_lambda=0.3).lambda_.min(), 0.3 - 0.05)

    def test_side(self):
        inside = box_axis()
        with self.assertWarnsRegex(UserWarning, "axis is empty"):
            outside = box_axis(side="exterior")
        self.assertEqual((inside.side, outside.side), ("interior", "exterior"))
        self.assertGreater(len(inside.points), 0)
        self.assertEqual(len(outside.points), 0)  # a box is convex
        self.assertEqual(outside.to_vtk().GetNumberOfPoints(), 0)

    def test_open_mesh_has_no_sides(self):
        vertices, quads = shapes.box()
        axis = medial.medial_axis(vertices, quads[3:], resolution=RESOLUTION)
        self.assertEqual((axis.side, axis.sign, axis.engine), ("both", "none", "processor"))

    def test_representations(self):
        points = box_axis(representation="points")
        self.assertEqual((points.representation, box_axis().representation), ("points", "surface"))
        self.assertEqual(len(points.vertices), len(points.points))
        self.assertEqual(len(points.faces), 0)
        faces = box_axis(representation="faces")
        self.assertGreater(len(faces.quads), 0)
        self.assertEqual(len(faces.triangles), 0)

    def test_compact_axis(self):
        axis = box_axis(max_spheres=30)
        self.assertLessEqual(len(axis.points), 30)
        self.assertGreater(len(axis.points), 10)
        self.assertGreater(len(axis.triangles), 10)
        self.assertLess(axis.triangles.max(), len(axis.points))
        np.testing.assert_array_equal(axis.faces, axis.triangles)

    def test_topology_of_a_ball_at_large_angles(self):
        vertices, faces = shapes.ball(2)
        kept = medial.medial_axis(vertices, faces, resolution=17, angle=175, topology="preserve")
        self.assertGreater(len(kept.points), 0)
        self.assertLess(np.linalg.norm(kept.points, axis=1).max(), 0.3)

    def test_field_of_the_same_run(self):
        self.assertIsNone(box_axis().field)
        field = box_axis(field=True, arrays=["closest_feature"]).field
        x, y, z = np.meshgrid(*field.axes(), indexing="ij")
        exact = shapes.box_distance(np.stack([x, y, z], axis=-1))
        np.testing.assert_allclose(field.distance, exact, atol=1e-3)
        self.assertIsNotNone(field.closest_feature)
        self.assertIsNone(field.closest_cell)

    def test_mesh_of_vtk(self):
        mesh = medial.Surface(*shapes.box()).to_vtk()
        axis = medial.medial_axis(mesh, resolution=RESOLUTION)
        np.testing.assert_array_equal(axis.points, box_axis().points)


class Warnings(unittest.TestCase):
    def assert_warns(self, message, *mesh, **parameters):
        with warnings.catch_warnings(record=True) as caught:
            warnings.simplefilter("always")
            axis = medial.medial_axis(*mesh, **{"resolution": RESOLUTION, **parameters})
        self.assertEqual(len(caught), 1)
        self.assertRegex(str(caught[0].message), message)
        self.assertEqual(caught[0].filename, __file__)
        return axis

    def test_side_that_cannot_be_had(self):
        vertices, quads = shapes.box()
        for side in ("interior", "exterior"):
            axis = self.assert_warns(f"both sides, not of side '{side}': .* does not define an inside",
                                     vertices, quads[3:], side=side)
            self.assertEqual(axis.side, "both")
        turned = np.concatenate([quads[:1, ::-1], quads[1:]])
        axis = medial.medial_axis(vertices, turned, side="interior", resolution=16)
        self.assertEqual(axis.side, "interior")
        self.assert_warns("sign method none was asked for", vertices, quads, side="interior",
                          sign="none")

    def test_empty_axis(self):
        axis = self.assert_warns("axis is empty: .* angle of 60 degrees and a lambda of 0.25 and a "
                                 "radius of 3 or more", *shapes.box(), min_lambda=0.25,
                                 min_radius=3)
        self.assertEqual(len(axis.points), 0)

    def test_nothing_to_tell(self):
        vertices, quads = shapes.box()
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            for side in ("interior", "both"):
                self.assertEqual(box_axis(side=side).side, side)
            for parameters in ({}, {"side": "both"}):
                axis = medial.medial_axis(vertices, quads[3:], resolution=RESOLUTION, **parameters)
                self.assertEqual(axis.side, "both")


class Vtk(unittest.TestCase):
    def test_is_the_output_of_the_filter(self):
        axis = box_axis()
        algorithm = medial.vtkMedialAxis()
        algorithm.SetInputData(medial.Surface(*shapes.box()).to_vtk())
        algorithm.SetResolution(RESOLUTION)
        algorithm.Update()
        expected, mesh = algorithm.GetOutput(), axis.to_vtk()
        self.assertIsInstance(mesh, vtkPolyData)
        for count in ("GetNumberOfPoints", "GetNumberOfVerts", "GetNumberOfLines",
                      "GetNumberOfPolys"):
            self.assertEqual(getattr(mesh, count)(), getattr(expected, count)(), count)
        names = [expected.GetPointData().GetArrayName(i)
                 for i in range(expected.GetPointData().GetNumberOfArrays())]
        self.assertGreaterEqual(len(names), 6)
        for name in names:
            np.testing.assert_array_equal(vtk_to_numpy(mesh.GetPointData().GetArray(name)),
                                          vtk_to_numpy(expected.GetPointData().GetArray(name)))
        self.assertEqual(mesh.GetPointData().GetScalars().GetName(), "Radius")
        self.assertTrue(np.shares_memory(vtk_to_numpy(mesh.GetPoints().GetData()), axis.points))

    def test_arrays_that_do_not_fit_are_refused(self):
        axis = box_axis(resolution=17)
        n = len(axis.points)
        for changes, message in (
                ({"radius": axis.radius[1:]}, rf"radius has the shape \({n - 1},\), not \({n},\)"),
                ({"triangles": axis.triangles + n}, rf"triangles name the vertex \d+, .* {n},"),
                ({"points": axis.points[:, :2]}, r"points have the shape")):
            with self.assertRaisesRegex(ValueError, message):
                dataclasses.replace(axis, **changes).to_vtk()


if __name__ == "__main__":
    unittest.main()
