# SPDX-License-Identifier: BSD-3-Clause
"""Sizes of one pattern on each other: rules are those of plates whose sizes are known, and of scaled surfaces."""

import csv
import os
import unittest

import numpy as np
import surfaceflattening as sf
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkPolyData

from surfaces import command, grid

COLUMNS, ROWS = 6, 10
at = command.grid_ids(COLUMNS)


def plate(width, height, turn=0.3):
    """A plate in space, lying askew, with its centre line as a straight key."""
    def place(i, j):
        x, y = i * width / COLUMNS, j * height / ROWS
        return x * np.cos(turn) - y * np.sin(turn), x * np.sin(turn) + y * np.cos(turn), 0.2 * y
    centre = sf.Curve([at(COLUMNS // 2, b) for b in range(ROWS + 1)], "key", "centre", "straight")
    return *grid(COLUMNS, ROWS, place), [centre]


def flat_plate(width, height):
    return sf.flatten(*plate(width, height))


class Grading(command.CommandTest):
    def setUp(self):
        super().setUp()
        self.sizes = {"S": flat_plate(28.0, 48.0), "M": flat_plate(30.0, 50.0), "L": flat_plate(33.0, 52.0)}

    def test_the_table_and_the_nest_hold_the_same_numbers(self):
        grading = sf.grade(self.sizes, unit="cm")
        grading.write_rules(self.path("rules.csv"))
        grading.write_nest(self.path("nest.svg"), "a <plate>")
        rows = list(csv.reader(self.read("rules.csv").splitlines()))
        self.assertEqual(rows[0], ["piece", "point", "name", "dx S mm", "dy S mm", "dx M mm", "dy M mm", "dx L mm",
                                   "dy L mm"])
        self.assertEqual(len(rows), 1 + len(grading.rules))
        for row, rule in zip(rows[1:], grading.rules):
            self.assertEqual((row[0], int(row[1]), row[2]), ("1", rule.point, rule.name))
            self.assertLess(np.abs(np.array(row[3:], float) - np.ravel(rule.deltas)).max(), 6e-5)
        layers = command.nest_layers(self.path("nest.svg"))
        self.assertEqual(list(layers), ["S", "M", "L"])
        for size, lines in layers.items():
            total = sum(np.linalg.norm(np.diff(line, axis=0), axis=1).sum() for _, line in lines)
            wanted = 10 * sum(wire.flat_length for wire in self.sizes[size].wires if wire.type != "connector")
            self.assertAlmostEqual(total, wanted, delta=1e-5)
        self.assertEqual(sorted(os.listdir(self.folder)), ["nest.svg", "rules.csv"])

    def test_the_unit_is_that_of_the_surfaces_where_none_is_given(self):
        centimetres = sf.grade(self.sizes).rules
        for unit, factor in (("mm", 0.1), ("cm", 1.0), ("m", 100.0), ("inch", 2.54)):
            for size in list(self.sizes)[1:]:  # the first that states one
                self.sizes[size]._parts.flat["field_arrays"]["LengthUnit"] = [unit]
            for rule, wanted in zip(sf.grade(self.sizes).rules, centimetres):
                self.assertLess(np.abs(np.array(rule.deltas) - factor * np.array(wanted.deltas)).max(), 1e-9 * factor)
            self.assertEqual(sf.grade(self.sizes, unit="cm").rules, centimetres)

    def test_sizes_with_broken_arrays_are_refused(self):
        filter_ = sf.vtkPatternGrading()
        filter_.SetUnit(2)
        for name, size in self.sizes.items():
            filter_.AddSize(name, size.to_polydata(), size.to_polydata("wires"))
        filter_.Update()

        def removed(name):
            return lambda nest: nest.GetFieldData().RemoveArray(name)

        def shortened(name):
            return lambda nest: nest.GetFieldData().GetAbstractArray(name).SetNumberOfTuples(0)

        for harm in (lambda nest: nest.SetPoints(vtkPoints()), lambda nest: nest.GetCellData().RemoveArray("SizeId"),
                     removed("BaseSize"), removed("GrainDirection"), removed("RuleDelta"), shortened("RulePoint"),
                     shortened("SizeName"), shortened("RuleDelta"), None):
            writer = sf.vtkPatternWriter()
            writer.AddObserver("ErrorEvent", lambda *_: None)
            writer.SetInputData(0, self.sizes["M"].to_polydata())
            if harm:
                nest = vtkPolyData()
                nest.DeepCopy(filter_.GetOutput())
                harm(nest)
                writer.SetInputData(3, nest)
            writer.SetFileName(self.path("none.rul"))
            self.assertEqual((writer.Write(), writer.GetStatusName()), (0, "InvalidPattern" if harm else "InvalidOption"))
        self.assertEqual(os.listdir(self.folder), [])

    def test_sizes_without_a_grain_are_turned_as_they_fit(self):
        corners = np.array([[0, 0], [40, 0], [40, 10], [0, 30.0]])
        triangles = np.array([[0, 1, 2], [0, 2, 3]])
        turn = np.radians(50.0)
        turned = corners @ np.array([[np.cos(turn), np.sin(turn)], [-np.sin(turn), np.cos(turn)]])
        sizes = {name: sf.flatten(np.column_stack([points, np.zeros(4)]), triangles, arrange=False)
                 for name, points in (("M", corners), ("L", 1.1 * turned))}
        grading = sf.grade(sizes, base="M", unit="mm")
        self.assertEqual(len(grading.rules), 4)
        for rule in grading.rules:
            place = grading.positions["M"][rule.point]
            self.assertLess(np.abs(np.array(rule.deltas[1]) - 0.1 * place).max(), 1e-6)

    def test_sizes_that_are_no_sizes_of_one_pattern_are_refused_by_name(self):
        other = sf.flatten(*plate(30.0, 50.0)[:2])
        fold = sf.Curve(plate(1, 1)[2][0].points, "key", "fold", "straight")
        renamed = sf.flatten(*plate(30.0, 50.0)[:2], [fold])
        for sizes, options, words in (
            (self.sizes, {"base": "XL"}, ["'XL'", "S, M, L"]),
            (self.sizes, {"at": "hem"}, ["'hem'", "centre"]),
            (self.sizes, {"unit": "ft"}, ["ft"]),
            ({"M": self.sizes["M"], "L": other}, {}, ["'L'", "'M'"]),
            ({"M": self.sizes["M"], "L": renamed}, {}, ["'L'", "fold"]),
        ):
            self.assert_raises(ValueError, words, sf.grade, sizes, **options)
        with self.assertRaises(OSError):
            sf.grade(self.sizes).write_nest(self.path("nowhere/nest.svg"))
        self.assertEqual(os.listdir(self.folder), [])


if __name__ == "__main__":
    unittest.main()
