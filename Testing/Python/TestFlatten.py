# SPDX-License-Identifier: BSD-3-Clause
"""flatten() takes what numpy and lists hold, and gives arrays that fit together."""

import json
import unittest
import warnings

import numpy as np

import surfaceflattening as sf
from surfaces import cap, column_of, command, distances, grid, quarter_sphere, quiet, read, shell, warned


class WhatAPlaneCannotHold(unittest.TestCase):
    def test_a_deep_piece_is_a_warning_that_names_the_energy_that_was_used(self):
        for angle, rings, size in ((2.6, 12, 1.0), (2.6, 8, 400.0), (2.0, 8, 0.01)):
            with warned() as told:
                result = sf.flatten(*cap(angle, rings, 16, size))
            piece = result.report["pieces"][0]
            self.assertGreater(piece["E_area"], 0.6)
            self.assertEqual(piece["energy_used"], "symmetric-dirichlet")
            self.assertEqual([w.category for w in told], [sf.FlatteningWarning])
            self.assertEqual(str(told[0].message), "piece 1: " + piece["verdict"])
            self.assertEqual(result.report["warnings"], ["piece 1: " + piece["verdict"]])
            self.assertIn("a plane cannot hold this piece", piece["verdict"])
            self.assertIn("the symmetric Dirichlet energy was used", piece["verdict"])

    def test_how_large_a_piece_is_and_what_its_cloth_has_to_do_is_told_in_words(self):
        points, triangles = cap(0.9, 8, 16, 1.0)
        for unit, size, odd in (("mm", 300, False), ("mm", 3, True), ("cm", 30, False), ("m", 12, True), ("inch", 12, False),
                                ("", 3, False)):
            surface = sf.make_surface(size * points, triangles)
            sf.vtkFlatteningAlgorithm.SetLengthUnitOf(surface, unit)
            with warned() as told:
                result = sf.flatten_polydata(surface)
            piece, = result.report["pieces"]
            extent = np.ptp(result.positions, axis=0) * {"mm": 0.1, "m": 100, "inch": 2.54}.get(unit, 1)
            digits = 1 if min(extent) < 10 else 0
            self.assertEqual(piece["size"], f"{extent[0]:.{digits}f} x {extent[1]:.{digits}f} cm")
            self.assertRegex(piece["ease"], r"^[\d.]+ % of the area must be (eased|stretched).*, worst [\d.]+ %")
            self.assertEqual(len(told), odd)
            for message in told:
                self.assertRegex(str(message.message), f"^the largest piece is .* in the stated unit, {unit}")
        flat, = sf.flatten(*grid(4, 4)).report["pieces"]
        self.assertEqual((flat["ease"], flat["name"]), ("it lies flat as it is", ""))

    def test_what_lies_well_is_no_warning(self):
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            for angle in (0.3, 0.9):
                self.assertEqual(sf.flatten(*cap(angle, 8, 16, 2.0)).report["pieces"][0]["verdict"], "")

    def test_another_energy_than_the_one_that_was_asked_for_is_a_warning(self):
        diameter = [1 + 12 * ring for ring in range(7, -1, -1)] + [0] + [7 + 12 * ring for ring in range(8)]
        for size in (0.1, 1.0, 300.0):
            for energy, used in (("rigid", True), ("dirichlet", False)):
                with warned() as told:
                    piece, = sf.flatten(*cap(1.05, 8, 12, size), [diameter], energy=energy).report["pieces"]
                self.assertEqual((piece["verdict"], piece["energy_used"]), ("", "symmetric-dirichlet"))
                self.assertNotIn("Dirichlet", piece["fallbacks"])
                self.assertEqual(
                    ["the symmetric Dirichlet energy was used" in str(w.message) for w in told], [True] * used)


class Results(unittest.TestCase):
    def test_a_seam_divides_and_its_sides_are_paired(self):
        points, triangles = grid()
        result = sf.flatten(points, triangles, [sf.Curve([2, 7, 12, 17], type="seam", name="middle")])
        self.assertEqual([piece["triangles"] for piece in result.report["pieces"]], [12, 12])
        curve, = result.report["curves"]
        self.assertEqual((curve["name"], curve["type"]), ("middle", "seam"))
        self.assertAlmostEqual(curve["length_2d"], 3.0, 12)
        self.assertEqual(len(result.positions), len(points) + 4)
        self.assertEqual(result.seam_pairs.shape, (3, 5))
        original = result.point_arrays["vtkOriginalPointIds"]
        for a, b, c, d, curve in result.seam_pairs:
            self.assertEqual((original[a], original[b], curve), (original[c], original[d], 0))
            self.assertNotEqual((a, b), (c, d))

    def test_pieces_are_flattened_as_if_each_were_alone(self):
        points, triangles = shell(9, 6, 0.2)
        row = list(range(30, 40))
        both = sf.flatten(points, triangles, [sf.Curve(column_of(9, 6, 4), "seam"), row], scheme="progressive")
        for piece, on_it in ((0, row[:5]), (1, row[4:])):
            kept = both.cell_arrays["vtkOriginalCellIds"][both.cell_arrays["PieceId"] == piece]
            alone = sf.flatten(points, triangles[kept], [on_it], scheme="progressive")
            self.assertAlmostEqual(both.report["pieces"][piece]["objective"], alone.report["pieces"][0]["objective"], 13)
            place = dict(zip(alone.point_arrays["vtkOriginalPointIds"], alone.positions))
            corners = both.triangles[both.cell_arrays["PieceId"] == piece].ravel()
            expected = np.array([place[p] for p in both.point_arrays["vtkOriginalPointIds"][corners]])
            np.testing.assert_allclose(distances(both.positions[corners]), distances(expected), atol=1e-12)

    def test_a_straight_key_is_a_straight_line_in_the_plane_and_stands_upright(self):
        points, triangles = shell(8, 8, 0.2)
        curves = [sf.Curve(column_of(8, 8, 3), "key", "grain", "straight"), range(36, 45)]
        for scheme in ("global", "progressive", "isometric"):
            result = sf.flatten(points, triangles, curves, scheme=scheme)
            grain = result.positions[next(wire for wire in result.wires if wire.name == "grain").vertices]
            np.testing.assert_allclose(grain[:, 0], grain[0, 0], atol=1e-10)
            self.assertAlmostEqual(np.ptp(grain[:, 1]), result.report["curves"][0]["length_3d"], 10)

    def test_released_keys_are_accessory_curves(self):
        points, triangles = shell(8, 8, 0.2)
        row, column = range(27, 36), column_of(8, 8, 3)
        plain = sf.flatten(points, triangles, [row, column], scheme="global", arrange=False)
        released = sf.flatten(
            points, triangles, [sf.Curve(row, "key"), column], scheme="global", release_keys=True, arrange=False)
        np.testing.assert_allclose(distances(released.positions), distances(plain.positions), atol=1e-12)

    def test_a_key_takes_a_planar_shape(self):
        points, triangles, arc = quarter_sphere()
        angles = np.linspace(0.0, 0.5, len(arc))
        shape = np.column_stack([np.cos(angles), np.sin(angles)])
        result = sf.flatten(points, triangles, [sf.Curve(arc, type="key", planar_shape=shape)])
        wire = next(wire for wire in result.wires if wire.type == "key")
        steps = np.diff(result.positions[wire.vertices] @ (1, 1j))
        turns = np.angle(steps[1:] / steps[:-1])
        np.testing.assert_allclose(np.abs(turns), 0.5 / (len(arc) - 1), atol=1e-9)
        self.assertEqual(len(set(np.sign(turns))), 1)

    def test_the_report_is_plain_python(self):
        surface, curves = read("shirt_shoulder"), read("shirt_shoulder_curves")
        result = sf.flatten_polydata(surface, curves)
        self.assertEqual(json.loads(json.dumps(result.report, allow_nan=False)), result.report)
        self.assertTrue(result.report["pieces"][0]["history"])

    def test_arrays_outlive_the_filter(self):
        points, triangles, arc = quarter_sphere()
        first = sf.flatten(points, triangles, [arc])
        kept = first.positions.copy()
        for _ in range(20):
            sf.flatten(points, triangles, [arc], arrange=False)
        np.testing.assert_array_equal(first.positions, kept)
        first.positions[0] = 0.0  # they are the caller's

    def test_progress_is_told(self):
        points, triangles, arc = quarter_sphere()
        told = []
        sf.flatten(points, triangles, [arc], progress=told.append)
        self.assertEqual(told, sorted(told))
        self.assertEqual(told[-1], 1.0)
        self.assertTrue(all(0.0 <= value <= 1.0 for value in told))


class ElasticCurves(command.WordsTest):
    @staticmethod
    @quiet()
    def arc(tolerance, scheme):
        points, triangles, arc = quarter_sphere()
        return sf.flatten(points, triangles, [sf.Curve(arc, length_tolerance=tolerance)], scheme=scheme, interior="laplacian")

    def test_they_stay_in_their_band_while_rigid_ones_stay_exact(self):
        for scheme in ("global", "progressive", "isometric"):
            for tolerance in (0.01, 0.05, 0.3):
                result = self.arc(tolerance, scheme)
                self.assertNotIn(result.report["status"], ("NotConverged", "LengthError"))
                error = result.report["curves"][0]["error"]
                self.assertTrue(1e-3 < error <= tolerance * (1 + 1e-9), error)
                self.assertLess(result.report["pieces"][0]["E_len_max"], 1e-12)
                self.assertLess(max(wire.length_error for wire in result.wires if wire.boundary), 1e-12)

    def test_the_wider_the_band_the_lower_the_objective(self):
        found = [self.arc(tolerance, "global").report["pieces"][0]["objective"] for tolerance in (0, 0.01, 0.03, 0.1)]
        self.assertAlmostEqual(found[0], 0.197157, delta=5e-7)
        self.assertEqual(found, sorted(set(found), reverse=True))

    def test_those_of_a_flat_surface_keep_their_length(self):
        points, triangles = grid(6, 6)
        result = sf.flatten(points, triangles, [sf.Curve(range(21, 28), length_tolerance=0.1), column_of(6, 6, 2)])
        self.assertEqual(result.report["status"], "Ok")
        self.assertLess(result.report["curves"][0]["error"], 1e-10)
        np.testing.assert_allclose(distances(result.positions), distances(points), atol=1e-9)

    def test_a_seam_between_two_pieces_is_as_long_on_both_sides(self):
        # One half of the surface is curved more than the other, so each by itself would choose another length.
        points, triangles = shell(10, 8, 0.5)
        curves = [sf.Curve(column_of(10, 8, 3), "seam", length_tolerance=0.05), range(44, 55)]
        for scheme in ("global", "progressive", "isometric"):
            with self.subTest(scheme), quiet():
                result = sf.flatten(points, triangles, curves, scheme=scheme)
                sides = (np.linalg.norm(result.positions[result.seam_pairs[:, k]] - result.positions[result.seam_pairs[:, k + 1]],
                                        axis=1) for k in (0, 2))
                np.testing.assert_allclose(*sides, rtol=1e-12)
                seam, row = (curve["error"] for curve in result.report["curves"])
                self.assertTrue(1e-4 < seam <= 0.05 * (1 + 1e-9), seam)
                self.assertLess(row, 1e-12)

    def test_eases_make_one_side_longer_and_leave_the_other_as_on_the_surface(self):
        seam = sf.Curve(column_of(10, 10, 4), "seam", "seam", length_tolerance=0.05)
        hem = sf.Curve(range(4), name="hem", length_tolerance=0.05)
        for name, piece, ease, expected in (("seam", 1, 0.03, {0: 0, 1: 0.03}), ("seam", 1, -0.02, {0: 0, 1: -0.02}),
                                            ("hem", None, 0.04, {0: 0.04})):  # of one piece
            result = sf.flatten(*shell(10, 10, 0.4), [seam, hem], ease={name if piece is None else (name, piece): ease})
            self.assertEqual(result.report["status"], "Ok")
            wires = [wire for wire in result.wires if wire.name == name]
            self.assertEqual({wire.piece for wire in wires}, set(expected))
            for wire in wires:
                flat, rest = (np.linalg.norm(np.diff(places[wire.vertices], axis=0), axis=1)
                              for places in (result.positions, result.points))
                np.testing.assert_allclose(flat / rest - 1, expected[wire.piece], atol=1e-9)
        dart = sf.Curve([4, 15, 26], "dart", "dart", length_tolerance=0.05)
        for name, words in (("dart", ["both sides", "dart"]), ("cuff", ["cuff"])):
            self.assert_raises(sf.FlatteningError, words, sf.flatten, *shell(10, 10, 0.4), [dart], ease={(name, 0): 0.03})


if __name__ == "__main__":
    unittest.main()
