# SPDX-License-Identifier: BSD-3-Clause
"""price_keys() tells which key curve costs what."""

import dataclasses
import math
import unittest

import surfaceflattening as sf
from surfaces import points_of, polylines_of, quiet, read, triangles_of
from vtkmodules.util.numpy_support import vtk_to_numpy


def piece(name, curves):
    """Points, triangles and the curves."""
    surface, lines = read(name), read(curves)
    types = vtk_to_numpy(lines.GetCellData().GetArray("CurveType"))
    return points_of(surface), triangles_of(surface), [
        sf.Curve(points_of(lines)[chain], ("accessory", "key", "dart", "seam")[types[k]], f"curve {k}")
        for k, chain in enumerate(polylines_of(lines))]


def largest(report, key):
    return max(part[key] for part in report["pieces"])


class KeyPrices(unittest.TestCase):
    def test_the_price_is_what_releasing_the_shape_saves(self):
        points, triangles, curves = piece("pants_front", "pants_front_curves_set3")
        prices = sf.price_keys(points, triangles, curves, scheme="global")
        self.assertEqual({key.name for key in prices.keys}, {"curve 0", "curve 4", "curve 6"})
        with quiet():
            whole = sf.flatten(points, triangles, curves, scheme="global").report
            for key in prices.keys:
                k = int(key.name[-1])
                others = [dataclasses.replace(c, type="accessory") if j == k else c for j, c in enumerate(curves)]
                report = sf.flatten(points, triangles, others, scheme="global").report
                self.assertAlmostEqual(key.price, largest(whole, "E_area") - largest(report, "E_area"), 12)
                self.assertAlmostEqual(key.without.strain_p95, largest(report, "strain_p95"), 12)
                self.assertEqual(key.without.released, [
                    curve["name"] for curve in report["curves"] if curve["released"]])
            none = sf.flatten(points, triangles, curves, scheme="global", release_keys=True).report
        self.assertAlmostEqual(prices.all.E_area, largest(whole, "E_area"), 12)
        self.assertAlmostEqual(prices.none.E_area, largest(none, "E_area"), 12)
        self.assertEqual([key.price for key in prices.keys],
                         sorted((key.price for key in prices.keys), reverse=True))

    def test_a_key_costs_nothing_where_the_surface_unrolls(self):
        prices = sf.price_keys(*piece("cone", "cone_curves"))
        for key in prices.keys:
            self.assertLess(abs(key.price), 1e-9)
            self.assertFalse(math.isnan(key.alone.E_area))


if __name__ == "__main__":
    unittest.main()
