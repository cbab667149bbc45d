# SPDX-License-Identifier: BSD-3-Clause
"""Names, ids and arrays as numpy and VTK have them: taken for what they are, or refused by name."""

import json
import unittest
import warnings

import numpy as np
from vtkmodules.vtkCommonCore import (
    vtkBitArray, vtkDoubleArray, vtkStringArray, vtkVariantArray)
from vtkmodules.vtkCommonDataModel import (
    vtkMultiBlockDataSet, vtkPolyData, vtkUnstructuredGrid)

import surfaceflattening as sf
from surfaces import grid, points_of

CURVE = [5, 6, 7]


class OddCase(unittest.TestCase):
    def setUp(self):
        self.points, self.triangles = grid()
        self.points = np.asarray(self.points, float)
        self.points[:, 2] += 0.1 * np.sin(self.points[:, 0] * self.points[:, 1])

    def wrong(self, words, call, kind=ValueError):
        with self.assertRaises(kind) as caught:
            call()
        for word in words:
            self.assertIn(word, str(caught.exception))

    def flatten(self, **curve):
        return sf.flatten(self.points, self.triangles, [sf.Curve(CURVE, **curve)])


class Names(OddCase):
    def test_names_of_any_language_come_back(self):
        for name in ("Ärmel", "袖", "\U0001f455", "a b", "a\tb", "%s%n", "x" * 10000):
            report = self.flatten(name=name).report
            self.assertEqual(report["curves"][0]["name"], name)
            self.assertEqual(json.loads(json.dumps(report))["curves"][0]["name"], name)

    def test_a_lone_surrogate_is_refused_and_not_the_end_of_the_interpreter(self):
        for name in ("a\ud800b", "\udfff", "sleeve\udc80"):
            self.wrong(["curve 1", repr(name), "UTF-8"], lambda name=name: sf.flatten(
                self.points, self.triangles, [CURVE, sf.Curve(CURVE, name=name)]))
            self.wrong(["curve 0", repr(name)], lambda name=name: sf.make_curves(
                [sf.Curve(CURVE, name=name)], self.points))
            for grain in (name, ["hem", name]):
                self.wrong(["grain", repr(name), "UTF-8"], lambda grain=grain: sf.flatten(
                    self.points, self.triangles, material="twill", grain=grain))

    def test_nul_is_refused(self):
        for name in ("\0", "a\0b", "hem\0"):
            self.wrong(["curve 0", repr(name), "NUL"], lambda name=name: self.flatten(name=name))

    def test_what_is_no_text_is_refused(self):
        for name in (b"hem", 7, None, ["hem"], 1.5):
            self.wrong(["curve 0", repr(name), "string"], lambda name=name: self.flatten(name=name),
                       TypeError)

    def test_bytes_in_a_vtk_array_that_are_no_utf8_are_replaced(self):
        curves = sf.make_curves([CURVE], self.points)
        names = vtkStringArray()
        names.SetName("CurveName")
        names.InsertNextValue(b"a\xff\xfeb")
        curves.GetCellData().AddArray(names)
        result = sf.flatten_polydata(sf.make_surface(self.points, self.triangles), curves)
        name = "a\ufffd\ufffdb"
        self.assertEqual(result.report["curves"][0]["name"], name)
        self.assertIn(name, [wire.name for wire in result.wires])
        json.dumps(result.report)
        stray = points_of(curves)
        stray[0, 2] += 9.0
        curves.GetPoints().SetPoint(0, stray[0])
        self.wrong([name], lambda: sf.flatten_polydata(
            sf.make_surface(self.points, self.triangles), curves), sf.FlatteningError)


class Ids(OddCase):
    def test_ids_that_no_int_holds_are_told_as_they_were_given(self):
        for huge in (2**63, 2**64, 2**70, -2**70):
            ids = [0, 1, huge]
            self.wrong(["triangles", str(huge)], lambda ids=ids: sf.flatten(self.points, [ids]))
            self.wrong(["curve 0", str(huge)],
                       lambda ids=ids: sf.flatten(self.points, self.triangles, [ids]))
        for array in (np.array([0, 1, 2**63 + 5], np.uint64), np.array([0, 1, 2**64 - 1], np.uint64)):
            self.wrong(["triangles", str(array[2])],
                       lambda array=array: sf.flatten(self.points, [array]))
            self.wrong(["curve 0", str(array[2])],
                       lambda array=array: sf.flatten(self.points, self.triangles, [array]))

    def test_ids_beyond_the_points_are_refused(self):
        for id_ in (-1, 20, 2**31, 2**32, 2**32 + 2, 2**62):
            corners = np.vstack([self.triangles, [[0, 1, id_]]])
            with self.assertRaises(sf.FlatteningError) as caught:
                sf.flatten(self.points, corners)
            self.assertEqual((caught.exception.name, caught.exception.ids), ("InvalidPointId", [len(self.triangles)]))
            self.wrong(["curve 0 ('hem')", f"point {id_}", "0 to 19"], lambda id_=id_: sf.flatten(
                self.points, self.triangles, [sf.Curve([5, id_], name="hem")]))

    def test_what_are_no_ids_is_refused(self):
        for array in (np.ones((3, 3), bool), np.ones((3, 3)), np.full((3, 3), "1"),
                      np.full((3, 3), None), np.full((3, 3), True, object)):
            self.wrong(["triangles", "whole numbers"],
                       lambda array=array: sf.flatten(self.points, array))
            self.wrong(["curve 0", "whole numbers"], lambda array=array: sf.flatten(
                self.points, self.triangles, [array[0]]))

    def test_pins_and_counts_beyond_int(self):
        flatten = lambda **options: sf.flatten(self.points, self.triangles, **options)
        self.wrong(["pins", "out of range"], lambda: flatten(scheme="lscm", pins=(2**70, 1)))
        self.wrong(["max_iterations", "out of range"], lambda: flatten(max_iterations=2**70))
        for piece in (2**31, 2**70):
            self.wrong(["ease", str(piece)], lambda piece=piece: flatten(ease={("hem", piece): 0.1}))
        for pins in (None, 7, (1,), (1.5, 2), "ab"):
            self.wrong(["pins"], lambda pins=pins: flatten(scheme="lscm", pins=pins), TypeError)
        self.wrong(["pins"], lambda: flatten(scheme="lscm", pins=(-5, 3)), sf.FlatteningError)


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
        self.wrong(["(n, 3)"], lambda: sf.flatten([], []))
        self.wrong(["EmptySurface"], lambda: sf.flatten(self.points, np.empty((0, 3), int)),
                   sf.FlatteningError)
        self.wrong(["EmptySurface"], lambda: sf.flatten(self.points, np.empty((0, 3))),
                   sf.FlatteningError)
        for curve in ([], np.empty(0), np.empty((0, 3)), np.empty(0, object)):
            self.wrong(["curve 0", "at least 2"], lambda curve=curve: sf.flatten(
                self.points, self.triangles, [curve]))

    def test_masked_values_are_no_values(self):
        masked = np.ma.masked_array(self.points, mask=False)
        self.expect_same(masked, self.triangles)
        masked[3, 1] = np.ma.masked
        self.wrong(["points", "masked"], lambda: sf.flatten(masked, self.triangles))
        corners = np.ma.masked_equal(self.triangles, 3)
        self.wrong(["triangles", "masked"], lambda: sf.flatten(self.points, corners))
        curve = np.ma.masked_equal(CURVE, 6)
        self.wrong(["curve 0", "masked"], lambda: sf.flatten(self.points, self.triangles, [curve]))

    def test_masks_within_lists_are_seen(self):
        rows = self.triangles.tolist()
        rows[3] = np.ma.masked_equal(rows[3], rows[3][1])
        self.wrong(["triangles", "masked"], lambda: sf.flatten(self.points, rows))
        places = [tuple(point) for point in self.points]
        places[2] = np.ma.array(places[2], mask=[False, True, False])
        self.wrong(["points", "masked", ".filled()"], lambda: sf.flatten(places, self.triangles))
        self.wrong(["curve 0", "masked"], lambda: sf.flatten(
            self.points, self.triangles, [[5, 6, np.ma.masked]]))
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
            self.wrong(["points", str(huge), "2**53", "unit"], lambda: sf.flatten(points, triangles))
        self.wrong(["points", "numbers", "bool"], lambda: sf.flatten(points > 1, triangles))

    def test_one_curve_in_place_of_a_list_is_named(self):
        for curve in (CURVE, np.array(CURVE), tuple(CURVE), sf.Curve(CURVE), self.points[CURVE],
                      range(5, 8), "hem"):
            self.wrong(["list", "[curve]"], lambda curve=curve: sf.flatten(
                self.points, self.triangles, curve), TypeError)
        rows = np.array([[5, 6, 7], [10, 11, 12]])
        self.assertEqual(len(sf.flatten(self.points, self.triangles, rows).report["curves"]), 2)

    def test_options_that_are_not_there_and_flags_that_are_none(self):
        call = lambda **options: sf.flatten(self.points, self.triangles, **options)
        self.wrong(["flatten()", "'sheme'", "'scheme'"], lambda: call(sheme="global"), TypeError)
        self.wrong(["flatten_polydata()", "'colour'"], lambda: sf.flatten_polydata(
            sf.make_surface(self.points, self.triangles), colour=1), TypeError)
        for value in ("no", 0, None, [True]):
            self.wrong(["close_cuts", repr(value), "True or False"],
                       lambda value=value: call(close_cuts=value), TypeError)
        self.assertEqual(call(close_cuts=np.bool_(False)).report["status"], "Ok")
        self.wrong(["tolerance of 'hem'", "'wide'"], lambda: call(tolerance={"hem": "wide"}), TypeError)

    def test_shapes_say_what_helps(self):
        self.wrong(["(20, 2)", "zeros for z"], lambda: sf.flatten(self.points[:, :2], self.triangles))
        self.wrong(["(n, 3)"], lambda: sf.flatten(self.points.ravel(), self.triangles))
        self.wrong(["(1, 4)", "flat list"], lambda: sf.flatten(self.points, [[0, 1, 6, 5]]))
        for triangles in (7, self.triangles[None], self.triangles[:, :2]):
            self.wrong(["(m, 3)"], lambda triangles=triangles: sf.flatten(self.points, triangles))
        self.wrong(["curve 1", "(k, 3)"], lambda: sf.flatten(self.points, self.triangles, [CURVE, np.zeros((4, 2))]))
        self.wrong(["planar_shape", "(3, 2)"], lambda: self.flatten(type="key", planar_shape=[[0, 0], [1, 0]]))
        self.wrong(["triangles", ".astype(int)"], lambda: sf.flatten(
            self.points, self.triangles.astype(float)))

    def test_what_are_no_numbers_is_refused_by_name(self):
        for points, words in ((self.points + 1j, "real"), ([["a", 0, 0]] * 20, "numbers"), ([[0, 0, 0], [1, 0]], "rows"),
                              (np.full((20, 3), None), "not a finite number"), (self.points.astype("M8[s]"), "datetime64")):
            self.wrong(["points", words], lambda points=points: sf.flatten(points, self.triangles))
        self.wrong(["triangles", "rows"], lambda: sf.flatten(self.points, [[0, 1, 2], [0, 1]]))
        self.wrong(["curve 0 ('hem')", "rows"], lambda: sf.flatten(
            self.points, self.triangles, [sf.Curve([[0, 0, 0], [1, 1]], name="hem")]))
        for tolerance in ("wide", None, [1, 2]):
            self.wrong(["length_tolerance", "curve 0 ('hem')", repr(tolerance)],
                       lambda tolerance=tolerance: self.flatten(name="hem", length_tolerance=tolerance))
        for shape in ([[0, 0], [1]], [["a", "b"]] * 3, np.zeros((3, 2)) + 1j):
            self.wrong(["planar_shape", "curve 0 ('hem')"], lambda shape=shape: self.flatten(
                name="hem", type="key", planar_shape=shape))
        for kind in (None, ["key"], 1, np.array(["key", "dart"])):
            self.wrong(["type of curve 0"], lambda kind=kind: self.flatten(type=kind))


class DataSets(OddCase):
    def setUp(self):
        super().setUp()
        self.surface = sf.make_surface(self.points, self.triangles)

    def test_what_is_no_polydata_is_refused(self):
        for call in (sf.flatten_polydata, sf.suggest_polydata, sf.make_flattenable_polydata):
            for wrong in (None, "file.vtp", 7, vtkUnstructuredGrid(), vtkMultiBlockDataSet(), self.points,
                          sf.Curve([0, 1])):
                self.wrong(["surface", "vtkPolyData"], lambda wrong=wrong: call(wrong), TypeError)
                if wrong is not None:
                    self.wrong(["curves", "vtkPolyData", "list of curves"],
                               lambda wrong=wrong: call(self.surface, wrong), TypeError)
            self.wrong(["brackets"], lambda: call(self.surface, range(2)), TypeError)

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

    def test_a_data_set_without_points_is_an_empty_surface(self):
        self.wrong(["EmptySurface"], lambda: sf.flatten_polydata(vtkPolyData()), sf.FlatteningError)


if __name__ == "__main__":
    unittest.main()
