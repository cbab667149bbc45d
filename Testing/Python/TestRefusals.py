# SPDX-License-Identifier: BSD-3-Clause
"""Bad input is an exception that says what is wrong and where; broken promises are warnings."""

import contextlib
import os
import pickle
import tempfile
import unittest

import numpy as np
from vtkmodules.vtkCommonCore import vtkIntArray

import surfaceflattening as sf
from surfaces import command, grid, read, warned

Codes = sf.vtkFlatteningAlgorithm


@contextlib.contextmanager
def silence(test):
    """VTK writes nothing past Python's sys.stderr."""
    with tempfile.TemporaryFile() as file:
        kept = os.dup(2)
        os.dup2(file.fileno(), 2)
        try:
            yield
        finally:
            os.dup2(kept, 2)
            os.close(kept)
            file.seek(0)
            test.assertEqual(file.read(), b"")


class Refused(unittest.TestCase):
    def refuse(self, code, *arguments, **options):
        with silence(self), self.assertRaises(sf.FlatteningError) as caught:
            sf.flatten(*arguments, **options)
        error = caught.exception
        self.assertEqual(error.code, code)
        self.assertTrue(error.message)
        self.assertEqual(str(error), f"{error.name}: {error.message}")
        return error

    def test_words_of_the_command_name_the_keyword_that_was_meant(self):
        points, triangles = grid()
        for call, word, meant in (
                (sf.flatten, "--no-arrange", "arrange=False"), (sf.flatten, "no_keys", "release_keys"),
                (sf.flatten, "curve-distance", "imprint_tolerance"), (sf.suggest, "max_strain", "bound"),
                (sf.suggest, "kind", "cuts"), (sf.flatten, "schem", "scheme")):
            with self.subTest(word=word), self.assertRaisesRegex(TypeError, f"did you mean '{meant}'\\?"):
                call(points, triangles, **{word: True})

    def test_near_misses_name_the_call_that_was_meant(self):
        points, triangles = grid()
        mesh = sf.make_surface(points, triangles)
        for call in (sf.flatten, sf.suggest, sf.make_flattenable):
            for arguments in ((mesh,), (mesh, [[0, 1]])):
                with self.assertRaisesRegex(TypeError, "flatten_polydata\\(\\), suggest_polydata\\(\\)"):
                    call(*arguments)
            with self.assertRaisesRegex(TypeError, "triangles are missing"):
                call(points)
            for curves in ([("dart", [0, 1])], [[[0, 1], "dart"]], ("dart", [0, 1])):
                with self.assertRaisesRegex(TypeError, "sf.Curve\\(points, \"dart\"\\)"):
                    call(points, triangles, curves)

    def test_what_is_skipped_is_warned_of_and_reported(self):
        all_points, all_triangles = map(np.array, command.together(command.sheet(), command.TETRAHEDRON))
        first = len(all_triangles) - 4
        error = self.refuse(Codes.CLOSED_SURFACE, all_points, all_triangles)
        self.assertEqual(error.ids, [first])
        with silence(self), warned() as caught:
            result = sf.flatten(all_points, all_triangles, skip_closed=True)
        self.assertEqual([warning.category for warning in caught], [sf.FlatteningWarning])
        self.assertEqual(caught[0].filename, __file__)
        self.assertEqual(result.report["warnings"], [str(caught[0].message)])
        self.assertEqual(result.report["left_out"],
                         [{"reason": "ClosedSurface", "cell": first, "triangles": 4}])
        np.testing.assert_array_equal(result.cell_arrays["vtkOriginalCellIds"], np.arange(first))

    def test_a_straight_key_along_two_edges_of_a_triangle_is_warned_of(self):
        points, triangles = grid()
        for scale in (1e-3, 1.0, 300.0):
            for start, way, told in ((1.015, "key", True), (1.05, "key", True), (1.015, "accessory", False),
                                       (1.0, "key", False)):
                line = np.array([[0, 0, 0], [start, 0, 0], [1.5, 0.9, 0], [2.0, 3.0, 0]]) * scale
                curve = sf.Curve(line, way, "bent", "straight") if way == "key" else sf.Curve(line, way, "bent")
                with self.subTest(scale=scale, start=start, way=way), warned() as caught:
                    sf.flatten(points * scale, triangles, [curve])
                    found = [str(one.message) for one in caught if "two edges of a triangle" in str(one.message)]
                    self.assertEqual(len(found), 1 if told else 0, [str(one.message) for one in caught])
                    if told:
                        self.assertRegex(found[0], r"'bent' runs along .* in cells 2, ")

    def test_arrays_of_curves_whose_names_differ_in_case_alone_are_warned_of(self):
        points, triangles = grid()
        for name in ("CurveType", "CurveName", "KeyShape", "LengthTolerance", "LengthEase", "EasedPiece", "PlanarShape"):
            with self.subTest(name), warned() as caught:
                curves = sf.make_curves([sf.Curve([0, 1], "key", planar_shape=[[0, 0], [1, 0]])], points)
                data = curves.GetPointData() if name == "PlanarShape" else curves.GetCellData()
                data.RemoveArray(name)
                array = vtkIntArray()
                array.SetName(name.upper())
                array.InsertNextValue(0)
                data.AddArray(array)
                sf.flatten_polydata(sf.make_surface(points, triangles), curves)
                found = [str(one.message) for one in caught if name.upper() in str(one.message)]
                self.assertEqual(len(found), 1, [str(one.message) for one in caught])
                self.assertIn("call it " + name, found[0])

    def test_the_error_can_be_sent_to_another_process(self):
        error = self.refuse(Codes.EMPTY_SURFACE, np.empty((0, 3)), np.empty((0, 3), int))
        self.assertEqual(sf.flatten(*grid()).report["status"], "Ok")  # the next run is sound
        again = pickle.loads(pickle.dumps(error))
        self.assertEqual((again.code, again.name, again.ids, again.message),
                         (error.code, error.name, error.ids, error.message))


class Arguments(command.CommandTest):
    def wrong(self, words, curves=(), **options):
        error = self.assert_raises(ValueError, words, sf.flatten, *grid(), curves, **options)
        self.assertIsInstance(error, sf.ArgumentError)

    def test_words(self):
        for option in ("scheme", "solver", "interior", "coincident_points"):
            self.wrong([option, "'best'", "one of"], **{option: "best"})
        self.wrong(["type of curve 0", "accessory, key, dart, seam"], [sf.Curve([0, 1], type="hem")])
        self.wrong(["key_shape", "straight"], [sf.Curve([0, 1], key_shape="round")])

    def test_capital_letters_of_words_do_not_matter_as_in_the_command(self):
        points, triangles = grid()
        small, large = (sf.flatten(points, triangles, scheme=scheme, interior=interior)
                        for scheme, interior in (("global", "laplacian"), ("Global", "LAPLACIAN")))
        self.assertEqual(small.positions.tolist(), large.positions.tolist())
        self.wrong(["isometric_tolerance", "isometric", "global"], scheme="Global", isometric_tolerance=1.0)
        large.write_pattern(self.path("a.pdf"), unit="CM", paper="a3")
        self.assertTrue(os.path.exists(self.path("a.pdf")))

    def test_words_of_the_commands_text_files(self):
        points, _ = grid()
        for word in ("straight", "Straight"):
            self.wrong([f"type of curve 0 ('mid') is '{word}'", 'type="key", key_shape="straight"'],
                       [sf.Curve([0, 1], type=word, name="mid")])
        self.wrong(["'edge'", 'type="accessory"', "border"], [sf.Curve([0, 1], type="edge")])
        for kind, shape in (("key", "straight"), ("Key", "STRAIGHT")):
            data = sf.make_curves([sf.Curve([0, 1], type=kind, key_shape=shape)], points).GetCellData()
            self.assertEqual([data.GetArray(name).GetValue(0) for name in ("CurveType", "KeyShape")], [1, 1])

    def test_lists_and_dicts_of_another_type_are_named(self):
        points, triangles = grid()
        result = sf.flatten(points, triangles)
        for words, call in (
                ("sizes = .* must be a dict", lambda: sf.grade([result, result])),
                ("size 'L' is list", lambda: sf.grade({"M": result, "L": []})),
                ("tolerance = .* must be a dict", lambda: sf.flatten(points, triangles, tolerance=["hem"])),
                ("ease = .* must be a dict", lambda: sf.flatten(points, triangles, ease=["hem"])),
                ("prefer = .* must be a dict", lambda: sf.suggest(points, triangles, prefer=["hem"])),
                ("keep = .* must be a list", lambda: sf.make_flattenable(points, triangles, keep="hem"))):
            with self.subTest(words), self.assertRaisesRegex(sf.ArgumentTypeError, words):
                call()

    def test_ranges(self):
        for option, value in (("spacing", -0.1), ("imprint_tolerance", 2.0), ("max_iterations", 0),
                              ("snap_tolerance", float("nan"))):
            self.wrong([option, "out of range"], **{option: value})
        error = self.assert_raises(TypeError, "", sf.flatten, *grid(), spacing="wide")
        self.assertIsInstance(pickle.loads(pickle.dumps(error)), sf.ArgumentError)


class BrokenPromises(unittest.TestCase):
    def test_keys_that_contradict_each_other_are_named(self):
        with silence(self), warned() as caught:
            result = sf.flatten_polydata(read("pants_front"), read("pants_front_curves_set3"))
        # Fig. 13: both girths and the grain between them cannot keep their shapes together.
        self.assertEqual(result.report["status"], "IncompatibleKeys")
        self.assertEqual([warning.category for warning in caught], [sf.FlatteningWarning])
        self.assertIn(result.report["message"], str(caught[0].message))
        self.assertEqual(caught[0].filename, __file__)
        self.assertIn("midthigh", result.report["message"])
        self.assertGreater(len(result.positions), 0)


if __name__ == "__main__":
    unittest.main()
