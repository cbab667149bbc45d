# SPDX-License-Identifier: BSD-3-Clause
"""SVG as Inkscape and laser cutters take it, and HPGL, read by an XML parser and an interpreter of HPGL."""

import math
import re
import unittest

import pattern_files as pattern


def read_hpgl(text):
    """(pen, points in millimetres) of every line that is drawn, and the texts."""
    pen, down, at = 0, False, (0, 0)
    lines, texts = [], []
    rest = text
    while rest:
        match = re.match(r"\s*([A-Z]{2})", rest)
        if not match:
            assert not rest.strip(), rest[:20]
            break
        command, rest = match.group(1), rest[match.end():]
        if command == "LB":
            words, _, rest = rest.partition("\x03")
            texts.append(words)
            rest = rest.lstrip(";")
            continue
        arguments, _, rest = rest.partition(";")
        numbers = [float(word) for word in arguments.split(",") if word]
        if command == "SP":
            pen = int(numbers[0])
        elif command in ("PU", "PD"):
            down = command == "PD"
            for x, y in zip(numbers[::2], numbers[1::2]):
                assert x == int(x) and y == int(y), (x, y)
                if down:
                    if not lines or lines[-1][1][-1] != at or lines[-1][0] != pen:
                        lines.append((pen, [at]))
                    lines[-1][1].append((x, y))
                at = (x, y)
        else:
            assert command in ("IN", "DI", "SI"), command
    return [(pen, [(x / 40, y / 40) for x, y in points]) for pen, points in lines], texts


class Svg(pattern.PatternTest):
    def layers(self, group):
        return [child for child in group.findall(pattern.SVG + "g")
                if child.get(pattern.INKSCAPE + "groupmode") == "layer"]

    def test_pieces_are_layers_and_each_role_is_one_layer_in_them(self):
        self.make("shirt_front", "-o", "out/pattern.svg", "--piece", "front & facing")
        layers = self.layers(self.svg())
        self.assertEqual([layer.get(pattern.INKSCAPE + "label") for layer in layers],
                         ["scale check", "front & facing"])
        roles = self.layers(layers[1])
        self.assertEqual(len(roles), len(layers[1]))
        labels = [role.get(pattern.INKSCAPE + "label") for role in roles]
        self.assertEqual(len(labels), len(set(labels)), labels)
        self.assertEqual([label.replace(" ", "-") for label in labels],
                         [role.get("class") for role in roles])
        self.assert_words(("cut line", "sew line", "dart leg", "dart fold", "notch", "drill hole", "text"), labels)

    def test_a_laser_gets_thin_whole_lines_in_a_color_a_role(self):
        self.make("shirt_front", "-o", "out/pattern.svg", "--style", "laser")
        (piece,) = pattern.pieces_of(self.svg())
        colors = {}
        for role in self.layers(piece):
            if role.get("class") == "text":
                continue
            self.assertIsNone(role.get("stroke-dasharray"))
            self.assertLessEqual(float(role.get("stroke-width")), 0.1)
            colors[role.get("class")] = role.get("stroke")
        self.assertEqual(colors["cut-line"], "#ff0000")
        self.assertEqual(colors["sew-line"], "#0000ff")
        self.assertEqual(len(set(colors.values())), len(colors))
        self.assertGreater(len(colors), 6)

    def test_heads_of_the_grain_are_filled_but_for_a_laser_which_would_engrave_them(self):
        for options, fill in (((), "#000000"), (("--style", "laser",), None)):
            self.make("shirt_front", "-o", "out/pattern.svg", *options)
            (piece,) = pattern.pieces_of(self.svg())
            (grain,) = [role for role in self.layers(piece) if role.get("class") == "grain"]
            heads = [path for path in grain if path.get("d").endswith("Z")]
            self.assertTrue(heads)
            self.assertEqual({head.get("fill") for head in heads}, {fill})
            # What else is drawn is lines.
            for path in piece.iter(pattern.SVG + "path"):
                self.assertTrue(path in heads or path.get("fill") is None)


class BordersWithoutAllowance(pattern.PatternTest):
    def outlines(self, root, kind):
        """(piece, points) along all paths of a class, curves sampled."""
        for piece, element in pattern.svg_elements(root, kind):
            yield piece, [tuple(point) for curve in pattern.curves_of(element) for point in pattern.bezier_points(curve, 8)]

    def test_a_cutter_cuts_them_once_and_they_keep_their_lengths(self):
        for piece, unit in (("quarter_sphere", "m"), ("tshirt", "cm"), ("tshirt", "inch"), ("shoe_upper", "mm")):
            for fair in ("0", "0.2"):
                with self.subTest(piece, unit=unit, fair=fair):
                    self.make(piece, "-o", "out/pattern.svg", "-o", "out/pattern.dxf", "-o", "out/pattern.plt",
                              "--allowance", "0", "--smooth", fair, unit=unit)
                    root = self.svg()
                    self.assertEqual(pattern.svg_elements(root, "sew-line"), [])
                    wires = [wire for wire in pattern.wires_in_space(self.path("out"), unit)
                             if wire.kind in (pattern.BOUNDARY, pattern.SEAM)]
                    count = 1 + max(wire.piece for wire in wires)
                    drawn = [0.0] * count
                    for number, element in pattern.svg_elements(root, "cut-line"):
                        drawn[number] += sum(map(pattern.bezier_length, pattern.curves_of(element)))
                    for number, length in enumerate(drawn):
                        wanted = sum(sum(wire.edges) for wire in wires if wire.piece == number)
                        self.assertLess(abs(length - wanted), 1e-5 * wanted)
                    for block in self.dxf()[1]:
                        self.assertEqual(pattern.block_lines(block, "14"), [])
                        ((_, closed),) = pattern.block_lines(block, "1")
                        self.assertTrue(closed)
                    lines, _ = read_hpgl(self.content("pattern.plt").decode("ascii"))
                    cut = {point for pen, points in lines for point in points if pen == 2}
                    for pen, points in lines:
                        self.assertFalse(pen == 1 and len(points) > 2 and set(points) <= cut)

    def test_one_border_without_allowance_among_others_is_drawn_once(self):
        self.make("tshirt")
        seams = {wire.name for wire in pattern.wires_in_space(self.path("out"), "cm") if wire.kind == pattern.SEAM}
        for bare in sorted(seams)[:3]:
            self.make("tshirt", "-o", "out/pattern.svg", "--allowance", "8", "--allowance", bare + "=0")
            root = self.svg()
            cut = dict(self.outlines(root, "cut-line"))
            names = {element.get("data-curve") for _, element in pattern.svg_elements(root, "sew-line")}
            self.assertEqual(seams - names, {bare})
            for number, points in self.outlines(root, "sew-line"):
                self.assertGreater(max(pattern.distance_to(point, cut[number]) for point in points[4::9]), 1.0)


class Hpgl(pattern.PatternTest):
    def test_every_line_of_the_svg_is_drawn_at_its_place_and_cut_lines_are_cut_last(self):
        self.make_raw("tshirt", "-o", "out/pattern.svg", "-o", "out/pattern.plt")
        root = self.svg()
        lines, _ = read_hpgl(self.content("pattern.plt").decode("ascii"))
        roles = {group.get("class") for piece in pattern.pieces_of(root) for group in piece} - {"text"}
        paths = [(role in ("cut-line", "cut-out"), element, points + points[:1] if closed else points)
                 for role in roles for _, element, points, closed in pattern.svg_paths(root, role)]
        self.assertEqual(len(paths), len(lines))
        # The SVG has y downwards, and a legend above.
        left = min(x for _, _, points in paths for x, _ in points)
        bottom = max(y for _, _, points in paths for _, y in points)
        low = [min(point[k] for _, points in lines for point in points) for k in (0, 1)]
        wires = 0
        for is_cut, element, points in paths:
            wanted = [(x - left + low[0], bottom - y + low[1]) for x, y in points]
            pen, found = min(
                ((pen, line) for pen, line in lines if len(line) == len(wanted)),
                key=lambda line: max(math.dist(a, b) for a, b in zip(line[1], wanted)))
            self.assertLess(max(math.dist(a, b) for a, b in zip(found, wanted)), 0.036)
            self.assertEqual(pen, 2 if is_cut else 1)
            if element.get("data-length"):
                wires += 1
                length = sum(pattern.edge_lengths(found))
                self.assertLess(abs(length - float(element.get("data-length"))), 0.05)
        self.assertGreater(wires, 10)
        pens = [pen for pen, _ in lines]
        self.assertEqual(pens, sorted(pens))

    def test_texts_are_seven_bits(self):
        self.make("quarter_sphere", "-o", "out/pattern.plt", "--name", "Ärmel; \"2\"")
        _, texts = read_hpgl(self.content("pattern.plt").decode("ascii"))
        self.assertIn("?rmel; \"2\"", texts)


if __name__ == "__main__":
    unittest.main()
