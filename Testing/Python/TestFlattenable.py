# SPDX-License-Identifier: BSD-3-Clause
"""make_flattenable() moves a surface until it lies flat with little strain."""

import unittest

import numpy as np

import surfaceflattening as sf
from surfaces import cone, cylinder, dome, grid, quiet, shell


class Flattenable(unittest.TestCase):
    def test_the_moved_surface_lies_flat_and_its_boundary_stays(self):
        points, triangles = dome(10, 10, 0.3)
        moved = sf.make_flattenable(points, triangles, bound=0.01)
        self.assertTrue(moved.bound_met)
        self.assertEqual(moved.strain_before, sf.flatten(points, triangles).report["pieces"][0]["strain_p95"])
        self.assertEqual(moved.strain_after, moved.flattening.report["pieces"][0]["strain_p95"])
        self.assertLessEqual(moved.strain_after, 0.01)
        np.testing.assert_array_equal(moved.shift, moved.points - points)
        np.testing.assert_array_equal(moved.points[moved.kept], points[moved.kept])
        self.assertEqual(moved.kept.sum(), 40)
        again = sf.flatten(moved.points, moved.triangles)
        self.assertAlmostEqual(again.report["pieces"][0]["strain_p95"], moved.strain_after, 12)
        # By area: a third of the triangles around a point.
        a, b, c = (points[np.asarray(triangles)[:, k]] for k in range(3))
        area = 0.5 * np.linalg.norm(np.cross(b - a, c - a), axis=1)
        weights = np.zeros(len(points))
        for corner in range(3):
            np.add.at(weights, np.asarray(triangles)[:, corner], area / 3)
        far = np.linalg.norm(moved.shift, axis=1)
        self.assertAlmostEqual(moved.shift_mean, (weights * far).sum() / area.sum())
        self.assertEqual(moved.shift_max, far.max())
        self.assertAlmostEqual(moved.size ** 2, area.sum())

    def test_kept_curves_stay_and_come_back(self):
        points, triangles = dome(10, 10, 0.3)
        row = list(range(5 * 11, 6 * 11))
        curves = [sf.Curve(row, "key", "middle", "straight")]
        with quiet():
            moved = sf.make_flattenable(points, triangles, curves, keep=["middle"])
        np.testing.assert_array_equal(moved.points[row], points[row])
        flat, designed = (np.linalg.norm(np.diff(places[row], axis=0), axis=1)
                          for places in (moved.flattening.positions, points))
        np.testing.assert_allclose(flat, designed, rtol=1e-12)
        self.assertLess(moved.strain_after, moved.strain_before)
        curve, = moved.curves
        self.assertEqual((list(curve.points), curve.type, curve.name, curve.key_shape),
                         (row, "key", "middle", "straight"))
        self.assertEqual(len(sf.flatten(moved.points, moved.triangles, moved.curves).wires), len(moved.flattening.wires))

    def test_what_lies_flat_already_is_not_touched(self):
        for points, triangles in (cylinder(16, 8), cone(16, 8)):
            moved = sf.make_flattenable(points, triangles)
            self.assertEqual((moved.flattening.report["status"], moved.bound_met, moved.shift_max), ("Ok", True, 0))
            np.testing.assert_array_equal(moved.points, points)

    def test_a_tighter_bound_moves_it_farther_and_a_dart_less(self):
        found = [sf.make_flattenable(*shell(12, 12, 0.2), bound=bound) for bound in (0.03, 0.02, 0.01)]
        for moved, bound in zip(found, (0.03, 0.02, 0.01)):
            self.assertTrue(moved.bound_met and moved.strain_before > 0.04 and moved.strain_after <= bound)
        self.assertEqual([moved.shift_mean for moved in found], sorted(moved.shift_mean for moved in found))
        self.assertGreater(found[1].strain_after, 0.017)  # not farther than it takes
        self.assertLess(found[1].shift_mean, 0.025 * found[1].size)
        points, triangles = shell(12, 12, 0.35)
        whole, darted = (sf.make_flattenable(points, triangles, curves)
                         for curves in ([], [sf.Curve([6, 19, 32, 45, 58], "dart")]))
        self.assertTrue(whole.bound_met and darted.bound_met)
        self.assertEqual(len(darted.points), len(points))  # both sides stay one curve on the surface
        self.assertLess(darted.shift_mean, 0.9 * whole.shift_mean)

    def test_a_full_bias_reaches_the_bound_on_saddles_of_all_heights(self):
        saddles = [lambda x, y, h=h: h * (x * x - y * y) for h in np.arange(0.15, 0.95, 0.1)]
        for h in (0.2, 0.45, 0.7):  # no plane of symmetry between rise and fall; three valleys
            saddles += [lambda x, y, h=h: h * ((x * x - y * y) * (1 + 0.3 * x) + 0.2 * np.sin(3 * x + y)),
                        lambda x, y, h=h: h * (x**3 - 3 * x * y * y)]
        for number, height in enumerate(saddles):
            points, triangles = grid(12, 12, lambda i, j, height=height: (
                i / 6 - 1, j / 6 - 1, height(i / 6 - 1, j / 6 - 1)), other=lambda i, j: (i + j) % 2)
            for turned in (1, -1):
                moved = sf.make_flattenable(points, triangles[:, ::turned], outside_bias=1.0)
                with self.subTest(number, turned=turned):
                    self.assertTrue(moved.bound_met, moved.strain_after)
                    self.assertEqual(moved.flattening.report["warnings"], [])
                    self.assertLess(moved.shift_inwards_max, 1e-12)

    def test_with_a_full_bias_a_dome_does_not_sink_where_its_boundary_may_move(self):
        points, triangles = shell(12, 12, 0.2)
        either, outside = (sf.make_flattenable(points, triangles, keep_boundary=False, outside_bias=bias) for bias in (0, 1))
        self.assertTrue(either.bound_met and outside.bound_met)
        boundary = (points[:, :2] == points[:, :2].min(axis=0)) | (points[:, :2] == points[:, :2].max(axis=0))
        shift = np.linalg.norm(either.shift[boundary.any(axis=1)], axis=1).max()
        self.assertGreater(min(shift, either.shift_inwards_max), 1e-3 * either.size)
        self.assertLess(outside.shift_inwards_max, 1e-12)
        self.assertGreater(outside.shift_outwards_mean, max(0, either.shift_outwards_mean))

    def test_what_is_wrong_is_raised(self):
        points, triangles = dome(4, 4, 0.3)
        with self.assertRaisesRegex(sf.FlatteningError, "no curve is named"):
            sf.make_flattenable(points, triangles, keep=["hem"])
        for kind, name, *values in ((ValueError, "bound", 0.0, -1.0, 1.0, float("nan")), (TypeError, "cuts", "all"),
                                    (ValueError, "thickness", -1.0, 2.0), (ValueError, "outside_bias", 1.5, -0.5, float("nan"))):
            for value in values:
                with self.assertRaises(kind):
                    sf.make_flattenable(points, triangles, **{name: value})
        with self.assertRaises(TypeError):
            sf.make_flattenable_polydata(points)


if __name__ == "__main__":
    unittest.main()
