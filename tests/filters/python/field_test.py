"""Compares medial.distance_field() with exact distances."""

import dataclasses
import gc
import unittest

import medial
import numpy as np
import shapes
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkFiltersCore import vtkAppendPolyData
from vtkmodules.vtkFiltersSources import vtkCubeSource


def samples(field):
    """World coordinates of all grid points, (nx, ny, nz, 3)."""
    return np.stack(np.meshgrid(*field.axes(), indexing="ij"), axis=-1)


class Values(unittest.TestCase):
    def assert_is_of_the_box(self, field):
        exact = shapes.box_distance(samples(field))
        np.testing.assert_allclose(field.distance, exact, atol=1e-2 * field.spacing.min())

    def test_distances_are_those_of_the_box(self):
        field = medial.distance_field(*shapes.box(), resolution=33)
        self.assertEqual(field.distance.dtype, np.float32)
        self.assertEqual(field.distance.shape[0], 33)
        self.assertEqual(len(set(field.distance.shape)), 3)
        self.assertEqual(field.sign, "winding")
        self.assertEqual((field.engine, field.renderer), ("processor", ""))
        self.assert_is_of_the_box(field)

    def test_is_described_in_short(self):
        field = medial.distance_field(*shapes.box(), resolution=9)
        self.assertEqual(repr(field), "<DistanceField of 9 x 8 x 6 grid points, sign winding>")

    def test_padding_is_a_share_of_the_diagonal(self):
        field = medial.distance_field(*shapes.box(), resolution=33, padding=0.5)
        margin = -field.origin - shapes.HALF
        self.assertTrue(np.all(margin > 0.5 * 2 * np.linalg.norm(shapes.HALF) - 1e-9))
        self.assert_is_of_the_box(field)

    def test_resolution_and_padding_have_defaults(self):
        distance = medial.distance_field(*shapes.box()).distance
        stated = medial.distance_field(*shapes.box(), resolution=256, padding=0.05).distance
        np.testing.assert_array_equal(distance, stated)

    def test_spacing_may_differ_by_axis(self):
        field = medial.distance_field(*shapes.box(), spacing=(0.1, 0.2, 0.15))
        np.testing.assert_array_equal(field.spacing, [0.1, 0.2, 0.15])
        self.assert_is_of_the_box(field)
        np.testing.assert_array_equal(
            medial.distance_field(*shapes.box(), spacing=0.25).spacing, [0.25] * 3)

    def test_explicit_grid(self):
        field = medial.distance_field(*shapes.box(), origin=(-0.5, 0, 1), spacing=0.125,
                                      dimensions=(4, 5, 6))
        self.assertEqual(field.distance.shape, (4, 5, 6))
        np.testing.assert_array_equal(field.origin, [-0.5, 0, 1])
        np.testing.assert_array_equal(field.axes()[2], 1 + 0.125 * np.arange(6))
        self.assert_is_of_the_box(field)

    def test_unsigned(self):
        field = medial.distance_field(*shapes.box(), resolution=17, sign="none")
        self.assertEqual(field.sign, "none")
        exact = np.abs(shapes.box_distance(samples(field)))
        np.testing.assert_allclose(field.distance, exact, atol=1e-4)

    def test_engines_agree(self):
        fields = [medial.distance_field(*shapes.box(), resolution=17, engine=engine)
                  for engine in ("device", "rasteriser", "processor")]
        for field in fields:
            self.assert_is_of_the_box(field)
        self.assertEqual([field.engine for field in fields], ["device", "rasteriser", "processor"])
        self.assertNotEqual(fields[0].renderer, "")

    def test_what_is_closest(self):
        vertices, quads = shapes.box()
        field = medial.distance_field(vertices, quads, resolution=17, arrays=(
            "closest_point", "closest_cell", "closest_feature", "closest_site"))
        to_closest = np.linalg.norm(field.closest_point - samples(field), axis=-1)
        np.testing.assert_allclose(to_closest, np.abs(field.distance), atol=1e-5)
        # Quads are planar: the closest point is in the plane of the closest one.
        corner = vertices[quads[field.closest_cell, 0]]
        normals = np.array([[-1, 0, 0], [1, 0, 0], [0, -1, 0], [0, 1, 0], [0, 0, -1], [0, 0, 1]])
        depth = np.sum((field.closest_point - corner) * normals[field.closest_cell], axis=-1)
        np.testing.assert_allclose(depth, 0.0, atol=1e-5)
        # Outside, what the closest point lies on follows from how many coordinates are beyond.
        beyond = np.sum(np.abs(samples(field)) > shapes.HALF + 1e-6, axis=-1)
        for feature, count in ((0, 3), (1, 2)):
            np.testing.assert_array_equal(field.closest_feature[beyond == count], feature)
        # Two triangles a quad, 18 edges, 8 vertices.
        self.assertLess(field.closest_site.max(), 12 + 18 + 8)
        np.testing.assert_array_equal(field.closest_site[beyond == 3] >= 12 + 18, True)

    def test_arrays_that_are_not_wanted_are_none(self):
        field = medial.distance_field(*shapes.box(), resolution=9, arrays="closest_cell")
        self.assertIsNotNone(field.closest_cell)
        self.assertIsNone(field.closest_point)
        self.assertIsNone(field.closest_feature)
        self.assertIsNone(field.closest_site)

    def test_points_and_segments(self):
        grid = dict(origin=(0, 0, 0), spacing=1, dimensions=(1, 1, 3))
        points = medial.distance_field([[0, 0, 5], [3, 0, 0]], [[0], [1]], **grid)
        np.testing.assert_allclose(points.distance.ravel(), [3, np.sqrt(10), 3], rtol=1e-6)
        segment = medial.distance_field([[-9, 2, 0], [9, 2, 0]], [[0, 1]], **grid)
        np.testing.assert_allclose(segment.distance.ravel(), [2, np.sqrt(5), np.sqrt(8)], rtol=1e-6)


class Meshes(unittest.TestCase):
    """Whatever form the box has, its field is the same."""

    def setUp(self):
        self.vertices, self.quads = shapes.box()
        self.expected = medial.distance_field(self.vertices, self.quads, resolution=17).distance

    def assert_same(self, *mesh):
        field = medial.distance_field(*mesh, resolution=17)
        np.testing.assert_allclose(field.distance, self.expected, atol=1e-6)
        return field

    def test_types_and_layouts(self):
        self.assert_same(self.vertices.tolist(), self.quads.tolist())
        self.assert_same(self.vertices.astype(np.float32), self.quads.astype(np.uint8))
        self.assert_same(np.asfortranarray(self.vertices), np.asfortranarray(self.quads))
        self.assert_same(np.repeat(self.vertices, 2, axis=0)[::2], self.quads.astype(np.int32))
        constant = self.vertices.copy()
        constant.flags.writeable = False
        self.assert_same(constant, self.quads)

    def test_faces_of_different_sizes(self):
        quads = self.quads.tolist()
        first = quads.pop(0)
        self.assert_same(self.vertices, [first[:3], [first[0], *first[2:]], *quads])

    def test_polydata(self):
        cube = vtkCubeSource()
        cube.SetXLength(2.0)
        cube.SetYLength(1.5)
        cube.SetZLength(1.0)
        cube.Update()
        self.assert_same(cube.GetOutput())
        self.assertEqual(cube.GetOutput().GetPointData().GetNumberOfArrays(), 2)

    def test_subclass_of_polydata(self):
        class PolyData(vtkPolyData):
            """A subclass of vtkPolyData, as pyvista's class is."""

        mesh = PolyData()
        mesh.ShallowCopy(medial.Surface(self.vertices, self.quads).to_vtk())
        self.assert_same(mesh)

    def test_object_with_vertices_and_faces(self):
        class Mesh:
            vertices = self.vertices
            faces = self.quads

        self.assert_same(Mesh())
        self.assert_same(medial.Surface(self.vertices, self.quads))


class Memory(unittest.TestCase):
    def test_vertices_are_not_copied(self):
        vertices, quads = shapes.box()
        for values in (vertices, vertices.astype(np.float32)):
            polydata = medial.Surface(values, quads).to_vtk()
            self.assertTrue(
                np.shares_memory(vtk_to_numpy(polydata.GetPoints().GetData()), values))

    def test_arrays_live_without_what_they_came_from(self):
        field = medial.distance_field(*shapes.box(), resolution=33)
        expected, distance = field.distance.copy(), field.distance
        del field
        gc.collect()
        np.testing.assert_array_equal(distance, expected)

    def test_vtk_object_keeps_the_arrays_alive(self):
        def surface():
            vertices, faces = shapes.ball(4)
            return medial.Surface(vertices, faces).to_vtk(), faces.copy()

        polydata, faces = surface()
        gc.collect()
        # Takes any memory that was set free, whatever its size.
        scratch = [np.full_like(faces, -1) for _ in range(10)]
        scratch += [np.full(len(faces) + 1, -1) for _ in range(10)]
        radii = np.linalg.norm(vtk_to_numpy(polydata.GetPoints().GetData()), axis=1)
        np.testing.assert_allclose(radii, 1.0)
        cells = polydata.GetPolys()
        np.testing.assert_array_equal(vtk_to_numpy(cells.GetConnectivityArray()), faces.ravel())
        np.testing.assert_array_equal(vtk_to_numpy(cells.GetOffsetsArray()),
                                      3 * np.arange(len(faces) + 1))
        self.assertEqual(len(scratch), 20)

    def test_image_has_the_samples_where_they_belong(self):
        field = medial.distance_field(*shapes.box(), resolution=17, arrays=["closest_point"])
        image = field.to_vtk()
        self.assertEqual(image.GetDimensions(), field.distance.shape)
        self.assertTrue(np.shares_memory(
            vtk_to_numpy(image.GetPointData().GetArray("Distance")), field.distance))
        index = image.FindPoint(0.9, -0.7, 0.1)
        point = np.array(image.GetPoint(index))
        distance = image.GetPointData().GetScalars().GetTuple1(index)
        self.assertAlmostEqual(distance, shapes.box_distance(point), places=5)
        closest = np.array(image.GetPointData().GetArray("ClosestPoint").GetTuple3(index))
        self.assertAlmostEqual(np.linalg.norm(closest - point), abs(distance), places=5)

    def test_image_of_arrays_that_do_not_fit(self):
        field = medial.distance_field(*shapes.box(), resolution=9,
                                      arrays=["closest_point", "closest_cell"])
        for change, message in (
                ({"distance": field.distance[:-1]}, "closest_point has the shape"),
                ({"closest_cell": field.closest_cell[:, 1:]}, "closest_cell has the shape"),
                ({"closest_point": field.closest_point[..., :2]}, "closest_point has the shape"),
                ({"closest_point": field.distance}, "closest_point has the shape"),
                ({"distance": field.distance.ravel()}, r"distance .* not \(nx, ny, nz\)"),
                ({"origin": field.origin[:2]}, r"origin has the shape \(2,\), not \(3,\)")):
            with self.assertRaisesRegex(medial.InvalidInputError, message):
                dataclasses.replace(field, **change).to_vtk()
        part = dataclasses.replace(field, distance=field.distance[2:7], closest_point=None,
                                   closest_cell=field.closest_cell[2:7]).to_vtk()
        values = vtk_to_numpy(part.GetPointData().GetArray("ClosestCell"))
        np.testing.assert_array_equal(values.reshape(part.GetDimensions(), order="F"),
                                      field.closest_cell[2:7])

    def test_mesh_of_the_caller_stays_as_it_is(self):
        append = vtkAppendPolyData()
        append.AddInputData(medial.Surface(*shapes.box()).to_vtk())
        append.Update()
        mesh = append.GetOutput()
        time = mesh.GetMTime()
        medial.distance_field(mesh, resolution=9)
        self.assertEqual(mesh.GetMTime(), time)


if __name__ == "__main__":
    unittest.main()
