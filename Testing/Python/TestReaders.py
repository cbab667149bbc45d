# SPDX-License-Identifier: BSD-3-Clause
"""Surfaces and curves from files: coordinates to the last bit, lengths of drawn shapes by their formulas, and what is
wrong by file and line."""

import os
import pathlib
import unittest

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkPolyData

import surfaceflattening as sf
from surfaces import command, lengths_of, quarter_sphere

# Two squares side by side; coordinates that single precision does not hold. Texture coordinates break between them.
X = (0.1, 1.0 / 3.0, 1e-9)
CORNERS = [(X[0] + i, X[1] + j, X[2]) for j in range(2) for i in range(3)]
OBJ = "".join(f"v {x!r} {y!r} {z!r}\n" for x, y, z in CORNERS) + "".join(
    f"vt {u} {v}\n" for u, v in ((0, 0), (1, 0), (1, 1), (0, 1))) + """# units: inch
o left
usemtl red
f 1/1 2/2 5/3 4/4
o right
usemtl blue
f 2/1 3/2 6/3 5/4
g dart middle
l 2 5
"""


def names(curves):
    array = curves.GetCellData().GetAbstractArray("CurveName")
    return [array.GetValue(k) for k in range(array.GetNumberOfValues())]


def types(curves):
    return vtk_to_numpy(curves.GetCellData().GetArray("CurveType")).tolist()


class Files(command.CommandTest):
    def write(self, name, content):
        return self.path(super().write(name, content))


class Surfaces(Files):
    def test_an_obj_file_gives_its_unit_names_lines_and_seams(self):
        path = self.write("a.obj", OBJ)
        surface, curves = sf.read_surface(path)
        self.assertEqual(vtk_to_numpy(surface.GetPoints().GetData()).tolist(), [list(x) for x in CORNERS])
        self.assertEqual(surface.GetNumberOfPolys(), 2)
        self.assertEqual(sf.vtkFlatteningAlgorithm.GetLengthUnitOf(surface), "inch")
        array = surface.GetCellData().GetAbstractArray("PieceName")
        self.assertEqual([array.GetValue(k) for k in range(2)], ["left", "right"])
        self.assertEqual((names(curves), types(curves)), (["middle"], [2]))
        for seams in ("textures", "materials", "groups"):
            with self.subTest(seams=seams):
                _, curves = sf.read_surface(path, seams=seams)
                self.assertEqual(types(curves), [2, 3])
                np.testing.assert_allclose(lengths_of(curves), [1.0, 1.0], rtol=1e-15)

    def test_edges_without_a_face_are_left_out_with_a_warning(self):
        path = self.write("a.obj", "o a\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\nl 1 4\n")
        for read in (sf.load_surface, sf.read_surface):
            with self.assertWarnsRegex(sf.FlatteningWarning, "1 edge without a face is left out, at line 7") as told:
                curves = read(path)
            self.assertEqual(told.filename, __file__)
        self.assertEqual(curves[1].GetNumberOfLines(), 0)

    def test_files_and_what_was_read_name_the_call_that_was_meant(self):
        path = self.write("a.obj", OBJ)
        for given, words in ((path, r"read by load_surface\(\)"), (pathlib.Path(path), r"read by load_surface\(\)"),
                             (sf.load_surface(path), r"flatten\(\*surface\[:3\]\)")):
            with self.assertRaisesRegex(TypeError, words):
                sf.flatten(given)

    def test_what_is_wrong_is_raised_with_file_and_line(self):
        for name, content, words in (
                ("a.obj", "v 0 0 0\nf 1 2 3\n", "a.obj:2:"),
                ("a.ply", "ply\nformat ascii 1.0\nelement vertex 9\n", "a.ply"),
                ("a.vtp", "<VTKFile/>", "flatten_polydata() takes"),
                ("a.glb", "glTF", "flatten_polydata() takes")):
            self.assert_raises(ValueError, words, sf.read_surface, self.write(name, content))
        with self.assertRaises(FileNotFoundError):
            sf.read_surface(os.path.join(self.folder, "none.obj"))
        self.assert_raises(ValueError, "textures", sf.read_surface, self.write("a.ply", "ply\n"), seams="folds")


class Curves(Files):
    def test_tables_texts_and_lines_are_the_same_curve(self):
        points, triangles, _ = quarter_sphere()
        surface = sf.make_surface(points, triangles)
        ids = [0, 1, 2]
        places = points[ids].tolist()
        rows = "name,type,x,y,z\n" + "".join(f"\"hem, left\",key,{x!r},{y!r},{z!r}\n" for x, y, z in places)
        text = 'key "hem, left" 0 1 2\n'
        lines = "".join(f"v {x!r} {y!r} {z!r}\n" for x, y, z in places) + "g key hem, left\nl 1 2 3\n"
        for name, content in (("a.csv", rows), ("a.txt", text), ("a.obj", lines)):
            with self.subTest(name=name):
                curves = sf.read_curves(self.write(name, content), surface)
                self.assertEqual((names(curves), types(curves)), (["hem, left"], [1]))
                np.testing.assert_allclose(
                    lengths_of(curves), [np.linalg.norm(np.diff(points[ids], axis=0), axis=1).sum()], rtol=1e-15)

    def test_what_is_wrong_is_raised_with_file_and_line(self):
        surface = sf.make_surface(*quarter_sphere()[:2])
        last = surface.GetNumberOfPoints() - 1
        for name, content, owner, words in (
                ("a.txt", "key a 0 1\n", None, "surface"),
                ("a.txt", f"key a 0 {last + 1}\n", surface, "a.txt:1:"),
                ("a.csv", "name,type,x,y,z\na,edge,0,0,0\na,edge,1,0,0\n", None, "no boundary"),
                ("a.obj", "v 0 0 0\n", surface, "line element"),
                ("a.vtp", "<VTKFile/>", surface, "vtkXMLPolyDataReader")):
            self.assert_raises(ValueError, words, sf.read_curves, self.write(name, content), owner)
        with self.assertRaises(FileNotFoundError):
            sf.read_curves(os.path.join(self.folder, "none.csv"))
        with self.assertRaises(TypeError):
            sf.read_curves(self.write("a.txt", "key a 0 1\n"), "surface")

    def test_a_failed_run_leaves_an_empty_output(self):
        reader = sf.vtkFeatureCurveReader()
        errors = []
        reader.AddObserver("ErrorEvent", lambda *_: errors.append(1))
        surface = vtkPolyData()
        reader.SetInputData(surface)
        reader.Update()
        self.assertEqual(reader.GetOutput().GetNumberOfCells(), 0)
        self.assertIn("FileName", reader.GetErrorMessage())
        self.assertNotEqual(reader.GetErrorCode(), 0)
        self.assertTrue(errors)


if __name__ == "__main__":
    unittest.main()
