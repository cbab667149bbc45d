# SPDX-License-Identifier: BSD-3-Clause
"""Smooth borders, measured again in SVG, DXF and the walk by code of its own."""

import os
import re
import resource
import unittest

import numpy as np
from vtkmodules.vtkCommonTransforms import vtkTransform
from vtkmodules.vtkFiltersGeneral import vtkTransformPolyDataFilter
from vtkmodules.vtkIOXML import vtkXMLPolyDataWriter

import pattern_files as pattern

TOLERANCE = 1.0  # the meshes of Data have chords of 20 mm


def place_at(curves, length):
    """The point of Bezier curves at a length from their start."""
    for curve in curves:
        whole = pattern.bezier_length(curve)
        if length <= whole or curve is curves[-1]:
            break
        length -= whole
    low, high = 0.0, 1.0
    for _ in range(50):
        middle = (low + high) / 2
        short = pattern.bezier_length(first_part(curve, middle)) < length
        low, high = (middle, high) if short else (low, middle)
    return first_part(curve, low)[-1]


def first_part(curve, share):
    """After de Casteljau."""
    part, rest = [], curve
    while len(rest):
        part.append(rest[0])
        rest = (1 - share) * rest[:-1] + share * rest[1:]
    return np.array(part)


class Fair(pattern.PatternTest):
    def paths(self):
        root = self.svg()
        return root, [(number, element) for number, group in enumerate(pattern.pieces_of(root)) for layer in group
                      for element in layer.findall(pattern.SVG + "path") if element.get("data-length")]

    def test_borders_of_fifty_metres_with_hundreds_of_notches_take_a_bounded_time(self):
        def seconds():
            used = resource.getrusage(resource.RUSAGE_CHILDREN)
            return used.ru_utime + used.ru_stime

        for piece, unit, tolerance, spacing in (("shirt_front", "m", "50", "100"), ("pants_front", "m", "0.2", "60"),
                                                ("tshirt", "cm", "0.2", "1")):
            with self.subTest(piece):
                begin = seconds()
                self.make(piece, "-o", "out/pattern.svg", "--smooth", tolerance, "--notch-spacing", spacing, unit=unit)
                self.assertLess(seconds() - begin, 40.0)

    def test_every_curve_of_the_svg_has_its_length_on_the_surface(self):
        for piece in ("tshirt", "shirt_front", "shoe_upper"):
            with self.subTest(piece):
                self.make(piece, "-o", "out/pattern.svg", "--smooth", str(TOLERANCE))
                self.assert_lengths_are_kept()
                self.assertTrue(any("C" in element.get("d") for _, element in self.paths()[1]))

    def test_each_notch_lies_on_its_curve_at_its_length(self):
        self.make("tshirt", "-o", "out/pattern.svg", "--smooth", str(TOLERANCE), "--notch-spacing", "70")
        root, paths = self.paths()
        measured = {}
        for piece, notch, points, _ in pattern.svg_paths(root, "notch"):
            name, arc = notch.get("data-curve"), float(notch.get("data-arc-length"))
            # A notch points from the cut line to its foot on the sew line.
            start, end = map(np.array, points)
            way = (end - start) / np.linalg.norm(end - start)
            beside = []
            for number, element in paths:
                if number == piece and element.get("data-curve") == name:
                    off = place_at(pattern.curves_of(element), arc) - start
                    beside.append(abs(way[0] * off[1] - way[1] * off[0]))
            self.assertLess(min(beside), 1e-5, (name, arc))
            measured.setdefault(name, []).append(round(arc, 6))
        seams = {wire.name: sum(wire.edges) for wire in pattern.wires_in_space(self.path("out"), "cm")
                 if wire.kind == pattern.SEAM}
        self.assertEqual(set(measured), set(seams))
        for name, length in seams.items():
            at = sorted(set(measured[name]))
            self.assertEqual(sorted(measured[name]), sorted(2 * at), name)  # on both sides
            if length > 87.5:
                self.assertEqual(at, [70.0 * (k + 1) for k in range(len(at))])
                self.assertLess(length - at[-1], 87.5 + 1e-6)
            else:
                self.assertAlmostEqual(at[0], length / 2, places=5)

    def test_the_dxf_keeps_lengths_with_few_curve_points(self):
        self.make_raw("tshirt", "-o", "out/pattern.dxf", "-o", "out/pattern.svg")
        raw = self.curve_points()
        self.make("tshirt", "-o", "out/pattern.dxf", "-o", "out/pattern.svg", "--smooth", str(TOLERANCE))
        self.assertLess(2 * self.curve_points(), raw)
        _, paths = self.paths()
        for number, block in enumerate(self.dxf()[1]):
            lines = pattern.block_lines(block, "8", "14")
            found = sorted(sum(pattern.edge_lengths(points, closed)) for points, closed in lines)
            wanted = sorted(float(element.get("data-length")) for piece, element in paths if piece == number)
            self.assertEqual(len(found), len(wanted))
            for a, b in zip(found, wanted):
                self.assertLess(abs(a - b), 0.05 * max(1.0, b / 100.0))  # of each 100 mm

    def misses(self):
        """By pieces, how far control points of sew lines and legs are from the image of others of them, at the
        axis of their second moments, which is one of symmetry if there is any."""
        control = {}
        root = self.svg()
        for kind in ("sew-line", "dart-leg"):
            for piece, element in pattern.svg_elements(root, kind):
                control.setdefault(piece, []).extend(pattern.curves_of(element))

        def miss(points, normal):
            return max(np.linalg.norm(points - (p - 2 * (p @ normal) * normal), axis=1).min() for p in points)
        misses = []
        for curves in control.values():
            points = np.vstack(curves)
            points -= points.mean(axis=0)
            _, axes = np.linalg.eigh(points.T @ points)
            misses.append(min(miss(points, normal) for normal in axes.T))
        return misses

    def assert_lengths_are_kept(self):
        wires = pattern.wires_in_space(self.path("out"), "cm")
        _, paths = self.paths()
        wanted = sorted(sum(wire.edges) for wire in wires)
        found = sorted(sum(map(pattern.bezier_length, pattern.curves_of(element))) for _, element in paths)
        self.assertEqual(len(found), len(wanted))
        for a, b in zip(found, wanted):
            self.assertLess(abs(a - b), 1e-6)

    def test_outlines_of_symmetric_pieces_are_mirror_images_in_the_file(self):
        for piece in ("wetsuit_upper_front", "shirt_front", "wetsuit_pants_back"):
            with self.subTest(piece):
                self.make(piece, "-o", "out/pattern.svg", "--symmetrize")
                self.assertLess(max(self.misses()), 1e-3)
                self.assert_lengths_are_kept()
        self.make("wetsuit_pants_back", "-o", "out/pattern.svg")
        self.assertGreater(max(self.misses()), 0.1)

    def test_lengths_are_kept_however_a_surface_lies_in_space(self):
        # Other rounding leads the search for few curves by other ways: one had hidden 5 mm in a fold.
        for angle in (10, 33, 123, 200):
            turn = vtkTransform()
            turn.RotateX(angle)
            turn.RotateY(2.3 * angle)
            turn.RotateZ(1.7 * angle)
            for name in ("shirt_front.vtp", "shirt_front_curves.vtp"):
                turned = vtkTransformPolyDataFilter()
                turned.SetTransform(turn)
                turned.SetInputData(pattern.read_file(os.path.join(pattern.DATA, name)))
                writer = vtkXMLPolyDataWriter()
                writer.SetFileName(self.path(name))
                writer.SetInputConnection(turned.GetOutputPort())
                writer.Write()
            with self.subTest(angle):
                self.make(self.path("shirt_front"), "-o", "out/pattern.svg", "--symmetrize")
                self.assert_lengths_are_kept()

    def test_a_symmetric_piece_strained_by_too_much_is_nearer_to_its_points_and_stays_symmetric(self):
        self.make("shirt_shoulder", "-o", "out/pattern.svg", "--smooth", "0.5", "--symmetrize")
        self.assertLess(max(self.misses()), 1e-3)
        self.assertRegex("\n".join(self.notes()), r"kept within [5-9]\d(\.\d)? % of the tolerance")

    def test_what_was_made_symmetric_is_told_piece_by_piece(self):
        self.make("tshirt", "-o", "out/pattern.svg", "--symmetrize")
        told = [note for note in self.notes() if "its own mirror image" in note]
        self.assertEqual(len(told), 4)
        missed = r"not drawn as its own mirror image: mirrored, it misses itself by \d\.\d+ mm"
        for piece, words in enumerate(2 * ["drawn as its own mirror image"] + 2 * [missed], 1):  # the caps of sleeves
            self.assertRegex("\n".join(told), f"(?m)^piece tshirt {piece}: its outline is {words}")
        self.make("quarter_sphere", "-o", "out/pattern.svg", "--symmetrize")
        self.assertIn("not drawn as its own mirror image: it would strain", "\n".join(self.notes()))

    def curve_points(self):
        """On sew lines and feature curves; the cut line is another line."""
        count = 0
        for block in self.dxf()[1]:
            ((cut, _),) = pattern.block_lines(block, "1")
            corners = set(cut)
            count += sum(1 for point in block.query("POINT") if point.dxf.layer == "3"
                         and tuple(point.dxf.location)[:2] not in corners)
        return count

    def test_unless_another_distance_is_asked_for_a_pattern_is_smooth_within_a_fifth_of_a_millimetre(self):
        for piece in ("tshirt", "quarter_sphere"):
            run = self.make(piece, "-o", "out/pattern.svg", "-o", "out/pattern.dxf")
            self.assertNotIn("wirewarp: note", run.stderr)
            usual = self.content("pattern.svg"), self.content("pattern.dxf")
            found = re.findall(r"at most ([\d.]+) mm from their points, with 95 % of the area strained by no more "
                               r"than ([\d.]+) % \(([\d.]+) % before\)", "\n".join(self.notes()))
            self.assertTrue(found)
            for deviation, strain, before in found:
                self.assertLessEqual(float(deviation), 0.2)
                self.assertLessEqual(float(strain) - float(before), 0.3 + 0.01)  # of two digits each
            self.make(piece, "-o", "out/pattern.svg", "-o", "out/pattern.dxf", "--smooth", "0.2")
            self.assertEqual((self.content("pattern.svg"), self.content("pattern.dxf")), usual)
            self.make_raw(piece, "-o", "out/pattern.svg", "-o", "out/pattern.dxf")
            self.assertNotIn(b"C", b"".join(re.findall(rb' d="([^"]*)"', self.content("pattern.svg"))))
            self.assertFalse([note for note in self.notes() if "curves and" in note])

    def test_what_was_done_is_said_and_what_could_not_be_is_named(self):
        def printed(*options):
            run = self.run_command("pattern", *pattern.command.data_files("tshirt"), "--unit", "cm", "-o", "out",
                                   "-o", "out/pattern.svg", *options)
            mark = "wirewarp: note: "
            return [line[len(mark):] for line in run.stderr.splitlines() if line.startswith(mark)]

        def done(note):
            return "curves and" in note and "strained" in note

        def left(note):
            return "left as the mesh has them" in note

        for asked in ("boundary=0.001", "0.001"):
            notes = printed("--smooth", asked)
            self.assertTrue(any(map(done, notes)), notes)
            self.assertEqual(notes, self.notes())
        self.assertTrue(any(map(left, notes)))
        quiet = printed("--smooth", "0.001", "--quiet")
        self.assertEqual(quiet, list(filter(left, self.notes())))
        self.assertTrue(any(map(done, self.notes())))
        # Unasked there is no news, but in the report.
        notes = printed()
        self.assertFalse(any(done(note) or left(note) for note in notes), notes)
        self.assertTrue(any(map(done, self.notes())) and any(map(left, self.notes())))


if __name__ == "__main__":
    unittest.main()
