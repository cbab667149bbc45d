# SPDX-License-Identifier: BSD-3-Clause
"""Patterns measured again by programs that did not write them: an XML parser, ezdxf, poppler."""

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
                root = self.svg()
                scale = pattern.svg_scale(root)
                lines = [line for kind in ("sew-line", "dart-leg", "key-curve", "internal")
                         for line in pattern.svg_paths(root, kind)]
                self.assertEqual(len(lines), len(wires))
                for wire in wires:
                    name = wire.name if wire.kind != pattern.BOUNDARY else None
                    found = self.match(wire, name, lines)
                    lines.remove(found)
                    _, element, points, closed = found
                    edges = [scale * edge for edge in pattern.edge_lengths(points, closed)]
                    expected = sum(wire.edges)
                    self.assertLess(abs(sum(edges) - expected), 1e-6 * expected, wire.name)
                    self.assertLess(abs(float(element.get("data-length")) - expected), 1e-6 * expected)
                    for edge, in_space in zip(edges, wire.edges):
                        self.assertLess(abs(edge - in_space), 1e-5 * in_space, wire.name)

    def match(self, wire, name, lines):
        """The line of a wire: its piece, its name, its number of edges, its length."""
        candidates = [line for line in lines if line[0] == wire.piece and line[1].get("data-curve") == name
                      and len(line[2]) - (0 if line[3] else 1) == len(wire.edges)]
        self.assertTrue(candidates, f"{wire.name} is missing")
        return min(candidates, key=lambda line: abs(sum(pattern.edge_lengths(line[2], line[3])) - sum(wire.edges)))

    def test_every_edge_of_the_dxf_has_its_length_and_the_audit_finds_nothing(self):
        for piece, unit in PIECES:
            with self.subTest(piece):
                self.make_raw(piece, "-o", "out/pattern.dxf", unit=unit)
                wires = pattern.wires_in_space(self.path("out"), unit)
                document, blocks = self.dxf()
                self.assertEqual(document.dxfversion, "AC1009")
                # ENGLISH files are in inches, METRIC ones in millimetres.
                scale = 25.4 if unit == "inch" else 1.0
                self.assertEqual((document.header["$INSUNITS"], document.header["$MEASUREMENT"]),
                                 (1, 0) if unit == "inch" else (4, 1))
                said = [text.dxf.text for text in document.modelspace().query("TEXT")]
                self.assertEqual([text for text in said if text.startswith("Units:")],
                                 ["Units: ENGLISH" if unit == "inch" else "Units: METRIC"])
                self.assertEqual(len(blocks), 1 + max(wire.piece for wire in wires))
                for number, block in enumerate(blocks):
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
        text = self.read("out", "pattern.dxf")
        inserted = re.search("INSERT\r\n  5\r\n.*\r\n  8\r\n1\r\n  2\r\n", text).end()
        self.write("broken.dxf", text[:inserted] + "NOT_THERE_" + text[inserted:])
        self.assertNotEqual(pattern.read_dxf(self.path("broken.dxf"))[1], [])


if __name__ == "__main__":
    unittest.main()
