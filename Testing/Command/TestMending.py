# SPDX-License-Identifier: BSD-3-Clause
"""Surfaces with the blemishes that modellers and scanners leave: mended with a line, or named with the option
that mends them."""
import itertools
import math
import re

import command

SIZE = 10
at = command.grid_ids(SIZE)


def dome():
    """SIZE x SIZE squares of 3 cm over a shallow dome, in cm."""
    return command.grid(
        SIZE, SIZE, lambda i, j: (3.0 * i, 3.0 * j, -0.01 * ((3.0 * i - 15) ** 2 + (3.0 * j - 15) ** 2)))


def thick(points, triangles, depth):
    """The surface, another one below it, and the rim between them."""
    count = len(points)
    sides = {(t[k], t[(k + 1) % 3]) for t in triangles for k in range(3)}
    rim = [t for a, b in sides if (b, a) not in sides for t in ((b, a, a + count), (b, a + count, b + count))]
    return (points + [(x, y, z - depth) for x, y, z in points],
            triangles + [tuple(v + count for v in reversed(t)) for t in triangles] + rim)


class Mending(command.CommandTest):
    def setUp(self):
        super().setUp()
        self.points, self.triangles = dome()
        self.write("good.obj", command.obj(self.points, self.triangles))

    def flattened(self, points, triangles, *options):
        """The report, and what the command warned of."""
        self.write("bad.obj", command.obj(points, triangles))
        unit = () if "--unit" in options else ("--unit", "cm")
        run = self.run_command(*options, "bad.obj", *unit, "--output", "out", code=0)
        report = self.report("out")
        self.assertEqual(report["status"], "Ok")
        prefix = "wirewarp: warning: "
        self.assertEqual([line[len(prefix):] for line in run.stderr.splitlines()], report["warnings"])
        return report, report["warnings"]

    def assert_whole(self, report, triangles):
        """As the good surface is, but for the diagonals of a square or two."""
        good = self.flatten("good.obj", "--unit", "cm")
        self.assertEqual(len(report["pieces"]), 1)
        piece = report["pieces"][0]
        self.assertEqual(piece["triangles"], triangles)
        for key in ("width_mm", "height_mm"):
            self.assertAlmostEqual(report["sizes"][0][key], good["sizes"][0][key], delta=0.2)
        self.assertAlmostEqual(piece["E_area"], good["pieces"][0]["E_area"], delta=1e-3)

    def test_of_a_good_surface_of_triangles_or_quads_nothing_is_said(self):
        quads = [(at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)) for j in range(SIZE) for i in range(SIZE)]
        for cells in (self.triangles, quads):
            report, warnings = self.flattened(self.points, cells)
            self.assertEqual(warnings, [])
            self.assert_whole(report, 2 * SIZE * SIZE)

    def split_by_a_texture_seam(self):
        """Points of the column in the middle twice, for left and right."""
        column = {at(5, j): len(self.points) + j for j in range(SIZE + 1)}
        points = self.points + [self.points[v] for v in column]
        triangles = [tuple(column.get(v, v) for v in t) if k % (2 * SIZE) >= SIZE else t
                     for k, t in enumerate(self.triangles)]
        return points, triangles

    def test_doubled_points_are_named_with_the_option_that_joins_them(self):
        points, triangles = self.split_by_a_texture_seam()
        report, (warning,) = self.flattened(points, triangles)
        self.assertEqual(len(report["pieces"]), 2)
        self.assert_words(("20 edges of the boundary lie on each other", "--weld"), warning)
        report, warnings = self.flattened(points, triangles, "--weld")
        self.assertEqual(warnings, ["11 points are joined with one that it lies on, as --weld asks"])
        self.assert_whole(report, 2 * SIZE * SIZE)

    def test_doubled_points_are_joined_where_cuts_are_proposed(self):
        points, triangles = thick(self.points, self.triangles, 2.0)
        sheets = [triangles[:len(self.triangles)], triangles[len(self.triangles):2 * len(self.triangles)],
                  triangles[2 * len(self.triangles):]]
        doubled = [(k, points[v]) for k, sheet in enumerate(sheets) for v in sorted({v for t in sheet for v in t})]
        place = {entry: at_ for at_, entry in enumerate(doubled)}
        apart = [tuple(place[k, points[v]] for v in t) for k, sheet in enumerate(sheets) for t in sheet]
        self.write("apart.obj", command.obj([point for _, point in doubled], apart))
        cut = ("cut", "apart.obj", "--unit", "cm", "--max-work", "5", "--output", "cuts.vtp")
        note = f"{8 * SIZE} points are joined with one that it lies on, as most of the boundary does"
        self.assertIn(note, self.run_command(*cut, code=(0, 4)).stderr)
        self.assertNotIn("points are joined", self.run_command(*cut, "--no-weld", code=(0, 4)).stderr)

    def test_defects_are_healed_and_refused_on_request(self):
        top = len(self.points)
        points = [*self.points, (12.0, 12.0, 9.0), (-3.0, 3.0, 0.0), (-3.0, 6.0, 0.0)]
        triangles = [*self.triangles, self.triangles[30][::-1], (at(4, 4), at(4, 5), top), (at(0, 2), top + 2, top + 1)]
        report, warnings = self.flattened(points, triangles)
        count = len(self.triangles)
        self.assertEqual(warnings, [
            f"1 triangle with the corners of another was taken out ({count})",
            f"1 triangle standing on an edge of others was taken out ({count + 1})",
            f"1 point in which parts touch was doubled ({at(0, 2)})"])
        self.assertEqual([piece["triangles"] for piece in report["pieces"]], [count, 1])
        report = self.flatten("bad.obj", "--no-heal", "--unit", "cm", code=3)
        self.assertEqual((report["status"], report["ids"]), ("NonManifoldEdge", [count]))
        # The same in proposals, and in what check says and writes.
        self.assert_stderr(warnings[0], "cut", "bad.obj", "--unit", "cm", "--output", "cuts.vtp", code=0)
        self.run_command("cut", "bad.obj", "--unit", "cm", "--no-heal", "--output", "cuts.vtp", code=3)
        self.assert_stderr(warnings[2], "check", "bad.obj", "--unit", "cm", "--output", "healed.vtp", code=0)
        healed = self.flatten("healed.vtp", "--unit", "cm")
        self.assertEqual(healed["warnings"], [])
        self.assertEqual([piece["triangles"] for piece in healed["pieces"]], [count, 1])

    def test_sheets_that_meet_in_a_line_are_separated_where_cuts_are_proposed(self):
        spine = [(0.0, 3.0 * j, 0.0) for j in range(4)]
        points, pages = list(spine), []
        for angle in (0, 120, 240):
            turn = math.radians(angle)
            rows = [[0, 1, 2, 3]]
            for r in (3.0, 6.0, 9.0):
                rows.append([len(points) + j for j in range(4)])
                points += [(r * math.cos(turn), y, r * math.sin(turn)) for _, y, _ in spine]
            for near, far in zip(rows, rows[1:]):
                for j in range(3):
                    pages += [(near[j], near[j + 1], far[j + 1]), (near[j], far[j + 1], far[j])]
        self.write("pages.obj", command.obj(points, pages))
        report = self.flatten("pages.obj", "--unit", "cm", code=3)
        self.assertEqual((report["status"], report["ids"]), ("NonManifoldEdge", [0, 18, 36]))
        warning = "the surface was separated at 3 edges of more than two triangles (0-1, 1-2, 2-3)"
        self.assert_stderr(warning, "cut", "pages.obj", "--unit", "cm", "--output", "cuts", code=0)
        self.assertEqual(len(self.report("cuts")["pieces"]), 3)
        self.assert_stderr(warning, "check", "pages.obj", "--unit", "cm", "--output", "healed.vtp", code=0)
        self.assertEqual(len(self.flatten("healed.vtp", "--unit", "cm")["pieces"]), 3)

    def area(self):
        """Of the flat surface as it was flattened."""
        x = self.array("out/cut.vtp", "Points")
        ids = self.array("out/cut.vtp", "connectivity", "Polys")
        corners = [[(x[3 * v], x[3 * v + 1]) for v in ids[k:k + 3]] for k in range(0, len(ids), 3)]
        return sum(abs((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])) for a, b, c in corners) / 2

    def strip(self, wedge):
        """Quads of 10 x 10 in rows, with a column of no width, or of quads that open like wedges."""
        columns = [10.0 * i for i in range(13)]
        at_bottom, at_top = columns[:7] + columns[6:], columns[:7] + [columns[6] + 2.5 * wedge] + columns[7:]
        count = len(at_bottom)
        points = [(x + (y - x) * j / 4, 10.0 * j, 0.0) for j in range(5) for x, y in zip(at_bottom, at_top)]
        quads = [(j * count + i, j * count + i + 1, (j + 1) * count + i + 1, (j + 1) * count + i)
                 for j in range(4) for i in range(count - 1)]
        return points, quads

    def test_quads_without_width_are_taken_out_and_no_area_is_lost(self):
        for wedge, options, turned in itertools.product((False, True), ((), ("--weld",)), (False, True)):
            with self.subTest(wedge=wedge, options=options, turned=turned):
                points, quads = self.strip(wedge)
                quads = [quad[2:] + quad[:2] for quad in reversed(quads)] if turned else quads
                report, warnings = self.flattened(points, quads, *options)
                self.assertEqual(len(report["pieces"]), 1)
                self.assertAlmostEqual(self.area() / (120 * 40), 1.0, delta=1e-12)
                mended, = [line for line in warnings if "without area" in line]
                self.assertIn(f"{1 if wedge else 8} triangle", mended)

    def test_loose_triangles_in_one_place_are_left_out(self):
        for count, first in ((1, False), (40, True)):
            with self.subTest(count=count, first=first):
                loose = [tuple(len(self.points) + 3 * k + i for i in range(3)) for k in range(count)]
                points = self.points + [(7.0 * k, 9.0, 0.0) for k in range(count) for _ in range(3)]
                report, warnings = self.flattened(points, loose + self.triangles if first else self.triangles + loose)
                self.assertEqual([piece["triangles"] for piece in report["pieces"]], [2 * SIZE * SIZE])
                cell = 0 if first else len(self.triangles)
                self.assertRegex(warnings[0], rf"^{count} triangles? without area w(as|ere) taken out \((first: )?{cell}\b")

    def test_boundaries_that_run_beside_each_other_are_named_with_the_length_that_joins_them(self):
        points, triangles = self.split_by_a_texture_seam()
        for unit, millimetres in (("mm", 1.0), ("cm", 10.0), ("m", 1000.0)):
            for gap in (2e-3, 1e-2):  # in units of the surface, which is 30 large
                with self.subTest(unit=unit, gap=gap):
                    apart = points[:len(self.points)] + [(x + gap, y, z) for x, y, z in points[len(self.points):]]
                    report, warnings = self.flattened(apart, triangles, "--unit", unit)
                    self.assertEqual(len(report["pieces"]), 2)
                    (line,) = [row for row in warnings if "beside another one" in row]
                    length = float(re.search("--weld ([0-9.e+-]+) joins", line)[1])
                    self.assertGreaterEqual(length, gap * millimetres)
                    self.assertLess(length, 1.2 * gap * millimetres)
                    for given in (("--weld", f"{length:.17g}"), ("--weld", f"{length:.17g}mm"),
                                  (f"--weld={length / 10:.17g}cm",)):
                        report, warnings = self.flattened(apart, triangles, *given, "--unit", unit)
                        self.assertEqual([piece["triangles"] for piece in report["pieces"]], [2 * SIZE * SIZE])
                        self.assertIn("11 points are joined", "".join(warnings))
                    report, warnings = self.flattened(apart, triangles, "--weld", "--unit", unit)
                    self.assertEqual(len(report["pieces"]), 2)
        # What is longer than edges joins no ends of one, and what is longer than the surface nothing.
        report, _ = self.flattened(self.points, self.triangles, "--weld", "29mm")
        self.assertEqual(report["pieces"][0]["triangles"], 2 * SIZE * SIZE)
        for text, code in (("1000", 3), ("-1", 2), ("3furlongs", 2), ("nan", 2)):
            self.assert_stderr("--weld", f"--weld={text}", "bad.obj", "--unit", "cm", "--output", "out", code=code)

    def test_curves_that_name_points_keep_their_meaning(self):
        points, triangles = self.split_by_a_texture_seam()
        self.write("bad.obj", command.obj(points, triangles))
        # The last of these points is one that is joined to another.
        self.write("curve.txt", f"accessory c {at(2, 5)} {at(3, 5)} {at(4, 5)} {len(self.points) + 5}\n")
        curve = self.flatten("bad.obj", "curve.txt", "--weld")["curves"][0]
        self.assertAlmostEqual(curve["length_3d"], sum(
            math.dist(self.points[at(i, 5)], self.points[at(i + 1, 5)]) for i in (2, 3, 4)), delta=1e-12)

    def test_missing_triangles_are_named_and_filled(self):
        missing = {(at(5, 5), at(6, 5), at(6, 6)), (at(2, 7), at(3, 8), at(2, 8)), (at(2, 7), at(3, 7), at(3, 8))}
        triangles = [t for t in self.triangles if t not in missing]
        self.assertEqual(len(triangles), 2 * SIZE * SIZE - 3)
        # Openings of 4.3 cm, a twentieth of the diagonal here is 2.1: they may be meant.
        self.assertEqual(self.flattened(self.points, triangles)[1], [])
        report, warnings = self.flattened(self.points, triangles, "--fill-holes", "50")
        self.assertEqual(warnings, ["2 openings filled, as --fill-holes asks"])
        self.assert_whole(report, 2 * SIZE * SIZE)
        report, warnings = self.flattened(self.points, triangles, "--fill-holes", "10")
        self.assertEqual(warnings, ["--fill-holes found no opening so small"])
        self.assertEqual(report["pieces"][0]["triangles"], len(triangles))

    def test_an_opening_that_looks_like_a_missing_triangle_is_filled_as_its_line_says(self):
        a, b, c = at(5, 5), at(6, 5), at(6, 6)
        m = len(self.points)
        # A triangle about the centre of another, a third of its size, is missing.
        centre = [sum(self.points[v][k] for v in (a, b, c)) / 3 for k in range(3)]
        fine = self.points + [
            tuple(centre[k] + (self.points[v][k] - centre[k]) / 3 for k in range(3)) for v in (a, b, c)]
        triangles = [t for t in self.triangles if t != (a, b, c)]
        triangles += [(a, b, m), (m, b, m + 1), (b, c, m + 1), (m + 1, c, m + 2), (c, a, m + 2), (m + 2, a, m)]
        _, (warning,) = self.flattened(fine, triangles)
        self.assertIn("1 small opening", warning)
        across = math.hypot(10, 10, 0.6)  # mm, a third of a square of 3 cm; the dome's height hardly counts
        words = re.search(r"the largest ([0-9.]+) mm across.*(--fill-holes) ([0-9]+) closes it", warning)
        self.assertAlmostEqual(float(words[1]), across, delta=0.2)
        report, warnings = self.flattened(fine, triangles, words[2], words[3])
        self.assertEqual(warnings, ["1 opening filled, as --fill-holes asks"])
        self.assert_whole(report, len(triangles) + 1)

    def test_of_a_sheet_with_thickness_the_outer_side_is_taken(self):
        points, triangles = thick(self.points, self.triangles, 0.2)
        refusal = self.flatten(self.write("bad.obj", command.obj(points, triangles)), code=3)
        self.assertEqual(refusal["status"], "ClosedSurface")
        self.assertIn("--outer-side", refusal["message"])
        report, warnings = self.flattened(points, triangles, "--outer-side")
        self.assertEqual(warnings, [f"of {len(triangles)} triangles the {2 * SIZE * SIZE} of the outer side are "
                                    "kept, as --outer-side asks"])
        self.assert_whole(report, 2 * SIZE * SIZE)
        _, warnings = self.flattened(self.points, self.triangles, "--outer-side")
        self.assertEqual(warnings, ["--outer-side found no closed sheet with two sides"])

    def test_the_outer_side_of_a_sheet_is_taken_where_cuts_are_proposed(self):
        cap = [(x, y, -0.02 * (x * x + y * y)) for x, y in ((x - 15.0, y - 15.0) for x, y, _ in self.points)]
        self.write("bowl.obj", command.obj(*thick(cap, self.triangles, 0.2)))
        cut = ("cut", "bowl.obj", "--unit", "cm", "--max-work", "5", "--output", "cuts.vtp")
        words = (f"the {2 * SIZE * SIZE} of the outer side are kept, since the surface is a sheet", "mm thick; --no-outer-side")
        self.assert_words(words, self.run_command(*cut, code=(0, 4)).stderr)
        self.run_command(*cut[:-1], "whole", code=(0, 4))
        # Cuts that were proposed are laid into what they were proposed for.
        strains = [[piece["strain_p95"] for piece in report["pieces"]]
                   for report in (self.report("whole"), self.flatten("bowl.obj", "cuts.vtp", "--unit", "cm", code=(0, 4)))]
        self.assertEqual(*strains)
        self.assertNotIn("outer side", self.run_command(*cut, "--no-outer-side", code=(0, 4)).stderr)

    def test_of_two_sided_faces_one_is_taken_where_cuts_are_proposed(self):
        count = len(self.points)
        back = [(a + count, c + count, b + count) for a, b, c in self.triangles]
        mixed = [t for pair in zip(back, self.triangles) for t in pair]
        for doubled in (self.triangles + back, mixed):
            self.write("two.obj", command.obj(self.points + self.points, doubled))
            cut = ("cut", "two.obj", "--unit", "cm", "--max-work", "5", "--output", "two")
            stderr = self.run_command(*cut).stderr
            self.assertIn(f"{len(back)} triangles that lie on others are left out, as the back of two-sided faces", stderr)
            self.assert_whole(self.report("two"), len(back))
        self.assertNotIn("two-sided", self.run_command(*cut, "--no-outer-side", code=(0, 4)).stderr)
        self.assertEqual(len(self.report("two")["pieces"]), 2)

    def test_mends_take_effect_in_stl(self):
        self.write("cut.stl", command.stl(self.points, [t for t in self.triangles if at(5, 5) not in t]))
        report = self.flatten("cut.stl", "--unit", "cm", "--fill-holes", "100")
        self.assertEqual(report["warnings"], ["1 opening filled, as --fill-holes asks"])
        self.assertEqual(report["pieces"][0]["triangles"], 2 * SIZE * SIZE - 2)


command.main()
