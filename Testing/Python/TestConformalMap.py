# SPDX-License-Identifier: BSD-3-Clause
"""Scheme "lscm": the least squares conformal map of Levy et al., scaled to the perimeter."""

import unittest

import numpy as np

import surfaceflattening as sf
from surfaces import command, distances, grid, moved_rigidly, shell


def outline(triangles):
    """The boundary edges, each as it runs in its triangle."""
    sides = [(t[k], t[(k + 1) % 3]) for t in triangles.tolist() for k in range(3)]
    return np.array([side for side in sides if side[::-1] not in set(sides)])


def perimeter(triangles, places):
    ends = places[outline(triangles)]
    return np.linalg.norm(ends[:, 1] - ends[:, 0], axis=1).sum()


def dense_reference(points, triangles, pins, area_normalized):
    """Levy's rows as they are written in the article."""
    rows = np.zeros((2 * len(triangles), 2 * len(points)))
    for t, corners in enumerate(triangles):
        u, v = points[corners[1:]] - points[corners[0]]
        normal = np.cross(u, v)
        x = u / np.linalg.norm(u)
        y = np.cross(normal, x) / np.linalg.norm(normal)
        plane = np.array([(0, 0), (u @ x, 0), (v @ x, v @ y)])
        for k, corner in enumerate(corners):
            a, b = (plane[(k + 2) % 3] - plane[(k + 1) % 3]) / (np.sqrt(np.linalg.norm(normal)) if area_normalized else 1)
            rows[2 * t:2 * t + 2, 2 * corner:2 * corner + 2] = (a, -b), (b, a)
    places = np.zeros((len(points), 2))
    places[pins[1], 0] = 1
    free = np.repeat([v not in pins for v in range(len(points))], 2)
    places.ravel()[free] = np.linalg.lstsq(rows[:, free], -rows @ places.ravel(), rcond=None)[0]
    return places * perimeter(triangles, points) / perimeter(triangles, places)


class ConformalMap(unittest.TestCase):
    def map(self, points, triangles, **options):
        result = sf.flatten(points, triangles, scheme="lscm", arrange=False, **options)
        self.assertEqual(result.report["status"], "Ok")
        return result.positions

    def test_it_agrees_with_a_dense_least_squares_solution(self):
        points, triangles = shell(7, 6, 0.4)
        for pins in ((0, 55), (3, 4)):
            for normalized in (True, False):
                found = self.map(points, triangles, pins=pins, area_normalized=normalized)
                expected = dense_reference(points, triangles, pins, normalized)
                np.testing.assert_allclose(distances(found), distances(expected), atol=1e-10)

    def test_it_keeps_the_perimeter_and_pins_the_farthest_boundary_vertices(self):
        points, triangles = shell(9, 6, 0.3)
        flat = self.map(points, triangles)
        self.assertAlmostEqual(perimeter(triangles, flat), perimeter(triangles, points), 12)
        # Both diagonals are equally long; the one with the smallest ids counts.
        np.testing.assert_array_equal(flat, self.map(points, triangles, pins=(0, 69)))

    def test_it_does_not_depend_on_pose_and_scales_with_the_surface(self):
        points, triangles = shell(9, 6, 0.3)
        reference = distances(self.map(points, triangles, pins=(0, 69)))
        for scale in (1e-9, 1.0, 1e9):
            flat = self.map(scale * moved_rigidly(points), triangles, pins=(0, 69)) / scale
            np.testing.assert_allclose(distances(flat), reference, atol=1e-11)

    def test_a_single_triangle_is_itself(self):
        flat = self.map([(0, 0, 0), (3, 0, 0), (0, 4, 0)], [(0, 1, 2)])
        np.testing.assert_allclose(distances(flat), [(0, 3, 4), (3, 0, 5), (4, 5, 0)], atol=1e-13)

    def test_a_closed_surface_and_wrong_pins_are_refused(self):
        points, triangles = grid(3, 3)
        for surface, name, ids, pins in ((command.TETRAHEDRON, "ClosedSurface", [0], (-1, -1)), *(
                ((points, triangles), "InvalidOption", list(pins), pins)
                for pins in ((2, 2), (0, 16), (-1, 4), (-7, 4), (3, -1)))):
            with self.subTest(pins=pins), self.assertRaises(sf.FlatteningError) as caught:
                sf.flatten(*map(np.array, surface), scheme="lscm", pins=pins)
            self.assertEqual((caught.exception.name, caught.exception.ids), (name, ids))


if __name__ == "__main__":
    unittest.main()
