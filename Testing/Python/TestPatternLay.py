# SPDX-License-Identifier: BSD-3-Clause
"""Lays on cloth, read from the SVG: every copy is there once, apart from the others, within the cloth, with its
grain along it, and the share of the cloth that is used is the one that is told."""

import os
import re
import unittest

import numpy as np

import pattern_files as pattern
from surfaces import flattened

COPIES = {1: 1, 2: 1, 3: 1, 4: 1}  # of the T-shirt's pieces, by number


def distance(ring, other):
    """Least distance of two closed polygons from corners to sides; 0 where a corner lies inside the other."""
    least = np.inf
    for points, sides in ((ring, other), (other, ring)):
        a, b = sides, np.roll(sides, -1, axis=0)
        along = b - a
        t = np.einsum("pki,ki->pk", points[:, None] - a, along) / np.maximum(np.sum(along**2, axis=1), 1e-300)
        foot = a + np.clip(t, 0, 1)[..., None] * along
        least = min(least, np.min(np.linalg.norm(points[:, None] - foot, axis=2)))
        x, y = points[0]
        crossing = (a[:, 1] > y) != (b[:, 1] > y)
        where = a[crossing, 0] + (y - a[crossing, 1]) / along[crossing, 1] * along[crossing, 0]
        if np.sum(where > x) % 2:
            return 0.0
    return least


def area(ring):
    after = np.roll(ring, -1, axis=0)
    return float(np.sum(ring[:, 0] * after[:, 1] - ring[:, 1] * after[:, 0])) / 2


class Lay(pattern.PatternTest):
    def outlines(self, name):
        """(number, polygon) of all cut lines, y down."""
        root = pattern.svg_root(self.path("out", name))
        numbers = [int(group.get("id").split("-")[1]) for group in pattern.pieces_of(root)]
        return [(numbers[at], np.array(points))
                for at, _, points, _ in pattern.svg_paths(root, "cut-line")], root

    def nest(self, piece, *options, formats):
        """Lays a piece of Data on cloth."""
        files = [word for ending in formats for word in ("-o", "out/lay." + ending)]
        self.run_command("nest", *pattern.command.data_files(piece), "--unit", "cm", "-o", "out", *files, "--quiet",
                         *options, code=(0, 4))

    def lay(self, width, *options, copies=None):
        self.nest("tshirt", "--roll-width", str(width), *options, formats=("svg",))
        self.run_command("pattern", "out", "-o", "out/pattern.svg", *(["--pairs"] if "--pairs" in options else []),
                         code=0)
        laid, root = self.outlines("lay.svg")
        flat = dict(self.outlines("pattern.svg")[0])
        counts = {}
        for number, _ in laid:
            counts[number] = counts.get(number, 0) + 1
        self.assertEqual(counts, copies or COPIES)
        ids = [element.get("id") for element in root.iter() if element.get("id")]
        self.assertEqual(len(ids), len(set(ids)))
        cloth = next(group for group in root.iter(pattern.SVG + "g") if group.get("id") == "fabric")
        box = {key: float(cloth[0].get(key)) for key in ("x", "y", "width", "height")}
        self.assertEqual(box["width"], width)
        for number, ring in laid:
            low, high = ring.min(axis=0), ring.max(axis=0)
            self.assertGreaterEqual(low[0], box["x"] - 1e-6)
            self.assertLessEqual(high[0], box["x"] + width + 1e-6)
            self.assertGreaterEqual(low[1], box["y"] - 1e-6)
            self.assertLessEqual(high[1], box["y"] + box["height"] + 1e-3)
        for k, (_, ring) in enumerate(laid):
            for _, other in laid[:k]:
                self.assertGreaterEqual(distance(ring, other), 5.0 - 0.02)
        used = sum(abs(area(ring)) for _, ring in laid) / (width * box["height"])
        told = re.search(r"cloth: ([\d.]+) mm x (\d+) mm for (\d+) pieces?, of which ([\d.]+) % is used",
                         "\n".join(self.notes()))
        self.assertIsNotNone(told, self.notes())
        self.assertEqual(float(told[1]), width)
        self.assertAlmostEqual(float(told[2]), box["height"], delta=0.5)
        self.assertEqual(int(told[3]), len(laid))
        self.assertAlmostEqual(float(told[4]), 100 * used, delta=0.06)
        return laid, flat, box["height"], used

    def ways(self, laid, flat):
        """How each copy lies: "up", "down", or turned over ("over up", "over down")."""
        result = []
        for number, ring in laid:
            mine = flat[number]
            self.assertEqual(len(ring), len(mine))
            found = set()
            for name, turn in (("up", (1, 1)), ("down", (-1, -1)), ("over up", (-1, 1)), ("over down", (1, -1))):
                turned = mine * turn
                # The pattern's own grain is upright to a hundredth of a degree.
                if np.abs((ring - ring.min(axis=0)) - (turned - turned.min(axis=0))).max() < 0.2:
                    found.add(name)
            self.assertTrue(found, number)
            result.append((number, found))
        return result

    def test_pieces_are_apart_on_the_cloth_with_their_grain_along_it(self):
        for width in (1400.0, 1100.0, 700.0):
            with self.subTest(width=width):
                laid, flat, length, used = self.lay(width)
                for number, found in self.ways(laid, flat):
                    self.assertTrue(found & {"up", "down"}, number)
                tallest = sum(np.ptp(ring[:, 1]) for ring in flat.values())
                self.assertLess(length, tallest + 20.0)
                self.assertGreater(used, 0.5)

    def test_on_cloth_with_nap_no_piece_is_turned(self):
        laid, flat, _, _ = self.lay(1100.0, "--nap")
        for number, found in self.ways(laid, flat):
            self.assertIn("up", found, number)

    def test_of_a_pair_one_is_turned_over_and_quantities_are_laid(self):
        laid, flat, _, _ = self.lay(
            1100.0, "--nap", "--pairs", "--piece", ":2", "--piece", ":1",
            copies={1: 2, 2: 1, 3: 2})
        ways = self.ways(laid, flat)
        self.assertEqual(sum("over up" in found for number, found in ways if number == 3), 1)
        self.assertEqual(sum("up" in found for number, found in ways if number == 1), 2)

    def test_pieces_to_be_cut_on_the_fold_are_laid_whole(self):
        self.lay(1400.0)
        whole = {number: abs(area(ring)) for number, ring in self.outlines("lay.svg")[0]}
        self.nest("tshirt", "--roll-width", "1400", "--fold", "symmetric", formats=("svg",))
        for number, ring in self.outlines("lay.svg")[0]:
            self.assertAlmostEqual(abs(area(ring)), whole[number], delta=1e-6 * whole[number])

    def test_a_plotter_gets_the_same_lay(self):
        self.nest("tshirt", "--roll-width", "1400", formats=("svg", "plt"))
        text = self.content("lay.plt").decode("ascii")
        cuts = text[text.index("SP2;"):]
        corners = [tuple(map(int, pair)) for run in re.findall(r"P[UD]([-\d,]+);", cuts)
                   for pair in re.findall(r"(-?\d+),(-?\d+)", run)]
        self.assertLessEqual(max(x for x, _ in corners), 40 * 1400)
        self.assertGreater(max(x for x, _ in corners), 40 * 1000)
        self.assertIn("PD", text)

    def test_cloth_that_is_narrower_than_a_piece_gives_no_lay_but_the_result(self):
        arguments = pattern.command.data_files("tshirt")
        self.assert_stderr(("front", "300 mm", "wide"), "nest", *arguments, "--unit", "cm", "--roll-width", "300",
                           "--output", "none", "--piece", "front", "--quiet")
        self.assertFalse(os.path.exists(self.path("none", "lay.svg")))
        self.assertTrue(os.path.exists(self.path("none", "flat.vtp")))
        for options in (("--nap",), ("--roll-width", "0"), ("--roll-width", "900", "--gap", "-1")):
            self.run_command("nest", *arguments, *options, code=2)

    def test_more_pieces_than_can_be_laid_are_refused_before_they_are_counted_out(self):
        result = flattened("tshirt")
        for quantity in (1001, 1_000_000):
            with self.subTest(quantity=quantity), self.assertRaisesRegex(Exception, "no more than 1000 can be"):
                result.write_pattern(self.path("lay.svg"), unit="cm", fabric_width=1400.0, quantity=quantity)
            self.assertFalse(os.path.exists(self.path("lay.svg")))

    def test_quantities_are_written_on_their_pieces(self):
        self.make("tshirt", "-o", "out/pattern.svg", "--quantity", "3", "--piece", ":2", "--piece", ":5")
        root = self.svg()
        self.assertEqual([group.get("data-quantity") for group in pattern.pieces_of(root)], ["2", "5", "3", "3"])
        self.assert_words(("cut 2", "cut 5", "cut 3"), [text.text for text in root.iter(pattern.SVG + "text")])


if __name__ == "__main__":
    unittest.main()
