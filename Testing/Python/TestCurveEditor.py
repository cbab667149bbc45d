# SPDX-License-Identifier: BSD-3-Clause
"""Feature curves drawn by the commands of vtkFeatureCurveEditor, into the filter and into files."""

import math
import os
import unittest

import numpy as np
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkIOXML import vtkXMLPolyDataWriter
from vtkmodules.util.numpy_support import vtk_to_numpy

import surfaceflattening as sf
from surfaces import SOURCE, command, points_of, read, read_file, vtk_points

TYPES = ("accessory", "key", "dart", "seam")


def tutorial():
    """Type, name and vertices of the tutorial's curves."""
    with open(os.path.join(SOURCE, "Documentation", "tutorial_curves.txt"), encoding="utf-8") as file:
        for line in file:
            if not line.startswith("#"):
                kind, name, *vertices = line.split()
                yield TYPES.index(kind), name, [int(v) for v in vertices]


def through_vertices(surface):
    """The tutorial's curves as a user without an editor gives them."""
    return sf.make_curves([sf.Curve(vertices, TYPES[kind], name) for kind, name, vertices in tutorial()],
                          points_of(surface))


def drawn(surface):
    editor = sf.vtkFeatureCurveEditor()
    assert editor.SetSurface(surface), editor.GetMessage()
    for curve, (kind, name, vertices) in enumerate(tutorial()):
        assert editor.AddCurve(vtk_points([surface.GetPoint(vertices[0])]), editor.SECTION)
        for v in vertices[1:]:
            count = editor.GetNumberOfNodes(curve)
            assert editor.InsertNode(curve, count, surface.GetPoint(v), editor.SECTION)
        assert editor.SetCurveName(curve, name)
        assert editor.SetCurveType(curve, kind)
    return editor


def flattened(surface, curves):
    warping = sf.vtkWireWarpingFilter()
    warping.SetInputData(surface)
    warping.SetCurvesData(curves)
    warping.Update()
    pieces, curves = warping.GetPieces(), warping.GetCurves()
    return ([pieces.GetColumnByName(name).GetValue(0) for name in ("AreaError", "AngleErrorMean", "Objective")],
            vtk_to_numpy(curves.GetColumnByName("FlatLength")).tolist())


def curves_of(editor):
    curves = vtkPolyData()
    editor.GetCurves(curves)
    return curves


class Editor(command.CommandTest):
    @classmethod
    def setUpClass(cls):
        cls.surface = read("shirt_front")
        cls.editor = drawn(cls.surface)

    def assert_close(self, actual, expected):
        for a, b in zip(actual, expected, strict=True):
            np.testing.assert_allclose(a, b, rtol=1e-7)

    def edited(self, curves):
        """Another editor that goes on with them."""
        editor = sf.vtkFeatureCurveEditor()
        self.assertTrue(editor.SetSurface(self.surface))
        self.assertTrue(editor.SetCurves(curves), editor.GetMessage())
        return editor

    def test_drawn_curves_give_the_report_of_those_given_by_vertices(self):
        self.assert_close(flattened(self.surface, curves_of(self.editor)),
                          flattened(self.surface, through_vertices(self.surface)))

    def test_curves_from_a_file_can_be_edited_again(self):
        writer = vtkXMLPolyDataWriter()
        writer.SetFileName(self.path("curves.vtp"))
        writer.SetInputData(curves_of(self.editor))
        writer.Write()
        again = self.edited(read_file(self.path("curves.vtp")))
        self.assertEqual(again.GetNumberOfCurves(), 5)
        self.assertFalse(again.CanUndo())
        for curve in range(5):
            for get in ("GetCurveName", "GetCurveType", "GetNumberOfNodes"):
                self.assertEqual(getattr(again, get)(curve), getattr(self.editor, get)(curve))
            self.assertEqual(again.GetSegmentKind(curve, 0), again.SECTION)
        np.testing.assert_array_equal(points_of(curves_of(again)), points_of(curves_of(self.editor)))

    def test_eases_come_back_and_images_have_them_where_no_piece_is_named(self):
        editor = drawn(self.surface)
        self.assertTrue(editor.SetMirrorPlane((0, 0, 0), (1, 0, 0)))
        self.assertTrue(editor.SetCurveMirrored(1, True), editor.GetMessage())
        self.assertIsNone(curves_of(editor).GetCellData().GetArray("LengthEase"))
        for ease, piece, of_image in ((0.03, 1, 0.0), (-0.02, -1, -0.02)):
            self.assertTrue(editor.SetCurveEase(1, ease, piece), editor.GetMessage())
            cells = curves_of(editor).GetCellData()
            images = [k for k in range(cells.GetNumberOfTuples()) if cells.GetArray("CurveImageOf").GetValue(k) >= 0]
            self.assertEqual([cells.GetArray("LengthEase").GetValue(k) for k in images], [of_image])
            again = self.edited(curves_of(editor))
            self.assertEqual((again.GetCurveEase(1), again.GetCurveEasedPiece(1)), (ease, piece))
            self.assertEqual((again.GetCurveEase(0), again.GetCurveEasedPiece(0)), (0.0, -1))
        editor.Undo()
        self.assertEqual((editor.GetCurveEase(1), editor.GetCurveEasedPiece(1)), (0.03, 1))

    def test_polylines_of_others_get_a_node_at_each_point(self):
        others = read("shirt_front_curves")
        editor = self.edited(others)
        self.assertEqual(editor.GetNumberOfCurves(), others.GetNumberOfCells())
        self.assertEqual(editor.GetNumberOfNodes(0), others.GetCell(0).GetNumberOfPoints())
        self.assert_close(flattened(self.surface, curves_of(editor)), flattened(self.surface, others))

    def test_what_cannot_be_is_refused_by_name_and_changes_nothing(self):
        editor, stroke = drawn(self.surface), vtk_points(self.surface.GetPoint(k) for k in (30, 31, 32))
        for call, word in ((lambda: editor.SetCurveName(1, "centre_front"), "centre_front"),
                           (lambda: editor.MoveNode(9, 0, (0, 0, 0)), "no curve 9"),
                           (lambda: editor.MoveNode(0, -1, (0, 0, 0)), "no node"),
                           (lambda: editor.MoveNode(0, 0, (math.nan, 0, 0)), "finite"),
                           (lambda: editor.SetCurveTolerance(0, 1.5), "1.5"),
                           (lambda: editor.SetCurveEase(0, 1.0, 0), "ease is 1 "),
                           (lambda: editor.SetCurveEase(0, 0.1, -2), "piece -2"),
                           (lambda: editor.SetCurveClosed(3, True), "no closed section"),
                           (lambda: editor.SetMirrorPlane((0, 0, 0), (0, 0, 0)), "normal"),
                           (lambda: editor.AddMirrorImage(0), "mirror plane"),
                           (lambda: editor.AddOffset(1, 0.0), "not 0"), (lambda: editor.AddOffset(1, 1e6), "1e+06"),
                           (lambda: editor.AddOffset(1, math.nan), "finite"), (lambda: editor.TightenCurve(1), "closed"),
                           (lambda: editor.AddStroke(vtk_points([]), 0.05), ""),
                           (lambda: editor.AddStroke(stroke, 0.0), ""), (lambda: editor.AddStroke(stroke, math.nan), "")):
            before = editor.GetMTime()
            self.assertFalse(call())
            self.assertIn(word, editor.GetMessage())
            self.assertEqual(editor.GetMTime(), before)
        empty = sf.vtkFeatureCurveEditor()
        self.assertFalse(empty.RemoveCurve(0))
        self.assertIn("surface", empty.GetMessage())

    def test_offsets_and_strokes_become_curves_at_their_distance_and_within_their_tolerance(self):
        editor = drawn(self.surface)
        self.assertTrue(editor.AddOffset(1, -1.5), editor.GetMessage())
        curve, place = editor.GetNumberOfCurves() - 1, [0.0] * 3
        self.assertEqual(editor.GetCurveType(curve), editor.GetCurveType(1))
        self.assertEqual(editor.GetCurveName(curve), editor.GetCurveName(1) + " offset")
        editor.GetNode(curve, 0, place)
        self.assertAlmostEqual(editor.GetDistance(1, place), -1.5, delta=0.005)
        stroke = vtk_points(np.array(self.surface.GetPoint(30)) + (x, 0.5 * math.sin(x), 0.0) for x in np.linspace(0, 3, 101))
        for kind in (editor.SPLINE, editor.GEODESIC):
            self.assertTrue(editor.AddStroke(stroke, 0.02, kind), editor.GetMessage())
            curve = editor.GetNumberOfCurves() - 1
            self.assertLess(editor.GetNumberOfNodes(curve), 25)
            self.assertEqual(editor.GetSegmentKind(curve, 0), kind)

    def test_curves_that_were_not_on_the_surface_are_laid_onto_it_and_named(self):
        curves = curves_of(self.editor)
        editor = self.edited(curves)
        self.assertEqual(editor.GetMessage(), "")
        first = curves.GetCell(0).GetPointId(0)
        point = curves.GetPoint(first)
        curves.GetPoints().SetPoint(first, point[0], point[1], point[2] + 10.0)
        self.assertTrue(editor.SetCurves(curves))
        self.assert_words((self.editor.GetCurveName(0), "from the surface"), editor.GetMessage())

    def test_damaged_control_points_are_refused(self):
        curves = curves_of(self.editor)
        curves.GetFieldData().GetArray("ControlPointKind").SetValue(0, 9)
        editor = sf.vtkFeatureCurveEditor()
        editor.SetSurface(self.surface)
        self.assertFalse(editor.SetCurves(curves))
        self.assertIn("control point 0", editor.GetMessage())
        curves.GetFieldData().GetArray("ControlPointKind").SetNumberOfTuples(3)
        self.assertFalse(editor.SetCurves(curves))
        self.assertIn("do not fit", editor.GetMessage())


if __name__ == "__main__":
    unittest.main()
