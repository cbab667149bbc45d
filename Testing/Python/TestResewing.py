# SPDX-License-Identifier: BSD-3-Clause
"""resew() sews flat pieces together again and says how far that is from the design."""

import unittest

import numpy as np

import surfaceflattening as sf
from surfaces import command, dome


class Resewing(command.WordsTest):
    def test_a_body_is_not_entered_and_pressure_lifts(self):
        flat = sf.flatten(*dome(12, 12, 0.3))
        free = sf.resew(flat)
        top = free.points[:, 2].max()
        plane = sf.make_surface([(-9, -9, 0.5 * top), (-9, 9, 0.5 * top), (9, 9, 0.5 * top), (9, -9, 0.5 * top)],
                                [(0, 1, 2), (0, 2, 3)])
        held = sf.resew(flat, body=plane)
        self.assertLess(held.points[:, 2].max(), 0.5 * top)
        self.assertEqual(held.shapes[0].body_depth, 0.0)
        self.assertGreater(sf.resew(flat, pressure=0.05).points[:, 2].sum(), free.points[:, 2].sum())
        self.assertEqual(sf.resew(flat, second_start=False).shapes[0].second_distance_mean, 0.0)

    def test_threads_are_strained_by_the_lengths_of_the_sewn_cloth(self):
        points, triangles = dome(12, 12, 0.3)
        flat = sf.flatten(points, triangles, material="jersey")
        sewn = sf.resew(flat, material="jersey", second_start=False)
        # The images of the axes of the plane: warp along y.
        plane, space = (places[triangles] for places in (flat.positions, sewn.points))
        edges = plane[:, 1:, :2] - plane[:, :1, :2]
        axes = np.linalg.solve(edges, space[:, 1:] - space[:, :1])
        lengths = np.linalg.norm(axes, axis=2)
        cosine = (axes[:, 0] * axes[:, 1]).sum(axis=1) / lengths.prod(axis=1)
        expected = np.column_stack([lengths[:, 1] - 1, lengths[:, 0] - 1, 90 - np.degrees(np.arccos(cosine))])
        np.testing.assert_allclose(sewn.thread_strains, expected, atol=1e-9)
        area = np.abs(np.cross(edges[:, 0], edges[:, 1]))
        rms = np.sqrt((area[:, None] * expected**2).sum(axis=0) / area.sum())
        shape, = sewn.shapes
        np.testing.assert_allclose((shape.strain_warp_rms, shape.strain_weft_rms, shape.shear_rms), rms, rtol=1e-6)
        sheet = sf.resew(flat, second_start=False)
        self.assertIsNone(sheet.thread_strains)
        self.assertIsNone(sheet.shapes[0].shear_rms)
        self.assertNotAlmostEqual(sheet.shapes[0].distance_mean, shape.distance_mean, 6)

    def test_weight_pulls_and_what_nothing_holds_is_refused(self):
        flat = sf.flatten(*dome(12, 12, 0.3))
        free, down, up = (sf.resew(flat, gravity=(0, 0, g), second_start=False).points[:, 2].sum()
                          for g in (0, -2e-3, 2e-3))
        self.assertLess(down, free)
        self.assertLess(free, up)
        seam = [6 + 13 * j for j in range(13)]
        halves = sf.flatten(*dome(12, 12, 0.3), [sf.Curve(seam, "seam", "middle")])
        with self.assertRaisesRegex(sf.FlatteningError, "nothing holds"):
            sf.resew(halves, "product", gravity=(0, 0, -1e-3))

    def test_measures_are_those_of_the_arrays(self):
        points, triangles = dome(12, 12, 0.3)
        flat = sf.flatten(points, triangles)
        sewn = sf.resew(flat)
        shape, = sewn.shapes
        self.assertEqual((shape.pieces, shape.triangles), (1, len(flat.triangles)))
        a, b, c = (flat.points[flat.triangles[:, k]] for k in range(3))
        self.assertAlmostEqual(shape.size ** 2, 0.5 * np.linalg.norm(np.cross(b - a, c - a), axis=1).sum())
        # Stretches by another way: the generalized eigenvalues of both metrics.
        u, v, w = (flat.positions[flat.triangles[:, k]] for k in range(3))
        x, y, z = (sewn.points[flat.triangles[:, k]] for k in range(3))
        rest = np.stack([v - u, w - u], axis=2)
        bent = np.stack([y - x, z - x], axis=2) @ np.linalg.inv(rest)
        stretches = np.linalg.svd(bent, compute_uv=False)
        np.testing.assert_allclose(sewn.principal_strains, stretches - 1, atol=1e-12)
        area = 0.5 * abs(np.linalg.det(rest))
        strain = abs(np.log(stretches)).max(axis=1)
        self.assertAlmostEqual(shape.strain_mean, area @ strain / area.sum(), 12)
        self.assertAlmostEqual(shape.strain_max, strain.max(), 12)
        self.assertAlmostEqual(shape.energy_membrane, (area * ((stretches - 1) ** 2).sum(axis=1)).sum(), 12)
        self.assertAlmostEqual(
            shape.compressed_area, area[stretches[:, 1] < 0.999].sum() / area.sum(), 12)
        shares = np.bincount(flat.triangles.ravel(), np.repeat(area / 3, 3)) / area.sum()
        self.assertAlmostEqual(shape.distance_mean, shares @ sewn.distance, 12)
        self.assertAlmostEqual(shape.distance_rms, np.sqrt(shares @ sewn.distance ** 2), 12)
        self.assertEqual(shape.distance_max, max(sewn.distance.max(), sewn.design_distance.max()))
        self.assertGreater(shape.distance_mean, 0)
        # The boundary is held, and no point is farther from the design than from its own place.
        moved = np.linalg.norm(sewn.points - flat.points, axis=1)
        self.assertTrue((sewn.distance <= moved + 1e-12).all())
        edge = np.isclose(abs(flat.points[:, :2]).max(axis=1), 1)
        self.assertEqual(moved[edge].max(), 0)

    def test_odd_arguments_are_refused(self):
        flat = sf.flatten(*dome(4, 3, 0.3))
        for kind, words, arguments in (
                (ValueError, "", {"test": "dress"}), (ValueError, "", {"max_iterations": 0}),
                *((ValueError, "", {"thickness": value}) for value in (-1.0, float("nan"))),
                (TypeError, "", {"thickness": "thin"}), (TypeError, "body is", {"body": [0.0]}),
                (TypeError, "name or the path", {"material": 3}),
                *((TypeError, "three numbers", {"gravity": value}) for value in ((0, 0), 1.0, "down", (0, 0, None))),
                *((ValueError, "out of range", {"gravity": value}) for value in ((0, 0, 2), (float("nan"), 0, 0)))):
            with self.subTest(arguments):
                self.assert_raises(kind, words, sf.resew, flat, **arguments)
        with self.assertRaises(TypeError):
            sf.resew(flat.positions)


if __name__ == "__main__":
    unittest.main()
