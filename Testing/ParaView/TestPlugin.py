# SPDX-License-Identifier: BSD-3-Clause
"""The plugin's filters run from ParaView, with optional inputs, properties, refusals, collections."""

import math
import os
import unittest
from xml.etree import ElementTree

import paraview.simple as pv

from plugin import SOURCE, fetch, read, values


class Plugin(unittest.TestCase):
    def tearDown(self):
        for proxy in list(pv.GetSources().values()):
            pv.Delete(proxy)

    def test_every_proxy_can_be_made(self):
        tree = ElementTree.parse(os.path.join(SOURCE, "Plugin", "SurfaceFlattening.xml"))
        proxies = tree.getroot().findall(".//SourceProxy")
        self.assertGreaterEqual(len(proxies), 6)
        for proxy in proxies:
            made = getattr(pv, proxy.get("name"))(Input=read("quarter_sphere"))
            for element in proxy:
                if element.get("default_values") and not element.get("information_only"):
                    self.assertIsNotNone(made.GetProperty(element.get("name")))

    def test_curves_are_optional_and_may_be_several(self):
        surface = read("pants_front")
        filter_ = pv.WireWarping(Input=surface)
        self.assertEqual(values(fetch(filter_), "WirePatches"), [1])
        filter_.Curves = read("pants_front_curves")
        patches = values(fetch(filter_), "WirePatches")[0]
        self.assertGreater(patches, 1)
        names = values(fetch(filter_, 1), "CurveNames")
        # An edge of the surface inside a wire-patch: a wire more, of its length, and no patch more.
        cut = fetch(filter_, 2)
        edge = [cut.GetPoint(cut.GetCell(500).GetPointId(k)) for k in range(2)]
        filter_.Curves = [read("pants_front_curves"), pv.Line(Point1=edge[0], Point2=edge[1])]
        wires = fetch(filter_, 1)
        filter_.UpdatePropertyInformation()
        self.assertEqual(filter_.Status, "Ok", filter_.StatusMessage)
        self.assertEqual(values(wires, "CurveNames"), [*names, f"curve {len(names)}"])
        for array in ("CurveRestLengths", "CurveFlatLengths"):
            self.assertAlmostEqual(values(wires, array)[-1], math.dist(*edge), delta=1e-9)
        self.assertEqual(values(fetch(filter_), "WirePatches"), [patches])
        filter_.Curves = None
        self.assertEqual(values(fetch(filter_), "WirePatches"), [1])

    def test_properties_reach_the_filter(self):
        filter_ = pv.WireWarping(
            Input=read("pants_front"), Curves=read("pants_front_curves"), Scheme="Global")
        objective = values(fetch(filter_), "Objective")[0]
        filter_.ReleaseKeys = 1
        self.assertLess(values(fetch(filter_), "Objective")[0], objective)
        filter_.ReleaseKeys = 0
        filter_.Scheme = "Progressive"
        flat = fetch(filter_)
        order = flat.GetCellData().GetArray("WarpingOrder")
        self.assertEqual(order.GetRange(), (0.0, values(flat, "WirePatches")[0] - 1.0))
        filter_.Scheme = "Least squares conformal"
        self.assertGreater(values(fetch(filter_), "EdgeLengthError")[0], 1e-3)
        filter_.Scheme = "Isometric"
        self.assertGreater(values(fetch(filter_), "DistortionEnergy")[0], 0.0)
        self.assertLess(values(fetch(filter_), "MaxEdgeLengthError")[0], 1e-9)

    def test_outputs_have_names(self):
        filter_ = pv.WireWarping(Input=read("quarter_sphere"))
        for port, name in enumerate(("Flat Pieces", "Wires", "Cut Surface")):
            self.assertEqual(pv.OutputPort(filter_, name).Port, port)
        bounds = fetch(filter_, 0).GetBounds()
        self.assertEqual(bounds[4:], (0.0, 0.0))
        self.assertGreater(fetch(filter_, 1).GetNumberOfLines(), 0)
        self.assertNotEqual(fetch(filter_, 2).GetBounds()[4:], (0.0, 0.0))

    def test_what_is_refused_is_named(self):
        filter_ = pv.WireWarping(Input=pv.Sphere())
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
        flattening = pv.WireWarping(Input=surface, Curves=curves)
        quality = pv.FlatteningQuality(
            Input=pv.OutputPort(flattening, 2), FlatSurface=pv.OutputPort(flattening, 0),
            Edges=pv.OutputPort(flattening, 1))
        for name in ("EdgeLengthError", "AngleErrorMean", "GlobalHomogeneity", "AreaError"):
            self.assertAlmostEqual(
                values(fetch(quality), name)[0], values(fetch(flattening), name)[0], 10)
        cutter = pv.FeatureCurveCutter(Input=surface, Curves=curves)
        self.assertEqual(
            fetch(cutter).GetNumberOfPoints(), fetch(flattening).GetNumberOfPoints())
        imprinter = pv.FeatureCurveImprinter(Input=surface, Curves=curves)
        self.assertEqual(fetch(imprinter).GetNumberOfCells(), 1414)
        measured = fetch(pv.SurfaceDevelopability(Input=surface))
        low, high = measured.GetPointData().GetArray("Developability").GetRange()
        self.assertTrue(0.0 <= low < high < 3.2)
        conformal = pv.LeastSquaresConformalMap(Input=surface, Curves=curves)
        self.assertGreater(values(fetch(conformal), "EdgeLengthError")[0], 1e-3)

    def test_a_collection_is_flattened_block_by_block(self):
        names = ("quarter_sphere", "shirt_shoulder", "cone")
        collection = pv.GroupDatasets(Input=[read(name) for name in names])
        flat = fetch(pv.WireWarping(Input=collection))
        self.assertEqual(flat.GetNumberOfBlocks(), len(names))
        for block, name in enumerate(names):
            alone = fetch(pv.WireWarping(Input=read(name)))
            self.assertEqual(flat.GetBlock(block).GetBounds(), alone.GetBounds())
            self.assertEqual(values(flat.GetBlock(block), "RunStatus"), ["Ok"])


if __name__ == "__main__":
    unittest.main()
