# SPDX-License-Identifier: BSD-3-Clause
"""Curves drawn on surfaces, and measures, without VTK: by formula, and as the filters have them."""

import unittest

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy

import surfaceflattening as sf
import surfaces
from surfaces import FLIPPED_STRAIN, grid, points_of, polylines_of, quarter_sphere


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

    def test_an_exact_unrolling_has_no_error(self):
        points, triangles = surfaces.cylinder()
        unrolled = np.array([(2 * np.sin(1.5 / 40) * i, 2 * j / 20) for j in range(21) for i in range(41)])
        quality = sf.measure(points, triangles, unrolled)
        for key in ("E_len_all", "E_len_max", "E_ang", "E_area", "strain_p95", "energy_rigid", "flipped"):
            self.assertLess(quality.measures[key], 1e-12, key)
        for key in ("E_h", "E_r"):
            self.assertAlmostEqual(quality.measures[key], 1, 12)
        self.assertLess(sf.developability(points, triangles).max(), 1e-12)

    def test_one_linear_map_gives_its_singular_values_everywhere(self):
        points, triangles = grid(6, 5)
        matrix = np.array([[1.7, 0.4], [-0.3, 0.8]])
        (large, small), area = np.linalg.svd(matrix, compute_uv=False), np.linalg.det(matrix)
        quality = sf.measure(points, triangles, points[:, :2] @ matrix.T + (5, -3))
        for name, value in (("AreaRatio", area), ("HomogeneityOfDistortion", 1 / area), ("AspectRatio", small / large)):
            np.testing.assert_allclose(quality.cell_arrays[name], value, atol=1e-13)
        for key, value in (("E_r", small / large), ("E_h", 1), ("E_area", area - 1)):
            self.assertAlmostEqual(quality.measures[key], value, 12)

    def test_angles_of_a_stretched_right_triangle(self):
        # 90, 45, 45 degrees become 90, 60, 30.
        measures = sf.measure([(0, 0, 0), (1, 0, 0), (0, 1, 0)], [(0, 1, 2)], [(0, 0), (1, 0), (0, np.sqrt(3))]).measures
        self.assertAlmostEqual(measures["E_ang"], 2 / 9, 14)
        self.assertAlmostEqual(measures["E_len"], (np.sqrt(3) - 1 + np.sqrt(2) - 1) / 3, 14)

    def test_compression_counts_like_extension_and_a_scale_is_no_error_of_angles(self):
        points, triangles = grid()
        for factor in (1.25, 0.8):
            measures = sf.measure(points, triangles, factor * points[:, :2]).measures
            change = abs(factor - 1)
            for key, value in (("strain_p95", np.log(1.25)), ("energy_rigid", 2 * change**2), ("E_len_all", change),
                               ("E_len", change), ("E_len_max", change), ("E_ang", 0), ("E_area", abs(factor**2 - 1))):
                self.assertAlmostEqual(measures[key], value, 12, key)

    def test_a_flipped_triangle_counts_as_strained_beyond_all_others(self):
        points, triangles = grid(4, 4)
        folded = points[:, :2].copy()
        folded[12] += (1.6, 0.1)
        quality = sf.measure(points, triangles, folded)
        flipped = quality.cell_arrays["Flipped"] == 1
        self.assertTrue((triangles[flipped] == 12).any(axis=1).all() and flipped.any())
        self.assertEqual(quality.measures["flipped"], flipped.sum())
        self.assertLess(quality.cell_arrays["AspectRatio"][flipped].max(), 0)
        self.assertEqual(quality.cell_arrays["HomogeneityOfDistortion"][flipped].max(), 0)
        self.assertLess(quality.measures["E_h"], 0)
        for share in (0.04, 0.06):  # of the area of two triangles, the larger one stretched by a tenth
            legs = np.sqrt([share, 1 - share])
            corners = np.vstack([leg * np.array([(0, 0), (1, 0), (0, 1)]) for leg in legs])
            measures = sf.measure(np.column_stack([corners, np.repeat((0, 1), 3)]), [(0, 1, 2), (3, 4, 5)],
                                  corners * np.repeat([(-1, 1), (1, 1.1)], 3, axis=0)).measures
            self.assertAlmostEqual(measures["strain_p95"], FLIPPED_STRAIN if share > 0.05 else np.log(1.1), 12)
            # A mirror is by (-1 - 1)^2 from the nearest rotation.
            self.assertAlmostEqual(measures["energy_rigid"], 4 * share + 0.01 * (1 - share), 12)

    def test_what_collapses_or_explodes_gives_finite_numbers(self):
        points, triangles = grid(3, 1)
        for scale, energy in (((0, 0), 2), ((1, 0), 1), ((1e-60, 1e-60), None), ((1e60, 1e60), None)):
            quality = sf.measure(points, triangles, points[:, :2] * scale)
            self.assertEqual(quality.measures["strain_p95"], FLIPPED_STRAIN)
            self.assertTrue(np.isfinite(list(quality.measures.values())).all())
            if energy:
                self.assertAlmostEqual(quality.measures["energy_rigid"], energy, 12)
                self.assertEqual((quality.measures["flipped"], quality.measures["E_h"]), (6, 0))
                self.assertEqual(quality.cell_arrays["AreaRatio"].max(), 0)

    def test_a_saddle_is_as_far_from_developable_as_its_angles_say(self):
        # Six triangles around a point whose neighbors alternate above and below.
        around = [(np.cos(k * np.pi / 3), np.sin(k * np.pi / 3), 0.5 * (-1)**k) for k in range(6)]
        found = sf.developability([(0, 0, 0), *around], [(0, 1 + k, 1 + (k + 1) % 6) for k in range(6)])
        self.assertAlmostEqual(found[0], 6 * np.arccos((0.5 - 0.25) / 1.25) - 2 * np.pi, 13)

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
