"""Meshes and scans from files, and scans from arrays."""

import math
import pathlib
import tempfile
import unittest

import medial
import numpy as np
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkFiltersSources import vtkCubeSource
from vtkmodules.vtkIOGeometry import vtkSTLWriter
from vtkmodules.vtkIOXML import vtkXMLPolyDataWriter

# Turned by 90 degrees about z, with thicker slices.
AFFINE = np.array([[0, -0.5, 0, 3], [0.5, 0, 0, -4], [0, 0, 1, 5], [0, 0, 0, 1.0]])
SIZE = (40, 41, 22)
CENTRE = AFFINE[:3, :3] @ (20, 20.5, 11) + AFFINE[:3, 3]
RADIUS = 8


def distances():
    """From the voxels of an image to a point, in world units."""
    voxels = np.moveaxis(np.indices(SIZE), 0, -1)
    return np.linalg.norm(voxels @ AFFINE[:3, :3].T + AFFINE[:3, 3] - CENTRE, axis=-1)


def volume(surface):
    """Of a closed surface; negative where it is inside out."""
    a, b, c = np.moveaxis(surface.vertices[surface.faces], 1, 0)
    return np.einsum("ij,ij->", a, np.cross(b, c)) / 6


def nrrd(values):
    """An image as text."""
    axes = " ".join(f"({','.join(map(str, column))})" for column in AFFINE[:3, :3].T.tolist())
    return (f"NRRD0004\ntype: {'uchar' if values.dtype == np.uint8 else 'float'}\ndimension: 3\n"
            f"space: left-posterior-superior\nsizes: {values.shape[0]} {values.shape[1]} {values.shape[2]}\n"
            f"space directions: {axes}\nspace origin: ({','.join(map(str, AFFINE[:3, 3].tolist()))})\n"
            f"encoding: ascii\n\n" + " ".join(map(str, values.ravel(order="F").tolist())))


class Scans(unittest.TestCase):
    def setUp(self):
        self.labels = np.where(distances() < RADIUS, 3, 0).astype(np.uint8)

    def assert_ball(self, surface, tolerance):
        distance = np.linalg.norm(surface.vertices - CENTRE, axis=1)
        self.assertLess(abs(distance - RADIUS).max(), tolerance)
        self.assertLess(abs(volume(surface) / (4 / 3 * math.pi * RADIUS ** 3) - 1), 0.02)

    def test_label_of_an_array(self):
        smooth = medial.scan_surface(self.labels, AFFINE, label=3)
        self.assert_ball(smooth, 0.6)
        steps = medial.scan_surface(self.labels, AFFINE, label=3, smoothing=0)
        self.assertEqual(len(steps.faces), len(smooth.faces))
        self.assertGreater(abs(steps.vertices - smooth.vertices).max(), 0.1)

    def test_isovalue_of_an_array(self):
        self.assert_ball(medial.scan_surface(distances(), AFFINE, isovalue=RADIUS), 0.03)
        self.assert_ball(medial.scan_surface(-distances(), AFFINE[:3], isovalue=-RADIUS), 0.03)

    def test_mirrored_axes_leave_the_inside_inside(self):
        mirrored = medial.scan_surface(self.labels[::-1], AFFINE @ [[-1, 0, 0, SIZE[0] - 1], [0, 1, 0, 0],
                                                                    [0, 0, 1, 0], [0, 0, 0, 1]], label=3)
        self.assert_ball(mirrored, 0.6)

    def test_without_affine_units_are_indices(self):
        block = np.zeros((7, 5, 3))
        block[2:5, 1:4, 1] = 1
        surface = medial.scan_surface(block, label=1, smoothing=0)
        self.assertEqual(surface.vertices.min(axis=0).tolist(), [1.5, 0.5, 0.5])
        self.assertEqual(surface.vertices.max(axis=0).tolist(), [4.5, 3.5, 1.5])

    def test_types_and_layouts_make_no_difference(self):
        expected = medial.scan_surface(self.labels, AFFINE, label=3)
        for values in (self.labels.astype(">i2"), self.labels.astype("<f8"), self.labels.astype(np.float16),
                       self.labels.astype(np.uint64), np.asfortranarray(self.labels), self.labels.tolist()):
            surface = medial.scan_surface(values, AFFINE, label=3)
            np.testing.assert_array_equal(surface.vertices, expected.vertices)
            np.testing.assert_array_equal(surface.faces, expected.faces)
        surface = medial.scan_surface(self.labels == 3, AFFINE, label=1)
        np.testing.assert_array_equal(surface.vertices, expected.vertices)

    def test_nan_is_outside_and_stays_in_the_array(self):
        for sign in 1, -1:  # dark and bright inside
            values = np.where(distances() < RADIUS + 2, sign * distances(), math.nan)
            before = values.copy(order="K")
            self.assert_ball(medial.scan_surface(values, AFFINE, isovalue=sign * RADIUS), 0.03)
            np.testing.assert_array_equal(values, before)

    def test_closed_at_the_border(self):
        half = medial.scan_surface(self.labels[20:], AFFINE, label=3)
        self.assertLess(abs(volume(half) / (2 / 3 * math.pi * RADIUS ** 3) - 1), 0.05)

    def test_files_are_the_same_as_arrays(self):
        grey = distances().astype(np.float32)
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder, "a.nrrd")
            for values, wanted in ((self.labels, {"label": 3}), (self.labels, {"label": 3, "smoothing": 5}),
                                   (grey, {"isovalue": 7.5})):
                path.write_text(nrrd(values))
                read = medial.read_scan(path, **wanted)
                expected = medial.scan_surface(values, AFFINE, **wanted)
                np.testing.assert_array_equal(read.vertices, expected.vertices)
                np.testing.assert_array_equal(read.faces, expected.faces)
            path.write_text(nrrd(self.labels)[:-40])
            with self.assertRaisesRegex(medial.InvalidInputError, f"{path}: ends early"):
                medial.read_scan(str(path), label=3)
            path.write_text(nrrd(self.labels))
            with self.assertRaisesRegex(medial.InvalidInputError,
                                        f"{path}: has no voxel with the label 4; those that occur: 0, 3"):
                medial.read_scan(path, label=4)
            path = path.rename(path.with_suffix(".dcm"))
            with self.assertRaisesRegex(medial.InvalidInputError, "extension '.dcm', allowed: .nrrd .mha"):
                medial.read_scan(path, label=3)
        with self.assertRaisesRegex(medial.InvalidInputError, "absent.nii: no such file"):
            medial.read_scan("absent.nii", label=1)

    def test_refusals(self):
        surface = medial.scan_surface
        for message, arguments, options in (
                ("either an isovalue or a label", (self.labels,), {}),
                ("either an isovalue or a label", (self.labels,), {"label": 3, "isovalue": 1}),
                ("no voxel with the label 4; those that occur: 0, 3", (self.labels,), {"label": 4}),
                (r"isovalue 9: its values are in \[0, 3\]", (self.labels,), {"isovalue": 9}),
                (r"isovalue nan is outside \(-inf, inf\)", (self.labels,), {"isovalue": math.nan}),
                (r"smoothing 1001 is outside \[0, 1000\]", (self.labels,), {"label": 3, "smoothing": 1001}),
                ("label 9223372036854775808 is outside", (self.labels,), {"label": 2**63}),
                (r"shape \(40, 41\), not \(nx, ny, nz\)", (self.labels[:, :, 0],), {"label": 3}),
                (r"shape \(0, 41, 22\), not", (self.labels[:0],), {"label": 3}),
                ("of type complex128, not numbers", (self.labels + 1j,), {"label": 3}),
                (r"affine has the shape \(3, 3\), not \(4, 4\)", (self.labels, np.eye(3)), {"label": 3}),
                ("last row of affine is", (self.labels, np.ones((4, 4))), {"label": 3}),
                ("span no volume", (self.labels, np.diag([1, 1, 0, 1])), {"label": 3}),
                ("span no volume", (self.labels, np.diag([1, 1, math.inf, 1])), {"label": 3}),
                ("affine is no matrix", (self.labels, "LPS"), {"label": 3})):
            with self.subTest(message), self.assertRaisesRegex(medial.InvalidInputError, message):
                surface(*arguments, **options)
        with self.assertRaisesRegex(TypeError, "label 1.5 is not an integer"):
            surface(self.labels, label=1.5)
        with self.assertRaisesRegex(TypeError, "isovalue '1' is not a number"):
            surface(self.labels, isovalue="1")


class Files(unittest.TestCase):
    def test_version_is_that_of_the_library(self):
        self.assertRegex(medial.__version__, r"\A\d+\.\d+\.\d+\Z")

    def test_mesh_is_read_exactly_or_refused(self):
        text = "OFF\n4 2 0\n0 0 0\n1 0 0\n1 0.1 0\n0 1 0\n3 0 1 2\n3 0 2 3\n"
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder, "two.off")
            path.write_text(text)
            surface = medial.read_mesh(path)
            self.assertEqual(surface.vertices.tolist(),
                             [[0, 0, 0], [1, 0, 0], [1, 0.1, 0], [0, 1, 0]])
            self.assertEqual(surface.faces.tolist(), [[0, 1, 2], [0, 2, 3]])
            path.write_text(text[:-4])
            with self.assertRaisesRegex(medial.InvalidInputError, "two.off"):
                medial.read_mesh(str(path))
        for absent in ("absent.off", "absent.step"):
            with self.assertRaisesRegex(medial.InvalidInputError, absent):
                medial.read_mesh(absent)


class FilesOfVtk(unittest.TestCase):
    """Those that VTK writes."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.path = pathlib.Path(folder.name, "box.stl")
        cube = vtkCubeSource()
        cube.Update()
        self.box = medial.read_mesh(self.write(vtkXMLPolyDataWriter(), cube.GetOutput(), "box.vtp"))

    def write(self, writer, mesh, name):
        path = self.path.with_name(name)
        writer.SetInputData(mesh)
        writer.SetFileName(str(path))
        medial.update(writer)
        return path

    def assert_refused(self, content, message, suffix=".stl"):
        path = self.path.with_suffix(suffix)
        path.write_bytes(content)
        with self.assertRaisesRegex(medial.InvalidInputError, f"{path}: {message}"):
            medial.read_mesh(path)

    def test_vtp_is_welded_and_of_triangles(self):
        self.assertEqual((self.box.vertices.shape, self.box.faces.shape), ((8, 3), (12, 3)))
        self.assertEqual(sorted(self.box.vertices.tolist()),
                         [[x, y, z] for x in (-.5, .5) for y in (-.5, .5) for z in (-.5, .5)])

    def test_stl(self):
        for name, file_type in (("text.stl", 1), ("binary.STL", 2)):
            writer = vtkSTLWriter()
            writer.SetFileType(file_type)
            read = medial.read_mesh(self.write(writer, self.box.to_vtk(), name))
            self.assertEqual(sorted(read.vertices.tolist()), sorted(self.box.vertices.tolist()))
            self.assertEqual(read.vertices[read.faces].tolist(),
                             self.box.vertices[self.box.faces].tolist())

    def test_stl_that_was_cut_short(self):
        writer = vtkSTLWriter()
        writer.SetFileTypeToBinary()
        content = self.write(writer, self.box.to_vtk(), "whole.stl").read_bytes()
        for size in (5, 84, 400, len(content) - 1):
            self.assert_refused(content[:size], rf"not a complete STL file: .* bytes, not {size}\Z")
        self.assert_refused(b"", "the file is empty")
        self.assert_refused(content[:400], ".* the 12 triangles of a binary one would take 684 bytes")
        self.assert_refused(content + b"x", ".* 684 bytes, not 685")
        self.assert_refused(bytes(84), "has 0 triangles")

    def test_text_stl_that_is_damaged(self):
        facet = "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\n" \
                "endloop\nendfacet\n"
        text = f"solid a part\n{facet}endsolid a part\n".encode()
        self.path.write_bytes(text + text)  # two solids
        self.assertEqual(len(medial.read_mesh(self.path).faces), 2)
        self.assert_refused(text.replace(b"endsolid a part\n", b""), "ends early: its last solid has no 'endsolid'")
        self.assert_refused(text[:60], "line 5: 'vert' in place of vertex")
        self.assert_refused(text + b"more", "line 10: 'more' in place of solid")
        self.assert_refused(text.replace(b"1 0 0", b"1 O 0"), "line 5: 'o' in place of a coordinate")
        self.path.write_bytes(text.replace(b"1 0 0", b"1e99 0 0"))
        with self.assertRaisesRegex(medial.InvalidInputError, "point 1 .*not finite"):
            medial.read_mesh(self.path)

    def test_vtp_that_was_cut_short(self):
        content = self.path.with_name("box.vtp").read_bytes()
        self.assert_refused(b"", "the file is empty", suffix=".vtp")
        for size in range(10, len(content) - 12, len(content) // 20):
            self.assert_refused(content[:size], ".", suffix=".vtp")
        self.assert_refused(b"<VTKFile type='ImageData'></VTKFile>", "not a VTK file of polygonal", suffix=".vtp")

    def test_vtp_that_contradicts_itself(self):
        writer = vtkXMLPolyDataWriter()
        writer.SetDataModeToAscii()
        content = self.write(writer, self.box.to_vtk(), "text.vtp").read_bytes()
        for old, new, message in (
                (b'NumberOfPoints="8"', b'NumberOfPoints="9"', "array 'Points' has 24 numbers"),
                (b'NumberOfPolys="12"', b'NumberOfPolys="13"', "NumberOfPolys is 13, but there are 12 offsets"),
                (b'NumberOfPoints="8"', b'NumberOfPoints="-8"', "NumberOfPoints is '-8'")):
            self.assertIn(old, content)
            self.assert_refused(content.replace(old, new), message, suffix=".vtp")

    def test_vtp_without_faces(self):
        self.write(vtkXMLPolyDataWriter(), vtkPolyData(), "box.vtp")
        with self.assertRaisesRegex(medial.InvalidInputError, "box.vtp: holds no faces, lines or vertices"):
            medial.read_mesh(self.path.with_suffix(".vtp"))

    def test_what_may_be_read(self):
        self.path.with_suffix(".step").touch()
        with self.assertRaisesRegex(medial.InvalidInputError,
                                    "'.step', allowed: .stl .obj .ply .off .vtp .vtk"):
            medial.read_mesh(self.path.with_suffix(".step"))



if __name__ == "__main__":
    unittest.main()
