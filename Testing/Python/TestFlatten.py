# SPDX-License-Identifier: BSD-3-Clause
"""flatten() takes what numpy and lists hold, and gives arrays that fit together."""

import json
import unittest
import warnings

import numpy as np

import surfaceflattening as sf
from surfaces import cap, grid, quarter_sphere, read, warned


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

    def test_an_elastic_curve_stays_within_its_tolerance(self):
        points, triangles, arc = quarter_sphere()
        elastic = sf.flatten(points, triangles, [sf.Curve(arc, length_tolerance=0.05)])
        error = elastic.report["curves"][0]["error"]
        self.assertTrue(1e-6 < error <= 0.05 + 1e-9, error)

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


if __name__ == "__main__":
    unittest.main()
