# SPDX-License-Identifier: BSD-3-Clause
"""resew() sews flat pieces together again and says how far that is from the design."""

import json
import pathlib
import tempfile
import unittest

import numpy as np

import surfaceflattening as sf
from surfaces import command, cone, cylinder, dome, grid, moved_rigidly, shell


class Resewing(command.WordsTest):
    def test_a_body_is_not_entered_and_pressure_lifts(self):
        flat = sf.flatten(*dome(12, 12, 0.3))
        free = sf.resew(flat)
        top = free.points[:, 2].max()
        plane = sf.make_surface([(-9, -9, 0.5 * top), (-9, 9, 0.5 * top), (9, 9, 0.5 * top), (9, -9, 0.5 * top)],
                                [(0, 1, 2), (0, 2, 3)])
        held = sf.resew(flat, body=plane)
        self.assertLess(held.points[:, 2].max(), 0.5 * top)
        self.assertGreater(held.points[:, 2].max(), 0.5 * top - 3e-3)  # it lies against it, at the gap
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
        with self.assertRaisesRegex(sf.FlatteningError, "holds no pressure"):
            sf.resew(halves, "product", pressure=0.01)

    def test_developables_return_to_their_design_and_bending_moves_them_by_the_square_of_the_thickness(self):
        for surface in (cylinder(24, 12), cone(24, 12)):
            flat = sf.flatten(*surface)
            sheet, woven = (sf.resew(flat, thickness=1e-6, material=material) for material in (None, "twill"))
            shape, threads = sheet.shapes[0], woven.shapes[0]
            self.assertTrue(0 < shape.distance_max < 1e-6 * shape.size and shape.iterations > 0)
            self.assertLess(shape.strain_max, 1e-8)
            self.assertLess(shape.normal_deviation_mean, 1e-4)
            self.assertEqual(shape.compressed_area, 0)
            self.assertLess(threads.distance_max, 1e-6 * threads.size)
            self.assertLess(threads.strain_warp_rms + threads.strain_weft_rms, 1e-7)
        flat = sf.flatten(*cylinder(24, 12))
        thick, thin = (sf.resew(flat, thickness=thickness).shapes[0].distance_max for thickness in (1e-5, 1e-6))
        self.assertAlmostEqual(thick / thin, 100, delta=10)

    def test_tubes_of_two_pieces_come_to_rest_as_designed_without_pins(self):
        for upper in (1.0, 0.5):
            points, triangles = command.tube(32, 8, lambda j, upper=upper: (1 + (upper - 1) * j / 8, j / 4))
            flat = sf.flatten(np.array(points), np.array(triangles),
                              [sf.Curve([i + 32 * j for j in range(9)], "seam") for i in (0, 16)])
            sewn = sf.resew(flat, "product")
            shape, = sewn.shapes
            self.assertEqual(shape.pieces, 2)
            self.assertLess(shape.distance_max, 0.005 * shape.size)
            self.assertLess(shape.strain_max, 1e-4)
            self.assertLess(np.abs(sewn.seam_strains).sum(axis=1).max(), 1e-4)
            for one, other in ((0, 2), (1, 3)):  # seams are shared
                np.testing.assert_array_equal(sewn.points[flat.seam_pairs[:, one]], sewn.points[flat.seam_pairs[:, other]])

    def test_neither_mesh_nor_pose_nor_unit_nor_numbering_changes_the_shape(self):
        points, triangles = shell(12, 12, 0.2)
        shape, = sf.resew(sf.flatten(points, triangles)).shapes
        fine, = sf.resew(sf.flatten(*shell(24, 24, 0.2))).shapes
        self.assertAlmostEqual(shape.distance_mean / fine.distance_mean, 1, delta=0.15)
        chance = np.random.default_rng(4)
        order, place = chance.permutation(len(triangles)), chance.permutation(len(points))
        elsewhere = np.empty_like(points)
        elsewhere[place] = points
        for places, corners, scale in ((1000 * moved_rigidly(points), triangles, 1000), (elsewhere, place[triangles[order]], 1)):
            other, = sf.resew(sf.flatten(places, corners)).shapes
            self.assertAlmostEqual(other.size / scale / shape.size, 1, 12)
            self.assertAlmostEqual(other.energy_membrane / scale**2 / shape.energy_membrane, 1, delta=1e-6)
            self.assertAlmostEqual(other.strain_p95 / shape.strain_p95, 1, delta=1e-6)
            for key in ("distance_mean", "distance_max"):
                self.assertAlmostEqual(getattr(other, key) / scale / getattr(shape, key), 1, delta=1e-6)

    def test_a_body_that_is_not_touched_changes_nothing(self):
        flat = sf.flatten(*shell(12, 12, 0.2))
        plane = sf.make_surface([(-9, -9, -1), (9, -9, -1), (9, 9, -1), (-9, 9, -1)], [(0, 1, 2), (0, 2, 3)])
        one, other = (sf.resew(flat, body=body).shapes[0].distance_mean for body in (plane, None))
        self.assertAlmostEqual(one / other, 1, delta=1e-6)

    def test_a_sphere_of_eight_gores_under_pressure_has_its_radius(self):
        around, rings = 32, 24
        points = [(0, 0, 1), (0, 0, -1)] + [
            (np.sin(b) * np.cos(a), np.sin(b) * np.sin(a), np.cos(b))
            for b in np.pi * np.arange(1, rings) / rings for a in 2 * np.pi * np.arange(around) / around]

        def vertex(i, j):
            return 0 if j == 0 else 1 if j == rings else 2 + (j - 1) * around + i % around

        quads = [(vertex(i, j), vertex(i, j + 1), vertex(i + 1, j + 1), vertex(i + 1, j))
                 for i in range(around) for j in range(rings)]
        triangles = [t for a, b, c, d in quads for t in ((a, b, c), (a, c, d)) if len(set(t)) == 3]
        seams = [sf.Curve([vertex(i, j) for j in range(rings + 1)], "seam") for i in range(0, around, 4)]
        gores = sf.flatten(points, triangles, seams)
        self.assertEqual(len(gores.report["pieces"]), 8)
        # The pattern of globes: each gore as high as its meridian is long, and as wide at each latitude as its circle there.
        for corners in gores.triangles:
            x, y, _ = gores.points[corners].sum(axis=0)
            center = np.pi / 4 * (np.floor(np.arctan2(y, x) / (np.pi / 4)) + 0.5)
            for v in corners:
                x, y, z = gores.points[v]
                width = np.hypot(x, y)
                turn = np.angle(np.exp(1j * (np.arctan2(y, x) - center))) if width > 1e-9 else 0
                gores.positions[v] = width * turn, np.arctan2(z, width)

        def radius(places):
            """Of the ball of the same volume."""
            a, b, c = (places[gores.triangles[:, k]] for k in range(3))
            return np.cbrt(0.75 / np.pi * (a * np.cross(b, c)).sum() / 6)

        held, slack = (sf.resew(gores, "product", pressure=pressure) for pressure in (0.01, 0.0))
        self.assertTrue(held.shapes[0].converged)
        self.assertAlmostEqual(radius(held.points) / radius(gores.points), 1, delta=0.01)
        # Without pressure it caves in or stays smaller.
        self.assertGreater(slack.shapes[0].distance_mean, held.shapes[0].distance_mean)

    def test_a_long_flat_panel_sags_under_its_weight_as_a_supported_beam(self):
        # In the middle 5 q a^4 / (384 D) across, with D = modulus thickness^2 / 12; ten times as long as wide. Edges along
        # and across and one diagonal: what bends as a cylinder bends as a plate.
        size, thickness, weight = np.sqrt(10), 0.01, 1e-8
        flat = sf.flatten(*grid(16, 160, lambda i, j: (i / 16, j / 16, 0)))
        sewn = sf.resew(flat, thickness=thickness / size, gravity=(0, 0, -weight * size), second_start=False)
        sag = -sewn.points[17 * 80 + 8, 2]
        self.assertAlmostEqual(sag * 384 / 5 * thickness**2 / 12 / weight, 1, delta=0.005)

    def test_turning_the_pieces_by_a_right_angle_is_swapping_warp_and_weft(self):
        flat = sf.flatten(*shell(12, 12, 0.2))
        (jersey,) = (material for material in sf.materials() if material["name"] == "jersey")
        turned = {**{key: jersey[key] for key in ("warp", "weft", "shear", "compression")},
                  "warp": jersey["weft"], "weft": jersey["warp"]}
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "turned.json"
            path.write_text(json.dumps(turned), encoding="utf-8")
            upright, = sf.resew(flat, material="jersey", second_start=False).shapes
            flat.positions[:] = flat.positions[:, ::-1] * (-1, 1)
            across, = sf.resew(flat, material=path, second_start=False).shapes
        self.assertGreater(upright.strain_warp_rms, 1e-4)
        for one, other in (("strain_warp_rms", "strain_weft_rms"), ("strain_weft_rms", "strain_warp_rms"),
                           ("distance_mean", "distance_mean")):
            self.assertAlmostEqual(getattr(upright, one), getattr(across, other), 9)

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
        # At rest it bears less than the flattening says of the design.
        self.assertLess(shape.strain_p95, flat.report["pieces"][0]["strain_p95"])
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
