# SPDX-License-Identifier: BSD-3-Clause
"""Defects of surfaces are healed with a warning each; curves and results go on referring to the input's points."""

import unittest

import numpy as np

import surfaceflattening as sf
from surfaces import command, warned

COLUMNS, ROWS = 12, 10
at = command.grid_ids(COLUMNS)


def sheet():
    """A bent sheet as lists, to be damaged."""
    points, triangles = command.grid(COLUMNS, ROWS, lambda x, y: [
        x / COLUMNS, y / COLUMNS, 0.1 * np.sin(3.0 * x * y / COLUMNS ** 2)])
    return points, [list(triangle) for triangle in triangles]


class Healed(unittest.TestCase):
    def flatten(self, points, triangles, *arguments, **options):
        with warned() as caught:
            result = sf.flatten(np.array(points), np.array(triangles), *arguments, **options)
        self.assertEqual(result.report["warnings"], [str(one.message) for one in caught])
        self.assertEqual(result.report["status"], "Ok")
        return result

    def test_every_point_of_the_surface_has_a_flat_place(self):
        points, triangles = sheet()
        points[at(5, 5)] = list(points[at(6, 5)])
        triangles.append(triangles[30][::-1])
        for k in (50, 51, 52, 53):
            triangles[k] = triangles[k][::-1]
        points += [[-0.1, 0.1, 0.0], [-0.1, 0.4, 0.0]]
        triangles.append([at(0, 3), len(points) - 1, len(points) - 2])
        told = (f"1 point was joined with a neighbor within a millionth of the edges there ({at(6, 5)})",
                "2 triangles without area were taken out",
                f"1 triangle with the corners of another was taken out ({len(triangles) - 2})",
                "4 triangles were turned over to agree with the others (first: 50, 51, 52)",
                f"1 point in which parts touch was doubled ({at(0, 3)})")
        with self.assertRaises(sf.FlatteningError) as caught:
            sf.flatten(np.array(points), np.array(triangles), heal=False)
        self.assertEqual(caught.exception.name, "DegenerateTriangle")
        result = self.flatten(points, triangles)
        for expected in told:
            self.assertTrue(any(line.startswith(expected) for line in result.report["warnings"]), expected)
        original = result.point_arrays["vtkOriginalPointIds"]
        self.assertEqual(set(original), set(range(len(points))))
        self.assertEqual(len(original), len(points) + 1)  # the pinched one twice
        places = {p: place for p, place in zip(original, result.positions)}
        np.testing.assert_array_equal(places[at(5, 5)], places[at(6, 5)])
        self.assertTrue(np.isfinite(result.positions).all())
        self.assertLess(result.triangles.max(), len(points) + 1)
        cells = result.cell_arrays["vtkOriginalCellIds"]
        for corners, cell in zip(original[result.triangles], cells):
            expected = [at(5, 5) if p == at(6, 5) else p for p in triangles[cell]]
            self.assertEqual(sorted(corners), sorted(expected))

    def test_curves_go_on_through_the_points_that_they_name(self):
        points, triangles = sheet()
        curve = [at(3, 5), at(4, 5), at(5, 5), at(6, 5), at(7, 5)]
        points[at(5, 5)] = list(points[at(6, 5)])
        result = self.flatten(points, triangles, [sf.Curve(curve, "key", "waist", key_shape="straight")])
        length = sum(np.linalg.norm(np.subtract(points[a], points[b])) for a, b in zip(curve, curve[1:]))
        report = result.report["curves"][0]
        self.assertAlmostEqual(report["length_3d"], length, delta=1e-9)
        self.assertAlmostEqual(report["length_2d"], length, delta=1e-9)
        places = {p: place for p, place in zip(result.point_arrays["vtkOriginalPointIds"], result.positions)}
        self.assertAlmostEqual(np.linalg.norm(places[curve[0]] - places[curve[-1]]), length, delta=1e-9)


if __name__ == "__main__":
    unittest.main()
