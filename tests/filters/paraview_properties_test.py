"""ParaView's properties have the texts, ranges and defaults of the headers, and none is missing.

usage: paraview_properties_test.py FILTERS-FOLDER
"""

import re
import sys
import unittest
import xml.etree.ElementTree as ElementTree
from pathlib import Path

FILTERS = Path(sys.argv[1])
XML = ElementTree.parse(FILTERS / "paraview/medial.xml").getroot()
PARAVIEWS_OWN = "ParaView "  # starts sentences that no header has


def plain(text):
    """Comparable wording: one line, lower case, enumerators without their prefixes."""
    text = re.sub(r"^\s*\*", "", text, flags=re.MULTILINE)
    return re.sub(r"\b(sign|engine)_", "", " ".join(text.split()).lower())


def sentences(text):
    return [part for part in re.split(r"(?<=[.])\s+", " ".join(text.split())) if part]


def header_text(name):
    """A header with parameters that several filters have in place of their macros."""
    text = (FILTERS / f"{name}.h").read_text()
    shared = (FILTERS / "vtkMedialParameters.h").read_text()
    for macro, lines in re.findall(r"#define (\w+)\(\)((?:.*\\\n)+.*)\n", shared):
        text = text.replace(f"{macro}();", lines.replace("\\\n", "\n") + ";")
    return text


class Header:
    """The manual of a class and of its parameters."""

    def __init__(self, name):
        text = header_text(name)
        self.manual = plain(text[:text.index("#ifndef")])
        self.parameters = {}
        for block in re.findall(r"///@\{\n\s*/\*\*(.*?)\*/(.*?)///@\}", text, re.DOTALL):
            macros = r"vtkSet(?:Vector3)?Macro\((\w+)[,)]"
            objects = r"virtual void Set(\w+)\((?:vtk\w+|const char)\*"
            for setter in re.findall(macros, block[1]) + re.findall(objects, block[1]):
                self.parameters[setter] = plain(block[0])


def proxies():
    for proxy in XML.iter("SourceProxy"):
        yield proxy, Header(proxy.get("class"))


def properties(proxy):
    """Properties that are parameters of the filter, by name."""
    return {element.get("name"): element for element in proxy
            if element.tag.endswith(("VectorProperty", "ProxyProperty")) and element.get("information_only") != "1"}


def stated_default(manual):
    """The default that a manual gives, as the text of an XML attribute."""
    value = re.search(r"default is (\([^)]*\)|[^ :]+?)(?:\.$|\. |:| for)", manual + " ")[1]
    words = {"on": "1", "off": "0", "empty": ""}
    return words.get(value, value.strip("()").replace(",", ""))


def default_of(element):
    entries = {entry.get("value"): plain(entry.get("text")) for entry in element.iter("Entry")}
    return entries.get(element.get("default_values"), element.get("default_values"))


class Properties(unittest.TestCase):
    def test_all_filters_are_in_the_menu(self):
        classes = {proxy.get("class") for proxy, _ in proxies()
                   if proxy.find("Hints/ShowInMenu[@category='Medial']") is not None}
        self.assertEqual(classes, {"vtkMeshDistanceField", "vtkMedialAxis", "vtkMedialThickness",
                                   "vtkMedialReconstruction", "vtkMedialCurves", "vtkMedialSkeleton", "vtkMeshProximity",
                                   "vtkMedialLocalThickness",
                                   "vtkMeshPointDistance"})

    def test_every_parameter_is_a_property(self):
        for proxy, header in proxies():
            self.assertEqual(set(properties(proxy)), set(header.parameters), proxy.get("class"))
            for name, element in properties(proxy).items():
                self.assertEqual(element.get("command"), f"Set{name}")

    def test_texts_are_those_of_the_headers(self):
        for proxy, header in proxies():
            for element in [proxy, *proxy]:
                manual = header.parameters.get(element.get("name"), header.manual)
                for text in sentences(element.findtext("Documentation", "")):
                    with self.subTest(proxy=proxy.get("class"), text=text):
                        if not text.startswith(PARAVIEWS_OWN):
                            self.assertIn(plain(text), manual)

    def test_every_property_is_explained(self):
        for proxy, _ in proxies():
            for name, element in properties(proxy).items():
                with self.subTest(proxy=proxy.get("class"), name=name):
                    text = plain(element.findtext("Documentation", ""))
                    self.assertRegex(text, "default is|paraview ")

    def test_defaults_are_those_of_the_headers(self):
        for proxy, header in proxies():
            for name, element in properties(proxy).items():
                with self.subTest(proxy=proxy.get("class"), name=name):
                    if PARAVIEWS_OWN not in element.findtext("Documentation"):
                        self.assertEqual(default_of(element),
                                         stated_default(header.parameters[name]))

    def test_ranges_are_those_of_the_headers(self):
        for proxy, header in proxies():
            for name, element in properties(proxy).items():
                domain = element.find("*[@max][@min]")
                if domain is not None and name != "Angle":  # an open interval
                    span = f"in [{domain.get('min')}, {domain.get('max')}]"
                    with self.subTest(proxy=proxy.get("class"), name=name):
                        self.assertIn(span, header.parameters[name])

    def test_values_are_those_of_the_headers(self):
        for proxy, _ in proxies():
            text = plain(header_text(proxy.get("class")))
            stated = [sorted(re.findall(r"(\w+) = (\d)", values))
                      for values in re.findall(r"enum \w+ \{([^}]*)\}", text)]
            for name, element in properties(proxy).items():
                entries = [(plain(e.get("text")), e.get("value")) for e in element.iter("Entry")]
                if entries:
                    with self.subTest(proxy=proxy.get("class"), name=name):
                        self.assertIn(sorted(entries), stated)

    def test_groups_have_every_property_but_single_ones(self):
        alone = {"SignMethod", "GenerateDistanceField", "NumberOfThreads", "DistributedInput"}
        for proxy, _ in proxies():
            grouped = {p.get("name") for p in proxy.findall("PropertyGroup/Property")}
            self.assertEqual(set(properties(proxy)) - grouped - alone, set())
            self.assertLessEqual(grouped, set(properties(proxy)))


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
