# SPDX-License-Identifier: BSD-3-Clause
"""What stands on which layer of a DXF pattern (ASTM D6673 / AAMA), as ezdxf reads it."""

import math
import unittest

import ezdxf.colors

import pattern_files as pattern


def marks(block, layer):
    return [tuple(point.dxf.location)[:2] for point in block.query("POINT")
            if point.dxf.layer == layer]


def records(text):
    """The pairs of group code and value of a DXF file."""
    lines = text.split("\r\n")
    return [(int(code), value) for code, value in zip(lines[::2], lines[1::2])]


def contrast(one, other):
    """Of two sRGB colors, by the definition of WCAG 2: 1 to 21."""
    def luminance(rgb):
        parts = [value / 255 for value in rgb]
        linear = [v / 12.92 if v <= 0.04045 else ((v + 0.055) / 1.055) ** 2.4 for v in parts]
        return sum(weight * value for weight, value in zip((0.2126, 0.7152, 0.0722), linear))
    high, low = sorted((luminance(one), luminance(other)), reverse=True)
    return (high + 0.05) / (low + 0.05)


class Layers(pattern.PatternTest):
    def draw(self, piece, *options, **more):
        self.make(piece, "-o", "out/pattern.dxf", *options, **more)
        return self.dxf()

    def test_for_a_cutter_each_line_is_there_once_in_model_space(self):
        document, _ = self.draw("tshirt", "--style", "cutter", "--allowance", "0")
        self.assertEqual((document.header["$INSUNITS"], document.header["$MEASUREMENT"]), (4, 1))
        space = document.modelspace()
        self.assertEqual({entity.dxf.layer for entity in space}, {"CUT", "MARK", "TEXT"})
        self.assertEqual(len(space.query("INSERT POINT")), 0)
        cuts = [line for line in space.query("POLYLINE") if line.dxf.layer == "CUT"]
        self.assertEqual(len(cuts), 4)
        self.assertTrue(all(line.is_closed for line in cuts))
        self.assertTrue(any(vertex.dxf.bulge for line in cuts for vertex in line.vertices))
        self.assertLess(sum(len(line) for line in cuts), 250)
        self.assertTrue({"A", "B"} <= {text.dxf.text for text in space.query("TEXT")})
        outlines = {tuple(vertex.dxf.location) for line in cuts for vertex in line.vertices}
        for line in space.query("POLYLINE"):
            if line.dxf.layer != "CUT":
                self.assertGreater(len({tuple(v.dxf.location) for v in line.vertices} - outlines), 0)

    def test_corners_are_turn_points_and_all_other_vertices_curve_points(self):
        for block in self.draw("tshirt")[1]:
            turns, curves = set(marks(block, "2")), set(marks(block, "3"))
            ((cut, _),) = pattern.block_lines(block, "1")
            for before, point, after in zip(cut[-1:] + cut[:-1], cut, cut[1:] + cut[:1]):
                self.assertIn(point, turns | curves)
                turn = abs(math.remainder(
                    math.atan2(after[1] - point[1], after[0] - point[0])
                    - math.atan2(point[1] - before[1], point[0] - before[0]), 2 * math.pi))
                if turn > math.radians(60):
                    self.assertIn(point, turns)
                elif turn < math.radians(5):
                    self.assertIn(point, curves)

    def test_notches_lie_on_the_boundary_as_many_as_the_svg_has(self):
        _, blocks = self.draw("tshirt", "-o", "out/pattern.svg", "--smooth", "0")
        drawn = pattern.svg_paths(self.svg(), "notch")
        for number, block in enumerate(blocks):
            ((cut, _),) = pattern.block_lines(block, "1")
            notches = marks(block, "4")
            self.assertEqual(len(notches), sum(1 for path in drawn if path[0] == number))
            self.assertGreater(len(notches), 3)
            for notch in notches:
                self.assertLess(pattern.distance_to(notch, cut), 0.01)

    def test_who_knows_no_notches_and_drill_holes_sees_lines_and_circles(self):
        _, (block,) = self.draw("shirt_front")
        lines = [line for line in block.query("LINE") if line.dxf.layer == "4"]
        starts = {tuple(line.dxf.start)[:2] for line in lines}
        self.assertEqual(starts, set(marks(block, "4")))
        for line in lines:
            self.assertGreater(math.dist(line.dxf.start, line.dxf.end), 1.0)
        circles = [circle for circle in block.query("CIRCLE") if circle.dxf.layer == "13"]
        self.assertEqual({tuple(circle.dxf.center)[:2] for circle in circles}, set(marks(block, "13")))
        self.assertEqual(len(circles), 2)

    def test_colors_of_layers_can_be_read_on_black_and_on_white(self):
        document, _ = self.draw("tshirt")
        read = 0
        for layer in document.layers:
            if layer.dxf.color == 7:  # black on white, white on black
                continue
            color = ezdxf.colors.aci2rgb(layer.dxf.color)
            for ground in ((0, 0, 0), (255, 255, 255)):
                self.assertGreater(contrast(color, ground), 3.0, (layer.dxf.name, color))
            read += 1
        self.assertEqual(read, 9)

    def test_layers_blocks_and_entities_have_handles_of_their_own(self):
        self.draw("tshirt")
        pairs = records(self.content("pattern.dxf").decode("ascii"))
        handles = []
        for at, (code, value) in enumerate(pairs):
            if code != 0 or value in ("SECTION", "ENDSEC", "TABLE", "ENDTAB", "EOF"):
                continue
            self.assertEqual(pairs[at + 1][0], 5, (value, pairs[at + 1]))
            handles.append(int(pairs[at + 1][1], 16))
        self.assertGreater(len(handles), 500)
        self.assertEqual(len(handles), len(set(handles)))
        seed = pairs[pairs.index((9, "$HANDSEED")) + 1]
        self.assertEqual(seed, (5, f"{max(handles) + 1:08X}"))

    def test_blocks_bear_the_names_of_their_pieces(self):
        _, blocks = self.draw("tshirt", "--piece", "front", "--piece", "front", "--piece", "Ärmel", "--piece", "x" * 40)
        names = [block.name for block in blocks]
        self.assertEqual(names[:2], ["FRONT", "FRONT_2"])
        self.assertRegex(names[2], "^_+RMEL$")
        self.assertEqual(names[3], "X" * 31)

    def test_sew_lines_are_dashed_and_their_dashes_run_on_over_the_points(self):
        for unit, scale in (("cm", 1.0), ("in", 1 / 25.4)):
            document, blocks = self.draw("shirt_front", unit=unit)
            self.assertEqual(document.layers.get("14").dxf.linetype, "DASHEDTINY")
            self.assertEqual({document.layers.get(layer).dxf.linetype for layer in ("1", "4", "7", "8", "11")},
                             {"CONTINUOUS"})
            dashes = [value for code, value in document.linetypes.get("DASHEDTINY").pattern_tags.tags if code in (40, 49)]
            for found, wanted in zip(dashes, (6, 4, -2)):
                self.assertAlmostEqual(found, scale * wanted, places=6)
            for block in blocks:
                lines = [line for line in block.query("POLYLINE") if line.dxf.layer == "14"]
                self.assertTrue(lines)
                for line in lines:
                    self.assertTrue(line.dxf.flags & 128)
                    self.assertEqual(line.dxf.get("linetype", "BYLAYER"), "BYLAYER")

    def test_the_grain_has_a_head_at_its_upper_end_or_at_both_where_none_is_known(self):
        for piece, known in (("shirt_front", True), ("quarter_sphere", False)):
            _, (block,) = self.draw(piece, "--up", "none")
            (grain,) = [line for line in block.query("LINE") if line.dxf.layer == "7"]
            heads = [[tuple(head.dxf.get(f"vtx{k}"))[:2] for k in range(4)]
                     for head in block.query("SOLID") if head.dxf.layer == "7"]
            grain_ends = [tuple(grain.dxf.end)[:2], tuple(grain.dxf.start)[:2]]
            self.assertEqual([head[1] for head in heads], grain_ends[:1 if known else 2])
            for left, tip, right, last in heads:
                self.assertEqual(last, right)
                self.assertAlmostEqual(math.dist(left, tip), math.dist(right, tip), places=6)
                self.assertGreater(math.dist(left, tip), min(4, 0.1 * math.dist(*grain_ends)))

    def test_texts_say_what_the_one_who_cuts_must_know(self):
        document, blocks = self.draw("tshirt", "--name", "Ärmel 1", "--size", "M", "--quantity", "3", "--piece", "front")
        self.assert_words(("Style Name: \\U+00C4rmel 1", "Sample Size: M"),
                          [text.dxf.text for text in document.modelspace().query("TEXT")])
        for number, block in enumerate(blocks):
            said = {text.dxf.text: text.dxf.layer for text in block.query("TEXT")}
            name = "front" if number == 0 else f"\\U+00C4rmel 1 {number + 1}"
            self.assertLessEqual({f"Piece Name: {name}": "1", "Size: M": "1", "Quantity: 3": "1",
                                  f"piece {number + 1} of 4": "15"}.items(), said.items())


if __name__ == "__main__":
    unittest.main()
