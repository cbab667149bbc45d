# SPDX-License-Identifier: BSD-3-Clause
"""The XML of the ParaView plugin says of the filters what is true. Needs no ParaView."""

import os
import re
import subprocess
import tempfile
import unittest
from xml.etree import ElementTree

import surfaceflattening as sf
from surfaces import SOURCE

TEMPLATE = os.path.join(SOURCE, "Plugin", "SurfaceFlattening.xml.in")
# Set methods of a filter that are inputs of its proxy, set what another one sets, or are of a data set.
INPUTS = {"SetCurvesConnection", "SetCurvesData", "SetFlatConnection", "SetFlatData",
          "SetEdgesConnection", "SetEdgesData", "SetDesignConnection", "SetDesignData", "SetBodyConnection", "SetBodyData",
          "SetControlPointsConnection", "SetControlPointsData",
          "SetNumberOfControlPoints", "SetFileName", "SetFileFormat", "SetLengthUnitOf"}
# What ParaView's users want and other programs do not: pieces beside the surface in one view, every
# process of the server at work, and one input of a writer.
OTHER_DEFAULTS = {"BesideSurface": (1.0,), "Distributed": (1.0,), "FollowPipeline": (1.0,)}
# Those of the writer that are of some formats alone, or are given by name, or twice.
FABRIC = {"SetFabricWidth", "SetFabricNap", "SetFabricGap"}
OF_FORMATS = {"pdf": {"SetPaper", "SetPageOverlap", "SetMaximumPages", "SetWalkTable", *FABRIC},
              "svg": {"SetLaserColors", *FABRIC}, "plt": FABRIC, "dxf": {"SetCutterStyle"}}
BY_NAME = {"SetPieceName", "SetPieceQuantity", "SetCurveAllowance", "SetCurveDartTip",
           "SetCurveFairTolerance", "SetUnitByName"}


def own_set_methods(cls):
    """Set methods of our classes, not those of VTK."""
    names = set()
    for base in cls.__mro__:
        if base.__module__.startswith("surfaceflattening"):
            names |= {name for name in vars(base) if re.match(r"Set[A-Z]", name)}
    return {name for name in names if not re.match(r"Set\w+To[A-Z]", name)} - INPUTS


def with_inherited(proxy, root):
    """A proxy with the elements of its base, where that is none of the menu's."""
    group = proxy.get("base_proxygroup", "")
    if not group.startswith("internal_"):
        return proxy
    path = f"./ProxyGroup[@name='{group}']/{proxy.tag}[@name='{proxy.get('base_proxyname')}']"
    own = {element.get("name") for element in proxy if element.get("name")}
    whole = ElementTree.Element(proxy.tag, proxy.attrib)
    whole.extend(element for element in with_inherited(root.find(path), root)
                 if element.get("name") not in own and element.tag not in ("Documentation", "Hints"))
    whole.extend(proxy)
    return whole


class Description(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "plugin.xml")
            subprocess.run([os.environ["WRITE_OPTIONS"], TEMPLATE, path], check=True)
            root = ElementTree.parse(path).getroot()
        cls.proxies, cls.writers = ([with_inherited(proxy, root) for group in groups
                                     for proxy in root.findall(f"./ProxyGroup[@name='{group}']/{tag}")]
                                    for groups, tag in ((("sources", "filters"), "SourceProxy"), (("writers",), "WriterProxy")))

    def properties(self):
        for proxy in (*self.proxies, *self.writers):
            filter_ = getattr(sf, proxy.get("class"))()
            for element in proxy:
                if (element.tag.endswith("VectorProperty") and not element.get("information_only")
                        and not element.get("repeat_command") and element.get("name") != "FileName"):
                    yield filter_, element, f"{proxy.get('name')}.{element.get('name')}"

    @staticmethod
    def get(filter_, element):
        value = getattr(filter_, "Get" + element.get("command")[3:])()
        return value if isinstance(value, tuple) else (value,)

    def test_every_filter_has_a_proxy(self):
        filters = {name for name in dir(sf) if name.startswith("vtk")
                   and isinstance(getattr(sf, name), type)
                   and name not in ("vtkFlatteningAlgorithm", "vtkFeatureCurveAlgorithm", "vtkFlatPieceAlgorithm",
                                    "vtkFeatureCurveEditor", "vtkPatternWriter")}
        self.assertEqual({proxy.get("class") for proxy in self.proxies}, filters)
        for proxy in self.proxies:
            self.assertTrue(proxy.find("Documentation").get("short_help"))
            # paraview.simple calls a proxy by its label.
            self.assertIn(proxy.get("label"), {
                re.sub(r"(?<=[a-z])(?=[A-Z])", " ", proxy.get("name")), "Flatten Surface (Wire Warping)"})

    def test_every_method_has_a_property(self):
        by_name = {proxy.get("name"): proxy for proxy in self.proxies}
        for proxy in self.proxies:
            base = by_name.get(proxy.get("base_proxyname"), ())
            commands = {element.get("command") for element in (*proxy, *base)}
            missing = own_set_methods(getattr(sf, proxy.get("class"))) - commands
            self.assertEqual(missing, set(), proxy.get("name"))

    def test_every_format_of_patterns_has_a_writer_with_all_options(self):
        factories = {writer.find("Hints/WriterFactory").get("extensions"): writer
                     for writer in self.writers}
        self.assertEqual(set(factories), {"svg", "pdf", "dxf", "plt", "json"})
        for extension, writer in factories.items():
            self.assertEqual(writer.get("class"), "vtkPatternWriter")
            commands = {element.get("command") for element in writer if element.get("command")}
            others = set().union(*OF_FORMATS.values()) - OF_FORMATS.get(extension, set())
            self.assertEqual(commands - {"SetFileName", "SetInputConnection"},
                             own_set_methods(sf.vtkPatternWriter) - BY_NAME - others)

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
            own = tuple(float(value) for value in self.get(filter_, element))
            other = OTHER_DEFAULTS.get(element.get("name"))
            self.assertEqual(default, other or own, name)
            self.assertNotEqual(own, other, f"{name} needs no other default")
            count += 1
        self.assertGreater(count, 20)

    def test_ends_of_ranges_are_valid(self):
        for filter_, element, name in self.properties():
            for domain in element:
                if not domain.tag.endswith("RangeDomain"):
                    continue
                for end in (domain.get("min"), domain.get("max")):
                    self.assertIsNotNone(end, f"{name} has no slider")
                    number = int if element.tag.startswith("Int") else float
                    values = tuple(number(word) for word in end.split())
                    getattr(filter_, element.get("command"))(*values)
                    self.assertEqual(self.get(filter_, element), values, name)


if __name__ == "__main__":
    unittest.main()
