# SPDX-License-Identifier: BSD-3-Clause
"""Patterns measured again by programs that did not write them: an XML parser, ezdxf, poppler."""

import csv
import math
import re
import unittest

import pattern_files as pattern

PIECES = (("quarter_sphere", "m"), ("shirt_front", "cm"), ("tshirt", "inch"), ("shoe_upper", "mm"))


class Lengths(pattern.PatternTest):
    def test_every_wire_of_the_svg_has_its_length_on_the_surface(self):
        for piece, unit in PIECES:
            with self.subTest(piece):
                self.make_raw(piece, "-o", "out/pattern.svg", unit=unit)
                wires = pattern.wires_in_space(self.path("out"), unit)
                root = pattern.svg_root(self.path("out", "pattern.svg"))
                scale = pattern.svg_scale(root)
                lines = [
                    line
                    for kind in ("sew-line", "dart-leg", "key-curve", "internal")
                    for line in pattern.svg_paths(root, kind)
                ]
                self.assertEqual(len(lines), len(wires))
                for wire in wires:
                    name = wire.name if wire.kind != pattern.BOUNDARY else None
                    found = self.match(wire, name, lines)
                    lines.remove(found)
                    _, element, points, closed = found
                    edges = [scale * edge for edge in pattern.edge_lengths(points, closed)]
                    expected = sum(wire.edges)
                    self.assertLess(abs(sum(edges) - expected), 1e-6 * expected, wire.name)
                    self.assertLess(
                        abs(float(element.get("data-length")) - expected), 1e-6 * expected)
                    for edge, in_space in zip(edges, wire.edges):
                        self.assertLess(abs(edge - in_space), 1e-5 * in_space, wire.name)

    def match(self, wire, name, lines):
        """The line of a wire: its piece, its name, its number of edges, its length."""
        candidates = [
            line
            for line in lines
            if line[0] == wire.piece
            and line[1].get("data-curve") == name
            and len(line[2]) - (0 if line[3] else 1) == len(wire.edges)
        ]
        self.assertTrue(candidates, f"{wire.name} is missing")
        return min(
            candidates,
            key=lambda line: abs(sum(pattern.edge_lengths(line[2], line[3])) - sum(wire.edges)),
        )

    def test_every_edge_of_the_dxf_has_its_length_and_the_audit_finds_nothing(self):
        for piece, unit in PIECES:
            with self.subTest(piece):
                self.make_raw(piece, "-o", "out/pattern.dxf", unit=unit)
                wires = pattern.wires_in_space(self.path("out"), unit)
                document, audit = pattern.read_dxf(self.path("out", "pattern.dxf"))
                self.assertEqual(audit, [])
                self.assertEqual(document.dxfversion, "AC1009")
                # ENGLISH files are in inches, METRIC ones in millimetres.
                scale = 25.4 if unit == "inch" else 1.0
                inserts = document.modelspace().query("INSERT")
                self.assertEqual(len(inserts), 1 + max(wire.piece for wire in wires))
                for number, insert in enumerate(inserts):
                    block = document.blocks.get(insert.dxf.name)
                    lines = pattern.block_lines(block, "8", "14")
                    mine = [wire for wire in wires if wire.piece == number]
                    self.assertEqual(len(lines), len(mine))
                    # In the file wires stand in the order of wires.vtp.
                    for wire, (points, closed) in zip(mine, lines):
                        edges = pattern.edge_lengths(points, closed)
                        self.assertEqual(len(edges), len(wire.edges))
                        for edge, in_space in zip(edges, wire.edges):
                            self.assertLess(abs(scale * edge - in_space), 0.01, wire.name)

    def test_the_audit_finds_what_is_wrong(self):
        self.make_raw("quarter_sphere", "-o", "out/pattern.dxf")
        with open(self.path("out", "pattern.dxf"), encoding="ascii") as file:
            text = file.read()
        inserted = re.search("INSERT\n  5\n.*\n  8\n1\n  2\n", text).end()
        with open(self.path("broken.dxf"), "w", encoding="ascii") as file:
            file.write(text[:inserted] + "NOT_THERE_" + text[inserted:])
        self.assertNotEqual(pattern.read_dxf(self.path("broken.dxf"))[1], [])

    def test_units_are_told_and_meant(self):
        spans = {}
        for unit in pattern.MILLIMETRES:
            self.make_raw("quarter_sphere", "-o", "out/pattern.dxf", "-o", "out/pattern.svg", "--allowance", "0", unit=unit)
            document, _ = pattern.read_dxf(self.path("out", "pattern.dxf"))
            self.assertEqual((document.header["$INSUNITS"], document.header["$MEASUREMENT"]),
                             (1, 0) if unit == "inch" else (4, 1))
            texts = [text.dxf.text for text in document.modelspace().query("TEXT")]
            said = [text for text in texts if text.startswith("Units:")]
            self.assertEqual(said, ["Units: ENGLISH" if unit == "inch" else "Units: METRIC"])
            per_unit = 25.4 if unit == "inch" else 1.0
            block = document.blocks.get(document.modelspace().query("INSERT")[0].dxf.name)
            (cut, _), = pattern.block_lines(block, "1")
            spans[unit] = per_unit * (max(x for x, _ in cut) - min(x for x, _ in cut))
            root = pattern.svg_root(self.path("out", "pattern.svg"))
            (_, _, points, _), = pattern.svg_paths(root, "cut-line")
            width = pattern.svg_scale(root) * (
                max(x for x, _ in points) - min(x for x, _ in points))
            self.assertAlmostEqual(width / spans[unit], 1.0, places=6)
        # The radius of the sphere is one unit: the same shape in all of them.
        for unit, millimetres in pattern.MILLIMETRES.items():
            self.assertAlmostEqual(spans[unit] / millimetres, spans["mm"], places=6)

    def test_notches_lie_at_the_same_lengths_on_the_surface_on_both_sides(self):
        self.make_raw("tshirt", "-o", "out/pattern.svg", "--notch-spacing", "70", "--allowance", "7")
        wires = pattern.wires_in_space(self.path("out"), "cm")
        root = pattern.svg_root(self.path("out", "pattern.svg"))
        sew = pattern.svg_paths(root, "sew-line")
        seams = {wire.name: sum(wire.edges) for wire in wires if wire.kind == pattern.SEAM}
        measured = {}
        for piece, element, points, _ in pattern.svg_paths(root, "notch"):
            name = element.get("data-curve")
            said = float(element.get("data-arc-length"))
            # Where the notch's line meets the sew line is found here again.
            reached = [
                arc
                for line in sew
                if line[0] == piece and line[1].get("data-curve") == name
                for arc in arc_lengths_at(line[2], points, 7.0)
            ]
            self.assertTrue(any(abs(arc - said) < 1e-3 for arc in reached), (name, said, reached))
            measured.setdefault(name, []).append(round(said, 6))
        self.assertEqual(set(measured), set(seams))
        for name, length in seams.items():
            at = sorted(set(measured[name]))
            self.assertEqual(sorted(measured[name]), sorted(2 * at), name)
            if length > 87.5:
                self.assertEqual(at, [70.0 * (k + 1) for k in range(len(at))])
                self.assertLess(length - at[-1], 87.5 + 1e-6)
            else:
                self.assertAlmostEqual(at[0], length / 2, places=5)

    def test_darts_have_legs_fold_line_mouth_notches_and_a_drill_hole(self):
        self.make_raw("shirt_front", "-o", "out/pattern.svg", "-o", "out/pattern.dxf")
        root = pattern.svg_root(self.path("out", "pattern.svg"))
        for name in ("bust_dart_left", "bust_dart_right"):
            legs = [line for line in pattern.svg_paths(root, "dart-leg")
                    if line[1].get("data-curve") == name]
            (fold,) = [line for line in pattern.svg_paths(root, "dart-fold")
                       if line[1].get("data-curve") == name]
            self.assertEqual(len(legs), 2)
            tip = fold[2][0]
            for _, _, points, _ in legs:
                self.assertLess(math.dist(points[-1], tip), 1e-6)
            # The fold line lies between the legs: equal angles with the chords to the mouths.
            angles = [angle(tip, fold[2][1], points[0]) for _, _, points, _ in legs]
            self.assertLess(abs(abs(angles[0]) - abs(angles[1])), 0.03)
            self.assertLess(angles[0] * angles[1], 0.0)
            mouths = [line for line in pattern.svg_paths(root, "notch")
                      if line[1].get("data-curve") == name]
            self.assertEqual(len(mouths), 2)
        document, _ = pattern.read_dxf(self.path("out", "pattern.dxf"))
        block = document.blocks.get(document.modelspace().query("INSERT")[0].dxf.name)
        holes = [point for point in block.query("POINT") if point.dxf.layer == "13"]
        self.assertEqual(len(holes), 2)

    def test_the_walk_has_the_legs_of_darts_as_they_are_drawn(self):
        for fair in ("0", "0.5"):
            self.make("shirt_front", "-o", "out/pattern.svg", "-o", "out/walk.csv", "--dart-tip", "13", "--smooth", fair)
            root = pattern.svg_root(self.path("out", "pattern.svg"))
            drawn = {}
            for group in root.iter():
                for element in group if group.get("class") == "dart-leg" else ():
                    drawn.setdefault(element.get("data-curve"), []).append(float(element.get("data-length")))
            self.assertEqual(len(drawn), 2)
            with open(self.path("out", "walk.csv"), encoding="utf-8", newline="") as file:
                rows = list(csv.DictReader(file))
            for name, lengths in drawn.items():
                for side in "ab":
                    walked = sum(float(row[f"length_{side}_mm"]) for row in rows if row["curve"] == name)
                    self.assertLess(min(abs(walked - length) for length in lengths), 1e-5)
                    self.assertLess(walked, max(float(row["to_mm"]) for row in rows if row["curve"] == name) - 1.0)


def angle(at, first, second):
    a = math.atan2(first[1] - at[1], first[0] - at[0])
    b = math.atan2(second[1] - at[1], second[0] - at[0])
    return math.remainder(b - a, 2 * math.pi)


def arc_lengths_at(line, notch, allowance):
    """Arc lengths at which the notch, prolonged by the allowance, crosses a polyline."""
    (x0, y0), (x1, y1) = notch
    length = math.hypot(x1 - x0, y1 - y0)
    direction = ((x1 - x0) / length, (y1 - y0) / length)
    arc = 0.0
    found = []
    for a, b in zip(line, line[1:]):
        side = (b[0] - a[0], b[1] - a[1])
        edge = math.hypot(*side)
        sine = direction[0] * side[1] - direction[1] * side[0]
        start = (a[0] - x0, a[1] - y0)
        if abs(sine) > 1e-12:
            along = (start[0] * side[1] - start[1] * side[0]) / sine
            across = (start[0] * direction[1] - start[1] * direction[0]) / sine
            if -1e-6 <= across <= 1 + 1e-6 and 0.0 < along < 2.5 * allowance:
                found.append(arc + across * edge)
        arc += edge
    return found


if __name__ == "__main__":
    unittest.main()
