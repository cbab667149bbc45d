# SPDX-License-Identifier: BSD-3-Clause
"""Each user interface says remedies with its own options."""

import inspect
import re
import unittest

import numpy as np

import surfaceflattening as sf
from surfaceflattening._core import make_message
from surfaces import column_of, grid, quarter_sphere, shell, warned

Algorithm = sf.vtkFlatteningAlgorithm
NAMES = [Algorithm.GetRemedyName(k) for k in range(Algorithm.GetNumberOfRemedies())]


class Words(unittest.TestCase):
    def test_there_are_remedies_each_once(self):
        self.assertGreater(len(NAMES), 30)
        self.assertEqual(len(set(NAMES)), len(NAMES))
        self.assertIsNone(Algorithm.GetRemedyName(len(NAMES)))
        self.assertIsNone(Algorithm.GetRemedySentence("Despair"))

    def test_each_names_properties_that_the_filters_have(self):
        arrays = {"LengthTolerance", "CurveType"}
        named = 0
        for name in NAMES:
            for option in re.findall("{(.*?)}", Algorithm.GetRemedySentence(name)):
                named += 1
                property_, _, value = option.rpartition(".")[2].partition("=")
                class_ = (sf.vtkSewnShape if option.startswith("Sewing.") else
                          sf.vtkPatternWriter if hasattr(sf.vtkPatternWriter, "Set" + property_) else
                          sf.vtkLeastSquaresConformalFilter if property_ == "Pins" else
                          sf.vtkWireWarpingFilter)
                with self.subTest(name, option=option):
                    self.assertTrue(property_ in arrays or hasattr(class_, "Set" + property_) or
                                    hasattr(class_, "Add" + property_.removesuffix("s")) or hasattr(sf, property_))
                    self.assertTrue(value in ("", "on", "0") or hasattr(class_, value))
        self.assertGreater(named, 20)

    def test_each_names_arguments_that_python_has(self):
        functions = (sf.flatten, sf.Curve, sf.Flattening.write_pattern, sf.resew)
        arguments = {name for function in functions for name in inspect.signature(function).parameters}
        named = 0
        for name in NAMES:
            words = make_message("", [(name, "%")])
            self.assertTrue(words.removeprefix("; "), name)
            self.assertNotRegex(words, "--|[][{}]|[A-Z][a-z]+[A-Z]|[A-Z]+_[A-Z]+")
            for word in re.findall(r"[a-z]+(?:_[a-z]+)+|[a-z]+(?==)", words):
                named += 1
                with self.subTest(name, word=word):
                    self.assertIn(word, arguments)
        self.assertGreater(named, 15)

    def test_a_message_is_the_defect_and_its_remedies(self):
        self.assertEqual(make_message("it is broken", []), "it is broken")
        self.assertEqual(
            make_message("banks cross", [("CloseCuts", ""), ("Give", "a seam")]),
            "banks cross; close the cuts where they cross (close_cuts=True), or give a seam")


class Reports(unittest.TestCase):
    def test_an_error_carries_kind_and_remedies(self):
        with self.assertRaises(sf.FlatteningError) as caught:
            sf.flatten(*grid(), [[[0.0, 0.5, 0.0], [4.0, 0.5, 0.0]]], split_triangles=False)
        error = caught.exception
        self.assertEqual(error.kind, "curve points")
        self.assertEqual(error.remedies[0], ("SplitTriangles", ""))
        self.assertIn("split_triangles", error.message)

    def test_the_run_agrees_with_its_worst_piece(self):
        points, triangles, ridges = pyramid()
        points, triangles = [*points, (10, 0, 0), (11, 0, 0), (10, 1, 0)], [*triangles, (5, 6, 7)]
        with warned() as caught:
            report = sf.flatten(points, triangles, ridges).report
        pieces = sorted(report["pieces"], key=lambda piece: piece["triangles"])
        self.assertEqual([piece["status"] for piece in pieces], ["Ok", "LengthError"])
        for key in ("status", "message", "ids", "id_kind", "remedies"):
            with self.subTest(key):
                self.assertEqual(report[key], pieces[1][key])
        self.assertEqual((pieces[0]["ids"], pieces[0]["remedies"]), ([], []))
        self.assertEqual(report["id_kind"], "curves")
        self.assertIn("ReleaseCurves", [remedy["name"] for remedy in report["remedies"]])
        self.assertIn("length_tolerance", report["message"])
        self.assertIn(report["message"], str(caught[0].message))


def run(*arguments, **options):
    """The result of a run that keeps no promise or all: there is a remedy exactly where something is wrong."""
    with warned():
        result = sf.flatten(*arguments, **options)
    report = result.report
    assert (report["status"] == "Ok") == (not report["message"]) == (not report["remedies"]), report["message"]
    return result, report, {remedy["name"] for remedy in report["remedies"]}


def pyramid():
    """Its four ridges are curves, and cannot be laid flat without a change of their lengths."""
    points = np.array([[0, 0, 1], [1, 0, 0], [0, 1, 0], [-1, 0, 0], [0, -1, 0]], float)
    triangles = np.array([[0, 1, 2], [0, 2, 3], [0, 3, 4], [0, 4, 1]])
    return points, triangles, [sf.Curve([0, v], name=f"ridge {v}") for v in range(1, 5)]


def two_arcs():
    """The quarter-sphere of Fig. 14."""
    points, triangles, arc = quarter_sphere()
    return points, triangles, [arc, [0, *range(3, 36, 5), 36]]


FRAME = [sf.Curve(ids, "key", name) for name, ids in (
    ("lower", range(44, 55)), ("upper", range(88, 99)), ("left", column_of(10, 10, 4)), ("right", column_of(10, 10, 8)))]


class BrokenPromises(unittest.TestCase):
    def test_each_keeps_a_result(self):
        staircase = grid(40, 2, lambda i, j: (
            (1 + j) * np.cos(-0.075 * np.pi * i), (1 + j) * np.sin(-0.075 * np.pi * i), 0.05 * i))
        for status, arguments, options in (
                ("NotConverged", shell(6, 6, 0.4), {"isometric_iterations": 1}),
                ("LengthError", shell(6, 6, 0.4), {"max_length_error": 0.0}),
                ("FlippedTriangles", two_arcs(), {"scheme": "progressive", "interior": "laplacian"}),
                # The patch in the middle has all its angles prescribed, and they are not those of a flat one.
                ("IncompatibleKeys", (*shell(10, 10, 0.3), FRAME), {}), ("Overlap", staircase, {}),
                ("BeyondLimits", shell(6, 6, 0.4), {"material": "laminate"}),
                ("MissingGrain", shell(6, 6, 0.4), {"material": "laminate", "grain": "hem"})):
            with self.subTest(status):
                result, report, _ = run(*arguments, **options)
                self.assertEqual(report["status"], status)
                self.assertEqual(len(result.positions), len(arguments[0]))

    def test_wires_that_miss_their_lengths_are_named_with_their_errors(self):
        for scheme in ("global", "isometric", "progressive"):
            _, report, remedies = run(*pyramid(), scheme=scheme)
            self.assertEqual((report["status"], report["id_kind"]), ("LengthError", "curves"))
            errors = [curve["error"] for curve in report["curves"]]
            self.assertEqual(errors[report["ids"][0]], max(errors))
            for curve in report["ids"]:
                self.assertGreater(errors[curve], 1e-9)
                self.assertIn(f'"{report["curves"][curve]["name"]}" by up to {errors[curve]:.4g}', report["message"])
            self.assertIn("ReleaseCurves", remedies)
            # More iterations are advised only where they change the result.
            self.assertFalse(remedies & {"AllowAngleIterations", "AllowIsometricIterations"})
        for scheme, option, remedy in (("global", "max_iterations", "AllowAngleIterations"),
                                       ("isometric", "isometric_iterations", "AllowIsometricIterations")):
            self.assertIn(remedy, run(*two_arcs(), scheme=scheme, **{option: 2})[2])

    def test_a_boundary_that_misses_its_length_is_named_by_an_edge(self):
        points, triangles = shell(6, 6, 0.4)
        _, report, _ = run(points, triangles, max_length_error=0.0)
        self.assertEqual((report["status"], report["id_kind"], len(report["ids"])), ("LengthError", "edges", 2))
        self.assertIn("the boundary", report["message"])
        self.assertTrue(any(set(report["ids"]) <= set(corners) for corners in triangles.tolist()))

    def test_keys_that_cannot_keep_their_shapes_are_named_with_a_way_out(self):
        ids = [(2, 2), (3, 2), (4, 2), (5, 2), (6, 2), (6, 3), (6, 4), (6, 5), (6, 6), (5, 6), (4, 6), (3, 6), (2, 6), (2, 5),
               (2, 4), (2, 3), (2, 2)]
        clashes = 0
        for chain in ([9 * j + i for i, j in ids], list(range(9)), list(range(36, 45))):
            # Of the planar shapes: to and fro, which folds each triangle beside it over.
            for shape in ({}, {"key_shape": "straight"}, {"planar_shape": [(k % 2, 1e-3 * k) for k in range(len(chain))]}):
                for scheme in ("global", "isometric", "progressive"):
                    with self.subTest(chain=chain[:2], scheme=scheme, **shape):
                        _, report, remedies = run(*shell(8, 8, 0.4), [sf.Curve(chain, "key", "mine", **shape)], scheme=scheme)
                        if report["status"] != "Ok":
                            clashes += 1
                            self.assertEqual((report["status"], report["id_kind"], report["ids"]),
                                             ("IncompatibleKeys", "curves", [0]))
                            self.assertIn('"mine"', report["message"])
                            self.assertIn("MakeAccessory", remedies)
                            self.assertTrue(report["curves"][0]["released"])
                            self.assertLess(report["pieces"][0]["E_len_max"], 1e-9)
        self.assertGreater(clashes, 5)

    def test_keys_whose_release_does_not_help_are_all_named_and_kept(self):
        # In a corner, away from the keys, a spike all of whose edges are wires cannot be laid flat.
        points, triangles = shell(10, 10, 0.3)
        spiked = points.copy()
        spiked[12, 2] += 1
        around = [int(v) for v in set(triangles[(triangles == 12).any(axis=1)].ravel()) - {12}]
        turn = {v: np.arctan2(*(points[v] - points[12])[1::-1]) for v in around}
        ring = sorted(around, key=turn.get)
        spike = [*(sf.Curve([12, v], name=f"ridge {v}") for v in ring), sf.Curve([*ring, ring[0]], name="ring")]
        _, report, remedies = run(spiked, triangles, [*FRAME, *spike], scheme="global")
        self.assertEqual(report["status"], "LengthError")
        self.assertIn("giving up all of them does not help alone", report["message"])
        for key in FRAME:
            self.assertIn(f'"{key.name}"', report["message"])
        self.assertFalse(any(curve["released"] for curve in report["curves"]))
        self.assertIn("MakeAccessory", remedies)
        # Without the spike their release does help.
        self.assertEqual(run(spiked, triangles, FRAME, scheme="global")[1]["status"], "IncompatibleKeys")


if __name__ == "__main__":
    unittest.main()
