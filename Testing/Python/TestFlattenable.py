# SPDX-License-Identifier: BSD-3-Clause
"""make_flattenable() moves a surface until it lies flat with little strain."""

import unittest

import numpy as np

import surfaceflattening as sf
from surfaces import dome, quiet


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
        curve, = moved.curves
        self.assertEqual((list(curve.points), curve.type, curve.name, curve.key_shape),
                         (row, "key", "middle", "straight"))
        self.assertEqual(len(sf.flatten(moved.points, moved.triangles, moved.curves).wires), len(moved.flattening.wires))

    def test_what_is_wrong_is_raised(self):
        points, triangles = dome(4, 4, 0.3)
        with self.assertRaisesRegex(sf.FlatteningError, "no curve is named"):
            sf.make_flattenable(points, triangles, keep=["hem"])
        for kind, name, *values in ((ValueError, "bound", 0.0, 1.0), (ValueError, "thickness", -1.0), (TypeError, "cuts", "all"),
                                    (ValueError, "outside_bias", 1.5, -0.5, float("nan"))):
            for value in values:
                with self.assertRaises(kind):
                    sf.make_flattenable(points, triangles, **{name: value})
        with self.assertRaises(TypeError):
            sf.make_flattenable_polydata(points)


if __name__ == "__main__":
    unittest.main()
