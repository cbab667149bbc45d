# SPDX-License-Identifier: BSD-3-Clause
"""Curves anywhere on a surface: holes, darts that meet, wires that end or float inside; what must not change a result,
and what no method can lay flat."""

import random
import unittest

import numpy as np

import surfaceflattening as sf
from surfaces import cap, column_of, command, distances, grid, moved_rigidly, quiet, shell

SIZE = 8
at = command.grid_ids(SIZE)


def flat(columns, rows):
    """A rectangle in a slanted plane, of uneven triangles: its places in the plane, points and triangles."""
    plane, triangles = grid(columns, rows, lambda i, j: (
        i + 0.2 * np.sin(2 * i + j), j + 0.2 * np.sin(i - 3 * j), 0), other=lambda i, j: (i + j) % 2)
    return plane, plane[:, :1] * (2, 1, 2) / 3 + plane[:, 1:2] * (-1, -2, 2) / 3 + (3, -2, 1), triangles


def line(*ends):
    """The vertices along straight lines of the grid from corner to corner."""
    vertices = [at(*ends[0])]
    for (i, j), (k, m) in zip(ends, ends[1:]):
        steps = max(abs(k - i), abs(m - j))
        vertices += [at(i + (k - i) * step // steps, j + (m - j) * step // steps) for step in range(1, steps + 1)]
    return vertices


def cut(*ends, kind="dart"):
    return sf.Curve(line(*ends), kind)


ROW, RING = line((0, 4), (8, 4)), line((3, 3), (5, 3), (5, 5), (3, 5), (3, 3))
# Sets of curves by name, and how many pieces they leave.
CASES = {
    "fish-eye dart": (1, cut((4, 2), (4, 5))),
    "fish-eye dart under a girth": (1, cut((4, 2), (4, 6)), ROW),
    "two fish-eye darts": (1, cut((2, 2), (2, 4)), cut((6, 4), (6, 6))),
    "darts that meet": (1, cut((4, 0), (4, 2)), cut((4, 2), (5, 2))),
    "fish-eye darts that cross": (1, cut((4, 2), (4, 5)), cut((2, 4), (5, 4))),
    "three darts to one vertex cut through": (3, cut((4, 0), (4, 2)), cut((8, 2), (4, 2)), cut((0, 2), (4, 2))),
    "a dart between two boundary points": (2, cut((5, 0), (5, 8)), ROW),
    "a seam with a girth across": (2, cut((3, 0), (3, 8), kind="seam"), ROW),
    "a seam around a region": (2, sf.Curve(RING, "seam")),
    "a closed accessory curve": (1, RING),
    "a dangling wire": (1, line((4, 0), (4, 2), (5, 2))),
    "a floating wire": (1, line((3, 3), (4, 3), (4, 4))),
    "two floating wires": (1, line((2, 2), (3, 2)), line((5, 5), (5, 6))),
    "curves that end on a dart": (1, cut((4, 0), (4, 3)), line((0, 2), (4, 2)), line((4, 1), (8, 1))),
    "a girth across a dart": (1, cut((4, 0), (4, 3)), line((0, 2), (8, 2))),
    "a curve along a dart": (1, cut((4, 0), (4, 2)), line((4, 1), (4, 3))),
    "a dart of one inner edge": (1, cut((4, 4), (4, 5))),
}


class Topology(unittest.TestCase):
    def assert_flat(self, result, plane, within):
        """Each piece is that of the plane, and no angle had to change."""
        self.assertEqual(result.report["status"], "Ok", result.report["message"])
        self.assertLess(max(piece["objective"] for piece in result.report["pieces"]), 1e-20)
        for number in range(len(result.report["pieces"])):
            vertices = np.unique(result.triangles[result.cell_arrays["PieceId"] == number])
            original = result.point_arrays["vtkOriginalPointIds"][vertices]
            np.testing.assert_allclose(
                distances(result.positions[vertices]), distances(plane[original]), atol=within)

    def test_whatever_the_curves_flat_surfaces_stay_and_wires_of_curved_ones_meet(self):
        plane, points, triangles = flat(SIZE, SIZE)
        for name, (pieces, *curves) in CASES.items():
            for scheme in ("global", "progressive", "isometric"):
                with self.subTest(name, scheme=scheme), quiet():
                    result = sf.flatten(points, triangles, curves, scheme=scheme, dart_legs="free")
                    self.assertEqual(len(result.report["pieces"]), pieces)
                    self.assert_flat(result, plane, 1e-10)
                    bent = sf.flatten(*shell(SIZE, SIZE, 0.2), curves, scheme=scheme, dart_legs="free").report
                    self.assertNotEqual(bent["status"], "NotConverged")
                    self.assertLess(max(piece["E_len_max"] for piece in bent["pieces"]), 1e-12)

    def test_cuts_open_but_not_their_tips_and_part_the_pieces(self):
        ids = command.grid_ids(6)

        def dart(*places, kind="dart"):
            return sf.Curve([ids(*place) for place in places], kind)

        across = [(2, j) for j in range(7)]
        for name, curves, copies, pairs, pieces, euler in (
                ("what cuts nothing", [range(14, 21), dart((2, 0), (2, 1), kind="key")], {}, 0, 1, 1),
                ("a dart from the boundary", [dart((3, 0), (3, 1), (3, 2))], {(3, 0): 2, (3, 1): 2, (3, 2): 1}, 2, 1, 1),
                ("one inside, which leaves a hole", [dart((3, 1), (3, 2), (3, 3), (3, 4))],
                 {(3, 1): 1, (3, 2): 2, (3, 4): 1}, 3, 1, 0),
                ("one inner edge, which opens nothing", [dart((3, 2), (3, 3))], {(3, 2): 1, (3, 3): 1}, 0, 1, 1),
                ("a dart from side to side", [dart(*across)], {(2, 3): 2}, 6, 2, 2),
                ("a seam from side to side", [dart(*across, kind="seam")], {(2, 3): 2}, 6, 2, 2),
                ("two darts that meet inside", [dart((2, 0), (2, 1), (2, 2)), dart((3, 2), (2, 2))],
                 {(2, 1): 2, (2, 2): 2, (3, 2): 1}, 3, 1, 1),
                ("three darts to one vertex", [dart((3, 0), (3, 1), (3, 2), (3, 3)), dart((0, 3), (1, 3), (2, 3), (3, 3)),
                                               dart((3, 3), (4, 3), (5, 3), (6, 3))], {(3, 3): 3}, 9, 3, 3)):
            with self.subTest(name), quiet():
                result = sf.flatten(*shell(6, 6, 0.3), curves)
                original = result.point_arrays["vtkOriginalPointIds"]
                self.assertEqual({place: (original == ids(*place)).sum() for place in copies}, copies)
                self.assertEqual((len(result.seam_pairs), len(result.report["pieces"])), (pairs, pieces))
                sides = {tuple(sorted((t[k - 1], t[k]))) for t in result.triangles.tolist() for k in range(3)}
                self.assertEqual(len(original) - len(sides) + len(result.triangles), euler)

    def test_wires_are_the_curves_and_go_on_on_both_sides_of_a_dart(self):
        surface, row = shell(6, 4, 0.2), range(14, 21)
        wire, = (wire for wire in sf.flatten(*surface, [row]).wires if not wire.boundary)
        self.assertEqual(list(wire.vertices), list(row))
        boundary, = sf.flatten(*surface).wires
        self.assertEqual((len(boundary.vertices), boundary.vertices[0]), (21, boundary.vertices[-1]))  # one loop
        cut_ = sf.flatten(*surface, [sf.Curve([3, 10, 17], "dart", "dart"), sf.Curve(range(7, 14), name="row")])
        one, other = (wire.vertices for wire in cut_.wires if wire.name == "row")
        self.assertEqual((len(one), len(other)), (4, 4))
        self.assertNotEqual(one[-1], other[0])

    def test_a_surface_with_two_boundary_loops_lies_flat_around_its_hole(self):
        plane, points, triangles = flat(SIZE, SIZE)
        kept = np.linalg.norm(points[triangles].mean(axis=1) - points[at(4, 4)], axis=1) > 1.3
        self.assertTrue(0 < (~kept).sum() < 20)
        for scheme in ("global", "progressive"):
            self.assert_flat(sf.flatten(points, triangles[kept], scheme=scheme), plane, 1e-10)

    def test_seams_cut_a_closed_surface_into_a_cross(self):
        points = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1)]
        sides = [(0, 3, 2, 1), (4, 5, 6, 7), (0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7)]
        # The four upright edges and three edges of the lid.
        edges = [(0, 4), (1, 5), (2, 6), (3, 7), (4, 5), (5, 6), (6, 7)]
        result = sf.flatten(points, [t for a, b, c, d in sides for t in ((a, b, c), (a, c, d))],
                            [sf.Curve(edge, "seam") for edge in edges])
        piece, = result.report["pieces"]
        self.assertEqual((result.report["status"], len(result.seam_pairs)), ("Ok", 7))
        self.assertLess(piece["objective"], 1e-20)
        for name in ("AreaRatio", "AspectRatio"):
            np.testing.assert_allclose(result.cell_arrays[name], 1, atol=1e-12)

    def walks(self, triangles, seed, keys):
        """Curves along random edges; they cross, touch and retrace each other as chance has it."""
        chance = random.Random(seed)
        neighbors = {}
        for a, b, c in triangles.tolist():
            for v, others in ((a, (b, c)), (b, (a, c)), (c, (a, b))):
                neighbors.setdefault(v, set()).update(others)
        for _ in range(chance.randint(1, 6)):
            chain = [chance.choice(sorted(neighbors))]
            for _ in range(chance.randint(1, 12)):
                chain.append(chance.choice(sorted(neighbors[chain[-1]])))
            kind = chance.choice(("accessory", "key", "dart", "seam"))
            yield sf.Curve(chain, kind if keys or kind != "key" else "accessory")

    def test_flat_surfaces_flatten_to_themselves_with_random_curves(self):
        plane, points, triangles = flat(7, 6)
        for seed in range(300):
            with self.subTest(seed=seed):
                # Cuts in a flat sheet leave sides that touch; they are no overlap.
                result = sf.flatten(points, triangles, list(self.walks(triangles, seed, True)),
                                    scheme=("global", "progressive")[seed % 2],
                                    solver="newton" if seed % 3 else "sequential", dart_legs="free")
                self.assert_flat(result, plane, 1e-9)

    def test_random_wires_of_a_curved_surface_meet(self):
        points, triangles = shell(7, 6, 0.12)
        for seed in range(300):
            with self.subTest(seed=seed), quiet():
                result = sf.flatten(points, triangles, list(self.walks(triangles, seed, False)),
                                    scheme=("global", "progressive")[seed % 2], dart_legs="free")
                self.assertTrue(np.isfinite(result.positions).all())
                self.assertLess(max(piece["E_len_max"] for piece in result.report["pieces"]), 1e-10)


class Invariance(unittest.TestCase):
    """Neither place nor unit nor numbering of a surface changes its pieces."""

    def corners(self, result, order):
        """Of its pieces, the flat corners of their triangles, which come in an order, with the angles' objective."""
        place = dict(zip(result.cell_arrays["vtkOriginalCellIds"], range(len(result.triangles))))
        rows = np.array([place[t] for t in order])
        pieces = result.cell_arrays["PieceId"][rows]
        for piece in dict.fromkeys(pieces):
            flat = result.positions[result.triangles[rows[pieces == piece]].ravel()]
            yield distances(flat), result.report["pieces"][piece]["objective"]

    def test_pieces_stay_the_same(self):
        points, triangles = shell(10, 8, 0.15)
        chains = ([(6 + 11 * j) for j in range(9)], [2, 13, 24], list(range(55, 66)), column_of(10, 8, 4), [30, 31, 42])
        kinds = ("seam", "dart", "key", "accessory", "accessory")

        def curves(place=lambda v: v):
            return [sf.Curve([place(v) for v in chain], kind, key_shape="straight" if kind == "key" else "surface")
                    for chain, kind in zip(chains, kinds)]

        chance = np.random.default_rng(5)
        vertices, order, same = chance.permutation(len(points)), chance.permutation(len(triangles)), np.arange(len(triangles))
        elsewhere = np.empty_like(points)
        elsewhere[vertices] = points
        changes = [(moved_rigidly(points), triangles, curves(), same, 1.0),
                   (points, triangles, [sf.Curve(curve.points[::-1], curve.type, key_shape=curve.key_shape)
                                        for curve in reversed(curves())], same, 1.0),
                   *((scale * points, triangles, curves(), same, scale) for scale in (1e-6, 1e-3, 1e6)),
                   (elsewhere, vertices[triangles], curves(lambda v: vertices[v]), same, 1.0),
                   (points, triangles[order], curves(), np.argsort(order), 1.0)]
        for options in ({}, {"boundary": "free"}, {"scheme": "global", "interior": "laplacian", "dart_legs": "free"},
                        {"scheme": "progressive", "interior": "laplacian", "dart_legs": "free"}):
            first = sf.flatten(points, triangles, curves(), arrange=False, **options)
            for number, (places, corners, lines, cells, scale) in enumerate(changes):
                if options.get("scheme") == "progressive" and cells is not same:
                    continue  # it breaks ties by the number of a patch
                with self.subTest(number=number, **options):
                    second = sf.flatten(places, corners, lines, arrange=False, **options)
                    self.assertEqual(first.report["status"], second.report["status"])
                    for (a, objective), (b, other) in zip(
                            self.corners(first, same), self.corners(second, cells), strict=True):
                        np.testing.assert_allclose(b / scale, a, atol=1e-9)
                        self.assertAlmostEqual(objective, other, 9)


SHIRT = 2 * 8 * 6  # triangles
RING_SIZE = 8


def parts(*kinds):
    """Shirts and what no method can lay flat, as one, with the curves of the shirts: a straight key and a seam."""
    ring_points, ring_triangles = command.torus(RING_SIZE)
    surfaces = {"shirt": [places.tolist() for places in shell(8, 6, 0.3)], "button": command.TETRAHEDRON,
                "ring": (ring_points, ring_triangles), "holed": (ring_points, ring_triangles[:-1])}
    curves, first = [], 0
    for kind in kinds:
        if kind == "shirt":
            curves += [sf.Curve(range(first + 27, first + 36), "key", key_shape="straight"),
                       sf.Curve([first + v for v in column_of(8, 6, 4)], "seam")]
        first += len(surfaces[kind][0])
    return (*map(np.array, command.together(*(surfaces[kind] for kind in kinds))), curves)


class WhatCannotLieFlat(command.WordsTest):
    """Surfaces with pieces without boundary, or with handles."""

    def refusal(self, *kinds, **options):
        error = self.assert_raises(sf.FlatteningError, "", sf.flatten, *parts(*kinds), **options)
        self.assert_words([str(id_) for id_ in error.ids], error.message)
        return error

    def test_all_are_named_in_one_message(self):
        ring = SHIRT + 4 + 2 * RING_SIZE**2 - 1 + SHIRT
        for scheme in ("progressive", "global", "isometric", "lscm"):
            error = self.refusal("shirt", "button", "holed", "shirt", "ring", "button", scheme=scheme)
            self.assertEqual((error.name, error.ids), ("ClosedSurface", [SHIRT, SHIRT + 4, ring, ring + 2 * RING_SIZE**2]))
        error = self.refusal("shirt", "holed")
        self.assertEqual((error.name, error.ids), ("Handle", [SHIRT]))
        error = self.refusal("button", "holed", skip_closed=True)  # nothing would remain
        self.assertEqual((error.name, error.ids), ("ClosedSurface", [0, 4]))
        self.assertNotIn("SkipClosed", dict(error.remedies))

    def test_what_is_skipped_changes_nothing_of_the_rest(self):
        for scheme in ("progressive", "global", "isometric", "lscm"):
            with quiet():
                result, rest = (sf.flatten(*parts(*kinds), scheme=scheme, skip_closed=True) for kinds in (
                    ("button", "shirt", "holed", "shirt", "button"), ("shirt", "shirt")))
            np.testing.assert_array_equal(result.positions, rest.positions)
            np.testing.assert_array_equal(result.triangles, rest.triangles)
            self.assertEqual([wire.flat_length for wire in result.wires], [wire.flat_length for wire in rest.wires])
            self.assertEqual(result.report["pieces"], rest.report["pieces"])
            self.assertEqual([(piece["cell"], piece["triangles"], piece["reason"]) for piece in result.report["left_out"]], [
                (0, 4, "ClosedSurface"), (4 + SHIRT, 2 * RING_SIZE**2 - 1, "Handle"),
                (4 + 2 * SHIRT + 2 * RING_SIZE**2 - 1, 4, "ClosedSurface")])
            points, triangles, _ = parts("button", "shirt", "holed", "shirt", "button")
            ids = result.point_arrays["vtkOriginalPointIds"]
            np.testing.assert_array_equal(result.points, points[ids])
            np.testing.assert_array_equal(np.sort(ids[result.triangles]),
                                          np.sort(triangles[result.cell_arrays["vtkOriginalCellIds"]]))

    def test_where_something_is_skipped_cells_of_the_input_are_named_that_overlap(self):
        stairs = command.grid(40, 1, lambda i, j: (
            (0.6 + 0.4 * j) * np.cos(0.065 * np.pi * i), (0.6 + 0.4 * j) * np.sin(0.065 * np.pi * i), 0.02 * i + 5))
        for scheme in ("isometric", "lscm"):
            with quiet():
                report = sf.flatten(*map(np.array, command.together(command.TETRAHEDRON, stairs, command.TETRAHEDRON)),
                                    scheme=scheme, skip_closed=True).report
            self.assertEqual((report["status"], len(report["left_out"])), ("Overlap", 2))
            self.assertTrue(report["ids"] and set(report["ids"]) <= set(range(4, 84)), report["ids"])

    def test_curves_count_as_far_as_they_run_on_what_is_kept(self):
        # A seam around two by two quads of a ring divides it into a disc and a part with a handle.
        points, triangles = map(np.array, command.torus(RING_SIZE))

        def ids(*places):
            return [i + RING_SIZE * j for i, j in places]

        curves = [sf.Curve(ids((0, 0), (1, 0), (2, 0), (2, 1), (2, 2), (1, 2), (0, 2), (0, 1), (0, 0)), "seam"),
                  ids((0, 1), (1, 1), (2, 1), (3, 1), (4, 1)), ids((4, 4), (5, 4))]
        with quiet():
            result = sf.flatten(points, triangles, curves, skip_closed=True)
        piece, = result.report["pieces"]
        self.assertEqual((piece["triangles"], len(result.seam_pairs)), (8, 0))
        self.assertEqual([(part["reason"], part["triangles"]) for part in result.report["left_out"]],
                         [("Handle", 2 * RING_SIZE**2 - 8)])
        for report, chain in zip(result.report["curves"], (curves[0].points, curves[1][:3], [])):
            length = np.linalg.norm(np.diff(points[chain], axis=0), axis=1).sum() if chain else 0
            self.assertAlmostEqual(report["length_3d"], length, 12)
            self.assertAlmostEqual(report["length_2d"], length, 9)
        self.assertEqual(sorted((wire.curve, len(wire.vertices)) for wire in result.wires), [(0, 9), (1, 3)])

    def test_of_a_tube_a_seam_is_advised_and_nothing_that_is_not_there(self):
        # With so few triangles some turn over.
        for length in (1.0, 4.0):
            surface = map(np.array, command.tube(6, 1, lambda j: (1, length * j)))
            points, triangles = surface
            for scheme in ("isometric", "global", "progressive"):
                with quiet():
                    report = sf.flatten(points, triangles, scheme=scheme).report
                self.assertNotEqual(report["status"], "Ok")
                remedies = {remedy["name"] for remedy in report["remedies"]}
                self.assertIn("SeamBetweenLoops", remedies)
                self.assertFalse(remedies & {"ReleaseCurves", "AddDarts"})

    def test_a_cap_loses_the_area_that_a_disk_with_its_boundary_lacks(self):
        for degrees in (10, 45, 60, 70, 90, 120, 126, 150, 170):
            angle = np.radians(degrees)
            with quiet():
                piece, = sf.flatten(*cap(angle, 24, 96)).report["pieces"]
            # A quarter is lost at 60 degrees, and the threshold is 0.3: nothing is said of what lies well.
            loss = 1 - 0.5 * np.sin(angle)**2 / (1 - np.cos(angle)) if degrees > 60 else 0
            self.assertAlmostEqual(piece["forecast_area_loss"], loss, delta=0.01 if loss else 0)
            self.assertEqual(piece["verdict"] != "", degrees > 60)
            if loss:  # a cut to the pole saves some
                self.assertEqual(piece["forecast_cut_to"], 0)
                self.assertGreaterEqual(piece["forecast_cut_from"], 1 + 23 * 96)
                self.assertLess(piece["forecast_area_loss_after_cut"], loss)
            if degrees == 126:
                self.assertTrue(0 < piece["forecast_area_loss_after_cut"] < 0.75 * loss)


if __name__ == "__main__":
    unittest.main()
