# SPDX-License-Identifier: BSD-3-Clause
"""What the isometric scheme, a free boundary, the legs of darts and closed cuts promise, and where pieces lie."""

import unittest

import numpy as np

import surfaceflattening as sf
from surfaces import cap, column_of, command, cone, cylinder, distances, grid, moved_rigidly, points_of, quiet, shell


def piece_of(result):
    return result.report["pieces"][0]


def energy_of(result):
    """Of the triangles, over the area."""
    return piece_of(result)["energy_sheet"] / piece_of(result)["triangles"]


def cross(a, b):
    return a[..., 0] * b[..., 1] - a[..., 1] * b[..., 0]


class Isometric(unittest.TestCase):
    CURVES = [column_of(8, 10, 4), range(27, 36), range(63, 72)]  # of shell(8, 10)

    def test_a_finer_mesh_of_the_same_surface_gives_the_same_shape(self):
        coarse, fine = (sf.flatten(*shell(side, side, 0.15), [range(side // 2 * (side + 1), (side // 2 + 1) * (side + 1))])
                        for side in (60, 120))
        self.assertAlmostEqual(piece_of(fine)["E_ang"] / piece_of(coarse)["E_ang"], 1, delta=0.03)
        width, other = (np.linalg.norm(np.ptp(result.positions, axis=0)) for result in (coarse, fine))
        self.assertAlmostEqual(other / width, 1, delta=2e-3)

    def test_a_symmetric_surface_stays_symmetric_in_both_directions(self):
        # The diagonals of its squares alternate, so that both mirrors take triangles to triangles.
        result = sf.flatten(*shell(8, 8, 0.2), [range(18, 27), range(54, 63), column_of(8, 8, 2), column_of(8, 8, 6)])
        self.assertLess(piece_of(result)["E_len_max"], 1e-12)
        ids = np.arange(81).reshape(9, 9)
        for image in (ids[:, ::-1], ids[::-1]):
            np.testing.assert_allclose(distances(result.positions[image.ravel()]), distances(result.positions), atol=1e-9)

    def test_it_stops_where_slivers_leave_only_rounding_in_the_gradient(self):
        # Curves between places inside triangles divide these into thin ones.
        points, triangles = cone(12, 10)
        chance, imprinted = np.random.default_rng(5), 0
        for _ in range(20):
            places = [chance.dirichlet((1, 1, 1)) @ points[chance.choice(triangles)] for _ in range(2)]
            try:
                piece = piece_of(sf.flatten(points, triangles, [np.array(places)]))
            except sf.FlatteningError:
                continue  # the section may leave the panel
            imprinted += 1
            self.assertEqual(piece["status"], "Ok", piece["message"])
            self.assertLess(piece["iterations"], 20)
            self.assertAlmostEqual(piece["E_h"], 1, 6)
        self.assertGreaterEqual(imprinted, 10)

    def test_it_stops_on_a_fine_mesh_where_the_rounding_of_all_lengths_is_what_is_left(self):
        def place(i, j):
            x, y = 10 * i / 99, 10 * j / 99
            return x, y, 0.3 * np.sin(0.5 * x) * np.cos(0.4 * y) + 0.2 * np.sin(x * y / 3)

        curves = [np.array([place(i, 50) for i in range(100)]), np.array([place(5, 5), place(33, 50), place(6, 90)])]
        piece = piece_of(sf.flatten(*grid(99, 99, place, other=lambda i, j: (i + j) % 2), curves))
        self.assertEqual(piece["status"], "Ok", piece["message"])
        self.assertLess(piece["iterations"], 20)
        self.assertLess(piece["E_len_max"], 1e-11)

    def test_the_symmetric_dirichlet_energy_never_flips_and_agrees_on_developables(self):
        surface = shell(8, 10, 0.3)
        one, other = (sf.flatten(*surface, self.CURVES, energy=energy) for energy in ("rigid", "dirichlet"))
        self.assertEqual((piece_of(other)["status"], piece_of(other)["flipped"]), ("Ok", 0))
        self.assertLess(piece_of(other)["E_len_max"], 1e-12)
        self.assertGreater(np.abs(distances(one.positions) - distances(other.positions)).max(), 1e-4)
        self.assertLessEqual(piece_of(one)["iterations"], 8)
        # Where there is an isometry, it has no energy of either kind.
        for surface, curves in ((cone(12, 6), [range(39, 52), column_of(12, 6, 6)]),
                                (cylinder(10, 8), [range(44, 55), column_of(10, 8, 5)])):
            one, other = (sf.flatten(*surface, curves, energy=energy) for energy in ("rigid", "dirichlet"))
            np.testing.assert_allclose(distances(one.positions), distances(other.positions), atol=1e-9)
            self.assertLess(max(piece_of(one)["energy_rigid"], piece_of(other)["energy_rigid"]), 1e-18)

    def test_a_bias_and_a_weight_of_the_wires_angles_lower_their_errors(self):
        def piece(**options):
            return piece_of(sf.flatten(*shell(8, 10, 0.3), self.CURVES, energy="rigid", **options))

        self.assertLess(piece(area_bias=0.8)["E_area"], piece()["E_area"])
        self.assertLess(piece(area_bias=-0.8)["E_ang"], piece()["E_ang"])
        self.assertLess(piece(angle_weight=10)["energy_angles"] / 10, piece(angle_weight=1)["energy_angles"])

    def test_weights_take_distortion_elsewhere(self):
        points, triangles = shell(9, 8, 0.4)
        matters = points[triangles, 0].mean(axis=1) > 0.4
        plain, weighted, even = (sf.flatten(points, triangles, **options) for options in (
            {}, {"weights": 1.0 * matters}, {"weights": np.full(len(triangles), 7.0)}))
        self.assertLess(piece_of(weighted)["E_len_max"], 1e-12)
        before, after = (np.abs(np.log(result.cell_arrays["AreaRatio"][matters])).sum() for result in (plain, weighted))
        self.assertLess(after, 0.8 * before)
        np.testing.assert_array_equal(even.positions, plain.positions)
        with self.assertRaises(sf.FlatteningError) as caught:
            sf.flatten(points, triangles, weights=np.where(np.arange(len(triangles)) == 3, -1.0, 1.0))
        self.assertEqual((caught.exception.name, caught.exception.ids), ("InvalidOption", [3]))


def ramp(turns, pitch=0.03):
    """Around an axis: flat, it is a ring of about the same number of turns."""
    return grid(round(40 * turns), 5, lambda i, j: (
        (1 + 0.2 * j) * np.cos(np.pi * i / 20), (1 + 0.2 * j) * np.sin(np.pi * i / 20), pitch * np.pi * i / 20),
        other=lambda i, j: (i + j) % 2)


def ruff(height, waves=3):
    """A saddle with the given number of waves, whose rim is far too long for its radius."""
    def at(ring, k):
        return 0 if ring == 0 else 1 + 2 * ring * (ring - 1) + k % (4 * ring)

    points, triangles = [(0, 0, 0)], []
    for ring in range(1, 11):  # of triangles of about one size
        radius = np.sin(np.pi / 3 * ring / 10)
        for k in range(4 * ring):
            turn, inner = 2 * np.pi * k / (4 * ring), k - k // ring
            points.append((radius * np.cos(turn), radius * np.sin(turn), height * radius**2 * np.sin(waves * turn)))
            triangles.append((at(ring - 1, inner), at(ring, k), at(ring, k + 1)))
            if k % ring != ring - 1:
                triangles.append((at(ring - 1, inner), at(ring, k + 1), at(ring - 1, inner + 1)))
    return np.array(points), np.array(triangles)


@quiet()
def free(surface, curves=(), **options):
    return sf.flatten(*surface, curves, boundary="free", **options)


class FreeBoundary(command.WordsTest):
    def test_it_keeps_the_stretches_that_curves_name(self):
        surface, hem = shell(9, 8, 0.4), sf.Curve(range(7), name="hem")
        curves = [hem, sf.Curve(range(40, 50), "key", "key", "straight")]
        without, result = free(surface), free(surface, curves)
        self.assertEqual(result.report["status"], "Ok")
        for curve in result.report["curves"]:
            self.assertLess(curve["error"], 1e-12)
        self.assertLess(piece_of(result)["E_len_max"], 1e-12)
        self.assertGreater(max(wire.length_error for wire in result.wires if wire.boundary), 1e-3)
        self.assertGreater(energy_of(result), energy_of(without))
        self.assertAlmostEqual(np.linalg.norm(result.positions[49] - result.positions[40]),
                               result.report["curves"][1]["length_3d"], 9)
        self.assertLess(piece_of(result)["E_len_all"], piece_of(sf.flatten(*surface, curves[1:]))["E_len_all"])
        elastic = free(surface, curves, tolerance={"hem": 0.02})
        self.assertLess(energy_of(elastic), energy_of(result))
        self.assertLessEqual(elastic.report["curves"][0]["error"], 0.02 + 1e-12)

    def test_it_takes_the_rigid_energy_on_request_where_that_does_not_fold(self):
        shallow, usual = free(shell(9, 8, 0.4), energy="rigid"), free(shell(9, 8, 0.4))
        self.assertIn("rigid", piece_of(shallow)["energy_used"])
        self.assertLess(piece_of(shallow)["energy_rigid"], piece_of(usual)["energy_rigid"])
        deep = free(cap(np.radians(170), 12, 48), energy="rigid")
        self.assertEqual((piece_of(deep)["energy_used"], piece_of(deep)["flipped"]), ("symmetric-dirichlet", 0))

    def assert_whole(self, result):
        piece = piece_of(result)
        self.assertEqual((piece["status"], piece["overlaps"], piece["flipped"]), ("Ok", 0, 0), piece["message"])

    def test_without_overlap_it_does_not_cross_itself_where_a_free_one_does(self):
        radius = 1 + (np.arange(1000) + 0.5) / 1000
        for turns in (1.1, 1.5, 2.3):
            crossing, result = free(ramp(turns)), free(ramp(turns), prevent_overlap=True)
            self.assertEqual(piece_of(crossing)["status"], "Overlap")
            self.assertEqual(piece_of(crossing)["remedies"][0]["name"], "PreventOverlap")
            self.assert_whole(result)
            # Wound up evenly to one turn, around the middle of its width, it does not overlap either.
            stretch = (1.5 * turns + radius - 1.5) / (turns * radius)
            self.assertLess(energy_of(result), np.average(stretch**2 + stretch**-2 - 2, weights=radius))
            self.assertGreater(energy_of(result), energy_of(crossing))
        points, triangles = ruff(3.0)
        holed = triangles[np.linalg.norm(points[triangles].mean(axis=1)[:, :2], axis=1) > 0.2]
        for surface in ((points, triangles), (points, holed), ruff(5.0)):
            self.assertEqual(piece_of(free(surface))["status"], "Overlap")
            self.assert_whole(free(surface, prevent_overlap=True))

    def test_without_overlap_it_is_the_free_one_where_that_does_not_cross_itself(self):
        folded = grid(12, 8, lambda i, j: (0.3 * i, 0.4 * np.sin(1.1 * i) + 0.02 * i * np.sin(0.4 * j), 0.25 * j))
        for surface in (folded, shell(9, 8, 0.4), ramp(0.8)):
            np.testing.assert_array_equal(free(surface, prevent_overlap=True).positions, free(surface).positions)

    def test_without_overlap_it_keeps_the_lengths_of_curves_as_well(self):
        result = free(ramp(1.3), [range(106, 159)], prevent_overlap=True)
        self.assert_whole(result)
        self.assertLess(result.report["curves"][0]["error"], 1e-12)
        # The innermost row would have to be longer.
        rigid, elastic = (free(ramp(1.3), [sf.Curve(range(53), length_tolerance=tolerance)], prevent_overlap=True)
                          for tolerance in (0.0, 0.02))
        self.assert_whole(elastic)
        self.assertTrue(1e-4 < elastic.report["curves"][0]["error"] <= 0.02 + 1e-12)
        self.assertLess(energy_of(elastic), energy_of(rigid))

    def test_what_has_no_effect_is_refused(self):
        points, triangles = shell(9, 8, 0.4)
        seam = sf.Curve(column_of(9, 8, 5), "seam", "seam")
        for options in (*({"scheme": scheme} for scheme in ("global", "progressive", "lscm")), {"area_bias": 0.5},
                        {"ease": {"seam": 0.01}}, {"tolerance": {"boundary": 0.02}}, {"tolerance": {"seam": 0.01}},
                        {"boundary": "exact", "prevent_overlap": True}):
            with self.subTest(**options), self.assertRaises(sf.FlatteningError) as caught:
                sf.flatten(points, triangles, [seam], **{"boundary": "free", **options})
            self.assertIn(caught.exception.name, ("InvalidOption", "InvalidArgument"))
        self.assertNotEqual(free((points, triangles), [seam]).report["status"], "InvalidOption")

    def test_each_stretch_of_an_elastic_boundary_between_ends_of_wires_has_one_factor(self):
        points, triangles = shell(12, 15, 0.3)
        curves = [column_of(12, 15, 5), range(117, 130)]
        exact, elastic = (sf.flatten(points, triangles, curves, **options)
                          for options in ({}, {"tolerance": {"boundary": 0.02}}))
        self.assertLess(piece_of(elastic)["E_len_max"], 1e-12)  # of the two curves
        self.assertLess(piece_of(elastic)["energy_rigid"], 0.95 * piece_of(exact)["energy_rigid"])
        factors = {}
        for wire in elastic.wires:
            for a, b in zip(wire.vertices, wire.vertices[1:]) if wire.boundary else ():
                quarter = (a % 13 + b % 13 > 10, a // 13 + b // 13 > 18)  # that the curves divide it into
                factors.setdefault(quarter, []).append(
                    np.linalg.norm(elastic.positions[a] - elastic.positions[b]) / np.linalg.norm(points[a] - points[b]))
        self.assertEqual(len(factors), 4)
        for found in factors.values():
            self.assertLess(np.ptp(found), 1e-12)
            self.assertTrue(1e-4 < abs(found[0] - 1) <= 0.02 + 1e-12)


class DartLegs(command.WordsTest):
    SIZE = 12
    # From the border and inside, both where the surface is not symmetric.
    DARTS = [sf.Curve([13 * j + 4 for j in range(7)], "dart", "mouth"),
             sf.Curve([13 * j + 8 for j in range(5, 11)], "dart", "fish-eye")]

    def flatten(self, legs, *more, darts=None, scheme="isometric"):
        with quiet():
            return sf.flatten(*shell(self.SIZE, self.SIZE, 0.5), [*(darts or self.DARTS), *more], dart_legs=legs, scheme=scheme)

    def legs(self, result, name):
        return [result.positions[wire.vertices] for wire in result.wires if wire.name == name]

    def miss(self, one, other):
        """How far a point of one leg is from its partner on the other, folded along the line from the tip."""
        tip = one[-1]
        axis = (one[0] + other[0]) / 2 - tip
        axis /= np.linalg.norm(axis)
        way = one - tip
        return np.linalg.norm(tip + 2 * np.outer(way @ axis, axis) - way - other, axis=1).max()

    def test_they_are_mirror_images_in_every_scheme_that_keeps_lengths_unless_they_are_free(self):
        free_ = self.flatten("free")
        self.assertEqual(free_.report["status"], "Ok")
        self.assertGreater(self.miss(*self.legs(free_, "mouth")), 1e-3)
        for scheme in ("isometric", "global", "progressive"):
            for legs in ("straight", "mirrored"):
                result = self.flatten(legs, scheme=scheme)
                for name in ("mouth", "fish-eye"):
                    self.assertLess(self.miss(*self.legs(result, name)), 1e-9)
                self.assertLess(piece_of(result)["E_len_max"], 1e-9)

    def test_straight_legs_are_straight_and_a_dart_with_two_tips_stays_open(self):
        result = self.flatten("straight")
        for leg in self.legs(result, "mouth"):
            chord = (leg[-1] - leg[0]) / np.linalg.norm(leg[-1] - leg[0])
            self.assertLess(np.abs(cross(chord, leg - leg[0])).max(), 1e-9)
        one, other = self.legs(result, "fish-eye")
        self.assertGreater(np.linalg.norm(one[2] - other[2]), 1e-3)

    def test_mirrored_legs_are_the_mean_of_free_ones(self):
        def turns(legs):
            for leg in self.legs(self.flatten(legs), "mouth"):
                steps = np.diff(leg @ (1, 1j))
                yield np.angle(steps[1:] / steps[:-1])

        one, other = turns("free")
        for found, expected in zip(turns("mirrored"), ((one - other) / 2, (other - one) / 2), strict=True):
            np.testing.assert_allclose(found, expected, atol=1e-9)

    def test_a_dart_that_branches_keeps_free_legs_and_is_named(self):
        result = self.flatten("straight", darts=[
            sf.Curve([13 * j + 4 for j in range(7)], "dart", "stem"), sf.Curve([43, 44, 45], "dart", "branch"),
            sf.Curve([13 * j + 9 for j in range(5)], "dart", "other")])
        self.assertIn('"stem"', piece_of(result)["fallbacks"])
        self.assertNotIn('"other"', piece_of(result)["fallbacks"])
        self.assertLess(self.miss(*self.legs(result, "other")), 1e-9)

    def test_keys_are_not_given_up_for_legs(self):
        # The key crosses the dart's mouth and forbids what straight legs would need.
        result = self.flatten("straight", sf.Curve(range(13), "key", "row"))
        self.assertEqual(result.report["status"], "Ok", result.report["message"])
        self.assertFalse(result.report["curves"][2].get("released"))


class ClosedCuts(unittest.TestCase):
    """Cones cut from the rim to the apex, which is vertex 0 and may be surrounded by more than a whole turn."""

    SPOKES = 24

    def directions(self, angle):
        """From the apex, on a circular cone or on one that waves up and down, so that they surround it by an angle."""
        turn = 2 * np.pi * np.arange(self.SPOKES) / self.SPOKES
        low, high = -10.0, 10.0
        for _ in range(60):
            middle = 0.5 * (low + high)
            way = np.column_stack([np.cos(turn), np.sin(turn), -middle + 0 * turn if middle < 0 else middle * np.sin(2 * turn)])
            way /= np.linalg.norm(way, axis=1)[:, None]
            narrow = np.arccos((way * np.roll(way, -1, axis=0)).sum(axis=1)).sum() < angle
            low, high = (middle, high) if narrow else (low, middle)
        return way

    def surface(self, *angles):
        """Rings at the distances 1, 2, ... seen from the apex under these angles, and the cut."""
        count = self.SPOKES
        points = np.vstack([np.zeros((1, 3)), *(ring * self.directions(angle) for ring, angle in enumerate(angles, 1))])
        triangles = [(0, 1 + k, 1 + (k + 1) % count) for k in range(count)]
        for ring in range(len(angles) - 1):
            for k in range(count):
                a, b = 1 + ring * count + k, 1 + ring * count + (k + 1) % count
                triangles += [(a, a + count, b + count), (a, b + count, b)]
        return points, triangles, [sf.Curve([0, *range(1, len(points), count)], "dart", "slit")]

    def flatten(self, *angles, **options):
        """The result, and which pairs of edges are closed."""
        with quiet():
            result = sf.flatten(*self.surface(*angles), dart_legs="free", **options)
        closed = result.to_polydata().GetFieldData().GetArray("SeamClosed")
        return result, np.array([closed.GetValue(k) for k in range(closed.GetNumberOfTuples())] if closed else [], bool)

    def test_a_saddle_cone_cut_to_its_apex_overlaps_unless_the_cut_is_closed(self):
        # Around the apex there are 6.6 radians, in the plane 2 pi at the most.
        for scheme in ("progressive", "global", "isometric"):
            open_, _ = self.flatten(6.6, 6.6, 6.6, 6.6, scheme=scheme)
            self.assertEqual((open_.report["status"], open_.report["curves"][0]["closed_length"]), ("Overlap", 0))
            self.assertIn('"slit"', open_.report["message"])
            self.assertTrue(all(wire.boundary for wire in open_.wires))
            shut, _ = self.flatten(6.6, 6.6, 6.6, 6.6, scheme=scheme, close_cuts=True)
            self.assertEqual(shut.report["status"], "Ok", shut.report["message"])
            self.assertAlmostEqual(shut.report["curves"][0]["closed_length"], 4, 12)
            self.assertEqual([wire.boundary for wire in shut.wires], [wire.curve != 0 for wire in shut.wires])
            self.assertEqual(sum(wire.curve == 0 for wire in shut.wires), 2)
            self.assertEqual(piece_of(shut)["vertices"], piece_of(open_)["vertices"])
            for one, other in ((0, 2), (1, 3)):
                np.testing.assert_array_equal(
                    shut.positions[shut.seam_pairs[:, one]], shut.positions[shut.seam_pairs[:, other]])
            self.assertLess(piece_of(shut)["E_len_max"], 1e-12)

    def test_a_cut_is_closed_only_where_its_sides_cross(self):
        open_, shut = (self.flatten(5.5, 5.5, 5.5, 5.5, close_cuts=close)[0] for close in (False, True))
        self.assertEqual((shut.report["status"], shut.report["curves"][0]["closed_length"]), ("Ok", 0))
        np.testing.assert_array_equal(shut.positions, open_.positions)
        # The inner rings ask for an open cut, the outer ones for more cloth than there is.
        angles = (5.6, 5.6, 6.6, 7.4, 7.8)
        self.assertEqual(self.flatten(*angles)[0].report["status"], "Overlap")
        shut, _ = self.flatten(*angles, close_cuts=True)
        curve, = shut.report["curves"]
        self.assertEqual(shut.report["status"], "Ok", shut.report["message"])
        self.assertTrue(0 < curve["closed_length"] < curve["length_3d"])
        self.assertLess(piece_of(shut)["E_len_max"], 1e-12)
        # Nothing of a closed cut is left in a filter for its next run.
        filter_ = sf.vtkWireWarpingFilter()
        filter_.SetInputData(sf.make_surface(*self.surface(*angles)[:2]))
        filter_.SetCurvesData(sf.make_curves(self.surface(*angles)[2], self.surface(*angles)[0]))
        for close in (False, True, True, False):
            filter_.SetCloseCuts(close)
            filter_.SetDartLegsToFree()
            filter_.Update()
            np.testing.assert_array_equal(points_of(filter_.GetOutput())[:, :2],
                                          self.flatten(*angles, close_cuts=close)[0].positions)

    def test_where_only_the_mouth_crosses_no_two_fans_of_triangles_are_held_together_at_a_vertex(self):
        overlapping = 0
        for inner in np.arange(4.5, 6.2, 0.2):
            for outer in np.arange(6.4, 9.5, 0.2):
                angles = (*[inner] * 4, outer)
                if self.flatten(*angles)[0].report["status"] == "Ok":
                    continue
                overlapping += 1
                shut, closed = self.flatten(*angles, close_cuts=True)
                self.assertEqual(shut.report["status"], "Ok", shut.report["message"])
                # A closed pair of vertices has a closed edge beside it.
                beside = set(shut.seam_pairs[closed, :4].ravel())
                for a, b, c, d, _ in shut.seam_pairs:
                    for one, other in ((a, c), (b, d)):
                        if one != other and (shut.positions[one] == shut.positions[other]).all():
                            self.assertIn(one, beside)
        self.assertGreaterEqual(overlapping, 8)


class Arrangement(unittest.TestCase):
    def test_the_long_side_of_the_smallest_rectangle_is_upright_wherever_the_surface_was(self):
        points, triangles = grid(7, 2)
        for angle in (0.0, 0.4, 1.3, 3.0):
            turned = points @ [[np.cos(angle), np.sin(angle), 0], [-np.sin(angle), np.cos(angle), 0], [0, 0, 1]] + (8, 9, 0)
            flat = sf.flatten(turned, triangles).positions
            np.testing.assert_allclose([flat.min(axis=0), flat.max(axis=0)], [(0, 0), (2, 7)], atol=1e-12)
            self.assertLess(flat[0, 1], 1)  # the first vertex is below
        one, other = (sf.flatten(places, cone(9, 4)[1]).positions for places in (cone(9, 4)[0], moved_rigidly(cone(9, 4)[0])))
        np.testing.assert_allclose(one, other, atol=1e-10)

    def test_pieces_fill_rows_rather_than_one_line(self):
        points, triangles = grid(1, 1)
        places, corners = command.together(*[(points.tolist(), triangles.tolist())] * 60)
        width, height = np.ptp(sf.flatten(places, corners, spacing=0.1).positions, axis=0)
        self.assertTrue(1 / 3 < width / height < 3)


if __name__ == "__main__":
    unittest.main()
