"""Each filter in pvpython: values on known shapes, properties, progress, abort."""

import os
import sys
import unittest

import numpy

sys.path.insert(0, os.path.dirname(__file__))
from paraview import servermanager
from paraview.simple import *
from vtkmodules.vtkCommonCore import reference
from session import (HALF_SIDES, box, bunny, default_colouring, figure, messages, output, points,
                     real_meshes, values)


def box_distance(x):
    """Signed distance to the box, negative inside."""
    q = numpy.abs(x) - HALF_SIDES
    return numpy.linalg.norm(numpy.maximum(q, 0), axis=1) + numpy.minimum(q.max(axis=1), 0)


def grid_points(image):
    return numpy.array([image.GetPoint(i) for i in range(image.GetNumberOfPoints())])


class Values(unittest.TestCase):
    def test_distance_field_of_a_box(self):
        field = output(MeshDistanceField(Input=box(), Resolution=24, GenerateClosestPoint=1))
        exact = box_distance(grid_points(field))
        numpy.testing.assert_allclose(values(field, "Distance"), exact, atol=1e-4)
        to_closest = numpy.linalg.norm(grid_points(field) - values(field, "ClosestPoint"), axis=1)
        numpy.testing.assert_allclose(to_closest, numpy.abs(exact), atol=1e-4)

    def test_medial_axis_of_a_box(self):
        axis = output(MedialAxis(Input=box(), Resolution=64))
        self.assertGreater(axis.GetNumberOfCells(), 500)
        depth = -box_distance(points(axis))
        numpy.testing.assert_allclose(values(axis, "Radius"), depth, atol=1e-4)
        nearest, second = numpy.sort(HALF_SIDES - numpy.abs(points(axis)), axis=1)[:, :2].T
        in_the_middle = numpy.abs(points(axis)[:, 2]) < 0.02
        numpy.testing.assert_array_less((second - nearest)[~in_the_middle], 0.06)

    def test_distance_field_of_the_medial_axis(self):
        axis = MedialAxis(Input=box(), Resolution=24, GenerateDistanceField=1)
        field = output(axis, 1)
        numpy.testing.assert_allclose(values(field, "Distance"), box_distance(grid_points(field)),
                                      atol=1e-4)
        axis.GenerateDistanceField = 0
        axis.UpdatePipeline()
        self.assertEqual(axis.GetDataInformation(1).GetNumberOfPoints(), 0)

    def test_thickness_of_a_ball(self):
        ball = Sphere(Radius=1.5, ThetaResolution=64, PhiResolution=64)
        filter = MedialThickness(Input=ball)
        numpy.testing.assert_allclose(values(output(filter), "Thickness"), 3.0, rtol=0.01)
        self.assertAlmostEqual(figure(filter, "MedianThickness"), 3.0, delta=0.03)
        self.assertEqual(figure(filter, "ShareWithout"), 0.0)

    def test_skeleton_of_a_beam(self):
        lines = output(MedialSkeleton(Input=Box(XLength=4, YLength=0.5, ZLength=0.5), Resolution=64))
        self.assertEqual(lines.GetNumberOfCells(), 1)
        numpy.testing.assert_allclose(points(lines)[:, 1:], 0, atol=0.01)

    def test_local_thickness_of_a_beam(self):
        image = output(MedialLocalThickness(Input=Box(XLength=4, YLength=4, ZLength=1), Resolution=48))
        self.assertAlmostEqual(values(image, "LocalThickness").max(), 1.0, delta=0.05)

    def test_reconstruction_of_a_box(self):
        axis = MedialAxis(Input=box(), Resolution=100, Angle=40)
        surface = output(MedialReconstruction(Input=axis, Resolution=64))
        worst = numpy.abs(box_distance(points(surface))).max()
        self.assertLess(worst, 0.1)
        numpy.testing.assert_allclose(surface.GetBounds()[1::2], HALF_SIDES, atol=0.03)

    def test_proximity_of_two_boxes(self):
        pair = MeshProximity(Input=box(), InputB=box())
        pair.TransformB.Translate = [3, 0, 0]
        self.assertAlmostEqual(figure(pair, "Separation"), 1.0)
        ends = points(output(pair))
        numpy.testing.assert_allclose(ends[:, 0], [1, 2])
        pair.TransformA.Rotate = [0, 0, 90]
        self.assertAlmostEqual(figure(pair, "Separation"), 3 - 1 - 0.7)
        pair.TransformA.Rotate = [0, 0, 0]
        pair.TransformB.Translate = [1.75, 0.2, 0.1]
        self.assertEqual((figure(pair, "Collide"), figure(pair, "Intersect")), (1, 1))
        self.assertAlmostEqual(figure(pair, "PenetrationDepth"), 0.25, delta=1e-3)
        moved = output(pair, 2)
        numpy.testing.assert_allclose(points(moved)[:, 0].min(), 0.75)
        self.assertAlmostEqual(values(moved, "PenetrationDepth").max(), 0.1, places=5)

    def test_distances_of_points_from_a_box(self):
        source = Wavelet(WholeExtent=[-3, 3, -3, 3, -3, 3])
        distance = MeshPointDistance(Input=source, Surface=box())
        image = output(distance)
        numpy.testing.assert_allclose(values(image, "Distance"), box_distance(grid_points(image)),
                                      atol=1e-6)
        self.assertEqual(figure(distance, "SignMethod"), "Winding")

    def test_contacts_of_a_box_on_another(self):
        pair = MeshProximity(Input=box(), InputB=box())
        pair.TransformB.Scale = [0.5, 0.5, 0.5]
        pair.TransformB.Translate = [0, 0, 0.55]
        data = output(pair)
        contacts = values(data, "Kind") == 1
        self.assertEqual(contacts.sum(), 4)
        numpy.testing.assert_allclose(values(data, "Depth")[contacts], 0.05, atol=1e-6)
        numpy.testing.assert_allclose(values(data, "Normal")[contacts], [[0, 0, 1]] * 4, atol=0.02)
        pair.MaximumNumberOfContacts = 1
        self.assertEqual((values(output(pair), "Kind") == 1).sum(), 1)

    def test_curves_of_a_box_have_the_kinds_asked_for(self):
        axis = MedialAxis(Input=box(), Resolution=48)
        kinds = {"Rims": 1, "Seams": 2}
        for wanted in kinds:
            curves = MedialCurves(Input=axis, Rims=0, Seams=0, Curves=0)
            setattr(curves, wanted, 1)
            lines = output(curves)
            self.assertGreater(lines.GetNumberOfLines(), 0)
            feature = lines.GetCellData().GetArray("AxisFeature")
            self.assertEqual(feature.GetRange(), (kinds[wanted],) * 2)

    def test_real_meshes(self):
        for name, mesh in real_meshes():
            with self.subTest(mesh=name):
                size = numpy.ptp(points(output(mesh)), axis=0).max()
                axis = MedialAxis(Input=mesh, Resolution=64)
                data = output(axis)
                self.assertGreater(data.GetNumberOfCells(), 1000)
                for end in "AB":
                    reach = values(data, f"ClosestPoint{end}") - points(data)
                    numpy.testing.assert_allclose(numpy.linalg.norm(reach, axis=1),
                                                  values(data, "Radius"), atol=0.01 * size)
                solid = output(MedialReconstruction(Input=axis, Resolution=48))
                numpy.testing.assert_allclose(solid.GetBounds(), output(mesh).GetBounds(),
                                              atol=0.06 * size)
                self.assertGreater(output(MedialCurves(Input=axis)).GetNumberOfLines(), 0)
                thickness = MedialThickness(Input=mesh)
                self.assertLess(numpy.nanmax(values(output(thickness), "Thickness")), size)
                self.assertLess(figure(thickness, "ShareWithout"), 0.05)
                field = values(output(MeshDistanceField(Input=mesh, Resolution=48)), "Distance")
                self.assertLess(field.min(), -0.4 * figure(thickness, "MedianThickness") / 2)


class Properties(unittest.TestCase):
    def test_defaults_follow_the_bounds(self):
        field = MeshDistanceField(Input=box())
        numpy.testing.assert_allclose(field.Spacing, [0.01] * 3)
        numpy.testing.assert_allclose(field.Origin, numpy.negative(HALF_SIDES))
        axis = MedialAxis(Input=box())
        for name in ("MinimumLambda", "MinimumRadius"):
            self.assertEqual(axis.GetPropertyValue(name), 0.0)
            domain = axis.SMProxy.GetProperty(name).FindDomain("vtkSMBoundsDomain")
            self.assertEqual(domain.GetMaximum(0, reference(0)), 1.0)  # half the longest side

    def test_grid_modes(self):
        field = MeshDistanceField(Input=box(), GridMode="Spacing", Spacing=[0.1, 0.2, 0.1],
                                  Padding=0)
        self.assertEqual(output(field).GetSpacing(), (0.1, 0.2, 0.1))
        field.GridMode = "Explicit"
        field.Dimensions = [3, 4, 5]
        self.assertEqual(output(field).GetDimensions(), (3, 4, 5))
        numpy.testing.assert_allclose(output(field).GetOrigin(), numpy.negative(HALF_SIDES))

    def test_the_menu_offers_filters_for_surfaces_only(self):
        axis = MedialAxis(Input=box(), Resolution=16)
        fits = {("MedialAxis", Wavelet): False, ("MedialAxis", Sphere): True,
                ("MedialReconstruction", Box): False, ("MedialReconstruction", lambda: axis): True}
        for (name, make), expected in fits.items():
            source = make()
            source.UpdatePipeline()
            proxy = servermanager.ProxyManager().NewProxy("filters", name)
            proxy.GetProperty("Input").AddUncheckedInputConnection(source.SMProxy, 0)
            with self.subTest(filter=name, input=source.GetXMLLabel()):
                self.assertEqual(bool(proxy.GetProperty("Input").IsInDomains()), expected)

    def test_blocks_are_computed_one_by_one(self):
        blocks = GroupDatasets(Input=[box(), Sphere()])
        for make in (MeshDistanceField, MedialAxis, MedialThickness):
            with self.subTest(filter=make.__name__):
                data = output(make(Input=blocks))
                self.assertEqual(data.GetNumberOfBlocks(), 2)
                for block in range(2):
                    self.assertGreater(data.GetBlock(block).GetNumberOfPoints(), 0)
        for inputs in ({"Input": blocks, "InputB": box()}, {"Input": box(), "InputB": blocks}):
            self.assertEqual(output(MeshProximity(**inputs)).GetNumberOfBlocks(), 2)

    def test_outputs_are_coloured_by_what_they_are_for(self):
        view = CreateView("RenderView")
        axis = MedialAxis(Input=box(), Resolution=32)
        self.assertEqual(default_colouring(axis, view), "Radius")
        field = MeshDistanceField(Input=box(), Resolution=32)
        self.assertEqual(default_colouring(field, view), "Distance")
        self.assertEqual(GetDisplayProperties(field, view).Representation, "Slice")
        self.assertEqual(default_colouring(MedialThickness(Input=bunny()), view), "Thickness")
        distance = MeshPointDistance(Input=bunny(), Surface=box())
        self.assertEqual(default_colouring(distance, view), "Distance")
        pair = MeshProximity(Input=bunny(), InputB=box())
        colourings = [default_colouring(OutputPort(pair, port), view) for port in range(3)]
        self.assertEqual(colourings, ["Kind", "PenetrationDepth", "PenetrationDepth"])

    def test_boxes_of_transforms_are_around_what_they_move(self):
        pair = MeshProximity(Input=box(), InputB=Sphere())
        around = [transform.SMProxy.GetProperty("DummyInput").GetProxy(0).GetXMLName()
                  for transform in (pair.TransformA, pair.TransformB)]
        self.assertEqual(around, ["CubeSource", "SphereSource"])

    def test_what_was_used_is_known(self):
        field = MeshDistanceField(Input=box(), Resolution=16)
        self.assertEqual(output(field).GetNumberOfPoints(), figure(field, "Samples"))
        self.assertEqual(figure(field, "SignMethod"), "Winding")
        self.assertEqual(figure(field, "Engine"), "Processor")
        field.Engine = "Rasteriser"
        self.assertEqual(figure(field, "Engine"), "Rasteriser")
        self.assertNotEqual(figure(field, "Renderer"), "")


class Executions(unittest.TestCase):
    def watch(self, proxy, action):
        """Calls action at each ProgressEvent of the filter behind a proxy."""
        algorithm = proxy.SMProxy.GetClientSideObject()
        tag = algorithm.AddObserver("ProgressEvent", lambda caller, event: action(caller))
        return lambda: algorithm.RemoveObserver(tag)

    def filters(self):
        axis = MedialAxis(Input=bunny(), Resolution=64)
        return [axis, MeshDistanceField(Input=bunny(), Resolution=100),
                MedialThickness(Input=bunny()), MedialReconstruction(Input=axis, Resolution=48),
                MedialCurves(Input=axis), MeshProximity(Input=bunny(), InputB=box()),
                MeshPointDistance(Input=bunny(), Surface=box()),
                MedialSkeleton(Input=bunny(), Resolution=64),
                MedialLocalThickness(Input=bunny(), Resolution=64)]

    def test_progress(self):
        for proxy in self.filters():
            steps = []
            self.watch(proxy, lambda caller: steps.append(caller.GetProgress()))
            proxy.UpdatePipeline()
            with self.subTest(filter=proxy.GetXMLLabel()):
                self.assertGreater(len(set(steps)), 2)  # the pipeline itself reports 0 and 1
                self.assertEqual(max(steps), 1.0)

    def test_abort_leaves_nothing_and_says_nothing(self):
        for proxy in self.filters():
            with self.subTest(filter=proxy.GetXMLLabel()), messages() as shown:
                stop = self.watch(proxy, lambda caller: caller.SetAbortExecute(1))
                proxy.UpdatePipeline()
                self.assertEqual(proxy.GetDataInformation().GetNumberOfPoints(), 0)
                stop()
                proxy.SMProxy.MarkModified(proxy.SMProxy)
                proxy.SMProxy.GetClientSideObject().Modified()
                proxy.UpdatePipeline()
                self.assertGreater(proxy.GetDataInformation().GetNumberOfPoints(), 0)
                self.assertEqual(shown(), "")


if __name__ == "__main__":
    unittest.main(verbosity=2)
