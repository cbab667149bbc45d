# SPDX-License-Identifier: BSD-3-Clause
"""flatten() gives the paper's numbers, exact unrollings, and arrays that fit together."""

import inspect
import json
import unittest
import warnings

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy

import surfaceflattening as sf
from surfaces import (
    distances, grid, points_of, polylines_of, quarter_sphere, read, triangles_of)


def edge_lengths(positions, vertices):
    return np.linalg.norm(np.diff(positions[vertices], axis=0), axis=1)


def cap(angle, rings, count, size):
    """The sphere about its pole down to an angle."""
    points, triangles = [(0.0, 0.0, size)], [(0, 1 + k, 1 + (k + 1) % count) for k in range(count)]
    for down in angle * np.arange(1, rings + 1) / rings:
        points += [(size * np.sin(down) * np.cos(turn), size * np.sin(down) * np.sin(turn), size * np.cos(down))
                   for turn in 2 * np.pi * np.arange(count) / count]
    for first in range(1, 1 + count * (rings - 1), count):
        for k in range(count):
            a, b = first + k, first + (k + 1) % count
            triangles += [(a, a + count, b + count), (a, b + count, b)]
    return np.array(points), np.array(triangles)


class WhatAPlaneCannotHold(unittest.TestCase):
    def test_a_deep_piece_is_a_warning_that_names_the_energy_that_was_used(self):
        for angle, rings, size in ((2.6, 12, 1.0), (2.6, 8, 400.0), (2.0, 8, 0.01)):
            with warnings.catch_warnings(record=True) as told:
                warnings.simplefilter("always")
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
        for unit, size, words in (("mm", 300.0, ""), ("mm", 3.0, "the smallest piece is "), ("cm", 30.0, ""),
                                  ("m", 3.0, "the largest piece is "), ("inch", 12.0, ""), ("", 3.0, "")):
            surface = sf.make_surface(size * points, triangles)
            sf.vtkFlatteningAlgorithm.SetLengthUnitOf(surface, unit)
            with warnings.catch_warnings(record=True) as told:
                warnings.simplefilter("always")
                result = sf.flatten_polydata(surface)
            piece, = result.report["pieces"]
            extent = np.ptp(result.positions, axis=0) * {"mm": 0.1, "m": 100, "inch": 2.54}.get(unit, 1)
            digits = 1 if min(extent) < 10 else 0
            self.assertEqual(piece["size"], f"{extent[0]:.{digits}f} x {extent[1]:.{digits}f} cm")
            self.assertRegex(piece["ease"], r"^[\d.]+ % of the area must be (eased|stretched).*, worst [\d.]+ %")
            self.assertEqual([str(w.message).startswith(words) for w in told], [True] if words else [])
            for message in told:
                self.assertIn(" in the stated unit, " + unit, str(message.message))
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
                with warnings.catch_warnings(record=True) as told:
                    warnings.simplefilter("always")
                    piece, = sf.flatten(*cap(1.05, 8, 12, size), [diameter], energy=energy).report["pieces"]
                self.assertEqual((piece["verdict"], piece["energy_used"]), ("", "symmetric-dirichlet"))
                self.assertNotIn("Dirichlet", piece["fallbacks"])
                self.assertEqual(
                    ["the symmetric Dirichlet energy was used" in str(w.message) for w in told], [True] * used)

    def test_a_conformal_map_keeps_no_length_that_would_want_room(self):
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            sf.flatten(*cap(2.0, 8, 16, 1.0), scheme="lscm")


class QuarterSphere(unittest.TestCase):
    """Fig. 11 and Table 1 of the paper."""

    def test_numbers_are_those_of_table_1(self):
        points, triangles, arc = quarter_sphere()
        for scheme, angle_error, homogeneity in (
            ("progressive", 0.1591, 0.394),
            ("global", 0.1488, 0.404),
        ):
            result = sf.flatten(points, triangles, [arc], scheme=scheme, interior="laplacian")
            piece = result.report["pieces"][0]
            self.assertLess(piece["E_len_max"], 1e-10)
            self.assertAlmostEqual(piece["E_ang"], angle_error, delta=5e-5)
            self.assertAlmostEqual(piece["E_h"], homogeneity, delta=5e-4)

    def test_the_papers_method_is_the_global_scheme_with_its_interior(self):
        points, triangles, arc = quarter_sphere()
        paper = sf.flatten(points, triangles, [arc], paper_method=True)
        pair = sf.flatten(points, triangles, [arc], scheme="global", interior="laplacian")
        np.testing.assert_array_equal(paper.positions, pair.positions)
        self.assertAlmostEqual(paper.report["pieces"][0]["E_ang"], 0.1488, delta=5e-5)

    def test_the_solvers_agree(self):
        points, triangles, arc = quarter_sphere()
        newton, sequential = (
            sf.flatten(points, triangles, [arc], solver=solver) for solver in ("newton", "sequential"))
        np.testing.assert_allclose(
            distances(newton.positions), distances(sequential.positions), atol=1e-7)

    def test_a_relaxation_that_runs_out_of_iterations_has_not_converged(self):
        points, triangles = grid(40, 40)
        points[:, 2] += np.sin(points[:, 0]) * np.sin(points[:, 1])
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            relaxed, direct = (
                sf.flatten(points, triangles, scheme="global", interior=interior).report
                for interior in ("relaxation", "laplacian"))
        self.assertEqual((relaxed["status"], direct["status"]), ("NotConverged", "Ok"))
        self.assertIn('interior="laplacian"', relaxed["message"])

    def test_lengths_that_could_not_be_made_exact_are_told(self):
        # Edges of exact length fix the angles at the top of a steep pyramid, which are not flat.
        points = np.array([[0, 0, 1], [1, 0, 0], [0, 1, 0], [-1, 0, 0], [0, -1, 0]], float)
        triangles = [(0, k, k % 4 + 1) for k in range(1, 5)]
        ridges = [sf.Curve((0, k), "accessory", f"ridge {k}") for k in range(1, 5)]
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            report = sf.flatten(points, triangles, ridges).report
        self.assertEqual(report["status"], "LengthError")
        self.assertIn("last correction of the wires' lengths", report["pieces"][0]["fallbacks"])

    def test_wires_keep_each_of_their_edges(self):
        points, triangles, arc = quarter_sphere()
        for scheme in ("progressive", "global", "isometric"):
            result = sf.flatten(points, triangles, [arc], scheme=scheme)
            self.assertEqual({wire.type for wire in result.wires}, {"boundary", "accessory"})
            for wire in result.wires:
                np.testing.assert_allclose(
                    edge_lengths(result.positions, wire.vertices),
                    edge_lengths(result.points, wire.vertices), rtol=1e-9)
                self.assertAlmostEqual(
                    wire.rest_length, edge_lengths(result.points, wire.vertices).sum(), 12)

    def test_the_unit_scales_the_result_alone(self):
        points, triangles, arc = quarter_sphere()
        one = sf.flatten(points, triangles, [arc])
        many = sf.flatten(1e4 * points + 5e4, triangles, [arc])
        np.testing.assert_allclose(
            distances(many.positions), 1e4 * distances(one.positions), atol=1e-4)

    def test_lists_and_other_number_types_are_taken(self):
        points, triangles, arc = quarter_sphere()
        expected = sf.flatten(points, triangles, [arc]).positions
        for given in (
            sf.flatten(points.tolist(), triangles.tolist(), [arc]),
            sf.flatten(points, triangles.astype(np.uint8), [np.array(arc, np.int16)]),
            sf.flatten(np.asfortranarray(points), np.asfortranarray(triangles), [points[arc]]),
        ):
            np.testing.assert_allclose(given.positions, expected, atol=1e-12)

    def test_arguments_are_left_as_they_were(self):
        points, triangles, arc = quarter_sphere()
        arc = np.array(arc)
        copies = points.copy(), triangles.copy(), arc.copy()
        for array in (points, triangles, arc):
            array.setflags(write=False)
        sf.flatten(points, triangles, [arc])
        for array, copy in zip((points, triangles, arc), copies):
            np.testing.assert_array_equal(array, copy)


class Developables(unittest.TestCase):
    """Surfaces of which the flat shape is known."""

    def test_they_unroll_exactly(self):
        for name in ("cylinder", "cone"):
            surface, curves = read(name), read(name + "_curves")
            exact = vtk_to_numpy(surface.GetPointData().GetArray("ExactUnrolling"))[:, :2]
            ends = points_of(curves)
            result = sf.flatten(points_of(surface), triangles_of(surface),
                                [ends[line] for line in polylines_of(curves)])
            original = result.point_arrays["vtkOriginalPointIds"]
            np.testing.assert_allclose(
                distances(result.positions), distances(exact[original]), atol=1e-6)
            self.assertLess(np.abs(result.cell_arrays["AreaRatio"] - 1.0).max(), 1e-6)


class Results(unittest.TestCase):
    def test_darts_that_cross_are_warned_of_or_closed(self):
        surface, curves = read("wetsuit_upper_front"), read("wetsuit_upper_front_curves")
        with self.assertWarnsRegex(sf.FlatteningWarning, "waist_dart_left"):
            self.assertGreater(len(sf.flatten_polydata(surface, curves).overlap_edges), 0)
        result = sf.flatten_polydata(surface, curves, close_cuts=True)
        report = result.report
        self.assertEqual(report["status"], "Ok")
        closed = {curve["name"]: curve["closed_length"] for curve in report["curves"]}
        self.assertGreater(closed["waist_dart_left"], 0.0)
        self.assertEqual(closed["bust_dart_left"], 0.0)
        pairs = result.seam_pairs[result.seam_closed]
        np.testing.assert_array_equal(result.positions[pairs[:, 0]], result.positions[pairs[:, 2]])
        np.testing.assert_array_equal(result.positions[pairs[:, 1]], result.positions[pairs[:, 3]])
        lengths = np.linalg.norm(result.points[pairs[:, 1]] - result.points[pairs[:, 0]], axis=1)
        self.assertAlmostEqual(lengths.sum(), sum(closed.values()), 9)

    def test_a_seam_divides_and_its_sides_are_paired(self):
        points, triangles = grid()
        seam = sf.Curve([2, 7, 12, 17], type="seam", name="middle")
        result = sf.flatten(points, triangles, [seam])
        self.assertEqual([piece["triangles"] for piece in result.report["pieces"]], [12, 12])
        self.assertEqual(result.report["curves"][0]["name"], "middle")
        self.assertEqual(result.report["curves"][0]["type"], "seam")
        self.assertAlmostEqual(result.report["curves"][0]["length_2d"], 3.0, 12)
        self.assertEqual(len(result.positions), len(points) + 4)
        self.assertEqual(result.seam_pairs.shape, (3, 5))
        original = result.point_arrays["vtkOriginalPointIds"]
        for a, b, c, d, curve in result.seam_pairs:
            self.assertEqual((original[a], original[b], curve), (original[c], original[d], 0))
            self.assertNotEqual((a, b), (c, d))
        pieces = result.cell_arrays["PieceId"]
        # Arranged in a row, without overlap.
        left, right = (result.positions[result.triangles[pieces == piece]] for piece in (0, 1))
        self.assertTrue(left[..., 0].max() < right[..., 0].min()
                        or right[..., 0].max() < left[..., 0].min())
        np.testing.assert_array_equal(np.bincount(pieces), [12, 12])

    def test_a_dart_opens(self):
        surface, curves = read("pants_front"), read("pants_front_curves")
        result = sf.flatten_polydata(surface, curves)
        sides = [wire for wire in result.wires if wire.type == "dart"]
        self.assertEqual(len(sides), 2)
        self.assertAlmostEqual(sides[0].flat_length, sides[1].flat_length, 9)
        self.assertTrue(all(wire.boundary for wire in sides))

    def test_a_curve_across_triangles_becomes_edges(self):
        points, triangles = grid()
        result = sf.flatten(points, triangles, [[[0.0, 0.5, 0.0], [4.0, 0.5, 0.0]]])
        self.assertGreater(len(result.positions), len(points))
        self.assertEqual((result.point_arrays["vtkOriginalPointIds"] == -1).sum(), 9)
        curve = result.report["curves"][0]
        self.assertEqual(curve["name"], "curve 0")
        self.assertAlmostEqual(curve["length_3d"], 4.0, 12)

    def test_a_straight_key_is_straight(self):
        points, triangles, arc = quarter_sphere()
        arc = sf.Curve(arc, type="key", key_shape="straight")
        result = sf.flatten(points, triangles, [arc])
        wire = next(wire for wire in result.wires if wire.type == "key")
        ends = result.positions[[wire.vertices[0], wire.vertices[-1]]]
        self.assertAlmostEqual(np.linalg.norm(ends[1] - ends[0]), wire.rest_length, 9)

    def test_a_key_takes_a_planar_shape(self):
        points, triangles, arc = quarter_sphere()
        angles = np.linspace(0.0, 0.5, len(arc))
        shape = np.column_stack([np.cos(angles), np.sin(angles)])
        result = sf.flatten(points, triangles, [sf.Curve(arc, type="key", planar_shape=shape)])
        wire = next(wire for wire in result.wires if wire.type == "key")
        steps = np.diff(result.positions[wire.vertices], axis=0)
        cross = steps[:-1, 0] * steps[1:, 1] - steps[:-1, 1] * steps[1:, 0]
        turns = np.arctan2(cross, (steps[:-1] * steps[1:]).sum(axis=1))
        np.testing.assert_allclose(np.abs(turns), 0.5 / (len(arc) - 1), atol=1e-9)
        self.assertTrue((turns > 0).all() or (turns < 0).all())

    def test_an_elastic_curve_stays_within_its_tolerance(self):
        points, triangles, arc = quarter_sphere()
        rigid = sf.flatten(points, triangles, [arc])
        elastic = sf.flatten(points, triangles, [sf.Curve(arc, length_tolerance=0.05)])
        error = elastic.report["curves"][0]["error"]
        self.assertTrue(1e-6 < error <= 0.05 + 1e-9, error)
        # What gives way spares the sheet.
        self.assertLess(elastic.report["pieces"][0]["energy_rigid"],
                        rigid.report["pieces"][0]["energy_rigid"])

    def test_the_report_is_plain_python(self):
        surface, curves = read("shirt_shoulder"), read("shirt_shoulder_curves")
        result = sf.flatten_polydata(surface, curves)
        self.assertEqual(json.loads(json.dumps(result.report, allow_nan=False)), result.report)
        self.assertTrue(result.report["pieces"][0]["history"])

    def test_arrays_fit_points_and_triangles(self):
        points, triangles, arc = quarter_sphere()
        result = sf.flatten(points, triangles, [arc])
        for name, array in result.point_arrays.items():
            self.assertEqual(len(array), len(result.positions), name)
        for name, array in result.cell_arrays.items():
            self.assertEqual(len(array), len(result.triangles), name)
        p, t = result.positions, result.triangles
        u, v = p[t[:, 1]] - p[t[:, 0]], p[t[:, 2]] - p[t[:, 0]]
        areas = 0.5 * (u[:, 0] * v[:, 1] - u[:, 1] * v[:, 0])
        a, b = (result.points[t[:, k]] - result.points[t[:, 0]] for k in (1, 2))
        in_space = 0.5 * np.linalg.norm(np.cross(a, b), axis=1)
        np.testing.assert_allclose(result.cell_arrays["AreaRatio"], areas / in_space, rtol=1e-9)

    def test_arrays_outlive_the_filter(self):
        points, triangles, arc = quarter_sphere()
        first = sf.flatten(points, triangles, [arc])
        kept = first.positions.copy()
        for _ in range(20):
            sf.flatten(points, triangles, [arc], arrange=False)
        np.testing.assert_array_equal(first.positions, kept)
        first.positions[0] = 0.0  # they are the caller's

    def test_separate_triangles_are_joined(self):
        points, triangles = grid()
        soup, corners = points[triangles.ravel()], np.arange(triangles.size).reshape(-1, 3)
        joined = sf.flatten(soup, corners)
        self.assertEqual(len(joined.positions), len(points))
        self.assertEqual(len(joined.report["pieces"]), 1)
        kept = sf.flatten(soup, corners, coincident_points="keep")
        self.assertEqual(len(kept.report["pieces"]), len(triangles))

    def test_progress_is_told(self):
        points, triangles, arc = quarter_sphere()
        told = []
        sf.flatten(points, triangles, [arc], progress=told.append)
        self.assertEqual(told, sorted(told))
        self.assertEqual(told[-1], 1.0)
        self.assertTrue(all(0.0 <= value <= 1.0 for value in told))

    def test_a_sound_run_warns_of_nothing(self):
        points, triangles, arc = quarter_sphere()
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            sf.flatten(points, triangles, [arc])


class Help(unittest.TestCase):
    def test_every_option_of_flatten_is_told_in_its_help(self):
        told = [line.strip().split(":")[0] for line in inspect.getdoc(sf.flatten).splitlines()]
        for option in inspect.signature(sf.flatten).parameters:
            self.assertIn(option, told)


if __name__ == "__main__":
    unittest.main()
