"""The filters from Python, together with VTK's own package."""

import math
import pathlib
import tempfile
import unittest

import medial
from vtkmodules.vtkCommonCore import vtkObject
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkPolyData
from vtkmodules.vtkFiltersCore import vtkContourFilter, vtkMassProperties, vtkTriangleFilter
from vtkmodules.vtkFiltersModeling import vtkLinearSubdivisionFilter
from vtkmodules.vtkFiltersSources import vtkCubeSource
from vtkmodules.vtkIOGeometry import vtkSTLWriter
from vtkmodules.vtkIOXML import vtkXMLPolyDataWriter


def box_axis(resolution=17):
    """An axis filter on a box of 2 x 1.5 x 1, not executed yet."""
    cube = vtkCubeSource()
    cube.SetXLength(2.0)
    cube.SetYLength(1.5)
    cube.SetZLength(1.0)
    axis = medial.vtkMedialAxis()
    axis.SetInputConnection(cube.GetOutputPort())
    axis.SetResolution(resolution)
    return axis


def figure(output, name):
    """The first value of a field data array."""
    return output.GetFieldData().GetAbstractArray(name).GetValue(0)


class FiltersTest(unittest.TestCase):
    def test_package_holds_the_filters(self):
        self.assertEqual({name for name in medial.__all__ if name.startswith("vtk")},
                         {"vtkDistributedFieldAlgorithm", "vtkMedialAxis", "vtkMedialCurves", "vtkMedialLocalThickness", "vtkMedialReconstruction",
                          "vtkMedialPolyDataAlgorithm", "vtkMedialSkeleton", "vtkMedialThickness",
                          "vtkMeshDistanceField", "vtkMeshFieldAlgorithm",
                          "vtkMeshPointDistance", "vtkMeshProximity"})
        from medial.vtkMedialFilters import vtkMedialAxis
        self.assertIs(medial.vtkMedialAxis, vtkMedialAxis)
        self.assertTrue(issubclass(medial.vtkMedialAxis, vtkObject))

    def test_manual_is_in_the_doc_strings(self):
        self.assertIn("separation angle", medial.vtkMedialAxis.__doc__)
        self.assertIn("Default is 60", medial.vtkMedialAxis.SetAngle.__doc__)
        self.assertIn("[2, 8192]", medial.vtkMeshDistanceField.SetResolution.__doc__)
        side = " ".join(medial.vtkMedialThickness.SetSide.__doc__.split()) # VTK wraps lines anew
        self.assertIn("Default is INTERIOR", side)
        self.assertIn("AxisFeature", medial.vtkMedialAxis.__doc__)

    def test_parameters_of_several_filters(self):
        for filter_, angle in ((medial.vtkMedialAxis(), 75.0), (medial.vtkMedialThickness(), 30.0)):
            filter_.SetAngle(angle)
            filter_.SetSideToExterior()
            filter_.SetNumberOfThreads(2)
            self.assertEqual((filter_.GetAngle(), filter_.GetSide(), filter_.GetNumberOfThreads()),
                             (angle, filter_.EXTERIOR, 2))
            self.assertEqual(filter_.GetSideAsString(), "Exterior")
            self.assertEqual((filter_.INTERIOR, filter_.EXTERIOR, filter_.BOTH), (0, 1, 2))

    def test_superclass_is_abstract(self):
        for superclass in (medial.vtkMeshFieldAlgorithm, medial.vtkMedialPolyDataAlgorithm):
            with self.assertRaises(TypeError):
                superclass()

    def test_distance_field_of_a_cube(self):
        cube = vtkCubeSource()
        field = medial.vtkMeshDistanceField()
        field.SetInputConnection(cube.GetOutputPort())
        field.SetGridModeToExplicit()
        field.SetOrigin(0.0, 0.0, 0.0)
        field.SetSpacing(0.25, 0.25, 0.25)
        field.SetDimensions(5, 5, 5)
        field.Update()
        image = field.GetOutput()
        self.assertIsInstance(image, vtkImageData)
        self.assertEqual(image.GetDimensions(), (5, 5, 5))
        # vtkCubeSource does not share points between its faces, but they weld to a closed box.
        self.assertEqual(figure(image, "Closed"), 1)
        self.assertEqual(figure(image, "SignMethod"), "Winding")
        distance = image.GetPointData().GetArray("Distance")
        self.assertAlmostEqual(distance.GetValue(0), -0.5, places=4)
        self.assertAlmostEqual(distance.GetValue(124), math.sqrt(0.75), places=4)

    def test_curves_of_a_box(self):
        axis = box_axis()
        curves = medial.vtkMedialCurves()
        curves.SetInputConnection(axis.GetOutputPort())
        curves.RimsOff()
        curves.Update()
        output = curves.GetOutput()
        self.assertGreater(output.GetNumberOfLines(), 0)
        kinds = output.GetCellData().GetArray("AxisFeature")
        self.assertEqual({kinds.GetValue(i) for i in range(output.GetNumberOfCells())}, {2})
        self.assertIsNotNone(output.GetPointData().GetArray("Radius"))

    def test_axis_of_a_box(self):
        axis = box_axis()
        axis.Update()
        output = axis.GetOutput()
        self.assertIsInstance(output, vtkPolyData)
        self.assertGreater(output.GetNumberOfCells(), 100)
        radius = output.GetPointData().GetArray("Radius")
        self.assertAlmostEqual(radius.GetRange()[1], 0.5, delta=0.02)
        self.assertEqual(figure(output, "Side"), "Interior")
        self.assertEqual(figure(output, "Engine"), "Processor")
        self.assertGreater(figure(output, "GridSpacing"), 0.0)

    def test_axis_of_few_spheres(self):
        axis = box_axis(33)
        axis.SetMaximumNumberOfSpheres(30)
        axis.Update()
        self.assertLessEqual(axis.GetOutput().GetNumberOfPoints(), 30)
        self.assertGreater(axis.GetOutput().GetNumberOfPoints(), 10)
        radius = axis.GetOutput().GetPointData().GetArray("Radius")
        self.assertAlmostEqual(radius.GetRange()[1], 0.5, delta=0.03)

    def test_thickness_of_a_box(self):
        cube = vtkCubeSource()
        cube.SetXLength(2.0)
        cube.SetZLength(0.5)
        triangles = vtkTriangleFilter()
        triangles.SetInputConnection(cube.GetOutputPort())
        fine = vtkLinearSubdivisionFilter()
        fine.SetInputConnection(triangles.GetOutputPort())
        fine.SetNumberOfSubdivisions(3)
        thickness = medial.vtkMedialThickness()
        thickness.SetInputConnection(fine.GetOutputPort())
        thickness.Update()
        output = thickness.GetOutput()
        values = output.GetPointData().GetArray("Thickness")
        middle = output.FindPoint(0.0, 0.0, 0.25)
        self.assertAlmostEqual(values.GetValue(middle), 0.5, places=5)
        self.assertEqual(figure(output, "MinThickness"), 0.0)
        thickness.SetSideToExterior()
        thickness.Update()
        self.assertEqual(figure(thickness.GetOutput(), "ShareWithout"), 1.0)

    def test_topology_of_a_box(self):
        axis = box_axis()
        self.assertEqual(axis.GetTopologyAsString(), "Selected")
        axis.SetTopologyToPreserve()
        self.assertEqual(axis.GetTopology(), axis.PRESERVE)
        axis.Update()
        self.assertEqual(axis.GetErrorCode(), 0)
        self.assertGreater(axis.GetOutput().GetNumberOfCells(), 100)
        self.assertIn("Topology: Preserve", str(axis))

    def test_second_output(self):
        axis = box_axis()
        axis.GenerateDistanceFieldOn()
        contour = vtkContourFilter()
        contour.SetInputConnection(axis.GetOutputPort(1))
        contour.SetValue(0, -0.2)
        contour.Update()
        self.assertGreater(contour.GetOutput().GetNumberOfCells(), 0)
        self.assertEqual(axis.GetDistanceField().GetDimensions()[0], 17)

    def test_error_has_a_code_and_a_message(self):
        axis = box_axis()
        messages = []

        def on_error(_caller, _event, text):
            messages.append(text)

        on_error.CallDataType = "string0"
        axis.AddObserver("ErrorEvent", on_error)
        axis.GetExecutive().AddObserver("ErrorEvent", lambda *_: None)
        axis.SetAngle(180.0)
        axis.Update()
        self.assertEqual(axis.GetErrorCode(), axis.InvalidInputError)
        self.assertEqual(len(messages), 1)
        self.assertIn("180", messages[0])

    def test_progress_and_abort(self):
        axis = box_axis()
        fractions = []

        def on_progress(caller, _event):
            fractions.append(caller.GetProgress())
            caller.SetAbortExecute(1)

        tag = axis.AddObserver("ProgressEvent", on_progress)
        axis.GetExecutive().AddObserver("ErrorEvent", lambda *_: None)
        axis.Update()
        self.assertTrue(fractions)
        self.assertEqual(axis.GetErrorCode(), axis.CancelledError)
        self.assertEqual(axis.GetOutput().GetNumberOfPoints(), 0)
        axis.RemoveObserver(tag)
        axis.Update()
        self.assertGreater(axis.GetOutput().GetNumberOfPoints(), 0)

    def test_reconstruction_of_a_box(self):
        axis = box_axis(33)
        axis.SetAngle(30.0)
        surface = medial.vtkMedialReconstruction()
        surface.SetInputConnection(axis.GetOutputPort())
        surface.SetResolution(48)
        surface.Update()
        properties = vtkMassProperties()
        properties.SetInputData(surface.GetOutput())
        self.assertAlmostEqual(properties.GetVolume(), 3.0, delta=0.15)
        self.assertIn("Default is 128", medial.vtkMedialReconstruction.SetResolution.__doc__)

    def test_reconstruction_needs_radii(self):
        cube = vtkCubeSource()
        surface = medial.vtkMedialReconstruction()
        surface.SetInputConnection(cube.GetOutputPort())
        messages = []

        def on_error(_caller, _event, text):
            messages.append(text)

        on_error.CallDataType = "string0"
        surface.AddObserver("ErrorEvent", on_error)
        surface.GetExecutive().AddObserver("ErrorEvent", lambda *_: None)
        surface.Update()
        self.assertEqual(len(messages), 1)
        self.assertIn("no point data array Radius", messages[0])

    def test_prints(self):
        self.assertIn("Angle: 60", str(medial.vtkMedialAxis()))


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
        for size in (0, 100, len(content) // 2, len(content) - 3):
            self.assert_refused(content[:size], "not a complete .vtp file", suffix=".vtp")
        self.assert_refused(b"<VTKFile type='ImageData'></VTKFile>", ".", suffix=".vtp")

    def test_what_may_be_read(self):
        self.path.with_suffix(".step").touch()
        with self.assertRaisesRegex(medial.InvalidInputError,
                                    "'.step', allowed: .stl .obj .ply .off .vtp .vtk"):
            medial.read_mesh(self.path.with_suffix(".step"))


if __name__ == "__main__":
    unittest.main()
