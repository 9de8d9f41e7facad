"""The package's documents are right: examples run, parameters are worded as elsewhere.

usage: manual_test.py SOURCES
"""

import contextlib
import doctest
import importlib
import inspect
import os
import pkgutil
import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import medial

SOURCES = Path(sys.argv[1])
FUNCTIONS = (medial.distance_field, medial.medial_axis, medial.thickness, medial.thickness_regions,
             medial.reconstruction, medial.curves, medial.skeleton, medial.local_thickness, medial.distance, medial.proximity,
             medial.read_mesh, medial.read_scan, medial.scan_surface, medial.update)
# The options of medial-axis, by the parameters that are the same.
OPTIONS = {
    medial.distance_field: ("resolution", "spacing", "padding", "memory"),
    medial.medial_axis: ("angle", "lambda", "min-radius", "side", "max-spheres", "topology"),
    medial.skeleton: ("min-branch",),
}


def words(text):
    """Without line breaks and quotes."""
    return " ".join(re.sub(r"[`\"]", "", text).split())


def option(name):
    """What the table of the command line's tutorial says about an option."""
    text = (SOURCES / "docs/COMMAND-LINE.md").read_text()
    row = re.search(rf"^\| `--{name} [^|`]*` \| (.*) \|$", text, re.MULTILINE)[1]
    return words(row)


def stated_default(function, parameter):
    """The default that the description of a parameter states."""
    description = re.search(rf"\n    {parameter}: (.*?)\n    \w", function.__doc__, re.DOTALL)[1]
    return re.search(r"default ([\w.]+\w)", description)[1]


@contextlib.contextmanager
def scratch_folder():
    """Makes an empty folder the current one."""
    before = os.getcwd()
    with tempfile.TemporaryDirectory() as folder:
        os.chdir(folder)
        try:
            yield
        finally:
            os.chdir(before)


class Examples(unittest.TestCase):
    def test_of_the_package(self):
        attempted = 0
        for module in pkgutil.iter_modules(medial.__path__, "medial."):
            with self.subTest(module=module.name):
                result = doctest.testmod(importlib.import_module(module.name))
                self.assertEqual(result.failed, 0)
                attempted += result.attempted
        self.assertGreater(attempted, 10)

    def test_of_the_tutorial(self):
        text = (SOURCES / "docs/PYTHON.md").read_text()
        code = "\n".join(re.findall(r"^```pycon\n(.*?)^```$", text, re.MULTILINE | re.DOTALL))
        test = doctest.DocTestParser().get_doctest(code, {}, "PYTHON.md", None, None)
        self.assertGreater(len(test.examples), 20)
        with scratch_folder():
            self.assertEqual(doctest.DocTestRunner().run(test).failed, 0)


    def test_of_several_processes(self):
        text = (SOURCES / "docs/PYTHON.md").read_text()
        code = re.search(r"^```python\n(import multiprocessing\n.*?)^```$", text,
                         re.MULTILINE | re.DOTALL)[1]
        with scratch_folder():
            Path("batch.py").write_text(code)
            for name, size in (("a", 1), ("b", 2)):
                corners = [f"{x} {y} {z}" for x in (0, size) for y in (0, size) for z in (0, size)]
                Path(f"{name}.off").write_text("\n".join([
                    "OFF", "8 6 0", *corners, "4 0 1 3 2", "4 4 6 7 5", "4 0 4 5 1", "4 2 3 7 6",
                    "4 0 2 6 4", "4 1 5 7 3"]))
            done = subprocess.run([sys.executable, "batch.py"], capture_output=True, text=True,
                                  timeout=300, check=True)
        radii = dict(line.split() for line in done.stdout.splitlines())
        self.assertAlmostEqual(float(radii["a.off"]), 0.5, places=3)
        self.assertAlmostEqual(float(radii["b.off"]), 1.0, places=3)


class Wording(unittest.TestCase):
    def test_every_parameter_is_documented(self):
        for function in FUNCTIONS:
            for name in inspect.signature(function).parameters:
                with self.subTest(function=function.__name__, parameter=name):
                    # Alone or in a list of names, at the beginning of a line.
                    self.assertRegex(function.__doc__, rf"\n +([\w,\s]+, )?\s*{name}\b[\w,\s]*: ")

    def test_attributes_are_documented(self):
        for class_ in (medial.DistanceField, medial.MedialAxis, medial.Surface, medial.Curve,
                       medial.Proximity, medial.Contacts, medial.LocalThickness, medial.Distribution, medial.Skeleton, medial.Branch,
                       medial.ThicknessRegion, medial.DividedThickness, medial.PointDistances):
            source = inspect.getsource(class_)
            for name in class_.__annotations__:
                with self.subTest(class_=class_.__name__, attribute=name):
                    self.assertRegex(source, rf"\n    {name}: [^\n]+\n    \"\"\"")

    def test_parameters_are_worded_as_the_options_of_the_program(self):
        for function, names in OPTIONS.items():
            text = words(function.__doc__)
            for name in names:
                # Both texts have the meaning and the range.
                meaning = re.split(r", in world units|: |; ", option(name))[0]
                ranges = re.findall(r"in [\[(][^])]*[])]|>= ?\d+|> 0", option(name))
                with self.subTest(option=name):
                    for phrase in [meaning, *ranges]:
                        self.assertIn(phrase.replace("at most N balls", "at most so many balls"),
                                      text)

    def test_defaults_are_those_of_the_program(self):
        for function, names in OPTIONS.items():
            parameters = inspect.signature(function).parameters
            for name in names:
                stated = re.search(r"default ([\w.]+)", option(name))
                if stated:
                    parameter = {"lambda": "min_lambda"}.get(name, name.replace("-", "_"))
                    value = parameters[parameter].default
                    with self.subTest(option=name):
                        if value is None:  # so that others can see whether it was given
                            value = stated_default(function, parameter)
                        expected = stated[1] if isinstance(value, str) else float(stated[1])
                        self.assertEqual(value, expected)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
