# SPDX-License-Identifier: BSD-3-Clause
"""Random commands for vtkFeatureCurveEditor, with arguments that make no sense among them."""

import math
import random
import unittest

import numpy as np
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData

import surfaceflattening as sf
from surfaces import command, points_of, vtk_points

NAN, INF = math.nan, math.inf


SURFACES = {
    "a triangle": ([(0, 0, 0), (1, 0, 0), (0, 1, 0)], [(0, 1, 2)]),
    "a sliver": ([(0, 0, 0), (1, 0, 0), (0.5, 1e-9, 0)], [(0, 1, 2)]),
    "no area": ([(0, 0, 0), (1, 0, 0), (0.5, 0, 0)], [(0, 1, 2)]),
    "nothing": ([], []),
    "points alone": ([(0, 0, 0), (1, 0, 0)], []),
    "a tetrahedron": command.TETRAHEDRON,
    "a torus": command.torus(),
    "three leaves": ([(0, 0, 0), (1, 0, 0), (0.5, 1, 0), (0.5, -1, 0.3), (0.5, 0, 1)],
                     [(0, 1, 2), (1, 0, 3), (0, 1, 4)]),
    "a bow tie": ([(0, 0, 0), (1, 0, 0), (0, 1, 0), (-1, 0, 0), (0, -1, 0)], [(0, 1, 2), (0, 3, 4)]),
    "two parts": command.together(
        command.grid(5, 4, lambda i, j: (0.2 * i, 0.25 * j, 0.005 * i * j)),
        command.tube(8, 3, lambda j: (0.5, 3 + j / 3))),
    "a corner that is nowhere": ([(0, 0, 0), (1, 0, 0), (0, NAN, 0), (1, 1, 0)], [(0, 1, 2), (1, 3, 2)]),
    "a point that is nowhere": ([(0, 0, 0), (1, 0, 0), (0, 1, 0), (NAN, 1, 0)], [(0, 1, 2)]),
    "a point of no triangle": ([(5, 5, 5), (0, 0, 0), (1, 0, 0), (0, 1, 0), (1, 1, 1)], [(1, 2, 3), (2, 4, 3)]),
    "a quadrangle": ([(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0.2)], [(0, 1, 2, 3)]),
    "a triangle twice": ([(0, 0, 0), (1, 0, 0), (0, 1, 0)], [(0, 1, 2), (0, 1, 2)]),
    "a sheet": command.grid(12, 12, lambda i, j: (i / 12, j / 12, 0.3 * math.sin(5 * i / 12) * math.cos(j / 3))),
    "a sheet far away": command.grid(4, 4, lambda i, j: (1e9 + i / 4, j / 4, 0.0)),
}


def poly_data(points, polygons):
    data, array = vtkPolyData(), vtkCellArray()
    data.SetPoints(vtk_points(points))
    for cell in polygons:
        array.InsertNextCell(len(cell), cell)
    data.SetPolys(array)
    return data


class Hand:
    """Commands drawn at random, senseless ones as well."""

    def __init__(self, editor, surface, seed):
        self.editor = editor
        self.random = random.Random(seed)
        self.points = [surface.GetPoint(k) for k in range(surface.GetNumberOfPoints())] or [(0.0, 0.0, 0.0)]

    def point(self):
        if self.random.random() < 0.15:
            return self.random.choice([(NAN, 0, 0), (0, INF, 0), (1e300, 0, 0), (1e9, -1e9, 0), (5, 5, 5)])
        a, b = self.random.choice(self.points), self.random.choice(self.points)
        return a if self.random.random() < 0.5 else tuple(0.5 * (x + y) for x, y in zip(a, b))

    def place(self):
        return vtk_points([self.point() for _ in range(self.random.choice([0, 1, 2, 3, 6]))])

    def id(self):
        return self.random.choice([-2**31, -1, 0, 0, 1, 1, 2, 3, 2**31 - 1])

    def number(self):
        return self.random.choice([0.0, 1e-300, 0.01, 0.1, 1.0, 1e9, 1e300, NAN, INF, -INF, -0.1, -1e9])

    def kind(self):
        return self.random.choice([-5, 0, 1, 2, 3, 99])

    def edit(self):
        """True where a command was carried out."""
        e, pick = self.editor, self.random
        curve, node = self.id(), self.id()
        return pick.choice([
            lambda: e.AddCurve(self.place(), self.kind(), pick.random() < 0.3),
            lambda: e.AddCurve(self.place(), self.kind(), False),
            lambda: e.InsertNode(curve, self.id(), self.point(), self.kind()),
            lambda: e.MoveNode(curve, node, self.point()),
            lambda: e.MoveNode(curve, node, self.point()),
            lambda: e.RemoveNode(curve, node),
            lambda: e.RemoveCurve(curve),
            lambda: e.SetCurveClosed(curve, pick.random() < 0.6),
            lambda: e.SplitCurve(curve, node),
            lambda: e.JoinCurves(curve, self.id()),
            lambda: e.SetMirrorPlane(self.point(), self.point()),
            lambda: e.SetCurveMirrored(curve, pick.random() < 0.6),
            lambda: e.AddMirrorImage(curve),
            lambda: e.AddOffset(curve, self.number()),
            lambda: e.TightenCurve(curve),
            lambda: e.AddStroke(self.place(), self.number(), self.kind()),
            lambda: e.SetSegmentKind(curve, node, self.kind()),
            lambda: e.SetCurveName(curve, pick.choice(["", "a", "b", "\u00e9" * 40])),
            lambda: e.SetCurveType(curve, self.id()),
            lambda: e.SetCurveKeyShape(curve, self.id()),
            lambda: e.SetCurveTolerance(curve, self.number()),
        ])()

    def look(self):
        """What changes nothing."""
        e, found, line = self.editor, [0, 0], vtkPolyData()
        length = e.PreviewSegment(self.point(), self.point(), self.kind(), line)
        assert length == -1.0 or math.isfinite(length), length
        e.SnapPoint(self.point(), self.number(), self.id(), [0.0, 0.0, 0.0])
        e.FindNode(self.point(), self.number(), found)
        e.FindSegment(self.point(), self.number(), found)
        for curve in (-1, 0, 2**31 - 1):
            e.GetDistance(curve, self.point())
            e.GetNode(curve, curve, [0.0, 0.0, 0.0])
            e.GetCurve(curve, line)
            for question in (e.GetCurveName, e.GetCurveType, e.GetCurveLength, e.GetNumberOfSegments):
                question(curve)
            e.GetSegmentLength(curve, curve)


class RandomEdits(unittest.TestCase):
    def test_no_command_on_any_surface_breaks_the_editor(self):
        for name, (points, polygons) in SURFACES.items():
            surface = poly_data(points, polygons)
            for seed in range(12):
                with self.subTest(surface=name, seed=seed):
                    self.abuse(surface, seed)

    def abuse(self, surface, seed):
        editor = sf.vtkFeatureCurveEditor()
        editor.Undo()
        editor.Redo()
        editor.EndGroup()
        usable = editor.SetSurface(surface)
        self.assertTrue(usable or editor.GetMessage())
        hand = Hand(editor, surface, seed)
        for _ in range(40):
            carried = hand.edit()
            self.assertTrue(carried or editor.GetMessage())
            self.assertTrue(usable or not carried)
            hand.look()
            curves = vtkPolyData()
            editor.GetCurves(curves)
            self.assertTrue(curves.GetNumberOfPoints() == 0 or np.isfinite(points_of(curves)).all())
            for curve in range(editor.GetNumberOfCurves()):
                self.assertTrue(0.0 <= editor.GetCurveLength(curve) < INF)
                self.assertGreater(editor.GetNumberOfNodes(curve), 0)
        while editor.CanUndo():
            editor.Undo()
        self.assertEqual(editor.GetNumberOfCurves(), 0)


if __name__ == "__main__":
    unittest.main()
