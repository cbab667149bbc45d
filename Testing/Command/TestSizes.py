# SPDX-License-Identifier: BSD-3-Clause
"""How large pieces come out, in which unit, and what their cloth has to do."""
import math
import os

import command


def plate(columns, rows, height=lambda x, y: 0.0):
    """columns x rows unit squares; vertex (i, j) is j * (columns + 1) + i."""
    return command.grid(columns, rows, lambda i, j: (float(i), float(j), height(i, j)))


class Sizes(command.CommandTest):
    def sides(self, report, piece=0):
        size = report["sizes"][piece]
        return sorted((size["width_mm"], size["height_mm"]))

    def test_a_flat_plate_has_its_size_in_each_unit(self):
        self.write("plate.obj", command.obj(*plate(6, 10)))
        for unit, millimetres in (("mm", 1.0), ("cm", 10.0), ("m", 1000.0), ("inch", 25.4)):
            report = self.flatten("plate.obj", "--unit", unit)
            self.assertEqual((report["unit"], report["unit_stated"]), (unit, True))
            for side, count in zip(self.sides(report), (6, 10)):
                self.assertAlmostEqual(side, millimetres * count, delta=1e-9 * millimetres)
        report = self.flatten("plate.obj")
        self.assertEqual((report["unit"], report["unit_stated"]), ("cm", False))
        self.assertAlmostEqual(self.sides(report)[1], 100.0, delta=1e-9)

    def test_an_obj_file_states_its_unit(self):
        text = command.obj(*command.grid(6, 8, lambda i, j: (10.0 * i, 10.0 * j, 0.0)))
        for comment, unit in (("# units: mm", "mm"), ("#Units = Centimeters", "cm"), ("# File units: metres", "m"),
                              ("# unit inch", "inch"), ("# units", ""), ("# unit: parsec", ""), ("# in the united kingdom", "")):
            run = self.run_command(self.write("plate.obj", comment + "\n" + text), "--output", "out", code=0)
            report = self.report("out")
            self.assertEqual((report["unit"] if unit else "", report["unit_stated"]), (unit, bool(unit)), comment)
            self.assertEqual("--unit" in run.stdout + run.stderr, not unit)
        # What is said on the command line goes before it, and patterns take the same.
        self.write("plate.obj", "# units: mm\n" + text)
        self.assertEqual(self.flatten("plate.obj", "--unit", "cm")["unit"], "cm")
        self.assertEqual(self.run_command("pattern", "plate.obj", "-o", "of file/pattern.svg").stderr, "")
        self.run_command("pattern", "plate.obj", "-o", "stated/pattern.svg", "--unit", "mm")
        self.assertEqual(self.read("of file/pattern.svg"), self.read("stated/pattern.svg"))

    def test_the_likely_unit_is_taken_and_said_once_and_not_where_one_is_stated(self):
        for scale, likely in ((0.1, "m"), (5.0, "cm"), (40.0, "mm")):
            self.write("plate.obj", command.obj(*command.grid(6, 10, lambda i, j: (scale * i, scale * j, 0.0))))
            self.assertIn(f"{likely} is likely and taken", self.run_command("check", "plate.obj").stdout)
            self.run_command("cut", "plate.obj", "--kind", "darts", "--output", "cut")
            self.assertEqual(self.report("cut")["unit"], likely)
            for files in ((), ("-o", "out/pattern.svg", "-o", "out/pattern.plt")):
                with self.subTest(likely=likely, files=files):
                    arguments = ("pattern" if files else "flatten", "plate.obj", *files, "--output", "out")
                    run = self.run_command(*arguments)
                    self.assertIn(f"note: plate.obj states no unit: {likely} is taken", run.stderr)
                    self.assertEqual((run.stderr + run.stdout).count("--unit"), 1, run.stderr)
                    report = self.report("out")
                    self.assertEqual((report["unit"], report["unit_stated"]), (likely, False))
                    run = self.run_command(*arguments, "--unit", "inch")
                    self.assertEqual((run.stderr + run.stdout).count("--unit"), 0, run.stderr)

    def test_a_stated_unit_is_kept_by_all_files_that_are_written(self):
        self.write("plate.obj", command.obj(*plate(6, 10)))
        self.write("line.txt", "accessory line " + " ".join(str(7 * j + 3) for j in range(11)) + "\n")
        curves = os.path.join("first", "curves.vtp")
        for unit, name, *inputs in (("m", "m", "plate.obj", curves), ("INCH", "inch", os.path.join("first", "cut.vtp")),
                                    ("mm", "mm", os.path.join("first", "flat.vtp")),
                                    ("cm", "cm", "plate.obj", "line.txt", curves)):
            self.run_command("cut", "plate.obj", "line.txt", "--unit", unit, "--kind", "darts", "--output", "first", code=0)
            with self.subTest(unit=name, inputs=inputs):
                run = self.run_command("pattern", *inputs, "-o", "out/a.svg", "--smooth", "0", "--output", "out", code=0)
                self.assertNotIn("--unit", run.stderr + run.stdout)
                report = self.report("out")
                self.assertEqual((report["unit"], report["unit_stated"]), (name, True))
        # What is said last goes before it.
        run = self.run_command("plate.obj", curves, "--unit", "mm", "--output", "last")
        self.assertIn("was saved in cm", run.stderr)
        report = self.flatten(os.path.join("last", "cut.vtp"))
        self.assertEqual((report["unit"], report["unit_stated"]), ("mm", True))
        # The surface goes before its curves, and a unit that is taken for granted is not written.
        self.write("stated.obj", "# units: inch\n" + command.obj(*plate(6, 10)))
        self.assertEqual(self.flatten("stated.obj", curves)["unit"], "inch")
        self.run_command("plate.obj", "line.txt", "--output", "bare")
        self.assertFalse(self.flatten(os.path.join("bare", "cut.vtp"))["unit_stated"])

    def test_what_must_be_eased_and_stretched_is_said(self):
        """By numbers that TestEveryNumber.py checks."""
        self.write("bump.obj", command.obj(*plate(
            12, 12, lambda x, y: 1.5 * math.exp(-((x - 9.5) ** 2 + (y - 10.0) ** 2) / 3.0))))
        self.write("arc.txt", "accessory arc " + " ".join(str(13 * 6 + i) for i in range(13)) + "\n")
        run = self.run_command("bump.obj", "arc.txt", "--unit", "cm", "--output", "out", code=0)
        size, piece = (self.report("out")[key][0] for key in ("sizes", "pieces"))
        self.assertGreater(size["stretched"], 0.01)
        line = next(row for row in run.stdout.splitlines() if row.startswith("piece 1: "))
        self.assert_words(("%.1f %% of the area must be stretched, worst" % (100 * size["stretched"]), size["worst_place"]), line)
        self.assertEqual(line, f"piece 1: {piece['size']}; {piece['ease']}; strain "
                               f"{100 * piece['strain_p95']:.2g} %, for material that gives")

    def test_how_far_curves_were_off_the_surface_is_said(self):
        self.write("plate.obj", command.obj(*plate(12, 12)))
        for height, said in ((0.02, True), (0.0, False)):
            self.write("c.csv", "name,x,y,z\n" + "".join(f"c,{x},6,{height}\n" for x in (0, 5.5, 12)))
            run = self.run_command("plate.obj", "c.csv", "--unit", "cm", "--output", "out")
            self.assertEqual((run.returncode, run.stderr), (0, ""))
            self.assertAlmostEqual(self.report("out")["curve_distance_mm"], 10 * height, delta=1e-12)
            self.assertEqual("up to 0.2 mm off the surface" in run.stdout, said)

    def test_curves_that_were_proposed_lie_on_the_surface_of_quads(self):
        side = range(13)
        points = [(x, y, 0.06 * (x - 4) * (x - 4) + 0.05 * (y - 6) * x) for y in side for x in side]
        quads = [(13 * y + x, 13 * y + x + 1, 13 * y + x + 14, 13 * y + x + 13) for y in side[:-1] for x in side[:-1]]
        self.write("saddle.obj", command.obj(points, quads))
        self.run_command("cut", "saddle.obj", "--unit", "cm", "--kind", "all", "--max-strain", "0", "--max-cuts", "2",
                         "--output", "first", code=0)
        self.assertGreater(len(self.report("first")["suggestions"]), 0)
        run = self.run_command("saddle.obj", "first/curves.vtp", "--unit", "cm", "--output", "second", code=0)
        self.assertLess(self.report("second")["curve_distance_mm"], 1e-6)
        self.assertNotIn("off the surface", run.stdout)

    def test_the_worst_place_is_named_after_the_curve_there(self):
        self.write("bump.obj", command.obj(*plate(
            12, 12, lambda x, y: 1.5 * math.exp(-((x - 6.0) ** 2 + (y - 6.0) ** 2) / 3.0))))
        self.write("toe.txt", "accessory toe " + " ".join(str(13 * 6 + i) for i in range(13)) + "\n")
        self.assertIn('near "toe"', self.run_command("bump.obj", "toe.txt").stdout)


command.main()
