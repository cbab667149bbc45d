# SPDX-License-Identifier: BSD-3-Clause
"""The plugin's filters run from ParaView, with optional inputs, properties, refusals, collections."""

import json
import math
import os
import re
import tempfile
import unittest
from xml.etree import ElementTree

import paraview.simple as pv
from vtkmodules.vtkFiltersCore import vtkMassProperties

from plugin import OUTPUT, fetch, read, values


class Plugin(unittest.TestCase):
    def tearDown(self):
        for proxy in list(pv.GetSources().values()):
            pv.Delete(proxy)

    def test_a_material_is_chosen_from_the_known_ones_or_a_file(self):
        flattening = pv.FlattenSurfaceWireWarping(Input=read("shirt_front"), Scheme="Global")
        known = list(flattening.GetProperty("Material").Available)
        self.assertEqual(known[:2], ["", "isotropic"])
        self.assertIn("leather", known)
        flattening.Material = "leather"
        self.assertEqual(values(fetch(flattening, 3), "ShearLimit"), [5.0])
        with tempfile.TemporaryDirectory() as folder:
            flattening.MaterialFile = os.path.join(folder, "cloth.json")
            with open(flattening.MaterialFile, "w", encoding="utf-8") as file:
                json.dump({"warp": 2000, "weft": 1000, "shear": 20, "limits": {"shear": 12}}, file)
            self.assertAlmostEqual(values(fetch(flattening, 3), "ShearLimit")[0], 12.0, 9)
        flattening.MaterialFile = ""
        self.assertEqual(values(fetch(flattening, 3), "ShearLimit"), [5.0])

    def test_every_proxy_can_be_made(self):
        tree = ElementTree.parse(os.path.join(os.environ["FLATTENING_BINARY"], "Plugin", "SurfaceFlattening.xml"))
        proxies = [(group, proxy) for group in ("sources", "filters")
                   for proxy in tree.getroot().findall(f"./ProxyGroup[@name='{group}']/SourceProxy")]
        self.assertGreaterEqual(len(proxies), 6)
        for group, proxy in proxies:
            inputs = {"Input": read("quarter_sphere")} if group == "filters" else {}
            made = getattr(pv, re.sub(r"\W", "", proxy.get("label")))(**inputs)
            for name in ("StatusName", "Distributed") if proxy.get("base_proxyname") else ():
                self.assertIsNotNone(made.SMProxy.GetProperty(name), proxy.get("name"))
            for element in proxy:
                if element.get("default_values") and not element.get("information_only"):
                    self.assertIsNotNone(made.GetProperty(element.get("name")))

    def test_a_pattern_of_garmentcode_is_opened_as_pieces_with_wires(self):
        corners = [[0.0, 0.0], [30.0, 0.0], [30.0, 40.0], [0.0, 40.0]]
        panel = {"translation": [0.0, 70.0, 25.0], "rotation": [0.0, 0.0, 0.0], "vertices": corners,
                 "edges": [{"endpoints": [k, (k + 1) % 4]} for k in range(4)]}
        seam = [{"panel": "front", "edge": 1}, {"panel": "back", "edge": 3}]
        document = {"pattern": {"panels": {"front": panel, "back": {**panel, "translation": [0.0, 70.0, -25.0]}},
                                "stitches": [seam]},
                    "properties": {"curvature_coords": "relative", "units_in_meter": 100}}
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "skirt.json")
            with open(path, "w", encoding="utf-8") as file:
                json.dump(document, file)
            reader = pv.GarmentCodeReader(FileName=path)
            flat, wires, placed = (fetch(reader, port) for port in range(3))
        for pieces in (flat, placed):
            measured = vtkMassProperties()
            measured.SetInputData(pieces)
            measured.Update()
            self.assertAlmostEqual(measured.GetSurfaceArea(), 2 * 30 * 40, delta=1e-6)
        self.assertEqual(sorted({placed.GetPoint(k)[2] for k in range(placed.GetNumberOfPoints())}), [-25.0, 25.0])
        self.assertGreater(wires.GetNumberOfLines(), 2)

    def test_curves_are_optional_and_may_be_several(self):
        surface = read("pants_front")
        filter_ = pv.FlattenSurfaceWireWarping(Input=surface)
        self.assertEqual(values(fetch(filter_, 3), "WirePatches"), [1])
        filter_.Curves = read("pants_front_curves")
        patches = values(fetch(filter_, 3), "WirePatches")[0]
        self.assertGreater(patches, 1)
        names = values(fetch(filter_, 4), "Name")
        # An edge of the surface inside a wire-patch: a wire more, of its length, and no patch more.
        cut = fetch(filter_, 2)
        edge = [cut.GetPoint(cut.GetCell(500).GetPointId(k)) for k in range(2)]
        filter_.Curves = [read("pants_front_curves"), pv.Line(Point1=edge[0], Point2=edge[1])]
        curves = fetch(filter_, 4)
        filter_.UpdatePropertyInformation()
        self.assertEqual(filter_.Status, "Ok", filter_.StatusMessage)
        self.assertEqual(values(curves, "Name"), [*names, f"curve {len(names)}"])
        for column in ("RestLength", "FlatLength"):
            self.assertAlmostEqual(values(curves, column)[-1], math.dist(*edge), delta=1e-9)
        self.assertEqual(values(fetch(filter_, 3), "WirePatches"), [patches])
        filter_.Curves = None
        self.assertEqual(values(fetch(filter_, 3), "WirePatches"), [1])

    def test_properties_reach_the_filter(self):
        filter_ = pv.FlattenSurfaceWireWarping(
            Input=read("pants_front"), Curves=read("pants_front_curves"), Scheme="Global")
        objective = values(fetch(filter_, 3), "Objective")[0]
        filter_.ReleaseKeys = 1
        self.assertLess(values(fetch(filter_, 3), "Objective")[0], objective)
        filter_.ReleaseKeys = 0
        filter_.Scheme = "Progressive"
        flat = fetch(filter_)
        order = flat.GetCellData().GetArray("WarpingOrder")
        self.assertEqual(order.GetRange(), (0.0, values(fetch(filter_, 3), "WirePatches")[0] - 1.0))
        name = values(fetch(filter_, 4), "Name")[0]
        filter_.Tolerances = [name, "0.1"]
        filter_.Ease = [name, "-1", "0.05"]
        curves = fetch(filter_, 4)
        self.assertEqual(values(curves, "Tolerance")[0], 0.1)
        self.assertGreater(values(curves, "FlatLength")[0], values(curves, "RestLength")[0])
        filter_.Tolerances = filter_.Ease = []
        filter_.Scheme = "Isometric"
        self.assertGreater(values(fetch(filter_, 3), "DistortionEnergy")[0], 0.0)
        self.assertLess(values(fetch(filter_, 3), "MaxEdgeLengthError")[0], 1e-9)

    def test_outputs_have_names(self):
        filter_ = pv.FlattenSurfaceWireWarping(Input=read("quarter_sphere"))
        for port, name in enumerate(("Flat Pieces", "Wires", "Cut Surface")):
            self.assertEqual(pv.OutputPort(filter_, name).Port, port)
        bounds = fetch(filter_, 0).GetBounds()
        self.assertEqual(bounds[4:], (0.0, 0.0))
        self.assertGreater(fetch(filter_, 1).GetNumberOfLines(), 0)
        self.assertNotEqual(fetch(filter_, 2).GetBounds()[4:], (0.0, 0.0))

    def test_what_is_refused_is_named(self):
        filter_ = pv.FlattenSurfaceWireWarping(Input=pv.Sphere())
        filter_.UpdatePipeline()
        filter_.UpdatePropertyInformation()
        self.assertEqual(filter_.Status, "ClosedSurface")
        self.assertIn("the surface is closed", filter_.StatusMessage)
        self.assertEqual(fetch(filter_).GetNumberOfPoints(), 0)
        self.assertEqual(values(fetch(filter_), "RunStatus"), ["ClosedSurface"])
        filter_.Input = read("quarter_sphere")
        self.assertEqual(fetch(filter_).GetNumberOfCells(), 56)

    def test_filters_form_a_pipeline(self):
        surface, curves = read("shirt_front"), read("shirt_front_curves")
        flattening = pv.FlattenSurfaceWireWarping(Input=surface, Curves=curves)
        quality = pv.FlatteningQuality(
            Input=pv.OutputPort(flattening, 2), FlatSurface=pv.OutputPort(flattening, 0),
            Edges=pv.OutputPort(flattening, 1))
        for name in ("EdgeLengthError", "AngleErrorMean", "GlobalHomogeneity", "AreaError"):
            self.assertAlmostEqual(
                values(fetch(quality, 1), name)[0], values(fetch(flattening, 3), name)[0], 10)
        cutter = pv.FeatureCurveCutter(Input=surface, Curves=curves)
        self.assertEqual(
            fetch(cutter).GetNumberOfPoints(), fetch(flattening).GetNumberOfPoints())
        imprinter = pv.FeatureCurveImprinter(Input=surface, Curves=curves)
        self.assertEqual(fetch(imprinter).GetNumberOfCells(), 1414)
        measured = fetch(pv.SurfaceDevelopability(Input=surface))
        low, high = measured.GetPointData().GetArray("Developability").GetRange()
        self.assertTrue(0.0 <= low < high < 3.2)
        conformal = pv.LeastSquaresConformalMap(Input=surface, Curves=curves)
        self.assertGreater(values(fetch(conformal, 3), "EdgeLengthError")[0], 1e-3)

    def test_a_picked_curve_is_kept_by_a_state(self):
        # Points off the surface, as picks on chords are; name and type as the panel sets them.
        picks = [-11.3, 34.1, 11.5, 0.3, 36.0, 12.0, 11.6, 34.1, 11.2]
        surface = read("shirt_front")
        pv.RenameSource("shirt", surface)
        curve = pv.SurfaceCurve(Input=surface, Points=picks, Name="bust line", Type="Key")
        pv.RenameSource("bust", curve)
        flattening = pv.FlattenSurfaceWireWarping(Input=surface, Curves=curve)
        pv.RenameSource("flat", flattening)
        before = fetch(flattening)
        file = os.path.join(OUTPUT, "picked.pvsm")
        pv.SaveState(file)
        self.tearDown()
        pv.LoadState(file)
        curve = pv.FindSource("bust")
        self.assertEqual(curve.Type, "Key")
        self.assertEqual(curve.Name, "bust line")
        self.assertEqual(list(curve.Points), picks)
        drawn = fetch(curve)
        self.assertEqual(drawn.GetCellData().GetAbstractArray("CurveName").GetValue(0), "bust line")
        after = fetch(pv.FindSource("flat"))
        self.assertEqual(values(after, "RunStatus"), ["Ok"])
        self.assertEqual(after.GetBounds(), before.GetBounds())
        self.assertIn("bust line", values(fetch(pv.FindSource("flat"), 4), "Name"))

    def test_a_collection_is_flattened_block_by_block(self):
        names = ("quarter_sphere", "shirt_shoulder", "cone")
        collection = pv.GroupDatasets(Input=[read(name) for name in names])
        flattening = pv.FlattenSurfaceWireWarping(Input=collection)
        beside = fetch(flattening)
        boxes = [beside.GetBlock(block).GetBounds() for block in range(len(names))]
        space = flattening.Input.GetDataInformation().GetBounds()
        for k, box in enumerate(boxes):
            self.assertGreater(box[0], space[1])
            for other in boxes[:k]:  # side by side, or in rows
                self.assertTrue(box[0] >= other[1] or other[0] >= box[1]
                                or box[2] >= other[3] or other[2] >= box[3])
        flattening.BesideSurface = 0
        flat = fetch(flattening)
        self.assertEqual(flat.GetNumberOfBlocks(), len(names))
        for block, name in enumerate(names):
            alone = fetch(pv.FlattenSurfaceWireWarping(Input=read(name), BesideSurface=0))
            self.assertEqual(flat.GetBlock(block).GetBounds(), alone.GetBounds())
            self.assertEqual(values(flat.GetBlock(block), "RunStatus"), ["Ok"])


if __name__ == "__main__":
    unittest.main()
