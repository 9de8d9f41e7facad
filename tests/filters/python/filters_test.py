"""The filters from Python, together with VTK's own package."""

import math
import unittest

import medial
from vtkmodules.util.vtkAlgorithm import VTKPythonAlgorithmBase
from vtkmodules.vtkCommonCore import vtkObject
from vtkmodules.vtkCommonDataModel import vtkDataObject, vtkImageData, vtkMultiBlockDataSet, vtkPolyData
from vtkmodules.vtkCommonExecutionModel import vtkStreamingDemandDrivenPipeline as Pipeline
from vtkmodules.vtkFiltersCore import vtkContourFilter, vtkMassProperties, vtkTriangleFilter
from vtkmodules.vtkFiltersModeling import vtkLinearSubdivisionFilter
from vtkmodules.vtkFiltersSources import vtkCubeSource


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


class Moving(VTKPythonAlgorithmBase):
    """A cube of side 1 about (2 + t, 0, 0) at some times t; between them, at the time before."""

    def __init__(self, *times, output="vtkPolyData"):
        super().__init__(nInputPorts=0, nOutputPorts=1, outputType=output)
        self.times = times

    def RequestInformation(self, _request, _input, output):
        info = output.GetInformationObject(0)
        info.Set(Pipeline.TIME_STEPS(), self.times, len(self.times))
        info.Set(Pipeline.TIME_RANGE(), (self.times[0], self.times[-1]), 2)
        return 1

    def at(self, time):
        return max((own for own in self.times if own <= time), default=self.times[0])

    def RequestData(self, _request, _input, output):
        key = Pipeline.UPDATE_TIME_STEP()
        info = output.GetInformationObject(0)
        time = self.at(info.Get(key) if info.Has(key) else self.times[0])
        cube = vtkCubeSource()
        cube.SetCenter(2 + time, 0, 0)
        cube.Update()
        data = vtkDataObject.GetData(output, 0)
        if isinstance(data, vtkMultiBlockDataSet):
            data.SetBlock(0, cube.GetOutput())
        else:
            data.ShallowCopy(cube.GetOutput())
        data.GetInformation().Set(vtkDataObject.DATA_TIME_STEP(), time)
        return 1


class Times(unittest.TestCase):
    """Pairs of inputs of which one moves, or both at times of their own."""

    def setUp(self):
        self.still = vtkCubeSource()

    def assert_distances(self, name, distance_at, make, pairs):
        """The figure of that name, at all times of both and back again."""
        for pair in pairs:
            times = sorted({time for one in pair if isinstance(one, Moving) for time in one.times})
            places = [lambda t, one=one: 2 + one.at(t) if isinstance(one, Moving) else 0 for one in pair]
            algorithm = make(*(one.GetOutputPort() for one in pair))
            algorithm.UpdateInformation()
            info = algorithm.GetOutputInformation(0)
            self.assertEqual(list(info.Get(Pipeline.TIME_STEPS())), times)
            self.assertEqual(list(info.Get(Pipeline.TIME_RANGE())), [times[0], times[-1]])
            for time in times + times[-2::-1] + times[1:]:
                algorithm.UpdateTimeStep(time)
                apart = abs(places[0](time) - places[1](time))
                output = algorithm.GetOutputDataObject(0)
                mesh = output.GetBlock(0) if isinstance(output, vtkMultiBlockDataSet) else output
                self.assertAlmostEqual(figure(mesh, name), distance_at(apart), 12, (pair, time))
                self.assertEqual(output.GetInformation().Get(vtkDataObject.DATA_TIME_STEP()), time)

    def test_proximity(self):
        def make(a, b):
            proximity = medial.vtkMeshProximity()
            proximity.SetInputConnection(0, a)
            proximity.SetInputConnection(1, b)
            return proximity

        blocks = Moving(0, 2, 6, output="vtkMultiBlockDataSet")
        self.assert_distances("Separation", lambda apart: max(0, apart - 1), make, (
            (self.still, Moving(0, 1, 2)), (Moving(0, 1, 2), self.still),
            (Moving(0, 4), Moving(1, 3, 6, 9)), (self.still, blocks), (blocks, self.still),
            (blocks, Moving(1, 3, 6, 9)), (Moving(1, 3, 6, 9), blocks)))

    def test_distances_at_points(self):
        def make(points, surface):
            distances = medial.vtkMeshPointDistance()
            distances.SetInputConnection(points)
            distances.SetSurfaceConnection(surface)
            return distances

        blocks = Moving(0, 2, 6, output="vtkMultiBlockDataSet")
        self.assert_distances("MaxDistance", lambda apart: apart, make, (
            (self.still, Moving(0, 1, 2)), (Moving(0, 1, 2), self.still),
            (Moving(0, 4), Moving(1, 3, 6, 9)), (blocks, Moving(1, 3, 7, 9))))

    def test_without_times(self):
        proximity = medial.vtkMeshProximity()
        for port in (0, 1):
            proximity.SetInputConnection(port, self.still.GetOutputPort())
        proximity.UpdateInformation()
        self.assertFalse(proximity.GetOutputInformation(0).Has(Pipeline.TIME_STEPS()))
        self.assertFalse(proximity.GetOutputInformation(0).Has(Pipeline.TIME_RANGE()))


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


if __name__ == "__main__":
    unittest.main()
