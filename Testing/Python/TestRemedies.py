# SPDX-License-Identifier: BSD-3-Clause
"""Each user interface says remedies with its own options."""

import inspect
import re
import unittest

import surfaceflattening as sf
from surfaceflattening._core import make_message
from surfaces import grid, warned

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
        # The four sides of a pyramid with their ridges as curves have no flat shape.
        points = [[0, 0, 1], [1, 0, 0], [0, 1, 0], [-1, 0, 0], [0, -1, 0], [10, 0, 0], [11, 0, 0], [10, 1, 0]]
        triangles = [[0, 1, 2], [0, 2, 3], [0, 3, 4], [0, 4, 1], [5, 6, 7]]
        ridges = [sf.Curve([0, v], name=f"ridge {v}") for v in range(1, 5)]
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


if __name__ == "__main__":
    unittest.main()
