# SPDX-License-Identifier: BSD-3-Clause
"""Curves drawn on surfaces, and measures, without VTK: by formula, and as the filters have them."""

import unittest

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy

import surfaceflattening as sf
from surfaces import grid, points_of, polylines_of, quarter_sphere


def cylinder(radius=2.0):
    """Half of one along y, over [0, pi] of its angle."""
    return grid(32, 8, lambda i, j: (radius * np.cos(np.pi * i / 32), 3 * j / 8, radius * np.sin(np.pi * i / 32)))


def length_of(curve):
    return np.linalg.norm(np.diff(curve.points, axis=0), axis=1).sum()


class Curves(unittest.TestCase):
    def test_a_geodesic_of_a_cylinder_is_straight_in_its_development(self):
        points, triangles = cylinder()
        (curve,) = sf.draw_curve(points, triangles, points[[0, -1]], type="dart", name="slit")
        self.assertEqual((curve.type, curve.name), ("dart", "slit"))
        across = 32 * 2 * 2.0 * np.sin(np.pi / 64)  # along the chords of the polygon
        self.assertAlmostEqual(length_of(curve), np.hypot(across, 3), 9)
        np.testing.assert_allclose(curve.points[[0, -1]], points[[0, -1]], atol=1e-12)
        self.assertEqual(sf.flatten(points, triangles, [sf.Curve(curve.points, "key", "slit")]).report["status"], "Ok")

    def test_they_are_those_of_the_filter(self):
        points, triangles, _ = quarter_sphere()
        through = points[[3, 15, 30]] + 0.01
        for number, kind in enumerate(("geodesic", "section", "edges", "spline")):
            for offset in (0.0, 0.05):
                filter_ = sf.vtkSurfaceCurve()
                filter_.SetInputData(sf.make_surface(points, triangles))
                filter_.SetNumberOfControlPoints(3)
                for k, point in enumerate(through):
                    filter_.SetControlPoint(k, *point)
                filter_.SetSegmentKind(number)
                filter_.SetOffset(offset)
                filter_.Update()
                curves = sf.draw_curve(points, triangles, through, kind, offset=offset)
                lines = polylines_of(filter_.GetOutput())
                self.assertEqual(len(curves), len(lines))
                for curve, line in zip(curves, lines):
                    np.testing.assert_array_equal(curve.points, points_of(filter_.GetOutput())[line])

    def test_what_is_wrong_is_raised(self):
        points, triangles = grid(3, 3)
        for words, call in (
                ("through must have the shape", lambda: sf.draw_curve(points, triangles, [0, 1])),
                ("kind is 'curly'", lambda: sf.draw_curve(points, triangles, points[:2], "curly")),
                ("offset = 'far'", lambda: sf.draw_curve(points, triangles, points[:2], offset="far")),
                ("1 different control points", lambda: sf.draw_curve(points, triangles, points[[0, 0]])),
                ("not finite", lambda: sf.draw_curve(points, triangles, [[0, 0, 0], [np.nan, 0, 0]])),
                ("distance|far", lambda: sf.draw_curve(points, triangles, points[:2], offset=1e3))):
            with self.assertRaisesRegex(sf.FlatteningError, words):
                call()


class Measures(unittest.TestCase):
    def test_they_are_those_of_the_report(self):
        points, triangles, _ = quarter_sphere()
        result = sf.flatten(points, triangles)
        quality = sf.measure(result.points, result.triangles, result.positions)
        (piece,) = result.report["pieces"]
        for key, value in quality.measures.items():
            self.assertAlmostEqual(value, piece[key], 12, key)
        self.assertGreater(len(quality.measures), 12)
        np.testing.assert_allclose(quality.cell_arrays["AreaRatio"], result.cell_arrays["AreaRatio"], rtol=1e-12)
        self.assertEqual(len(quality.overlap_edges), 0)

    def test_wrong_positions_are_refused(self):
        points, triangles = grid(2, 2)
        with self.assertRaisesRegex(ValueError, r"positions must have the shape \(9, 2\), not \(9, 3\)"):
            sf.measure(points, triangles, points)
        with self.assertRaises(sf.FlatteningError):
            sf.measure(points, triangles, np.full((9, 2), np.nan))

    def test_it_is_that_of_the_filter(self):
        points, triangles, _ = quarter_sphere()
        filter_ = sf.vtkSurfaceDevelopability()
        filter_.SetInputData(sf.make_surface(points, triangles))
        filter_.Update()
        np.testing.assert_array_equal(
            sf.developability(points, triangles),
            vtk_to_numpy(filter_.GetOutput().GetPointData().GetArray("Developability")))


if __name__ == "__main__":
    unittest.main()
