# SPDX-License-Identifier: BSD-3-Clause
"""suggest() proposes curves that flatten() takes."""

import unittest
import warnings

import numpy as np

import surfaceflattening as sf
from surfaces import grid


def dome(columns=14, rows=14, height=0.5):
    """Its own mirror image, triangles and all."""
    points, triangles = grid(columns, rows)
    for k in range(0, len(triangles), 2):
        if (k // 2 % columns + k // 2 // columns) % 2:
            a, b, c, d = *triangles[k], triangles[k + 1][2]
            triangles[k:k + 2] = [(a, b, d), (b, c, d)]
    x, y = 2 * points[:, 0] / points[:, 0].max() - 1, 2 * points[:, 1] / points[:, 1].max() - 1
    return np.column_stack([x, y, height * (1 - x * x) * (1 - y * y)]), triangles


class Suggestions(unittest.TestCase):
    def test_flatten_takes_what_is_proposed(self):
        points, triangles = dome()
        suggestion = sf.suggest(points, triangles, bound=0.05)
        self.assertTrue(suggestion.bound_met)
        self.assertTrue(suggestion.cuts)
        strain = [piece["strain_p95"] for piece in suggestion.flattening.report["pieces"]]
        self.assertLessEqual(max(strain), 0.05)
        again = sf.flatten(points, triangles, [cut.curve for cut in suggestion.cuts])
        np.testing.assert_allclose(
            [piece["strain_p95"] for piece in again.report["pieces"]], strain, rtol=1e-9)
        for cut in suggestion.cuts:
            steps = np.linalg.norm(np.diff(cut.curve.points, axis=0), axis=1)
            self.assertAlmostEqual(steps.sum(), cut.length, 9)
            self.assertGreater(cut.gain, 0)

    def test_mirror_images_are_named_and_exact(self):
        points, triangles = dome(height=0.6)
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", sf.FlatteningWarning)
            cuts = sf.suggest(points, triangles, cuts="darts", bound=0, max_cuts=6).cuts
        self.assertTrue(any(cut.mirror_of >= 0 for cut in cuts))
        for cut in cuts:
            if cut.mirror_of >= 0:
                other = cuts[cut.mirror_of]
                self.assertLess(abs(cut.length - other.length), 1e-12)

    def test_curves_given_stay_and_are_not_proposed_again(self):
        points, triangles = dome()
        middle = np.arange(15) + 7 * 15
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", sf.FlatteningWarning)
            suggestion = sf.suggest(
                points, triangles, [sf.Curve(middle, name="girth")], bound=0, max_cuts=1,
                prefer={"girth": 0.0})
        names = [curve["name"] for curve in suggestion.flattening.report["curves"]]
        self.assertEqual(names, ["girth", *(cut.curve.name for cut in suggestion.cuts)])

    def test_a_bound_that_is_not_met_is_a_warning(self):
        points, triangles = dome()
        with self.assertWarnsRegex(sf.FlatteningWarning, "above the bound of 0.001"):
            suggestion = sf.suggest(points, triangles, bound=0.001, max_cuts=1)
        self.assertFalse(suggestion.bound_met)

    def test_what_is_wrong_is_raised(self):
        points, triangles = dome()
        with self.assertRaisesRegex(ValueError, "cuts is 'pleats'"):
            sf.suggest(points, triangles, cuts="pleats")
        with self.assertRaisesRegex(ValueError, "bound = -1"):
            sf.suggest(points, triangles, bound=-1)
        with self.assertRaisesRegex(sf.FlatteningError, 'no curve is named "waist"'):
            sf.suggest(points, triangles, prefer={"waist": 2.0})


if __name__ == "__main__":
    unittest.main()
