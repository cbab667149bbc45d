# SPDX-License-Identifier: BSD-3-Clause
"""Sizes of one pattern: their rules are those of plates whose sizes are known, and of surfaces scaled by a factor."""
import glob
import math
import os

import command
import ezdxf

COLUMNS, ROWS = 6, 10
at = command.grid_ids(COLUMNS)
FACTORS = {"36": 0.95, "38": 1.0, "40": 1.04}


def plate(width, height, bulge=0.0, factor=1.0, turn=0.3):
    """A plate that lies askew in space, by a bulge out of its plane."""
    def place(i, j):
        x, y = i * width / COLUMNS, j * height / ROWS
        z = bulge * math.sin(math.pi * i / COLUMNS) * math.sin(math.pi * j / ROWS)
        return tuple(factor * v for v in (
            x * math.cos(turn) - y * math.sin(turn), x * math.sin(turn) + y * math.cos(turn), z))
    return command.grid(COLUMNS, ROWS, place)


class Grading(command.CommandTest):
    def setUp(self):
        super().setUp()
        for name, width, height in (("small", 28, 48), ("medium", 30, 50), ("large", 33, 52)):
            self.write(name + ".obj", command.obj(*plate(width, height)))
        for name, factor in FACTORS.items():
            self.write(name + ".obj", command.obj(*plate(30, 50, 4.0, factor)))
        self.write("curves.txt", "straight centre " + " ".join(str(at(COLUMNS // 2, j)) for j in range(ROWS + 1))
                   + f"\nedge hem {at(0, 0)} {at(COLUMNS, 0)}\n")

    def grade(self, *words, files=("nest.svg", "rules.csv"), code=0):
        """Grades into the folder `out`."""
        outputs = [word for name in files for word in ("-o", "out/" + name)]
        self.run_command("grade", *words, "-o", "out", *outputs, code=code)
        return self.report("out")

    def grade_scaled(self, *more):
        return self.grade("36=36.obj", "38=38.obj", "40=40.obj", "curves.txt", "--base", "38", "--unit", "cm", *more)

    def test_the_rule_table_moves_the_points_of_the_dxf(self):
        for unit, word in (("cm", "METRIC"), ("inch", "ENGLISH")):
            self.grade("36=36.obj", "38=38.obj", "40=40.obj", "curves.txt", "--base", "38", "--unit", unit, "--smooth", "0",
                       "--no-arrange", files=("pattern.dxf", "pattern.rul", "rules.csv"))
            head, *rules = self.read("out/pattern.rul").split("RULE: DELTA ")
            fields = dict(line.split(": ", 1) for line in head.splitlines() if ": " in line)
            self.assertEqual(head.splitlines()[0], "ASTM/D13Proposal 1 Version: D 6673-04")
            self.assertEqual((fields["UNITS"], fields["NUMBER OF SIZES"], fields["SIZE LIST"], fields["SAMPLE SIZE"]),
                             (word, "3", "36 38 40", "38"))
            self.assertEqual(rules[-1].splitlines()[-1], "END")
            deltas = {}
            for rule in rules:
                number, *lines = rule.replace("END", "").split("\n")
                deltas[int(number)] = [tuple(map(float, line.split(","))) for line in lines if line.strip()]
            self.assertEqual(len(deltas), len(self.table("out/rules.csv")))
            drawing = ezdxf.readfile(self.path("out/pattern.dxf"))
            block = next(b for b in drawing.blocks if b.name[0] not in "*$")
            places = {int(text.dxf.text[2:]): (text.dxf.insert.x, text.dxf.insert.y) for text in block.query("TEXT")
                      if text.dxf.text.startswith("# ") and text.dxf.layer == "2"}
            self.assertEqual(set(places), set(deltas))
            marks = [tuple(point.dxf.location)[:2] for point in block.query("POINT") if point.dxf.layer in "23"]
            for place in places.values():
                self.assertLess(min(math.dist(place, mark) for mark in marks), 1e-6)
            # Moved by their rules, the points are the base's scaled: all distances by the factor.
            for column, factor in enumerate(FACTORS.values()):
                moved = {n: tuple(p + d for p, d in zip(places[n], deltas[n][column])) for n in places}
                for a in places:
                    for b in places:
                        self.assertAlmostEqual(math.dist(moved[a], moved[b]), factor * math.dist(places[a], places[b]),
                                               delta=1e-5)

    def test_curves_by_coordinates_are_moved_with_the_surface(self):
        points, _ = plate(30, 50, 4.0)
        self.write("centre.csv", "name,x,y,z\n" + "".join(
            "key centre,%r,%r,%r\n" % points[at(COLUMNS // 2, j)] for j in range(ROWS + 1)))
        self.grade("38=38.obj", "40=40.obj", "centre.csv", "--unit", "cm")
        layers = command.nest_layers(self.path("out/nest.svg"))
        self.assertEqual(list(layers), ["38", "40"])
        for (name, small), (other, large) in zip(*layers.values()):
            self.assertEqual(name, other)
            lengths = [sum(math.dist(a, b) for a, b in zip(line, line[1:])) for line in (small, large)]
            self.assertAlmostEqual(lengths[1], 1.04 * lengths[0], delta=1e-5)

    def test_sizes_that_are_none_are_refused_and_leave_nothing(self):
        self.write("other.obj", command.obj(*command.sheet()))
        points, triangles = plate(30, 50)
        self.write("turned.obj", command.obj(points, [(b, c, a) for a, b, c in triangles]))
        for arguments, code, words in (
            (["M=large.obj"], 2, ["'M'", "twice"]),
            (["L"], 2, ["two sizes"]),
            (["=large.obj"], 2, ["SIZE=SURFACE"]),
            (["L=large.obj", "--base", "XL"], 2, ["'XL'"]),
            (["L=large.obj", "--kind", "darts"], 2, ["wirewarp cut"]),
            (["L=none.obj"], 3, ["'L'", "none.obj"]),
            (["L=other.obj"], 3, ["'L'", "other.obj", "connectivity", "77 vertices"]),
            (["L=turned.obj"], 3, ["'L'", "turned.obj", "corners"]),
            (["L=large.obj", "--at", "waist"], 3, ["'waist'", "centre"]),
        ):
            with self.subTest(arguments=arguments):
                self.assert_stderr(words, "grade", "M=medium.obj", "curves.txt", "--unit", "cm", "-o", "none", *arguments,
                                   code=code)
                self.assertLessEqual(set(glob.glob("*", root_dir=self.path("none"))), {"report.json"})

    def test_a_run_without_sizes_takes_those_of_an_earlier_one_away(self):
        self.grade_scaled("-o", "out/pattern.rul")
        self.assertLessEqual({"nest.svg", "rules.csv", "pattern.rul"}, set(os.listdir(self.path("out"))))
        self.flatten("38.obj", "curves.txt")
        self.assertFalse({"nest.svg", "rules.csv", "pattern.rul"} & set(os.listdir(self.path("out"))))


command.main()
