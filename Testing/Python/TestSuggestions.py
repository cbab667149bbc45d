# SPDX-License-Identifier: BSD-3-Clause
"""suggest() proposes curves that flatten() takes."""

import functools
import time
import unittest

import numpy as np
from vtkmodules.util.misc import calldata_type
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.util.vtkConstants import VTK_OBJECT

import surfaceflattening as sf
from surfaces import dome, grid, quiet, table_rows


@functools.cache
def proposed():
    return sf.suggest(*dome(), bound=0.05, max_work=3)


class Suggestions(unittest.TestCase):
    def test_flatten_takes_what_is_proposed(self):
        points, triangles = dome()
        suggestion = proposed()
        self.assertTrue(suggestion.bound_met)
        self.assertTrue(suggestion.cuts)
        strain = [piece["strain_p95"] for piece in suggestion.flattening.report["pieces"]]
        self.assertLessEqual(max(strain), 0.05)
        again = sf.flatten(points, triangles, [cut.curve for cut in suggestion.cuts])
        np.testing.assert_allclose(
            [piece["strain_p95"] for piece in again.report["pieces"]], strain, rtol=1e-9)
        for cut in suggestion.cuts:
            steps = np.linalg.norm(np.diff(cut.curve.points, axis=0), axis=1)
            self.assertAlmostEqual(steps.sum(), cut.length, 9)
            self.assertGreater(cut.gain, 0)
        for place, cut in enumerate(suggestion.cuts):
            self.assertIn(cut.mirror_of, range(-1, len(suggestion.cuts)))
            if cut.mirror_of >= 0:
                self.assertAlmostEqual(suggestion.cuts[cut.mirror_of].length, cut.length, 6)
                self.assertNotEqual(cut.mirror_of, place)

    def test_flatten_polydata_takes_what_is_proposed_for_a_mesh(self):
        points, triangles = dome()
        mesh = sf.make_surface(points, triangles)
        suggestion = sf.suggest_polydata(mesh, bound=0.05, max_work=3)
        curves = [cut.curve for cut in suggestion.cuts]
        self.assertTrue(curves)
        again = sf.flatten_polydata(mesh, curves)
        self.assertTrue(again == sf.flatten(points, triangles, curves))
        np.testing.assert_allclose(
            [piece["strain_p95"] for piece in again.report["pieces"]],
            [piece["strain_p95"] for piece in suggestion.flattening.report["pieces"]], rtol=1e-9)
        waist = sf.Curve(np.arange(15) + 7 * 15, name="waist")
        with quiet():
            for kept in (sf.suggest_polydata(mesh, [waist], max_cuts=1),
                         sf.make_flattenable_polydata(mesh, [waist], keep=["waist"], bound=0.1)):
                self.assertEqual(kept.flattening.report["curves"][0]["name"], "waist")

    def test_it_is_printed_in_a_line_and_shown_as_a_table(self):
        suggestion = proposed()
        self.assertRegex(repr(suggestion), r"^<Suggestion: \d+ curves? \(.*\), bound met; <Flattening: .*>>$")
        self.assertLess(len(repr(suggestion)), 250)
        for cut in suggestion.cuts:
            self.assertEqual(repr(cut.curve), f"<Curve {cut.curve.name!r}: {cut.curve.type}, "
                                              f"{len(cut.curve.points)} points>")
            self.assertLess(len(repr(cut)), 450)
        rows = table_rows(suggestion._repr_html_())
        self.assertEqual(rows[0][:3], ["name", "type", "length"])
        for row, cut in zip(rows[1:], suggestion.cuts):
            self.assertEqual(row[:2], [cut.curve.name, cut.curve.type])
            self.assertAlmostEqual(float(row[2]), cut.length, delta=1e-5 * cut.length)
            self.assertIn(f"{cut.strain_after:.4f}", row)
        self.assertIn(suggestion.flattening._repr_html_(), suggestion._repr_html_())
        flat = sf.suggest(*grid(3, 3))
        self.assertIn("Nothing is proposed", flat._repr_html_())
        self.assertRegex(repr(flat), "^<Suggestion: 0 curves, bound met; ")
        self.assertEqual(repr(sf.Curve([0, 1], "key", key_shape="straight", length_tolerance=0.1)),
                         "<Curve: key, straight, length_tolerance 0.1, 2 points>")
        for odd in (None, 3, np.array(3), [[0, 1], [2]]):
            self.assertTrue(repr(sf.Curve(odd, odd, key_shape=odd, length_tolerance=odd, planar_shape=odd)))

    def test_what_mirrors_the_surface_is_named(self):
        points, triangles = dome(20, 14)
        x, y = points[:, 0], points[:, 1]
        inside = np.clip(1 - ((abs(x) - 0.4) ** 2 + (y - 0.3) ** 2) / 0.16, 0, None)
        sheet = np.column_stack([x, y, 0.25 * inside ** 2])
        out = np.clip(x - 0.8, 0, None)  # flat there, so that a fold changes no length
        folded = sheet + np.column_stack([out * (np.cos(1.0) - 1), 0 * x, out * np.sin(1.0)])

        def mirror(surface, **options):
            with quiet():
                return sf.suggest(surface, triangles, cuts="darts", bound=0, max_cuts=2, **options).mirror

        plane = mirror(sheet)
        self.assertIsInstance(plane, sf.MirrorPlane)
        np.testing.assert_allclose(abs(plane.normal), (1, 0, 0), rtol=0, atol=1e-9)
        self.assertAlmostEqual(plane.offset, 0, 9)
        axis = mirror(folded)
        self.assertIsInstance(axis, sf.MirrorAxis)
        np.testing.assert_allclose(
            axis.ends[np.argsort(axis.ends[:, 1])], [(0, -1, 0), (0, 1, 0)], rtol=0, atol=1e-9)
        self.assertIsNone(mirror(sheet, symmetric="off"))

    def test_weights_say_where_distortion_matters(self):
        points, triangles = dome(10, 10)
        triangles = np.array(triangles)
        right = points[triangles, 0].mean(axis=1) > 0
        with quiet():
            cuts = sf.suggest(points, triangles, cuts="darts", bound=0, max_cuts=1, weights=1.0 * right).cuts
            surface = sf.make_surface(points, triangles)
            array = numpy_to_vtk(5.0 * right, deep=True)
            array.SetName("Weight")
            surface.GetCellData().AddArray(array)
            same = sf.suggest_polydata(
                surface, cuts="darts", bound=0, max_cuts=1, weights="Weight").cuts
        self.assertEqual(len(cuts), 1)
        self.assertGreater(cuts[0].curve.points[-1, 0], 0)
        np.testing.assert_allclose(same[0].curve.points, cuts[0].curve.points, rtol=0, atol=1e-9)

    def test_curves_given_stay_and_are_not_proposed_again(self):
        points, triangles = dome()
        with quiet():
            suggestion = sf.suggest(points, triangles, [sf.Curve(np.arange(15) + 7 * 15, name="girth")], bound=0, max_cuts=1,
                                    prefer={"girth": 0.0})
        names = [curve["name"] for curve in suggestion.flattening.report["curves"]]
        self.assertEqual(names, ["girth", *(cut.curve.name for cut in suggestion.cuts)])

    def test_a_bound_that_is_not_met_is_a_warning(self):
        points, triangles = dome()
        with self.assertWarnsRegex(sf.FlatteningWarning, r"above the bound of 0.1 %"):
            suggestion = sf.suggest(points, triangles, bound=0.001, max_cuts=1)
        self.assertFalse(suggestion.bound_met)

    def test_a_search_that_is_interrupted_gives_the_best_so_far(self):
        points, triangles = dome()

        def search(seconds):
            began = time.monotonic()

            def interrupt(_):
                if time.monotonic() - began > seconds:
                    raise KeyboardInterrupt
            return sf.suggest(points, triangles, bound=0, max_cuts=30, max_work=0, progress=interrupt)

        with self.assertRaises(KeyboardInterrupt):
            search(-1)  # before anything is known
        with self.assertWarnsRegex(sf.FlatteningWarning, "the search was interrupted after "):
            suggestion = search(5)
        self.assertTrue(suggestion.cuts)
        self.assertEqual(len(suggestion.flattening.report["curves"]), len(suggestion.cuts))

    def test_cuts_are_shown_while_the_search_goes_on(self):
        filter_ = sf.vtkFeatureCurveSuggestion()
        filter_.SetInputData(sf.make_surface(*dome()))
        filter_.SetMaximumWork(3)
        seen = []

        @calldata_type(VTK_OBJECT)
        def look(_, __, lines):
            seen.append(lines.GetNumberOfCells())
        filter_.AddObserver(filter_.PreviewEvent, look)
        filter_.Update()
        self.assertTrue(seen)
        self.assertGreater(min(seen), 0)

    def test_lines_are_those_that_measure_and_guide_and_cost_little(self):
        def bumps(x, y):
            return x, y, 0.2 * np.exp(-9 * ((abs(x) - 0.5)**2 + (y - 1.3)**2))

        points, triangles = grid(24, 30, lambda i, j: bumps(i / 12 - 1, j / 12), other=lambda i, j: (i + j) % 2)
        found = sf.suggest(points, triangles, cuts="lines")
        line = found.cuts[0].curve
        self.assertEqual((line.name, line.type, line.key_shape), ("centre line 1", "key", "straight"))
        np.testing.assert_allclose(line.points[:, 0], 0, atol=1e-9)
        np.testing.assert_allclose(np.sort(line.points[[0, -1], 1]), (0, 2.5), atol=1e-9)
        for k, cut in enumerate(found.cuts, 1):  # at the price that a flattening has
            piece, = sf.flatten(points, triangles, [cut.curve for cut in found.cuts[:k]]).report["pieces"]
            self.assertAlmostEqual(cut.E_area_after, piece["E_area"], 9)
            self.assertAlmostEqual(cut.strain_after, piece["strain_p95"], 9)
        energy = sf.flatten(points, triangles).report["pieces"][0]["energy_rigid"]
        for left in found.left_out:
            self.assertTrue(not left.sound or -left.gain > 0.05 * energy, left)
        # A piece keeps its own key.
        mine = sf.Curve([bumps(0.25, j / 12) for j in range(8, 13)], "key", "mine")
        found = sf.suggest(points, triangles, [mine], cuts="lines")
        for line in (*(cut.curve for cut in found.cuts), *found.left_out):
            self.assertNotRegex(line.name, "centre line|grain line")

    def test_no_line_guides_on_a_cylinder_and_none_collapses_a_triangle(self):
        found = sf.suggest(*grid(12, 20, lambda i, j: (np.cos(np.pi * i / 12), np.sin(np.pi * i / 12), j / 4)), cuts="lines")
        self.assertEqual((len(found.cuts), found.left_out), (1, []))
        self.assertNotRegex(found.cuts[0].curve.name, "girth|style line")
        self.assertLess(found.flattening.report["pieces"][0]["strain_p95"], 1e-9)
        # The line through the middle passes a vertex so near that two edges of a triangle become its.
        found = sf.suggest(*grid(10, 10, lambda i, j: (0.1 * i, 0.15 * j, 0.3 * np.sin(0.3 * i) * np.sin(0.3 * j)),
                                 other=lambda i, j: (i + j) % 2), cuts="lines")
        self.assertEqual(found.flattening.report["status"], "Ok")
        self.assertGreater(found.flattening.cell_arrays["AreaRatio"].min(), 0.5)

    def test_what_is_wrong_is_raised(self):
        points, triangles = dome()
        for kind, words, options in (
                (ValueError, "cuts is 'pleats'", {"cuts": "pleats"}), (ValueError, "bound = -1", {"bound": -1}),
                (ValueError, r"weights must have the shape \(392,\), .* not \(3,\)", {"weights": [1, 2, 3]}),
                (sf.FlatteningError, "negative or not finite", {"weights": np.arange(392) - 1}),
                (sf.FlatteningError, 'no curve is named "waist"', {"prefer": {"waist": 2.0}}),
                *((sf.FlatteningError, 'no curve is named "waist".*grain', {"material": "twill", "grain": grain})
                  for grain in ("waist", "waist:45", ["waist", "hem:30"]))):
            with self.assertRaisesRegex(kind, words) as raised:
                sf.suggest(points, triangles, **options)
            self.assertEqual(raised.exception.ids, [0] if "negative" in words else [])
        with self.assertRaisesRegex(sf.FlatteningError, 'no cell array of numbers named "where"'):
            sf.suggest_polydata(sf.make_surface(points, triangles), weights="where")


if __name__ == "__main__":
    unittest.main()
