# SPDX-License-Identifier: BSD-3-Clause
"""Names, ids and arrays as numpy and VTK have them: taken for what they are, or refused by name."""

import json
import unittest
import warnings

import numpy as np
from vtkmodules.vtkCommonCore import vtkBitArray, vtkDoubleArray, vtkStringArray, vtkVariantArray
from vtkmodules.vtkCommonDataModel import vtkMultiBlockDataSet, vtkPolyData, vtkUnstructuredGrid

import surfaceflattening as sf
from surfaces import command, grid, points_of

CURVE = [5, 6, 7]


class OddCase(command.WordsTest):
    def setUp(self):
        self.points, self.triangles = grid()
        self.points[:, 2] += 0.1 * np.sin(self.points[:, 0] * self.points[:, 1])

    def wrong(self, words, *arguments, kind=ValueError, **options):
        """The surface is that of the test unless arguments are given."""
        self.assert_raises(kind, words, sf.flatten, *(arguments or (self.points, self.triangles)), **options)

    def wrong_curves(self, words, *curves, kind=ValueError):
        self.wrong(words, self.points, self.triangles, list(curves), kind=kind)

    def flatten(self, **curve):
        return sf.flatten(self.points, self.triangles, [sf.Curve(CURVE, **curve)])


class Names(OddCase):
    def test_names_of_any_language_come_back(self):
        for name in ("Ärmel", "袖", "\U0001f455", "a b", "a\tb", "%s%n", "x" * 10000):
            report = self.flatten(name=name).report
            self.assertEqual(report["curves"][0]["name"], name)
            self.assertEqual(json.loads(json.dumps(report))["curves"][0]["name"], name)

    def test_what_is_no_text_is_refused_and_not_the_end_of_the_interpreter(self):
        for name in ("a\ud800b", "\udfff", "sleeve\udc80"):
            self.wrong_curves(["curve 1", repr(name), "UTF-8"], CURVE, sf.Curve(CURVE, name=name))
            self.assert_raises(ValueError, ["curve 0", repr(name)], sf.make_curves, [sf.Curve(CURVE, name=name)], self.points)
            for grain in (name, ["hem", name]):
                self.wrong(["grain", repr(name), "UTF-8"], material="twill", grain=grain)
        for name in ("\0", "a\0b", "hem\0"):
            self.wrong_curves(["curve 0", repr(name), "NUL"], sf.Curve(CURVE, name=name))
        for name in (b"hem", 7, None, ["hem"], 1.5):
            self.wrong_curves(["curve 0", repr(name), "string"], sf.Curve(CURVE, name=name), kind=TypeError)

    def test_bytes_in_a_vtk_array_that_are_no_utf8_are_replaced(self):
        curves, surface = sf.make_curves([CURVE], self.points), sf.make_surface(self.points, self.triangles)
        names = vtkStringArray()
        names.SetName("CurveName")
        names.InsertNextValue(b"a\xff\xfeb")
        curves.GetCellData().AddArray(names)
        result = sf.flatten_polydata(surface, curves)
        name = "a\ufffd\ufffdb"
        self.assertEqual(result.report["curves"][0]["name"], name)
        self.assertIn(name, [wire.name for wire in result.wires])
        json.dumps(result.report)
        curves.GetPoints().SetPoint(0, points_of(curves)[0] + (0, 0, 9))
        self.assert_raises(sf.FlatteningError, name, sf.flatten_polydata, surface, curves)


class Ids(OddCase):
    def test_ids_that_no_int_holds_are_told_as_they_were_given(self):
        for ids in (*([0, 1, huge] for huge in (2**63, 2**64, 2**70, -2**70)),
                    *(np.array([0, 1, huge], np.uint64) for huge in (2**63 + 5, 2**64 - 1))):
            self.wrong(["triangles", str(ids[2])], self.points, [ids])
            self.wrong_curves(["curve 0", str(ids[2])], ids)

    def test_ids_beyond_the_points_are_refused(self):
        for id_ in (-1, 20, 2**31, 2**32, 2**32 + 2, 2**62):
            corners = np.vstack([self.triangles, [[0, 1, id_]]])
            error = self.assert_raises(sf.FlatteningError, "", sf.flatten, self.points, corners)
            self.assertEqual((error.name, error.ids), ("InvalidPointId", [len(self.triangles)]))
            self.wrong_curves(["curve 0 ('hem')", f"point {id_}", "0 to 19"], sf.Curve([5, id_], name="hem"))

    def test_what_are_no_ids_is_refused(self):
        for array in (np.ones((3, 3), bool), np.ones((3, 3)), np.full((3, 3), "1"),
                      np.full((3, 3), None), np.full((3, 3), True, object)):
            self.wrong(["triangles", "whole numbers"], self.points, array)
            self.wrong_curves(["curve 0", "whole numbers"], array[0])

    def test_pins_and_counts_beyond_int(self):
        self.wrong(["pins", "out of range"], scheme="lscm", pins=(2**70, 1))
        self.wrong(["max_iterations", "out of range"], max_iterations=2**70)
        for piece in (2**31, 2**70):
            self.wrong(["ease", str(piece)], ease={("hem", piece): 0.1})
        for pins in (None, 7, (1,), (1.5, 2), "ab"):
            self.wrong("pins", scheme="lscm", pins=pins, kind=TypeError)
        self.wrong("pins", scheme="lscm", pins=(-5, 3), kind=sf.FlatteningError)


class Arrays(OddCase):
    def setUp(self):
        super().setUp()
        self.expected = self.flatten(type="key")

    def expect_same(self, points, triangles, curve=CURVE):
        result = sf.flatten(points, triangles, [sf.Curve(curve, "key")])
        np.testing.assert_array_equal(result.positions, self.expected.positions)
        np.testing.assert_array_equal(result.triangles, self.expected.triangles)

    def test_memory_of_any_layout(self):
        points, triangles = self.points, self.triangles
        spread = np.full((2 * len(points), 5), np.nan)
        spread[::2, 1:4] = points
        self.expect_same(spread[::2, 1:4], triangles)
        self.expect_same(np.asfortranarray(points), np.asfortranarray(triangles))
        self.expect_same(points[::-1].copy()[::-1], triangles[::-1].copy()[::-1])
        self.expect_same(points, triangles, np.repeat(CURVE, 3)[::3])

    def test_read_only_memory(self):
        points, triangles, curve = self.points.copy(), self.triangles.copy(), np.array(CURVE)
        for array in (points, triangles, curve):
            array.flags.writeable = False
        self.expect_same(points, triangles, curve)

    def test_other_byte_orders_and_types(self):
        for order in "<>":
            self.expect_same(self.points.astype(order + "f8"), self.triangles.astype(order + "i8"),
                             np.array(CURVE, order + "i4"))
        for kind in ("u1", "i1", "i2", "u4", "u8", object):
            self.expect_same(self.points, self.triangles.astype(kind), np.array(CURVE, kind))
        self.expect_same(self.points.astype(object), self.triangles)
        self.expect_same(self.points.tolist(), self.triangles.tolist(), tuple(CURVE))
        for positions in (self.points[CURVE], self.points[CURVE].astype(">f8")):
            self.expect_same(self.points, self.triangles, positions)

    def test_empty_arrays_are_refused(self):
        self.wrong("(n, 3)", [], [])
        for none in (np.empty((0, 3), int), np.empty((0, 3))):
            self.wrong("EmptySurface", self.points, none, kind=sf.FlatteningError)
        for curve in ([], np.empty(0), np.empty((0, 3)), np.empty(0, object)):
            self.wrong_curves(["curve 0", "at least 2"], curve)

    def test_masked_values_are_no_values(self):
        masked = np.ma.masked_array(self.points, mask=False)
        self.expect_same(masked, self.triangles)
        masked[3, 1] = np.ma.masked
        self.wrong(["points", "masked"], masked, self.triangles)
        self.wrong(["triangles", "masked"], self.points, np.ma.masked_equal(self.triangles, 3))
        self.wrong_curves(["curve 0", "masked"], np.ma.masked_equal(CURVE, 6))
        # Within lists as well.
        rows = self.triangles.tolist()
        rows[3] = np.ma.masked_equal(rows[3], rows[3][1])
        self.wrong(["triangles", "masked"], self.points, rows)
        places = [tuple(point) for point in self.points]
        places[2] = np.ma.array(places[2], mask=[False, True, False])
        self.wrong(["points", "masked", ".filled()"], places, self.triangles)
        self.wrong_curves(["curve 0", "masked"], [5, 6, np.ma.masked])
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            rows[3] = np.ma.array(self.triangles[3])
            self.expect_same(self.points, rows)

    def test_whole_numbers_are_coordinates_as_far_as_they_are_exact(self):
        points, triangles = grid()
        points = np.rint(points * 1000).astype(int)
        expected = sf.flatten(points.astype(float), triangles, [points[CURVE].astype(float)])
        for kind in (np.int32, np.int64, np.uint16, object):
            given = points.astype(kind)
            self.assertTrue(sf.flatten(given, triangles, [given[CURVE]]) == expected, kind)
        for huge in (2**53 + 1, -2**53 - 1):
            points[7, 0] = huge
            self.wrong(["points", str(huge), "2**53", "unit"], points, triangles)
        self.wrong(["points", "numbers", "bool"], points > 1, triangles)

    def test_one_curve_in_place_of_a_list_is_named(self):
        for curve in (CURVE, np.array(CURVE), tuple(CURVE), sf.Curve(CURVE), self.points[CURVE], range(5, 8), "hem"):
            self.wrong(["list", "[curve]"], self.points, self.triangles, curve, kind=TypeError)
        rows = np.array([[5, 6, 7], [10, 11, 12]])
        self.assertEqual(len(sf.flatten(self.points, self.triangles, rows).report["curves"]), 2)

    def test_options_that_are_not_there_and_flags_that_are_none(self):
        self.wrong(["flatten()", "'sheme'", "'scheme'"], sheme="global", kind=TypeError)
        self.assert_raises(TypeError, ["flatten_polydata()", "'colour'"], sf.flatten_polydata,
                           sf.make_surface(self.points, self.triangles), colour=1)
        for value in ("no", 0, None, [True]):
            self.wrong(["close_cuts", repr(value), "True or False"], close_cuts=value, kind=TypeError)
        self.assertEqual(sf.flatten(self.points, self.triangles, close_cuts=np.bool_(False)).report["status"], "Ok")
        self.wrong(["tolerance of 'hem'", "'wide'"], tolerance={"hem": "wide"}, kind=TypeError)

    def test_shapes_and_values_that_are_none_are_refused_with_what_helps(self):
        for words, points in (
                (["(20, 2)", "zeros for z"], self.points[:, :2]), ("(n, 3)", self.points.ravel()),
                (["points", "real"], self.points + 1j), (["points", "numbers"], [["a", 0, 0]] * 20),
                (["points", "rows"], [[0, 0, 0], [1, 0]]), (["points", "not a finite number"], np.full((20, 3), None)),
                (["points", "datetime64"], self.points.astype("M8[s]"))):
            self.wrong(words, points, self.triangles)
        for words, triangles in (
                (["(1, 4)", "flat list"], [[0, 1, 6, 5]]), ("(m, 3)", 7), ("(m, 3)", self.triangles[None]),
                ("(m, 3)", self.triangles[:, :2]), (["triangles", ".astype(int)"], self.triangles.astype(float)),
                (["triangles", "rows"], [[0, 1, 2], [0, 1]])):
            self.wrong(words, self.points, triangles)
        self.wrong_curves(["curve 1", "(k, 3)"], CURVE, np.zeros((4, 2)))
        self.wrong_curves(["curve 0 ('hem')", "rows"], sf.Curve([[0, 0, 0], [1, 1]], name="hem"))
        for tolerance in ("wide", None, [1, 2]):
            self.wrong_curves(["length_tolerance", "curve 0 ('hem')", repr(tolerance)],
                              sf.Curve(CURVE, name="hem", length_tolerance=tolerance))
        self.wrong_curves(["planar_shape", "(3, 2)"], sf.Curve(CURVE, type="key", planar_shape=[[0, 0], [1, 0]]))
        for shape in ([[0, 0], [1]], [["a", "b"]] * 3, np.zeros((3, 2)) + 1j):
            self.wrong_curves(["planar_shape", "curve 0 ('hem')"], sf.Curve(CURVE, name="hem", type="key", planar_shape=shape))
        for kind in (None, ["key"], 1, np.array(["key", "dart"])):
            self.wrong_curves("type of curve 0", sf.Curve(CURVE, type=kind))


class DataSets(OddCase):
    def setUp(self):
        super().setUp()
        self.surface = sf.make_surface(self.points, self.triangles)

    def test_what_is_no_polydata_is_refused(self):
        for call in (sf.flatten_polydata, sf.suggest_polydata, sf.make_flattenable_polydata):
            for wrong in (None, "file.vtp", 7, vtkUnstructuredGrid(), vtkMultiBlockDataSet(), self.points, sf.Curve([0, 1])):
                self.assert_raises(TypeError, ["surface", "vtkPolyData"], call, wrong)
                if wrong is not None:
                    self.assert_raises(TypeError, ["curves", "vtkPolyData", "list of curves"], call, self.surface, wrong)
            self.assert_raises(TypeError, "brackets", call, self.surface, range(2))
        self.assert_raises(sf.FlatteningError, "EmptySurface", sf.flatten_polydata, vtkPolyData())

    def test_arrays_of_every_kind_come_along(self):
        count = len(self.points)
        for cls in (vtkStringArray, vtkVariantArray, vtkBitArray, vtkDoubleArray):
            array = cls()
            array.SetName(cls.__name__)
            array.SetNumberOfTuples(count)
            for k in range(count):
                if cls is vtkBitArray:
                    array.SetValue(k, k % 2)
                elif cls is vtkDoubleArray:
                    array.SetValue(k, float(k))
            self.surface.GetPointData().AddArray(array)
        nameless = vtkDoubleArray()
        nameless.SetNumberOfTuples(count)
        nameless.Fill(0.0)
        self.surface.GetPointData().AddArray(nameless)
        arrays = sf.flatten_polydata(self.surface).point_arrays
        ids = arrays["vtkOriginalPointIds"]
        self.assertEqual(arrays["vtkBitArray"].dtype, np.bool_)
        np.testing.assert_array_equal(arrays["vtkBitArray"], ids % 2 == 1)
        np.testing.assert_array_equal(arrays["vtkDoubleArray"], ids)
        self.assertEqual(set(map(type, arrays)), {str})


if __name__ == "__main__":
    unittest.main()
