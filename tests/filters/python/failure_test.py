"""Wrong use ends in an exception that tells the cause."""

import os
import re
import subprocess
import sys
import tempfile
import textwrap
import unittest
from fractions import Fraction

import medial
import numpy as np
import shapes
from vtkmodules.vtkCommonCore import vtkObject
from vtkmodules.vtkCommonDataModel import vtkPolyData, vtkTable
from vtkmodules.vtkFiltersCore import vtkContourFilter, vtkElevationFilter
from vtkmodules.vtkIOGeometry import vtkOBJReader, vtkSTLReader, vtkSTLWriter
from vtkmodules.vtkIOLegacy import vtkPolyDataReader

VERTICES, QUADS = shapes.box()
SMALL = {"resolution": 9}


class Meshes(unittest.TestCase):
    def assert_refused(self, message, *mesh, error=ValueError):
        for function in (medial.distance_field, medial.medial_axis, medial.skeleton,
                         medial.thickness, medial.local_thickness):
            with self.assertRaisesRegex(error, message):
                function(*mesh)

    def test_arrays(self):
        self.assert_refused(r"vertices have the shape \(8, 2\)", VERTICES[:, :2], QUADS)
        self.assert_refused(r"vertices have the shape \(3,\)", [1.0, 2.0, 3.0], QUADS)
        self.assert_refused("vertices are not numbers", [["a", "b", "c"]], QUADS)
        self.assert_refused("vertices are not numbers", VERTICES * 1j, QUADS)
        self.assert_refused("not finite", np.where(VERTICES > 0.9, np.nan, VERTICES), QUADS)
        self.assert_refused("not finite", np.where(VERTICES > 0.9, np.inf, VERTICES), QUADS)
        self.assert_refused(r"faces name the vertex 8, but there are 8", VERTICES, QUADS + 1)
        self.assert_refused(r"faces name the vertex -1,", VERTICES, QUADS - 1)
        self.assert_refused("faces name the vertex 9", VERTICES, [[0, 1, 2], [0, 1, 3, 9]])
        self.assert_refused("faces are of type float64", VERTICES, QUADS.astype(float))
        self.assert_refused("face 1 has 2 vertices", VERTICES, [[0, 1, 2], [0, 1]])
        self.assert_refused("face 0 has 2 vertices", VERTICES, [[0, 1], [0, 1, 2]])
        self.assert_refused("faces are of type float64", VERTICES, [[0, 1, 2], [0, 1, 2.5, 3]])
        self.assert_refused("faces are of type", VERTICES, [[0, 1, 2], [0, 1, "x", 3]])
        self.assert_refused("faces are neither an array nor .* a mesh of pyvista", VERTICES,
                            [3, 0, 1, 2])
        self.assert_refused("faces are neither an array nor", VERTICES, 5)
        self.assert_refused(r"faces have the shape \(4,\), not \(m, k\); pass a mesh of pyvista",
                            VERTICES, np.array([3, 0, 1, 2]))
        self.assert_refused("the mesh has no cells", VERTICES, [])
        self.assert_refused("the mesh has no cells", VERTICES, np.empty((0, 3), dtype=int))

    def test_other_objects(self):
        for mesh in ("part.stl", VERTICES, 7, None):
            self.assert_refused("as a vtkPolyData", mesh, error=TypeError)
        self.assert_refused("own faces", vtkPolyData(), QUADS, error=TypeError)
        self.assert_refused("no cells", vtkPolyData())

    def test_file_that_cannot_be_read(self):
        for algorithm in (medial.vtkMedialAxis(), medial.vtkMedialThickness()):
            reader = vtkSTLReader()
            reader.SetFileName("absent.stl")
            algorithm.SetInputConnection(reader.GetOutputPort())
            with self.assertRaisesRegex(medial.Error, "absent.stl"):
                medial.update(algorithm)

    def test_pipeline_behind_a_filter_that_fails_again(self):
        reader = vtkSTLReader()
        reader.SetFileName("absent.stl")
        field = medial.vtkMeshDistanceField()
        field.SetInputConnection(reader.GetOutputPort())
        contour = vtkContourFilter()
        contour.SetInputConnection(field.GetOutputPort())
        for _ in range(3):
            with self.assertRaisesRegex(medial.Error, "the mesh has no cells"):
                medial.update(contour)


class Parameters(unittest.TestCase):
    def assert_refused(self, message, function=medial.distance_field, error=ValueError,
                       **parameters):
        with self.assertRaisesRegex(error, message):
            function(VERTICES, QUADS, **parameters)

    def test_grid(self):
        self.assert_refused(r"resolution 1 is outside \[2, 8192\]", resolution=1)
        self.assert_refused(r"resolution 8193 is outside", resolution=8193)
        self.assert_refused(r"padding nan is outside \[0, 10\]", padding=float("nan"))
        self.assert_refused("spacing along x -1 ", spacing=-1)
        self.assert_refused(r"spacing \(1, 2\) is not of three", spacing=(1, 2))
        self.assert_refused("1e-05", spacing=1e-5)
        explicit = "an explicit grid needs origin, spacing and dimensions"
        self.assert_refused(explicit, origin=(0, 0, 0))
        self.assert_refused(explicit, origin=(0, 0, 0), dimensions=(1, 1, 1))
        self.assert_refused(explicit, spacing=1, dimensions=(1, 1, 1))
        self.assert_refused(explicit, resolution=30, origin=(0, 0, 0), dimensions=(1, 1, 1))
        self.assert_refused("dimension", origin=(0, 0, 0), spacing=1, dimensions=(0, 1, 1))

    def test_grid_that_is_given_twice(self):
        whole = {"origin": (0, 0, 0), "spacing": 1, "dimensions": (1, 1, 1)}
        for function in (medial.distance_field, medial.medial_axis):
            self.assert_refused("resolution 30 and spacing 0.1 exclude each other",
                                function=function, resolution=30, spacing=.1)
            self.assert_refused("resolution 256 and spacing", function=function, resolution=256,
                                **whole)
            self.assert_refused(r"padding 0.1 and origin \(0, 0, 0\) exclude", function=function,
                                padding=.1, **whole)

    def test_integers(self):
        axis = medial.medial_axis(VERTICES, QUADS, **SMALL)

        def reconstruction(_vertices, _faces, **parameters):
            medial.reconstruction(axis, **parameters)

        for function, name, allowed in (
                (medial.distance_field, "resolution", r"\[2, 8192\]"),
                (medial.distance_field, "threads", r"\[0, 1024\]"),
                (medial.distance_field, "memory", r"\[0, 2147483647\]"),
                (medial.medial_axis, "resolution", r"\[2, 8192\]"),
                (medial.medial_axis, "max_spheres", r"\[0, 2147483647\]"),
                (medial.thickness, "threads", r"\[0, 1024\]"),
                (reconstruction, "resolution", r"\[2, 8192\]")):
            for value in ("30", 9.5, [9]):
                self.assert_refused(
                    f"^{name} {re.escape(repr(value))} is not an integer in {allowed}$",
                    function=function, error=TypeError, **{name: value})
            for value in (10**20, -10**20, -1, np.int64(2)**40):
                self.assert_refused(f"^{name} {value} is outside {allowed}$", function=function,
                                    **{name: value})
        grid = {"origin": (0, 0, 0), "spacing": 1}
        self.assert_refused(r"dimensions 10{20} is outside \[1, 8192\]", dimensions=(1, 1, 10**20),
                            **grid)
        self.assert_refused("dimensions 1.5 is not an integer", dimensions=(1, 1, 1.5),
                            error=TypeError, **grid)

    def test_reals(self):
        huge = 10**400
        for function, name, allowed in (
                (medial.distance_field, "padding", r"\[0, 10\]"),
                (medial.distance_field, "spacing", r"\(0, inf\)"),
                (medial.medial_axis, "angle", r"\(0, 180\)"),
                (medial.medial_axis, "min_lambda", r"\[0, inf\)"),
                (medial.medial_axis, "min_radius", r"\[0, inf\)"),
                (medial.skeleton, "min_branch", r"\[0, inf\)"),
                (medial.thickness, "angle", r"\(0, 180\)")):
            self.assert_refused(f"^{name} '30' is not a number in {allowed}$", function=function,
                                error=TypeError, **{name: "30"})
            self.assert_refused(f"^{name} {huge} is outside {allowed}$", function=function,
                                **{name: huge})
        self.assert_refused(r"origin 'x' is not a number in \(-inf, inf\)", error=TypeError,
                            origin=(0, "x", 0), spacing=1, dimensions=(1, 1, 1))

    def test_numbers_of_other_types_are_taken(self):
        field = medial.distance_field(VERTICES, QUADS, resolution=np.uint8(9), threads=True,
                                      padding=np.float32(0.5))
        self.assertEqual(field.distance.shape[0], 9)
        spaced = medial.distance_field(VERTICES, QUADS, spacing=np.array(Fraction(1, 2)))
        self.assertEqual(spaced.spacing.tolist(), [0.5] * 3)

    def test_words(self):
        self.assert_refused("sign 'outside' is none of auto, none", sign="outside")
        self.assert_refused(r"sign \['auto'\] is none of", sign=["auto"])
        self.assert_refused("engine 'gpu' is none of", engine="gpu")
        self.assert_refused("array 'closest' is none of closest_point", arrays=["closest"])
        for name in ("side", "representation", "topology"):
            self.assert_refused(f"{name} 'x' is none of", function=medial.medial_axis,
                                **{name: "x"})

    def test_run(self):
        self.assert_refused("memory 3 is outside", memory=3)
        self.assert_refused("sign 'parity' is none of auto, none, pseudonormal, winding$", sign="parity")
        with self.assertRaisesRegex(ValueError, "boundary"):
            medial.distance_field(VERTICES, QUADS[1:], sign="pseudonormal", **SMALL)

    def test_axis(self):
        axis = {"function": medial.medial_axis, **SMALL}
        self.assert_refused(r"angle 180 is outside \(0, 180\)", angle=180, **axis)
        self.assert_refused("lambda -1", min_lambda=-1, **axis)
        self.assert_refused("radius nan", min_radius=float("nan"), **axis)
        self.assert_refused(r"arrays \['closest_cell'\] .* need field=True",
                            arrays=["closest_cell"], **axis)
        self.assert_refused("points have no topology", topology="preserve",
                            representation="points", **axis)
        self.assert_refused("angle 0 is outside", function=medial.thickness, angle=0)

    def test_shape(self):
        axis = medial.medial_axis(VERTICES, QUADS, **SMALL)
        with self.assertRaisesRegex(ValueError, "resolution 0"):
            medial.reconstruction(axis, resolution=0)
        with self.assertRaisesRegex(ValueError, "no point data array Radius"):
            medial.reconstruction(medial.Surface(VERTICES, QUADS).to_vtk())
        for function in (medial.reconstruction, medial.curves):
            with self.assertRaisesRegex(TypeError, "not ndarray"):
                function(VERTICES)

    def test_grid_that_memory_cannot_hold(self):
        huge = {"origin": (0, 0, 0), "spacing": 1, "dimensions": (8192, 8192, 8192)}
        self.assert_refused("549755813888 points needs 2097152 MiB", error=MemoryError, **huge)
        self.assert_refused("points needs", error=MemoryError, function=medial.medial_axis,
                            field=True, **huge)
        self.assert_refused("points needs", error=medial.OutOfMemoryError,
                            function=medial.medial_axis, topology="preserve", **huge)
        ball = medial.medial_axis(VERTICES, QUADS, **SMALL)
        with self.assertRaises(medial.OutOfMemoryError):
            medial.reconstruction(ball, resolution=8192)

    def test_work_goes_on_after_failures(self):
        self.assert_refused("resolution", resolution=1)
        self.assertEqual(medial.distance_field(VERTICES, QUADS, **SMALL).distance.shape[0], 9)


class Inputs(unittest.TestCase):
    """Pipelines without the input that a filter needs."""

    def assert_refused(self, message, algorithm):
        for _ in range(2):
            with self.assertRaisesRegex(medial.Error, message):
                medial.update(algorithm)

    def test_points_whose_distances_are_asked_for(self):
        distances = medial.vtkMeshPointDistance()
        self.assert_refused("^input port 0, which takes the points, has no connection$", distances)
        distances.SetInputDataObject(vtkTable())
        self.assert_refused("^the input of port 0 is a vtkTable, not a vtkDataSet$", distances)
        points = vtkPolyData()
        distances.SetInputDataObject(points)
        self.assert_refused("nput port 1 .* has 0 connections", distances)
        distances.SetSurfaceData(medial.Surface(VERTICES, QUADS).to_vtk())
        medial.update(distances)
        self.assertEqual(distances.GetOutput().GetNumberOfPoints(), 0)


class WithoutWarnings(unittest.TestCase):
    """VTK's error macro tells nobody while global warnings are off."""

    def setUp(self):
        vtkObject.GlobalWarningDisplayOff()
        self.addCleanup(vtkObject.GlobalWarningDisplayOn)

    def assert_refused(self, message, algorithm, error=medial.Error):
        for _ in range(2):
            with self.assertRaisesRegex(error, message):
                medial.update(algorithm)

    def test_functions(self):
        unset = np.full_like(VERTICES, np.nan)
        for function in (medial.distance_field, medial.medial_axis, medial.skeleton,
                         medial.thickness, medial.local_thickness):
            with self.assertRaisesRegex(medial.InvalidInputError, r"point 0 .* \(nan, nan, nan\)"):
                function(unset, QUADS)
        with self.assertRaisesRegex(medial.InvalidInputError, "mesh B: point 0 "):
            medial.proximity(VERTICES, QUADS, unset, QUADS)
        with self.assertRaisesRegex(medial.InvalidInputError, r"point 0 .* \(nan, 0, 0\)"):
            medial.distance(VERTICES, QUADS, [[np.nan, 0, 0]])
        with self.assertRaisesRegex(medial.InvalidInputError, "no point data array Radius"):
            medial.reconstruction(medial.Surface(VERTICES, QUADS).to_vtk())

    def test_filters(self):
        axis = medial.vtkMedialAxis()
        self.assert_refused("^input port 0 of vtkMedialAxis has 0 connections$", axis)
        axis.SetInputData(medial.Surface(VERTICES, QUADS).to_vtk())
        axis.SetResolution(9)
        axis.SetAngle(200)
        elevation = vtkElevationFilter()
        elevation.SetInputConnection(axis.GetOutputPort())
        self.assert_refused("^separation angle 200", axis, medial.InvalidInputError)
        self.assert_refused("^separation angle 200", elevation)
        axis.SetAngle(60)
        medial.update(elevation)
        self.assertGreater(elevation.GetOutput().GetNumberOfPoints(), 0)

    def test_filter_that_is_aborted(self):
        axis = medial.vtkMedialAxis()
        axis.SetInputData(medial.Surface(VERTICES, QUADS).to_vtk())
        axis.SetResolution(9)
        tag = axis.AddObserver("ProgressEvent", lambda caller, _event: caller.SetAbortExecute(1))
        self.assert_refused("^vtkMedialAxis was aborted$", axis)
        vtkObject.GlobalWarningDisplayOn()
        self.assert_refused("^vtkMedialAxis was aborted$", axis)
        axis.RemoveObserver(tag)
        medial.update(axis)
        self.assertGreater(axis.GetOutput().GetNumberOfPoints(), 0)

    def test_readers_of_vtk(self):
        for make in (vtkSTLReader, vtkOBJReader, vtkPolyDataReader):
            reader = make()
            reader.SetFileName("absent")
            thickness = medial.vtkMedialThickness()
            thickness.SetInputConnection(reader.GetOutputPort())
            for algorithm in (reader, thickness):
                self.assert_refused(f"{make.__name__} .*failed without an error message", algorithm)

    def test_error_codes_that_readers_keep(self):
        with tempfile.TemporaryDirectory() as folder:
            reader, writer = vtkSTLReader(), vtkSTLWriter()
            for one in (reader, writer):
                one.SetFileName(os.path.join(folder, "part.stl"))
            self.assert_refused("^vtkSTLReader .*CannotOpenFile", reader)
            writer.SetInputData(medial.Surface(*shapes.ball(1)).to_vtk())
            medial.update(writer)
            medial.update(reader)
            self.assertEqual(reader.GetOutput().GetNumberOfPoints(), 18)
            self.assertEqual(reader.GetErrorCode(), 0)


class Processes(unittest.TestCase):
    """What depends on the environment, in processes of their own."""

    def run_script(self, script, **environment):
        """The standard output; what fails or prints errors fails the test."""
        done = subprocess.run(
            [sys.executable, "-c", textwrap.dedent(script)], capture_output=True, text=True,
            timeout=120, env={**os.environ, **environment}, cwd=os.path.dirname(__file__))
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        return done.stdout

    def test_without_egl(self):
        output = self.run_script("""
            import medial, shapes
            for function in (medial.distance_field, medial.medial_axis):
                function(*shapes.box(), resolution=9)
                try:
                    function(*shapes.box(), resolution=9, engine="rasteriser")
                except medial.NoGpuError as error:
                    print("no GPU:", error)
            print(medial.thickness(*shapes.box()).max())
            """, __EGL_VENDOR_LIBRARY_FILENAMES=os.devnull)
        self.assertRegex(output, r"\Ano GPU: .*EGL.*\nno GPU: .*EGL.*\n0.0\n\Z")

    def test_device_that_is_not_there(self):
        output = self.run_script("""
            import medial, shapes
            for device in ("Voodoo", 99, 0):
                try:
                    medial.distance_field(*shapes.box(), resolution=9, engine="rasteriser",
                                          device=device)
                    print("computed")
                except medial.NoGpuError as error:
                    print(error)
            """)
        self.assertRegex(output, r"\A.*'Voodoo'.*\n.*'99'.*\ncomputed\n\Z")

    def test_device_that_auto_leaves_to_the_processor(self):
        output = self.run_script("""
            import medial, shapes, sys, warnings
            from vtkmodules.vtkFiltersSources import vtkCubeSource
            cube = vtkCubeSource()
            with warnings.catch_warnings(record=True) as caught:
                warnings.simplefilter("always")
                for function in (medial.distance_field, medial.medial_axis):
                    assert function(*shapes.box(), resolution=9, device="Voodoo").engine == "processor"
                pipeline = medial.vtkMedialAxis()
                pipeline.SetInputConnection(cube.GetOutputPort())
                pipeline.SetResolution(9)
                for device in ("Voodoo", "Banshee", "Banshee"):
                    pipeline.SetDevice(device)
                    medial.update(pipeline)
                    pipeline.Modified()
            for warning in caught:
                print(warning.category.__name__, warning.filename, warning.message)
            """)
        line = "UserWarning <string> the engine device failed \\(.*'{}'.*\\), so the processor.*\n"
        self.assertRegex(output, r"\A" + line.format("Voodoo") + line.format("Banshee") + r"\Z")

    def test_software_renderer_where_hardware_is_required(self):
        output = self.run_script("""
            import medial, shapes
            try:
                field = medial.distance_field(*shapes.box(), resolution=9, require_gpu=True)
                print("hardware:", field.renderer)
            except medial.NoGpuError as error:
                print(error)
            """)
        self.assertRegex(output, "hardware: .|a hardware renderer is required, but")

    def test_readers_of_vtk_that_fail_again(self):
        # VTK would take what they have of an output for the whole, and crash.
        output = self.run_script("""
            import os, tempfile, warnings
            import medial, shapes
            from vtkmodules.vtkFiltersCore import vtkContourFilter
            from vtkmodules.vtkIOGeometry import vtkOBJReader, vtkSTLReader, vtkSTLWriter
            from vtkmodules.vtkIOImage import vtkMetaImageReader, vtkNIFTIImageReader, vtkNrrdReader
            from vtkmodules.vtkIOPLY import vtkPLYReader
            from vtkmodules.vtkIOXML import vtkXMLImageDataReader, vtkXMLPolyDataReader

            def failure(algorithm):
                try:
                    medial.update(algorithm)
                except medial.Error as error:
                    return type(error).__name__, str(error)

            warnings.simplefilter("ignore")
            images = vtkNrrdReader, vtkNIFTIImageReader, vtkXMLImageDataReader, vtkMetaImageReader
            meshes = vtkSTLReader, vtkOBJReader, vtkPLYReader, vtkXMLPolyDataReader
            for readers, consumer in (images, vtkContourFilter), (meshes, medial.vtkMedialThickness):
                for make in readers:
                    reader = make()
                    reader.SetFileName("absent")
                    other, last = consumer(), consumer()
                    for one in other, last:
                        one.SetInputConnection(reader.GetOutputPort())
                    failures = {failure(one) for one in (other, last, last, last)}
                    assert len(failures) == 1 and None not in failures, failures
                    if make == vtkPLYReader:
                        print(*failures)

            with tempfile.TemporaryDirectory() as folder:
                path = os.path.join(folder, "part.stl")
                reader, thickness = vtkSTLReader(), medial.vtkMedialThickness()
                reader.SetFileName(path)
                thickness.SetInputConnection(reader.GetOutputPort())
                print(failure(thickness)[1] == f"File {path} not found")
                writer = vtkSTLWriter()
                writer.SetInputData(medial.Surface(*shapes.ball(1)).to_vtk())
                writer.SetFileName(path)
                medial.update(writer)
                medial.update(thickness)
                print(thickness.GetOutput().GetNumberOfPoints())
            """)
        self.assertEqual(
            output, "('Error', 'vtkPLYReader failed without an error message')\nTrue\n18\n")

    def test_errors_are_exceptions_and_nothing_else(self):
        self.run_script("""
            import medial, shapes
            vertices, quads = shapes.box()
            for parameters in ({"resolution": 1}, {"dimensions": (8192,) * 3, "spacing": 1,
                                                   "origin": (0, 0, 0)}):
                try:
                    medial.distance_field(vertices, quads, **parameters)
                    raise SystemExit("no exception")
                except medial.Error:
                    pass
            """)


if __name__ == "__main__":
    unittest.main()
