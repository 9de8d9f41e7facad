"""What can happen while a filter executes: Ctrl-C, other threads, progress, pipelines."""

import os
import signal
import subprocess
import sys
import textwrap
import threading
import time
import unittest

import medial
import numpy as np
import shapes
from vtkmodules.util.vtkAlgorithm import VTKPythonAlgorithmBase
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkFiltersCore import vtkElevationFilter
from vtkmodules.vtkFiltersSources import vtkCubeSource

# Seconds from Ctrl-C to the exception, on a machine that is busy with other things too. It takes 0.3 at
# most on an idle machine, and the work takes minutes.
PROMPT = 5.0


class Interrupted(Exception):
    pass


def setUpModule():
    # Shells start what is to run in the background with Ctrl-C ignored.
    signal.signal(signal.SIGINT, signal.default_int_handler)


def long_axis(resolution=1500, **parameters):
    """Takes minutes, or with a resolution of 400 a second or more."""
    return medial.medial_axis(*shapes.ball(5), resolution=resolution, **parameters)


class Interruption(unittest.TestCase):
    def setUp(self):
        self.sent = None

    def interrupt(self, seconds):
        """Does what Ctrl-C does, after some time; only a thread that runs meanwhile can do it."""

        def send():
            time.sleep(seconds)
            self.sent = time.monotonic()
            os.kill(os.getpid(), signal.SIGINT)

        threading.Thread(target=send).start()

    def test_ctrl_c_raises_keyboard_interrupt_soon(self):
        for seconds in (0.05, 0.3, 0.8):
            with self.subTest(seconds=seconds):
                self.interrupt(seconds)
                with self.assertRaises(KeyboardInterrupt):
                    long_axis()
                self.assertLess(time.monotonic() - self.sent, PROMPT)

    def test_work_goes_on_afterwards(self):
        self.interrupt(0.1)
        with self.assertRaises(KeyboardInterrupt):
            long_axis()
        field = medial.distance_field(*shapes.box(), resolution=17)
        self.assertAlmostEqual(field.distance.min(), -0.5, delta=0.08)

    def test_handler_of_the_caller_is_called(self):
        def handler(_signal, _frame):
            raise Interrupted

        previous = signal.signal(signal.SIGINT, handler)
        try:
            self.interrupt(0.1)
            with self.assertRaises(Interrupted):
                long_axis()
        finally:
            signal.signal(signal.SIGINT, previous)

    def test_ctrl_c_in_a_filter_with_an_observer(self):
        # VTK by itself ends the process where Ctrl-C meets an observer in Python.
        axis = medial.vtkMedialAxis()
        axis.SetInputData(medial.Surface(*shapes.ball(5)).to_vtk())
        axis.SetResolution(1500)
        seen = []
        axis.AddObserver(
            "ProgressEvent", lambda caller, _event: seen.append(caller.GetProgress()), 10.0)
        self.interrupt(0.3)
        with self.assertRaises(KeyboardInterrupt):
            medial.update(axis)
        self.assertGreater(len(seen), 0)
        axis.SetResolution(17)
        medial.update(axis)
        self.assertGreater(axis.GetOutput().GetNumberOfPoints(), 0)

    def test_a_script_ends_as_python_scripts_do(self):
        script = ("import medial, shapes; mesh = shapes.ball(5); print('go', flush=True);"
                  "medial.medial_axis(*mesh, resolution=1500)")
        process = subprocess.Popen(
            [sys.executable, "-c", script], stdout=subprocess.PIPE, stderr=subprocess.PIPE,
            text=True, cwd=os.path.dirname(os.path.abspath(__file__)))
        self.assertEqual(process.stdout.readline(), "go\n")
        time.sleep(0.3)
        process.send_signal(signal.SIGINT)
        _, errors = process.communicate(timeout=60)
        self.assertEqual(process.returncode, -signal.SIGINT)
        self.assertEqual(errors.splitlines()[-1], "KeyboardInterrupt")


class Threads(unittest.TestCase):
    def test_other_threads_run(self):
        rounds = [0]
        done = threading.Event()

        def count():
            while not done.is_set():
                time.sleep(0.002)
                rounds[0] += 1

        thread = threading.Thread(target=count)
        thread.start()
        start = time.monotonic()
        long_axis(resolution=400)
        seconds = time.monotonic() - start
        done.set()
        thread.join()
        # Nearly 500 are possible. With the lock held it is 50 at most, those of the progress events.
        self.assertGreater(rounds[0] / seconds, 100)

    def test_threads_may_compute_at_the_same_time(self):
        results = {}

        def compute(resolution):
            results[resolution] = medial.medial_axis(*shapes.box(), resolution=resolution)

        threads = [threading.Thread(target=compute, args=(n,)) for n in (17, 25, 33, 41)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        for resolution, axis in results.items():
            expected = medial.medial_axis(*shapes.box(), resolution=resolution)
            np.testing.assert_array_equal(axis.points, expected.points)
        self.assertEqual(len(results), 4)


class Progress(unittest.TestCase):
    def test_fractions_grow_and_phases_have_names(self):
        axis = medial.medial_axis(*shapes.ball(3), resolution=33)
        gridded = (medial.distance_field, medial.medial_axis, medial.skeleton,
                   medial.local_thickness)
        for function in (*gridded, medial.thickness, medial.reconstruction, medial.curves,
                         medial.proximity, medial.distance):
            reports = []
            parameters = {"resolution": 65} if function in gridded else {}
            subject = shapes.ball(3) if function in (*gridded, medial.thickness) else (axis,)
            subject = (*shapes.ball(3), *shapes.ball(3)) if function == medial.proximity else subject
            subject = (*shapes.ball(3), [[0, 0, 0]]) if function == medial.distance else subject
            function(*subject, **parameters,
                     progress=lambda fraction, phase: reports.append((fraction, phase)))
            fractions = [fraction for fraction, _ in reports]
            self.assertGreater(len(fractions), 1)
            self.assertEqual(fractions, sorted(fractions))
            self.assertGreaterEqual(fractions[0], 0.0)
            self.assertEqual(fractions[-1], 1.0)
            self.assertTrue(all(isinstance(phase, str) for _, phase in reports))
            self.assertTrue(any(phase for _, phase in reports))

    def test_exception_stops_the_work(self):
        calls = []

        def progress(fraction, _phase):
            calls.append(fraction)
            raise Interrupted("enough")

        with self.assertRaisesRegex(Interrupted, "enough"):
            long_axis(progress=progress)
        self.assertEqual(len(calls), 1)

    def test_what_cannot_be_called(self):
        with self.assertRaises(TypeError):
            medial.distance_field(*shapes.box(), resolution=9, progress=3)

    def test_references_are_given_back(self):
        def progress(_fraction, _phase):
            raise Interrupted

        before = sys.getrefcount(progress)
        for _ in range(50):
            with self.assertRaises(Interrupted):
                medial.distance_field(*shapes.box(), resolution=5, progress=progress)
        self.assertEqual(sys.getrefcount(progress), before)


class Processes(unittest.TestCase):
    def test_children_by_fork_compute_or_say_why_not(self):
        # In a process of its own, since what the child gets depends on what its parent has done.
        script = """
            import multiprocessing
            import medial, shapes

            def compute(engine):
                try:
                    return medial.distance_field(*shapes.box(), resolution=9, engine=engine).distance.min()
                except medial.NoGpuError as error:
                    return str(error)

            here = compute("rasteriser")
            with multiprocessing.get_context("fork").Pool(2) as pool:
                refusals = pool.map_async(compute, 2 * ["rasteriser"]).get(60)
                minima = pool.map_async(compute, 2 * ["processor"]).get(60)
            print(all("fork()" in text for text in refusals))
            print(all(abs(minimum - here) < 1e-5 for minimum in minima))
            """
        done = subprocess.run(
            [sys.executable, "-c", textwrap.dedent(script)], capture_output=True, text=True,
            timeout=120, cwd=os.path.dirname(os.path.abspath(__file__)))
        self.assertEqual((done.stdout, done.stderr), ("True\nTrue\n", ""))


class Source(VTKPythonAlgorithmBase):
    """A box from Python; VTK asks no algorithm in Python for the lock."""

    def __init__(self):
        super().__init__(nInputPorts=0, nOutputPorts=1, outputType="vtkPolyData")

    def RequestData(self, _request, _input, output):
        mesh = medial.Surface(*shapes.box()).to_vtk()
        vtkPolyData.GetData(output, 0).DeepCopy(mesh)
        return 1


class Pipelines(unittest.TestCase):
    def test_filters_before_it_are_executed(self):
        for source in (vtkCubeSource(), Source()):
            axis = medial.vtkMedialAxis()
            axis.SetInputConnection(source.GetOutputPort())
            axis.SetResolution(17)
            medial.update(axis)
            self.assertGreater(axis.GetOutput().GetNumberOfPoints(), 0)

    def test_what_was_stopped_is_executed_again(self):
        def progress(_fraction, _phase):
            raise Interrupted

        elevation = vtkElevationFilter()
        elevation.SetInputData(medial.Surface(*shapes.ball(4)).to_vtk())
        for _ in range(3):
            with self.assertRaises(Interrupted):
                medial.update(elevation, progress)
        medial.update(elevation)
        self.assertIsNotNone(elevation.GetOutput().GetPointData().GetArray("Elevation"))

    def test_only_what_failed_is_executed_again(self):
        cube = vtkCubeSource()
        executions = []
        cube.AddObserver("StartEvent", lambda _caller, _event: executions.append("cube"))
        axis = medial.vtkMedialAxis()
        axis.SetInputConnection(cube.GetOutputPort())
        axis.SetResolution(17)
        axis.SetAngle(200)
        for _ in range(2):
            with self.assertRaisesRegex(medial.Error, "angle 200"):
                medial.update(axis)
        axis.SetAngle(60)
        medial.update(axis)
        self.assertEqual(len(executions), 1)
        self.assertFalse(cube.HasObserver("ErrorEvent"))

    def test_cause_is_told_where_an_earlier_filter_fails(self):
        axis = medial.vtkMedialAxis()
        axis.SetInputData(medial.Surface(*shapes.box()).to_vtk())
        axis.SetResolution(1)
        surface = medial.vtkMedialReconstruction()
        surface.SetInputConnection(axis.GetOutputPort())
        with self.assertRaisesRegex(medial.Error, r"resolution 1 is outside \[2, 8192\]"):
            medial.update(surface)

    def test_nothing_to_execute(self):
        with self.assertRaisesRegex(medial.Error, "0 connections"):
            medial.update(medial.vtkMedialAxis())
        for value in (None, 3, vtkPolyData()):
            with self.assertRaises(TypeError):
                medial.update(value)


if __name__ == "__main__":
    unittest.main()
