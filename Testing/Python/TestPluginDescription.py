# SPDX-License-Identifier: BSD-3-Clause
"""The XML of the ParaView plugin says of the filters what is true. Needs no ParaView."""

import os
import re
import unittest
from xml.etree import ElementTree

import surfaceflattening as sf
from surfaces import SOURCE

XML = os.path.join(SOURCE, "Plugin", "SurfaceFlattening.xml")
# Set methods of a filter that are inputs of its proxy, or set what another one sets.
INPUTS = {"SetCurvesConnection", "SetCurvesData", "SetFlatConnection", "SetFlatData",
          "SetEdgesConnection", "SetEdgesData", "SetControlPointsConnection", "SetControlPointsData",
          "SetNumberOfControlPoints"}


def own_set_methods(cls):
    """Set methods of our classes, not those of VTK."""
    names = set()
    for base in cls.__mro__:
        if base.__module__.startswith("surfaceflattening"):
            names |= {name for name in vars(base) if re.match(r"Set[A-Z]", name)}
    return {name for name in names if not re.match(r"Set\w+To[A-Z]", name)} - INPUTS


class Description(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.proxies = ElementTree.parse(XML).getroot().findall(".//SourceProxy")

    def properties(self):
        for proxy in self.proxies:
            filter_ = getattr(sf, proxy.get("class"))()
            for element in proxy:
                if (element.tag.endswith("VectorProperty") and not element.get("information_only")
                        and not element.get("repeat_command")):
                    yield filter_, element, f"{proxy.get('name')}.{element.get('name')}"

    @staticmethod
    def get(filter_, element):
        value = getattr(filter_, "Get" + element.get("command")[3:])()
        return value if isinstance(value, tuple) else (value,)

    def test_every_filter_has_a_proxy(self):
        filters = {name for name in sf.__all__ if name.startswith("vtk")
                   and name not in ("vtkFlatteningAlgorithm", "vtkFeatureCurveAlgorithm",
                                    "vtkFeatureCurveEditor", "vtkPatternWriter")}
        self.assertEqual({proxy.get("class") for proxy in self.proxies}, filters)
        for proxy in self.proxies:
            self.assertEqual(proxy.find("Hints/ShowInMenu").get("category"), "Surface Flattening")
            self.assertTrue(proxy.find("Documentation").get("short_help"))
            # paraview.simple calls a proxy by its label.
            self.assertEqual(proxy.get("label").replace(" ", ""), proxy.get("name"))

    def test_every_method_has_a_property(self):
        by_name = {proxy.get("name"): proxy for proxy in self.proxies}
        for proxy in self.proxies:
            base = by_name.get(proxy.get("base_proxyname"), ())
            commands = {element.get("command") for element in (*proxy, *base)}
            missing = own_set_methods(getattr(sf, proxy.get("class"))) - commands
            self.assertEqual(missing, set(), proxy.get("name"))

    def test_every_property_is_documented_and_in_one_group(self):
        for _, element, name in self.properties():
            self.assertTrue((element.findtext("Documentation") or "").strip(), name)
        for proxy in self.proxies:
            grouped = [item.get("name") for group in proxy.findall("PropertyGroup") for item in group]
            own = {element.get("name") for element in proxy if element.get("command")}
            self.assertEqual(len(grouped), len(set(grouped)), proxy.get("name"))
            self.assertLessEqual(set(grouped), own, proxy.get("name"))

    def test_defaults_are_those_of_the_class(self):
        count = 0
        for filter_, element, name in self.properties():
            if element.tag.startswith("String"):
                self.assertEqual(self.get(filter_, element), (element.get("default_values"),), name)
                continue
            default = tuple(float(word) for word in element.get("default_values").split())
            self.assertEqual(default, tuple(float(value) for value in self.get(filter_, element)), name)
            count += 1
        self.assertGreater(count, 20)

    def test_ends_of_ranges_are_valid(self):
        for filter_, element, name in self.properties():
            for domain in element:
                if not domain.tag.endswith("RangeDomain"):
                    continue
                for end in (domain.get("min"), domain.get("max")):
                    self.assertIsNotNone(end, f"{name} has no slider")
                    value = int(end) if element.tag.startswith("Int") else float(end)
                    getattr(filter_, element.get("command"))(value)
                    self.assertEqual(self.get(filter_, element), (value,), name)

    def test_lists_are_the_enumerations_of_the_class(self):
        count = 0
        for filter_, element, name in self.properties():
            domain = element.find("EnumerationDomain")
            if domain is None:
                continue
            values = {int(entry.get("value")): entry.get("text") for entry in domain}
            for value, text in values.items():
                getattr(filter_, element.get("command"))(value)
                self.assertEqual(self.get(filter_, element), (value,), name)
                own = getattr(filter_, f"Get{element.get('command')[3:]}AsString")()
                self.assertEqual(re.sub(r"\W", "", text).lower(), re.sub(r"\W", "", own).lower(), name)
            getattr(filter_, element.get("command"))(max(values) + 1)
            self.assertEqual(self.get(filter_, element), (max(values),), f"{name} leaves some out")
            count += 1
        self.assertGreaterEqual(count, 3)


if __name__ == "__main__":
    unittest.main()
