# SPDX-License-Identifier: BSD-3-Clause
"""Meshes of Python classes over vtkPolyData go in and come back: PyVista's where it is installed, and a
stand-in with what PyVista's users hand over elsewhere."""

import os
import unittest

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkPolyData

import surfaceflattening as sf
from surfaces import DATA, command, grid, points_of, quarter_sphere, read, triangles_of

try:
    import pyvista
except ImportError:
    pyvista = None


class StandIn(vtkPolyData):
    """What pyvista.PolyData has of a mesh: a constructor from another, points, flat faces."""

    def __init__(self, other=None, faces=None):
        super().__init__()
        if isinstance(other, vtkPolyData):
            self.ShallowCopy(other)
        elif other is not None:
            self.ShallowCopy(sf.make_surface(other, faces))

    @property
    def points(self):
        return vtk_to_numpy(self.GetPoints().GetData())

    @property
    def faces(self):
        rows = triangles_of(self)
        return np.hstack([np.full((len(rows), 1), 3), rows]).ravel()

    @property
    def n_cells(self):
        return self.GetNumberOfCells()


class Bare(vtkPolyData):
    """Takes nothing to begin with."""

    def __init__(self):
        super().__init__()


class Meshes:
    """What holds of any such class."""

    mesh_class = None

    def mesh(self):
        points, triangles, _ = quarter_sphere()
        return self.mesh_class(points, np.hstack([np.full((len(triangles), 1), 3), triangles]).ravel())

    def test_a_mesh_is_flattened_and_comes_back_as_one(self):
        mesh = self.mesh()
        result = sf.flatten_polydata(mesh)
        for part, places in (("flat", np.pad(result.positions, ((0, 0), (0, 1)))), ("cut", result.points)):
            back = result.to_polydata(part)
            self.assertIs(type(back), self.mesh_class)
            self.assertEqual(back.n_cells, mesh.n_cells)
            np.testing.assert_array_equal(np.asarray(back.points), places)
        self.assertEqual(result.to_polydata("wires").n_cells, len(result.wires))

    def test_its_points_and_faces_are_taken_as_arrays(self):
        mesh = self.mesh()
        points, triangles, arc = quarter_sphere()
        given = sf.flatten(mesh.points, mesh.faces, [arc])
        expected = sf.flatten(np.asarray(mesh.points, float), triangles, [arc])
        self.assertTrue(given == expected)

    def test_a_mesh_comes_back_the_same_from_another_run(self):
        flat = sf.flatten_polydata(self.mesh()).to_polydata()
        again = sf.flatten_polydata(flat)
        self.assertIs(type(again.to_polydata()), self.mesh_class)
        self.assertLess(again.report["pieces"][0]["E_area"], 1e-6)


class StandIns(Meshes, unittest.TestCase):
    mesh_class = StandIn

    def test_a_class_that_takes_nothing_to_begin_with(self):
        mesh = Bare()
        mesh.ShallowCopy(self.mesh())
        back = sf.flatten_polydata(mesh).to_polydata()
        self.assertIs(type(back), Bare)
        self.assertEqual(back.GetNumberOfCells(), mesh.GetNumberOfCells())

    def test_plain_meshes_stay_plain(self):
        result = sf.flatten_polydata(read("pants_front"), StandIn(read("pants_front_curves")))
        self.assertIs(type(result.to_polydata()), type(vtkPolyData()))  # newer VTKs have one of their own
        self.assertTrue(result == sf.flatten_polydata(read("pants_front"), read("pants_front_curves")))


@unittest.skipIf(pyvista is None, "PyVista is not installed")
class PyVista(Meshes, unittest.TestCase):
    mesh_class = pyvista.PolyData if pyvista else None

    def test_arrays_are_at_hand(self):
        result = sf.flatten_polydata(self.mesh())
        flat = result.to_polydata()
        np.testing.assert_array_equal(flat.cell_data["AreaRatio"], result.cell_arrays["AreaRatio"])
        np.testing.assert_array_equal(flat.faces.reshape(-1, 4)[:, 1:], result.triangles)

    def test_meshes_have_the_accessor_flattening(self):
        if not hasattr(pyvista, "register_dataset_accessor"):
            self.skipTest(f"PyVista {pyvista.__version__} has no accessors")
        mesh = self.mesh()
        result = mesh.flattening.flatten(scheme="global")
        self.assertTrue(result == sf.flatten_polydata(mesh, scheme="global"))
        flat = mesh.flattening.flat()
        self.assertIs(type(flat), pyvista.PolyData)
        self.assertAlmostEqual(flat.bounds[4], flat.bounds[5])
        self.assertEqual(len(mesh.flattening.suggest(max_cuts=1).cuts), len(sf.suggest_polydata(mesh, max_cuts=1).cuts))

    def test_the_readmes_line_draws(self):
        shirt = pyvista.read(os.path.join(DATA, "shirt_front.vtp"))
        plotter = pyvista.Plotter(off_screen=True)
        plotter.add_mesh(sf.flatten_polydata(shirt).to_polydata(), scalars="AreaRatio")
        picture = plotter.screenshot(return_img=True)
        self.assertGreater(len(np.unique(picture.reshape(-1, 3), axis=0)), 20)

    def test_a_clipped_sphere_of_pyvista_is_flattened(self):
        sphere = pyvista.Sphere().clip("z").clip("x")
        result = sf.flatten_polydata(sphere)
        self.assertEqual(result.report["status"], "Ok")
        self.assertLess(result.report["pieces"][0]["E_len_max"], 1e-9)


class FlatFaces(command.WordsTest):
    def test_polygons_are_triangulated(self):
        points, triangles = grid(2, 2)
        quads = [4, 0, 1, 4, 3, 4, 1, 2, 5, 4, 4, 3, 4, 7, 6, 3, 4, 5, 8, 3, 4, 8, 7]
        result = sf.flatten(points, quads)
        self.assertEqual(len(result.triangles), len(triangles))
        np.testing.assert_array_equal(
            np.bincount(result.cell_arrays["vtkOriginalCellIds"]), [2, 2, 2, 1, 1])
        self.assertLess(np.abs(result.cell_arrays["AreaRatio"] - 1).max(), 1e-12)

    def test_triangles_are_as_they_are_in_rows(self):
        points, triangles, arc = quarter_sphere()
        flat = np.hstack([np.full((len(triangles), 1), 3), triangles]).ravel()
        for faces in (flat, flat.tolist(), flat.astype(np.int32)):
            mesh = sf.make_surface(points, faces)
            np.testing.assert_array_equal(triangles_of(mesh), triangles)
            np.testing.assert_array_equal(points_of(mesh), points)
        self.assertTrue(sf.flatten(points, flat, [arc]) == sf.flatten(points, triangles, [arc]))

    def test_lists_that_do_not_end_with_a_polygon_are_refused_by_place(self):
        points, _ = grid(2, 2)
        for faces, words in (([3, 0, 1, 4, 3, 0, 4], ["at 4", "3 corners", "2 values"]),
                             ([3, 0, 1, 4, 2, 0, 4], ["at 4", "2 corners"]),
                             ([0, 1, 4, 0, 4, 3], ["at 0", "0 corners"]),
                             ([-1, 0, 1], ["at 0", "-1 corners"])):
            self.assert_raises(ValueError, ["triangles", *words], sf.make_surface, points, faces)


if __name__ == "__main__":
    if pyvista is None:
        print("PyVista is not installed: its tests are skipped, a stand-in takes its place")
    unittest.main()
