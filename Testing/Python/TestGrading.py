# SPDX-License-Identifier: BSD-3-Clause
"""Sizes of one pattern on each other: rules are those of plates whose sizes are known, and of scaled surfaces."""

import csv
import os
import tempfile
import unittest
from xml.etree import ElementTree

import numpy as np
import surfaceflattening as sf

SVG = "{http://www.w3.org/2000/svg}"
COLUMNS, ROWS = 6, 10


def at(i, j):
    return j * (COLUMNS + 1) + i


def plate(width, height, turn=0.3):
    """A plate in space, lying askew, with its centre line as a straight key."""
    i, j = np.meshgrid(np.arange(COLUMNS + 1), np.arange(ROWS + 1))
    x, y = i.ravel() * width / COLUMNS, j.ravel() * height / ROWS
    points = np.column_stack([x * np.cos(turn) - y * np.sin(turn), x * np.sin(turn) + y * np.cos(turn), 0.2 * y])
    cells = [(at(a, b), at(a + 1, b), at(a + 1, b + 1)) for a in range(COLUMNS) for b in range(ROWS)]
    cells += [(at(a, b), at(a + 1, b + 1), at(a, b + 1)) for a in range(COLUMNS) for b in range(ROWS)]
    centre = sf.Curve([at(COLUMNS // 2, b) for b in range(ROWS + 1)], "key", "centre", "straight")
    return points, np.array(cells), [centre]


def flat_plate(width, height):
    return sf.flatten(*plate(width, height))


def heights(height):
    """Of the plate on its own surface, which rises as it goes up."""
    return height * np.sqrt(1 + 0.2**2)


class Grading(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name
        self.sizes = {"S": flat_plate(28.0, 48.0), "M": flat_plate(30.0, 50.0), "L": flat_plate(33.0, 52.0)}

    def path(self, name):
        return os.path.join(self.folder, name)

    def test_corners_of_plates_go_with_their_width_and_height(self):
        grading = sf.grade(self.sizes, unit="cm")
        self.assertEqual((grading.sizes, grading.base), (["S", "M", "L"], "M"))
        rules = {rule.point: rule for rule in grading.rules}
        corners = [at(0, 0), at(COLUMNS, 0), at(0, ROWS), at(COLUMNS, ROWS)]
        self.assertLessEqual(set(corners), set(rules))
        places = grading.positions["M"][corners]
        self.assertEqual(sorted(map(tuple, np.round(np.abs(places), 6))),
                         sorted([(150.0, 0.0), (150.0, round(10 * heights(50), 6))] * 2))
        for point, (x, y) in zip(corners, places):
            for (dx, dy), (width, height) in zip(rules[point].deltas, ((28, 48), (30, 50), (33, 52))):
                self.assertAlmostEqual(dx, x * (width / 30 - 1), delta=1e-6)
                self.assertAlmostEqual(dy, y * (height / 50 - 1), delta=1e-6)
        self.assertIn("centre", {name for rule in grading.rules for name in rule.name.split(", ")})

    def test_a_surface_that_is_larger_by_a_factor_gives_rules_by_that_factor(self):
        points, triangles, curves = plate(30.0, 50.0)
        bulged = points + np.column_stack(
            [np.zeros((len(points), 2)), 0.2 * np.sin(np.arange(len(points)))])
        sizes = {name: sf.flatten(factor * bulged, triangles, curves)
                 for name, factor in (("36", 0.95), ("38", 1.0), ("40", 1.04))}
        grading = sf.grade(sizes, base="38", unit="mm")
        for rule in grading.rules:
            place = grading.positions["38"][rule.point]
            for delta, factor in zip(rule.deltas, (0.95, 1.0, 1.04)):
                self.assertLess(np.abs(np.array(delta) - (factor - 1) * place).max(), 1e-6)

    def test_the_table_and_the_nest_hold_the_same_numbers(self):
        grading = sf.grade(self.sizes, unit="cm")
        grading.write_rules(self.path("rules.csv"))
        grading.write_nest(self.path("nest.svg"), "a <plate>")
        with open(self.path("rules.csv"), encoding="utf-8", newline="") as file:
            rows = list(csv.reader(file))
        self.assertEqual(rows[0], ["piece", "point", "name", "dx S mm", "dy S mm", "dx M mm", "dy M mm", "dx L mm",
                                   "dy L mm"])
        self.assertEqual(len(rows), 1 + len(grading.rules))
        for row, rule in zip(rows[1:], grading.rules):
            self.assertEqual((row[0], int(row[1]), row[2]), ("1", rule.point, rule.name))
            self.assertLess(np.abs(np.array(row[3:], float) - np.ravel(rule.deltas)).max(), 6e-5)
        root = ElementTree.parse(self.path("nest.svg")).getroot()
        layers = {group.get("data-size"): group for group in root.findall(SVG + "g")}
        self.assertEqual(list(layers), ["S", "M", "L"])
        for size, group in layers.items():
            total = 0.0
            for path in group.findall(SVG + "path"):
                line = np.array([pair.split(",") for pair in path.get("d")[1:].split(" L")], float)
                total += np.linalg.norm(np.diff(line, axis=0), axis=1).sum()
            wanted = 10 * sum(wire.flat_length for wire in self.sizes[size].wires if wire.type != "connector")
            self.assertAlmostEqual(total, wanted, delta=1e-5)
        self.assertEqual(sorted(os.listdir(self.folder)), ["nest.svg", "rules.csv"])

    def test_sizes_that_are_no_sizes_of_one_pattern_are_refused_by_name(self):
        other = sf.flatten(*plate(30.0, 50.0)[:2])
        fold = sf.Curve(plate(1, 1)[2][0].points, "key", "fold", "straight")
        renamed = sf.flatten(*plate(30.0, 50.0)[:2], [fold])
        triangle = sf.flatten(np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0.0]]), np.array([[0, 1, 2]]))
        for sizes, options, words in (
            ({"M": self.sizes["M"]}, {}, ["1 sizes", "two"]),
            (self.sizes, {"base": "XL"}, ["'XL'", "S, M, L"]),
            (self.sizes, {"at": "hem"}, ["'hem'", "centre"]),
            (self.sizes, {"unit": "ft"}, ["ft"]),
            ({"M": self.sizes["M"], "L": triangle}, {}, ["'L'", "connectivity"]),
            ({"M": self.sizes["M"], "L": other}, {}, ["'L'", "'M'"]),
            ({"M": self.sizes["M"], "L": renamed}, {}, ["'L'", "fold"]),
        ):
            with self.subTest(words=words), self.assertRaises(ValueError) as caught:
                sf.grade(sizes, **options)
            for word in words:
                self.assertIn(word, str(caught.exception))
        with self.assertRaises(OSError):
            sf.grade(self.sizes).write_nest(self.path("nowhere/nest.svg"))
        self.assertEqual(os.listdir(self.folder), [])


if __name__ == "__main__":
    unittest.main()
