# SPDX-License-Identifier: BSD-3-Clause
"""Feature curves through control points: vtkSurfaceCurve, and its way into the filters."""

import math
import unittest

import numpy as np
from vtkmodules.vtkCommonCore import vtkObject
from vtkmodules.vtkCommonDataModel import (
    vtkMultiBlockDataSet, vtkPartitionedDataSet, vtkPartitionedDataSetCollection, vtkPolyData)

import surfaceflattening as sf
import surfaces
from surfaces import command, lengths_of, points_of, read, vtk_points


def cylinder():
    return sf.make_surface(*surfaces.cylinder())


def tube(sides=24, rows=10, radius=lambda j: 1.0):
    return sf.make_surface(*command.tube(sides, rows, lambda j: (radius(j), 0.3 * j)))


def drawn(surface, points, **properties):
    curve = sf.vtkSurfaceCurve()
    curve.SetInputData(surface)
    curve.SetNumberOfControlPoints(len(points))
    for k, point in enumerate(points):
        curve.SetControlPoint(k, *point)
    for name, value in properties.items():
        getattr(curve, "Set" + name)(value)
    curve.Update()
    return curve


def through(first, second, name):
    """Two curves through points that port 1 has as polylines."""
    curve = sf.vtkSurfaceCurve()
    curve.SetInputData(cylinder())
    curve.SetControlPointsData(sf.make_curves([np.array(first, float), np.array(second, float)], [[0, 0, 0]]))
    curve.SetCurveName(name)
    curve.Update()
    return curve


class Quiet(command.WordsTest):
    def setUp(self):
        vtkObject.GlobalWarningDisplayOff()
        self.addCleanup(vtkObject.GlobalWarningDisplayOn)


class Curves(Quiet):
    def test_arrays_say_what_the_curve_is(self):
        out = drawn(cylinder(), ((1, 0, 0.5), (0, 1, 1.5)), CurveType=1, CurveName="grain",
                    KeyShape=1, LengthTolerance=0.02).GetOutput()
        cells = out.GetCellData()
        self.assertEqual(cells.GetArray("CurveType").GetValue(0), 1)
        self.assertEqual(cells.GetAbstractArray("CurveName").GetValue(0), "grain")
        self.assertEqual(cells.GetArray("KeyShape").GetValue(0), 1)
        self.assertEqual(cells.GetArray("LengthTolerance").GetValue(0), 0.02)
        self.assertEqual(out.GetFieldData().GetArray("ControlPoints").GetNumberOfTuples(), 2)

    def test_the_editor_goes_on_with_it(self):
        surface = cylinder()
        for kind in range(4):
            out = drawn(surface, ((1, 0, 0.5), (0, 1, 1.5), (-0.9, 0.3, 0.4)), SegmentKind=kind,
                        CurveName="c").GetOutput()
            editor = sf.vtkFeatureCurveEditor()
            self.assertTrue(editor.SetSurface(surface))
            self.assertTrue(editor.SetCurves(out), editor.GetMessage())
            self.assertEqual(editor.GetNumberOfNodes(0), 3)
            self.assertEqual(editor.GetSegmentKind(0, 0), kind)
            self.assertAlmostEqual(editor.GetCurveLength(0), lengths_of(out)[0], 9)

    def test_the_mirror_gives_the_image(self):
        surface = tube()
        out = drawn(surface, ((0.9, 0.4, 0.4), (0.2, 1, 2.0)), Mirror=True, CurveName="side")
        self.assertEqual(out.GetOutput().GetNumberOfCells(), 2)
        self.assertAlmostEqual(lengths_of(out.GetOutput())[0], lengths_of(out.GetOutput())[1], 6)
        out.SetMirrorNormal(0, 0, 0)
        out.Update()
        self.assertEqual(out.GetStatusName(), "InvalidOption")
        self.assertEqual(out.GetOutput().GetNumberOfCells(), 0)

    def test_each_polyline_of_port_1_is_a_curve(self):
        curve = through(((1, 0, 0.5), (0, 1, 0.5)), ((1, 0, 1.5), (0, 1, 1.2)), "band")
        names = curve.GetOutput().GetCellData().GetAbstractArray("CurveName")
        self.assertEqual([names.GetValue(k) for k in range(2)], ["band 1", "band 2"])

    def test_a_closed_section_is_a_measuring_tape_and_a_tight_curve_the_waist(self):
        girth = 48 * math.sin(math.pi / 24)
        tape = drawn(tube(), ((1, 0, 1.5), (-1, 0, 1.5)), SegmentKind=1, Closed=True).GetOutput()
        self.assertAlmostEqual(lengths_of(tape)[0], girth, 9)
        points = [(1.2 * math.cos(a), 1.2 * math.sin(a), 1.7 + 0.2 * math.sin(a)) for a in (0.1, 1.8, 4.0)]
        waist = drawn(tube(radius=lambda j: 1.0 + 0.02 * (j - 4) ** 2), points, Closed=True, Tight=True).GetOutput()
        self.assertAlmostEqual(lengths_of(waist)[0], girth, 9)
        np.testing.assert_allclose(points_of(waist)[:, 2], 1.2, atol=1e-7)

    def test_an_offset_is_that_of_the_editor(self):
        surface = cylinder()
        points = ((1, 0, 0.3), (0, 1, 1.7), (-0.95, 0.2, 0.4))
        out = drawn(surface, points, SegmentKind=3, Offset=0.2, Mirror=True).GetOutput()
        editor = sf.vtkFeatureCurveEditor()
        editor.SetSurface(surface)
        self.assertTrue(editor.AddCurve(vtk_points(points), editor.SPLINE))
        self.assertTrue(editor.AddOffset(0, 0.2))
        self.assertAlmostEqual(lengths_of(out)[0], editor.GetCurveLength(1), 12)
        self.assertEqual(out.GetCellData().GetArray("CurveImageOf").GetValue(1), 0)

    def test_what_is_wrong_is_said(self):
        for points, status, words in (
                ((), "CurveTooShort", ""), (((1, 0, 0), (math.nan, 0, 0)), "NonFinitePoint", ""),
                (((1, 0, 0), (1, 0, 0)), "CurveTooShort", 'curve "waist": 1 different control point')):
            curve = drawn(cylinder(), points, CurveName="waist")
            self.assertEqual((curve.GetStatusName(), curve.GetOutput().GetNumberOfCells()), (status, 0))
            self.assertIn(words, curve.GetStatusMessage())
        for name, told in (("", "curve 2: "), ("hem", 'curve "hem 2": ')):
            curve = through(((1, 0, 0), (0, 1, 1)), ((0, 1, 0), (0, 1, 0)), name)
            self.assertEqual(curve.GetStatusName(), "CurveTooShort")
            self.assertIn(told, curve.GetStatusMessage())


class IntoTheFilters(Quiet):
    def setUp(self):
        super().setUp()
        self.surface = read("wetsuit_upper_front")
        box = self.surface.GetBounds()
        middle = [0.5 * (box[2 * k] + box[2 * k + 1]) for k in range(3)]
        self.across = ((box[0], middle[1], middle[2]), (box[1], middle[1], middle[2]))
        self.along = ((middle[0], box[2], middle[2]), (middle[0], box[3], middle[2]))

    def curves(self):
        return (drawn(self.surface, self.across, CurveName="across"),
                drawn(self.surface, self.along, CurveName="along", CurveType=1))

    def flat(self, *connections):
        flatten = sf.vtkWireWarpingFilter()
        flatten.SetInputData(self.surface)
        for data in connections:
            if isinstance(data, sf.vtkSurfaceCurve):
                flatten.AddCurvesConnection(data.GetOutputPort())
            else:
                flatten.AddInputDataObject(1, data)
        flatten.Update()
        return flatten

    def test_a_group_of_curves_is_all_of_its_leaves(self):
        first, second = self.curves()
        inner, group = vtkMultiBlockDataSet(), vtkMultiBlockDataSet()
        inner.SetBlock(0, second.GetOutput())
        group.SetBlock(0, first.GetOutput())
        group.SetBlock(2, inner)
        grouped = self.flat(group)
        self.assertFalse(grouped.IsRefused(), grouped.GetStatusMessage())
        self.assertIsInstance(grouped.GetOutputDataObject(0), vtkPolyData)  # nothing was iterated
        listed = self.flat(first, second)
        np.testing.assert_array_equal(points_of(grouped.GetOutput(0)), points_of(listed.GetOutput(0)))

    def test_a_refusal_names_the_connection_and_the_value(self):
        first, second = self.curves()
        moved = vtkPolyData()
        moved.DeepCopy(second.GetOutput())
        box = self.surface.GetBounds()
        moved.SetPoints(vtk_points(points_of(moved) + (0, 0, 0.05 * math.dist(box[::2], box[1::2]))))
        flatten = self.flat(first, moved)
        self.assertEqual((flatten.GetStatusName(), flatten.GetStatusConnection()), ("CurvePointOffSurface", 1))
        self.assert_words(("connection 1", '"along"'), flatten.GetStatusMessage())
        group = vtkMultiBlockDataSet()
        group.SetBlock(0, first.GetOutput())
        group.SetBlock(1, moved)
        for data, place in ((group, "block 2 of the curves: "), (None, 'block "front" of the')):
            if not data:
                group.GetMetaData(1).Set(group.NAME(), "front")
            self.assertRegex(self.flat(group).GetStatusMessage(), "^" + place)
        self.assertIn('connection 1, block "front" of the curves: curve "along"', self.flat(first, group).GetStatusMessage())
        # The partitions of a surface in a collection are named by it, as ParaView groups sources.
        parts, collection = vtkPartitionedDataSet(), vtkPartitionedDataSetCollection()
        parts.SetPartition(0, moved)
        collection.SetPartitionedDataSet(0, parts)
        collection.GetMetaData(0).Set(group.NAME(), "sleeve")
        self.assertRegex(self.flat(collection).GetStatusMessage(), '^block "sleeve" of the curves: ')
        value = flatten.GetStatusRemedySubjects().GetValue(1)
        self.assertIn("raise ImprintTolerance to " + value, flatten.GetStatusMessage())
        flatten.SetImprintTolerance(float(value))
        flatten.Update()
        self.assertNotEqual(flatten.GetStatusName(), "CurvePointOffSurface")


if __name__ == "__main__":
    unittest.main()
